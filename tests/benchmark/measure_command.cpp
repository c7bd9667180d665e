#include "benchmark/measurements.hpp"
#include "benchmark/stopwatch.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace iecfront::bench {
namespace {

constexpr std::size_t file_count = 16;
constexpr std::size_t small_size = 1000; // bytes

/// A folder for files that is gone when this is.
class TemporaryFolder {
public:
    TemporaryFolder() : path_(std::filesystem::temp_directory_path() / "iecfront_bench") {
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    /// Writes a file, and gives its path in quotes.
    std::string write(const std::string& name, std::string_view text) const {
        const std::filesystem::path path = path_ / name;
        std::ofstream(path, std::ios::binary) << text;
        return quoted(path.string());
    }

    static std::string quoted(const std::string& path) { return '"' + path + '"'; }

private:
    std::filesystem::path path_;
};

/// Pieces of about equal size, each up to the end of a line.
[[nodiscard]] std::string write_pieces(const TemporaryFolder& folder, std::string_view text) {
    std::string paths;
    for (std::size_t i = 0; i < file_count && !text.empty(); ++i) {
        const std::size_t about = text.size() / (file_count - i);
        const std::size_t end = i + 1 < file_count ? text.find('\n', about) : text.npos;
        paths += ' ' + folder.write(std::to_string(i) + ".st", text.substr(0, end));
        text.remove_prefix(end == text.npos ? text.size() : end + 1);
    }
    return paths;
}

[[nodiscard]] Row timed_command(std::size_t runs, std::string step, const std::string& line) {
    const Spread seconds = timed(runs, [&] {
        // Findings and their exit status are no matter here.
        static_cast<void>(std::system((line + " > /dev/null 2>&1").c_str()));
    });
    return {std::move(step),
            {{"median ms", seconds.median * 1e3, 2},
             {"min ms", seconds.least * 1e3, 2},
             {"max ms", seconds.most * 1e3, 2}}};
}

} // namespace

std::vector<Row> measure_command(const Options& options, const std::string& text) {
    if (options.command.empty())
        return {};
    const TemporaryFolder folder;
    const std::string check = TemporaryFolder::quoted(options.command) + " check";
    const std::string pieces = write_pieces(folder, text);
    const std::string small = folder.write("small.st", text.substr(0, small_size));
    return {
        timed_command(options.runs, "check --jobs 1", check + " --jobs 1" + pieces),
        timed_command(options.runs, "check", check + pieces),
        timed_command(options.runs, "check of 1 kB", check + ' ' + small),
        timed_command(options.runs, "empty program",
                      TemporaryFolder::quoted(options.self) + " --nothing"),
    };
}

} // namespace iecfront::bench
