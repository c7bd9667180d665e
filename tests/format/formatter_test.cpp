#include <iecfront/format/formatter.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>

namespace iecfront {
namespace {

[[nodiscard]] std::string formatted(std::string text, const FormatOptions& options = {},
                                    const ParseOptions& parsing = {}) {
    return format(parse(SourceText(std::move(text)), parsing), options);
}

TEST(Formatter, SpellsKeywordsAsItIsTold) {
    const std::string text = "Program p If a THEN b := true; end_if; END_PROGRAM\n";
    EXPECT_EQ(formatted(text), "PROGRAM p\n    IF a THEN\n        b := TRUE;\n    END_IF;\n"
                               "END_PROGRAM\n");
    EXPECT_EQ(formatted(text, {KeywordCase::lower}),
              "program p\n    if a then\n        b := true;\n    end_if;\nend_program\n");
    EXPECT_EQ(formatted(text, {KeywordCase::keep}),
              "Program p\n    If a THEN\n        b := true;\n    end_if;\nEND_PROGRAM\n");
}

TEST(Formatter, SpellsOperatorsAndQualifiersAsKeywords) {
    EXPECT_EQ(formatted("PROGRAM p\nld x\njmpcn y\nEND_PROGRAM\n"),
              "PROGRAM p\n        LD    x\n        JMPCN y\nEND_PROGRAM\n");
    EXPECT_EQ(formatted("PROGRAM p\nINITIAL_STEP s: a(sd, T#1s); END_STEP\nEND_PROGRAM\n"),
              "PROGRAM p\n    INITIAL_STEP s:\n        a(SD, T#1s);\n    END_STEP\nEND_PROGRAM\n");
}

TEST(Formatter, IndentsAsItIsTold) {
    FormatOptions options;
    options.indent_width = 2;
    EXPECT_EQ(formatted("TYPE a : INT; END_TYPE", options), "TYPE\n  a : INT;\nEND_TYPE\n");
    options.indent_width = 0;
    EXPECT_EQ(formatted("TYPE\n\t\ta : INT;\nEND_TYPE", options), "TYPE\na : INT;\nEND_TYPE\n");
}

TEST(Formatter, LeavesWhatWasNotReadAsItIs) {
    const std::string text = "type\n\t\ta : int;  end_type\n";
    ParseOptions parsing;
    parsing.maximum_unit_memory = 100;
    EXPECT_EQ(formatted(text, {}, parsing), text);
    parsing = {};
    parsing.maximum_source_size = 10;
    EXPECT_EQ(formatted(text, {}, parsing), text);
}

TEST(Formatter, BreaksLinesAsItIsTold) {
    FormatOptions options;
    options.line_length = 20;
    EXPECT_EQ(formatted("PROGRAM p f(aaaa, bbbb, cccc); END_PROGRAM", options),
              "PROGRAM p\n    f(aaaa, bbbb,\n      cccc);\nEND_PROGRAM\n");
}

TEST(Formatter, KeepsLineEnds) {
    EXPECT_EQ(formatted("TYPE\r\na : INT; END_TYPE"), "TYPE\r\n    a : INT;\r\nEND_TYPE\r\n");
    EXPECT_EQ(formatted("TYPE\ra : INT; END_TYPE"), "TYPE\r    a : INT;\rEND_TYPE\r");
    EXPECT_EQ(formatted("TYPE\na : INT;\r\nEND_TYPE"), "TYPE\n    a : INT;\nEND_TYPE\n");
    EXPECT_EQ(formatted("(* a\r\nb *)\nTYPE\n{c\rd}\na : INT; END_TYPE"),
              "(* a\nb *)\nTYPE\n    {c\nd}\n    a : INT;\nEND_TYPE\n");
    EXPECT_EQ(formatted("(* a\r\nb *)"), "(* a\r\nb *)\r\n");
}

TEST(Formatter, KeepsTheByteOrderMark) {
    EXPECT_EQ(formatted("\xEF\xBB\xBF\n TYPE a : INT; END_TYPE"),
              "\xEF\xBB\xBFTYPE\n    a : INT;\nEND_TYPE\n");
    EXPECT_EQ(formatted("\xEF\xBB\xBFTYPE  (* a\nb *)\n    t : INT;\nEND_TYPE\n"),
              "\xEF\xBB\xBFTYPE  (* a\nb *)\n    t : INT;\nEND_TYPE\n");
    EXPECT_EQ(formatted("\xEF\xBB\xBF"), "\xEF\xBB\xBF");
}

TEST(Formatter, CountsCharactersAndNotBytes) {
    EXPECT_EQ(formatted("PROGRAM p\na := '\xC3\x84'; (* a *)\nbbb := ''; (* b *)\nEND_PROGRAM\n"),
              "PROGRAM p\n    a := '\xC3\x84';   (* a *)\n    bbb := '';  (* b *)\nEND_PROGRAM\n");
}

TEST(Formatter, MakesNothingOfNothing) {
    EXPECT_EQ(formatted(""), "");
    EXPECT_EQ(formatted(" \n\t\n"), "");
    EXPECT_EQ(formatted("\n\n(* alone *)"), "(* alone *)\n");
}

TEST(Formatter, TakesFragments) {
    EXPECT_EQ(formatted("a:=1;b:=2;", {}, {FragmentKind::statement_list}), "a := 1;\nb := 2;\n");
    EXPECT_EQ(formatted("a+b", {}, {FragmentKind::expression}), "a + b\n");
    EXPECT_EQ(
        formatted("VAR a:INT;END_VAR VAR b:INT;END_VAR", {}, {FragmentKind::variable_declarations}),
        "VAR\n    a : INT;\nEND_VAR\nVAR\n    b : INT;\nEND_VAR\n");
    EXPECT_EQ(formatted("x:\nLD a\n", {}, {FragmentKind::body}), "x:\n    LD    a\n");
}

TEST(Formatter, KeepsBrokenBytes) {
    const std::string broken = "PROGRAM p\n   a  :=\xFF '\x80';\nEND_PROGRAM\n";
    EXPECT_EQ(formatted(broken), broken);
}

[[nodiscard]] std::string repeated(std::string_view text, std::size_t count) {
    std::string result;
    for (std::size_t i = 0; i < count; ++i)
        result += text;
    return result;
}

// Squares of these numbers would take minutes.
TEST(Formatter, TakesTimeInProportionToTheText) {
    constexpr std::size_t many = 100'000;
    const auto program = [](const std::string& body) {
        return "PROGRAM p " + body + " END_PROGRAM";
    };
    for (const std::string& text :
         {program("x := " + repeated("a + (b) * ", many) + "c;"),
          program(repeated("f(a, (* c *) b); (* d *) ", many)),
          program("f(" + repeated("(* a *) ", many) + "b);"),
          program(repeated("(* a\n a *)\n", many) + ";"),
          program(repeated("\n(* a *)", many) + repeated(" (* b *)", many) + " ;"),
          program(repeated("x := 1 2; ", many)),
          program("x := 'a" + repeated("\xC3\x84", many) + "';"),
          repeated("TYPE t : INT; END_TYPE ", many)})
        EXPECT_GT(formatted(text).size(), text.size() / 2);
}

// What stands behind, or is continued below, very long lines: were it moved as far to the right,
// the results had some hundreds of megabytes.
TEST(Formatter, GivesTextInProportionToTheText) {
    constexpr std::size_t many = 10'000;
    const std::string name(many, 'a');
    const std::string selection = "a" + repeated(".b", many);
    const auto program = [](const std::string& body) {
        return "PROGRAM p\n" + body + "\nEND_PROGRAM\n";
    };
    for (const std::string& text :
         {program("x := '" + name + "'; (* c *)\n" + repeated("y := 1; (* c *)\n", many)),
          program(selection + " := 1" + repeated("\n+ 1", many) + ";"),
          program("x := " + selection + "[1" + repeated(",\n1", many) + "];"),
          program(name + "(a := 1" + repeated(",\nb := 1", many) + ");"),
          program(name + "((* c" + repeated("\n d", many) + " *) a := 1);"),
          program("x := '" + name + "'; (* c" + repeated("\n d", many) + " *)"),
          program("a" + repeated("\n.\nb", many) + " := 1; (* c" + repeated("\n d", many) + " *)"),
          program(repeated("IF a THEN ", 200) + repeated(";", many) + repeated("END_IF; ", 200)),
          program(std::string(many, ' ') + "(* c" + repeated("\n d", many) + " *) ;"),
          repeated("f(a := 1) .\n", many),
          "TYPE t : " + repeated("THNE (* c\n d *)", many) + ". // c\nEND_PROGRAM ",
          "TYPE t : STRUCT\n" + name + " : INT;\n" + repeated("b : INT; // c\n", many) +
              "END_STRUCT; END_TYPE"}) {
        const std::string result = formatted(text);
        EXPECT_LT(result.size(), 100 * text.size()) << text.substr(0, 50);
        EXPECT_TRUE(formatted(result) == result) << text.substr(0, 50);
    }
}

TEST(Formatter, MovesNothingBeyondTheLineLength) {
    FormatOptions options;
    options.line_length = 30;
    const std::string text = "PROGRAM p\n"
                             "    x := 'a rather long string, this'; (* a *)\n"
                             "    y := 1; (* b *)\n"
                             "    x_with_a_name_of_more_columns := 1\n"
                             "    + 1;\n"
                             "END_PROGRAM\n";
    EXPECT_EQ(formatted(text, options), "PROGRAM p\n"
                                        "    x := 'a rather long string, this';  (* a *)\n"
                                        "    y := 1;  (* b *)\n"
                                        "    x_with_a_name_of_more_columns := 1\n"
                                        "                              + 1;\n"
                                        "END_PROGRAM\n");
}

TEST(Formatter, TakesTheLargestOptionsForLargerOnes) {
    FormatOptions options;
    options.indent_width = 0xFFFF'FFFF;
    options.line_length = 0xFFFF'FFFF;
    const std::string text = "TYPE a : INT; END_TYPE";
    EXPECT_EQ(formatted(text, options), "TYPE\n                a : INT;\nEND_TYPE\n");
}

} // namespace
} // namespace iecfront
