#include "support/repository_files.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront {
namespace {

/// `text` with each run of white space made one blank.
std::string normalized(std::string_view text) {
    std::istringstream words{std::string(text)};
    std::string result;
    for (std::string word; words >> word;)
        result += (result.empty() ? "" : " ") + word;
    return result;
}

/// True when a production begins at line `i`: `name = ...`, or the name alone with `=` on the next.
bool begins_production(const std::vector<std::string_view>& lines, std::size_t i) {
    const auto letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    };
    const std::string_view line = lines[i];
    const auto name_end = std::find_if_not(line.begin(), line.end(), letter);
    if (name_end == line.begin())
        return false;
    std::string rest = normalized(line.substr(static_cast<std::size_t>(name_end - line.begin())));
    if (rest.empty() && i + 1 < lines.size())
        rest = normalized(lines[i + 1]);
    return rest.starts_with("= ");
}

/// The productions in `lines`, by name: each from a line `name = ...` to the line that ends in `
/// ;`.
template<class Visit>
void for_each_production(const std::vector<std::string_view>& lines, Visit visit) {
    std::string production;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view line = lines[i];
        if (production.empty() && !begins_production(lines, i))
            continue;
        production += std::string(line) + "\n";
        if (!line.ends_with(" ;"))
            continue;
        const std::string text = normalized(production);
        visit(text.substr(0, text.find(' ')), text);
        production.clear();
    }
}

/// The lines inside the fences of docs/grammar.md that are marked `ebnf`.
std::map<std::string, std::string> documented() {
    std::map<std::string, std::string> result;
    for (const auto& file : test::repository_files({"docs"}, {"grammar.md"})) {
        std::vector<std::string_view> lines;
        bool inside = false;
        for (const std::string_view line : test::lines_of(file.text)) {
            if (line.starts_with("```"))
                inside = line == "```ebnf";
            else if (inside)
                lines.push_back(line);
        }
        for_each_production(lines, [&](const std::string& name, const std::string& text) {
            EXPECT_TRUE(result.emplace(name, text).second) << name << " stands there twice";
        });
    }
    return result;
}

// 1.5.1 i): the parser and the formal syntax do not drift apart.
TEST(Grammar, TheParserQuotesItsProductions) {
    const auto productions = documented();
    ASSERT_GT(productions.size(), 200U);
    std::size_t quoted = 0;
    for (const auto& file : test::repository_files({"src"}, {".cpp"})) {
        if (!file.path.starts_with("src/parser/"))
            continue;
        std::vector<std::string_view> comments;
        for (std::string_view line : test::lines_of(file.text)) {
            if (line.starts_with("// "))
                comments.push_back(line.substr(3));
        }
        for_each_production(comments, [&](const std::string& name, const std::string& text) {
            ++quoted;
            ASSERT_TRUE(productions.contains(name)) << file.path << ": " << name;
            EXPECT_EQ(text, productions.at(name)) << file.path;
        });
    }
    EXPECT_GT(quoted, 70U);
}

} // namespace
} // namespace iecfront
