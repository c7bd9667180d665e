#include "support/repository_files.hpp"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <string_view>

namespace iecfront::test {
namespace {

constexpr std::size_t maximum_columns = 100;

[[nodiscard]] std::vector<RepositoryFile>
files_ending_in(const std::vector<std::string_view>& extensions) {
    return repository_files({"include", "src", "tests", "examples"}, extensions);
}

TEST(SourceForm, CodeIsAscii) {
    for (const RepositoryFile& file : files_ending_in({".hpp", ".cpp", ".def"}))
        for (const std::string_view line : lines_of(file.text))
            EXPECT_TRUE(std::all_of(line.begin(), line.end(),
                                    [](char c) { return static_cast<unsigned char>(c) < 0x80; }))
                << file.path << ": " << line;
}

TEST(SourceForm, LinesFitTheirColumns) {
    for (const RepositoryFile& file : files_ending_in({".hpp", ".cpp"}))
        for (const std::string_view line : lines_of(file.text))
            EXPECT_LE(line.size(), maximum_columns) << file.path << ": " << line;
}

TEST(SourceForm, NoTabsAndNoBlanksAtLineEnds) {
    for (const RepositoryFile& file : files_ending_in({".hpp", ".cpp", ".def", ".cmake", ".txt"})) {
        if (file.path.find("/expected/") != std::string::npos)
            continue; // what a program printed
        for (const std::string_view line : lines_of(file.text)) {
            EXPECT_EQ(line.find('\t'), std::string_view::npos) << file.path << ": " << line;
            EXPECT_FALSE(line.ends_with(' ') || line.ends_with('\r')) << file.path << ": " << line;
        }
    }
}

TEST(SourceForm, HeadersAreGuarded) {
    for (const RepositoryFile& file : files_ending_in({".hpp"}))
        EXPECT_TRUE(file.text.starts_with("#pragma once\n")) << file.path;
}

} // namespace
} // namespace iecfront::test
