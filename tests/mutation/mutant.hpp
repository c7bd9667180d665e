#pragma once

// Included into every file of the build that mutate.sh makes: says which mutation is in force, and
// notes which have been reached.

#include <cstdio>
#include <cstdlib>
#include <type_traits>

namespace mutation {

inline constexpr unsigned most = 20000;

// What the environment says, read once: IECFRONT_MUTANT is the number of the mutation in force, and
// IECFRONT_REACHED a file to which those that were asked for are added at the end.
struct Run {
    unsigned chosen = 0; // none has this number
    const char* reached_file = std::getenv("IECFRONT_REACHED");
    bool reached[most] = {};

    Run() {
        if (const char* number = std::getenv("IECFRONT_MUTANT"))
            chosen = static_cast<unsigned>(std::atoi(number));
    }
    ~Run() {
        std::FILE* file = reached_file != nullptr ? std::fopen(reached_file, "a") : nullptr;
        if (file == nullptr)
            return;
        for (unsigned i = 0; i < most; ++i)
            if (reached[i])
                std::fprintf(file, "%u\n", i);
        std::fclose(file);
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;
};

// Defined in front of all else in each file, and so there before any table that asks.
inline Run run;

// What is computed when it is compiled is not mutated.
constexpr bool mutant(unsigned number) {
    if (std::is_constant_evaluated())
        return false;
    run.reached[number] = true;
    return run.chosen == number;
}

} // namespace mutation

using mutation::mutant;
