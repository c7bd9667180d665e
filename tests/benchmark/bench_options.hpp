#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::bench {

/// What the command line of `iecfront_bench` asks for.
struct Options {
    std::vector<std::size_t> megabytes; ///< sizes of generated texts
    std::vector<std::string> files;     ///< read in the place of generated ones
    std::vector<std::string> steps;     ///< the only ones; all when empty
    std::size_t runs = 5;
    std::uint64_t seed = 1;
    bool json = false;
    bool help = false;
    bool nothing = false; ///< end at once: what a program takes that does nothing
    std::string command;  ///< the program `iecfront`; `check` is not measured without it
    std::string self;     ///< how this program was called

    /// True when `step` is to be measured.
    [[nodiscard]] bool wants(std::string_view step) const;
};

/// What the options are.
[[nodiscard]] std::string_view usage() noexcept;

/// Reads the command line; what is wrong with it goes to `error`.
[[nodiscard]] Options read_options(int count, char** arguments, std::string& error);

} // namespace iecfront::bench
