#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <string>
#include <string_view>

namespace iecfront {
namespace {

/// A beginning, then one piece again and again, a word between, and another piece as often.
struct HostileText {
    std::string_view begin;
    std::string_view first;
    std::string_view between;
    std::string_view second;
};

[[nodiscard]] std::string text_of(const HostileText& hostile, std::size_t size) {
    std::string text(hostile.begin);
    while (text.size() < size / 2)
        text += hostile.first;
    text += hostile.between;
    while (text.size() < size)
        text += hostile.second;
    return text;
}

// Each of these would take minutes if a mistake looked for its meaning in all of its line.
TEST(HostileText, TakesLinearTime) {
    for (const HostileText& hostile : {
             HostileText{"PROGRAM p CASE a OF ", "T ", "a:", "'"},
             HostileText{"PROGRAM p CASE a OF ", "a b ", "LD ", ", "},
             HostileText{"FUNCTION f : INT\n", "ELSE IF ", "VAR_ACCESS ", "3("},
             HostileText{"CONFIGURATION c ", "VAR_ACCESS ", ";", "3.."},
             HostileText{"PROGRAM p CASE a OF ", "THEN ", "VAR_ACCESS ", "%"},
             HostileText{"PROGRAM p VAR ", "x[", "OF ", "END_VAR "},
             HostileText{"", "END_TYPE ", "FUNCTION ", "%"},
             HostileText{"PROGRAM p IF a THEN ", "VAR_ACCESS ", "INT#5 ", "x."},
             HostileText{"PROGRAM p x(", "-END_WHILE ", "END_FOR ", "*x:="},
             HostileText{"PROGRAM p ", "x := ", "'", ") "},
             HostileText{"PROGRAM p ", "x := ", "'", "$';"},
             HostileText{"PROGRAM p x := ", "'a'b", "\n", "a +\n"},
             HostileText{"PROGRAM p x := ", "\"a\"b'", "\n", "1 <<\n y[i].z"},
             HostileText{"PROGRAM p ", "REPEAT UNTILL a ", "\n", "x += "},
             HostileText{"PROGRAM p VAR ", "INT x, y : INT AT %I1 ", "\n", "!a | "},
             HostileText{"FUNCTION_BLOCK b VAR_INPUT a : INT := ", "(a:=2.5 3(", ":= ", "a:"},
         }) {
        const std::string text = text_of(hostile, 1U << 19U);
        EXPECT_EQ(parse(SourceText(text)).size(), text.size());
    }
}

} // namespace
} // namespace iecfront
