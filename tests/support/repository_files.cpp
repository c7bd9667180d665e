#include "support/repository_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace iecfront::test {
namespace {

[[nodiscard]] std::string content(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

std::vector<RepositoryFile> repository_files(const std::vector<std::string_view>& folders,
                                             const std::vector<std::string_view>& extensions) {
    namespace fs = std::filesystem;
    const fs::path top = IECFRONT_SOURCE_DIR;
    std::vector<RepositoryFile> files;
    for (const std::string_view folder : folders) {
        for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
            const std::string path = entry.path().lexically_relative(top).generic_string();
            const bool wanted =
                std::any_of(extensions.begin(), extensions.end(),
                            [&](std::string_view extension) { return path.ends_with(extension); });
            if (wanted && entry.is_regular_file())
                files.push_back({path, content(entry.path())});
        }
    }
    std::sort(files.begin(), files.end(),
              [](const RepositoryFile& a, const RepositoryFile& b) { return a.path < b.path; });
    return files;
}

void PrintTo(const RepositoryFile& file, std::ostream* out) {
    *out << file.path;
}

std::vector<RepositoryFile> example_programs() {
    return repository_files({"examples"}, {".st", ".il", ".iec"});
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

} // namespace iecfront::test
