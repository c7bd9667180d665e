#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// A file of the repository.
struct RepositoryFile {
    std::string path; ///< from the top of the repository, with `/`
    std::string text;
};

/// Prints the path: GoogleTest names tests by it.
void PrintTo(const RepositoryFile& file, std::ostream* out);

/// The files in these top-level folders whose names end in one of `extensions`, ordered by path.
[[nodiscard]] std::vector<RepositoryFile>
repository_files(const std::vector<std::string_view>& folders,
                 const std::vector<std::string_view>& extensions);

/// The programs among the examples, in whichever language.
[[nodiscard]] std::vector<RepositoryFile> example_programs();

/// The lines of `text` without their ends.
[[nodiscard]] std::vector<std::string_view> lines_of(std::string_view text);

} // namespace iecfront::test
