#include "support/case_file.hpp"
#include "support/case_outcome.hpp"
#include "support/line_diff.hpp"
#include "support/repository_files.hpp"

#include <iecfront/format/formatter.hpp>
#include <iecfront/parser/parse.hpp>

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

// What each construct looks like: tests/format/layouts/*.txt. With UPDATE_EXPECT=1 in the
// environment the expectations in the source tree are rewritten instead.

namespace iecfront::test {
namespace {

[[nodiscard]] bool updating() {
    const char* const update = std::getenv("UPDATE_EXPECT");
    return update != nullptr && std::string_view(update) == "1";
}

void update(CaseFile file) {
    const std::string before = write_case_file(file);
    for (Case& one : file.cases)
        one.replace("formatted", format(parse(source_text_of(one), options_of(one))));
    if (const std::string after = write_case_file(file); after != before)
        std::ofstream(std::string(IECFRONT_SOURCE_DIR) + '/' + file.path, std::ios::binary)
            << after;
}

TEST(Layouts, AreAsExpected) {
    for (const RepositoryFile& text : repository_files({"tests/format/layouts"}, {".txt"})) {
        const CaseFile file = read_case_file(text.path, text.text);
        EXPECT_TRUE(file.faults.empty()) << file.path;
        if (updating()) {
            update(file);
            continue;
        }
        for (const Case& one : file.cases) {
            const std::string found = trimmed(format(parse(source_text_of(one), options_of(one))));
            const std::string expected = trimmed(one.expected("formatted"));
            EXPECT_EQ(found, expected) << file.path << ": " << one.title << '\n'
                                       << line_diff(expected, found);
        }
    }
}

} // namespace
} // namespace iecfront::test
