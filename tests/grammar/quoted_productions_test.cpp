#include "grammar/formal_syntax.hpp"
#include "support/repository_files.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <string_view>

namespace iecfront::test {
namespace {

/// The comments of a source, without their slashes. A production begins a line there and ends in
/// ` ;`; the reader of the page reads them when they stand in a block.
[[nodiscard]] std::string block_of_productions(std::string_view source) {
    std::string block = "```ebnf\n";
    bool inside = false;
    for (std::string_view line : lines_of(source)) {
        if (!line.starts_with("// "))
            continue;
        line.remove_prefix(3);
        const std::size_t name_end =
            line.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_");
        inside = inside ||
                 (name_end != 0 && line.substr(std::min(name_end, line.size())).starts_with(" = "));
        if (inside)
            block += std::string(line) + "\n";
        inside = inside && !line.ends_with(" ;");
    }
    return block + "```\n";
}

// 1.5.1 i): the parser and the formal syntax do not drift apart.
TEST(QuotedProductions, AreThoseOfTheFormalSyntax) {
    std::size_t quoted = 0;
    for (const auto& file : repository_files({"src"}, {".cpp"})) {
        if (!file.path.starts_with("src/parser/"))
            continue;
        for (const Production& production :
             read_grammar(block_of_productions(file.text)).productions) {
            ++quoted;
            const Production* documented = formal_syntax().grammar.find(production.name);
            ASSERT_NE(documented, nullptr) << file.path << ": " << production.name;
            EXPECT_EQ(production.text, documented->text) << file.path;
        }
    }
    EXPECT_GT(quoted, 70U);
}

} // namespace
} // namespace iecfront::test
