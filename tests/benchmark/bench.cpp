// Measures how fast texts are read, and how much memory their trees take.

#include "benchmark/generator.hpp"
#include "benchmark/measurements.hpp"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace iecfront::bench {
namespace {

constexpr std::size_t lines_of_large_unit = 2000;

/// Shows the tables as they come, JSON in the end.
class Output {
public:
    explicit Output(bool json) noexcept : json_(json) {}
    ~Output() {
        if (json_)
            std::fputs(to_json(tables_).c_str(), stdout);
    }
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    void add(Table table) {
        if (!json_)
            std::printf("%s\n", to_text(table).c_str());
        std::fflush(stdout);
        tables_.push_back(std::move(table));
    }

private:
    bool json_;
    std::vector<Table> tables_;
};

void measure_generated(const Options& options, Output& output) {
    output.add(
        measure(options, "one unit", generate_function_block(lines_of_large_unit, options.seed)));
    for (const std::size_t megabytes : options.megabytes)
        output.add(measure(options, "generated " + std::to_string(megabytes) + " MB",
                           generate_source(megabytes * 1'000'000, options.seed)));
}

[[nodiscard]] bool measure_files(const Options& options, Output& output) {
    for (const std::string& path : options.files) {
        std::ifstream file(path, std::ios::binary);
        std::string bytes{std::istreambuf_iterator<char>(file), {}};
        if (!file.is_open() || bytes.empty()) {
            std::fprintf(stderr, "iecfront_bench: %s is empty or cannot be read\n", path.c_str());
            return false;
        }
        output.add(measure(options, path, std::move(bytes)));
    }
    return true;
}

/// glibc gives much of what a run has freed back to the system, or not, as a block happens to lie
/// behind it; and to ask for it again takes a run a third of its time.
void keep_freed_memory() noexcept {
#ifdef __GLIBC__
    mallopt(M_TRIM_THRESHOLD, -1);
    mallopt(M_MMAP_MAX, 0);
#endif
}

int run(const Options& options) {
    keep_freed_memory();
    Output output(options.json);
    if (options.files.empty())
        measure_generated(options, output);
    return measure_files(options, output) ? 0 : 1;
}

} // namespace
} // namespace iecfront::bench

int main(int count, char** arguments) {
    using namespace iecfront::bench;
    std::string error;
    const Options options = read_options(count, arguments, error);
    if (options.nothing)
        return 0;
    if (options.help || !error.empty()) {
        std::fprintf(error.empty() ? stdout : stderr, "%s%s%s", error.c_str(),
                     error.empty() ? "" : "\n", std::string(usage()).c_str());
        return error.empty() ? 0 : 2;
    }
    return run(options);
}
