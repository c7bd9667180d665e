#include "support/count_nodes.hpp"
#include "support/tree_faults.hpp"

#include <iecfront/ast/dump.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

namespace iecfront {
namespace {

using test::count_nodes;
using test::tree_fault;

std::string repeated(std::string_view text, std::size_t times) {
    std::string result;
    for (std::size_t i = 0; i < times; ++i)
        result += text;
    return result;
}

std::string program(const std::string& statements) {
    return "PROGRAM p\nVAR x : INT; END_VAR\n" + statements + "\nEND_PROGRAM\n";
}

std::size_t count(const SyntaxTree& tree, DiagnosticId id) {
    const auto found = tree.diagnostics();
    return static_cast<std::size_t>(
        std::count_if(found.begin(), found.end(), [id](const auto& one) { return one.id == id; }));
}

TEST(Parse, GivesOneUnitForNoText) {
    const SyntaxTree tree = parse(SourceText(""));
    ASSERT_EQ(tree.slots().size(), 1U);
    EXPECT_TRUE(tree.slots()[0].unit->root().elements.empty());
    EXPECT_TRUE(tree.diagnostics().empty());
}

// B.0: each library element declaration is a unit of its own.
TEST(Parse, GivesAUnitForEachLibraryElement) {
    const SyntaxTree tree = parse(SourceText("TYPE T : INT; END_TYPE (* c *)\n"
                                             "FUNCTION f : T VAR_INPUT a : T; END_VAR f := a;\n"
                                             "END_FUNCTION\n"));
    ASSERT_EQ(tree.slots().size(), 2U);
    // What stands on the line of the end belongs to it.
    EXPECT_EQ(tree.slots()[0].unit->text(), "TYPE T : INT; END_TYPE (* c *)");
    EXPECT_EQ(tree.slots()[1].first_line, 0U);
    EXPECT_TRUE(tree.diagnostics().empty());
}

// Of a large text, some tokens are held at a time.
TEST(Parse, GivesTheUnitsOfALargeTextAsAlone) {
    std::string text;
    for (const std::size_t statements : {1U, 9U, 900U, 2U, 5000U, 3U, 0U, 700U, 40U})
        text += program(repeated("x := x + {p} 1; (* c *) y__ := 'a;\n", statements)) + ";;;;;;;\n";
    const SyntaxTree tree = parse(SourceText(text));
    ASSERT_EQ(tree.slots().size(), 9U);
    for (const auto& slot : tree.slots()) {
        const SyntaxTree alone = parse(SourceText(std::string(slot.unit->text())));
        ASSERT_EQ(alone.slots().size(), 1U);
        EXPECT_TRUE(*alone.slots()[0].unit == *slot.unit) << slot.offset;
    }
}

// Units of a large text share blocks of memory. Some take more of it than is expected of so many
// tokens, so that there is not enough left of a block; one takes more than a block.
std::string text_of_many_blocks() {
    std::string some;
    for (std::size_t count = 100; count <= 3000; count += 100)
        some += program(repeated("x := x + {p} 1; (* c *)\n", count / 4)) + ";;;;;;;\n" +
                program(repeated("NOT\n", count)) + "TYPE t : POINTER TO INT; END_TYPE\n";
    const std::string large = program(repeated("x := 1; y__ := 'a;\n", 20'000));
    return some + large + some + large;
}

TEST(Parse, GivesUnitsThatShareABlockAsAlone) {
    const std::string text = text_of_many_blocks();
    const SyntaxTree tree = parse(SourceText(text));
    ASSERT_EQ(tree.slots().size(), 182U);
    EXPECT_EQ(tree_fault(tree, text), "");
    for (const auto& slot : tree.slots()) {
        const SyntaxTree alone = parse(SourceText(std::string(slot.unit->text())));
        EXPECT_TRUE(*alone.slots()[0].unit == *slot.unit) << slot.offset;
    }
}

TEST(Parse, LeavesAUnitToWhoHoldsItAlone) {
    const std::shared_ptr<const Unit> unit =
        parse(SourceText(text_of_many_blocks())).slots()[1].unit;
    const SyntaxTree alone = parse(SourceText(std::string(unit->text())));
    EXPECT_TRUE(*alone.slots()[0].unit == *unit);
}

// A unit is not less refused where there is a block with room for it: neither one whose tree is too
// large, nor one where it takes more than its tree to find the token that is out of place.
TEST(Parse, RefusesAUnitWhateverFollows) {
    const std::string sum = repeated(" + d", 1750);
    const std::string rest = "\nPROGRAM q (*" + std::string(300'000, 'x') + "*) END_PROGRAM";
    ParseOptions options;
    for (const std::uint32_t nesting : {8U, 2000U}) {
        options.maximum_nesting = nesting;
        for (const std::string& unit : {"PROGRAM p a := b" + sum + "; END_PROGRAM",
                                        "PROGRAM p a := b c" + sum + "; END_IF; END_PROGRAM"}) {
            for (std::uint32_t maximum = 20'000; maximum < 100'000; maximum += 500) {
                options.maximum_unit_memory = maximum;
                const SyntaxTree alone = parse(SourceText(unit), options);
                const SyntaxTree first = parse(SourceText(unit + rest), options);
                EXPECT_TRUE(*alone.slots()[0].unit == *first.slots()[0].unit)
                    << nesting << " " << maximum;
            }
        }
    }
}

// What is read is not kept for the sake of findings alone, and no memory is taken for more of them.
TEST(Parse, RefusesAUnitForItsFindings) {
    ParseOptions options;
    options.maximum_unit_memory = 100'000;
    const std::size_t most = options.maximum_unit_memory / ParseOptions::memory_of_finding;
    for (const std::string fault : {"x := ;\n", "x := %;\n", "IF THEN ; END_IF;\n", "LD a b\n"}) {
        for (const std::size_t count : {most / 10, 2 * most, 100 * most}) {
            const SyntaxTree tree =
                parse(SourceText("PROGRAM p\n" + repeated(fault, count) + "END_PROGRAM"), options);
            const Unit& unit = *tree.slots().front().unit;
            EXPECT_EQ(unit.diagnostics().front().id == DiagnosticId::unit_too_large, count > most)
                << fault << count;
            EXPECT_LE(unit.diagnostics().size(), most);
        }
    }
}

TEST(Parse, KeepsErrorsOfOneUnitFromAnother) {
    const std::string good =
        "FUNCTION g : INT\nVAR_INPUT a : INT; END_VAR\ng := a;\nEND_FUNCTION\n";
    const SyntaxTree alone = parse(SourceText(good));
    for (const std::string bad :
         {"FUNCTION b : INT\nVAR_INPUT a : INT\nb := (a;\nIF a THEN\nEND_FUNCTION\n",
          "TYPE T : STRUCT a : INT;\nEND_TYPE\n",
          "PROGRAM p\nVAR x : INT;\nx := 'open\nEND_PROGRAM\n",
          "FUNCTION_BLOCK b\nVAR x : INT; END_VAR\nREPEAT\nx := 1;\n"}) {
        const SyntaxTree tree = parse(SourceText(bad + good));
        ASSERT_GE(tree.slots().size(), 2U) << bad;
        const Unit& unit = *tree.slots().back().unit;
        EXPECT_TRUE(unit.diagnostics().empty()) << bad;
        EXPECT_EQ(s_expression(unit, unit.root()),
                  s_expression(*alone.slots()[0].unit, alone.slots()[0].unit->root()))
            << bad;
    }
}

// 3.3.1: the length of an expression is not limited; its nesting is, by an option.
TEST(Parse, ReadsAChainOfAMillionOperands) {
    const SyntaxTree tree =
        parse(SourceText(program("x := 0" + repeated(" + 1", 1'000'000) + ";")));
    EXPECT_TRUE(tree.diagnostics().empty());
    EXPECT_EQ(count_nodes(tree, ast::NodeKind::binary_expression), 1'000'000U);
    EXPECT_TRUE(tree == parse(tree.source()));
}

// 3.3.2.2: nor is the number of arguments, a line each.
TEST(Parse, ReadsALongListOfArguments) {
    const SyntaxTree tree =
        parse(SourceText(program("f(\n" + repeated("a := 1,\n", 1'000) + "a := 1);")));
    EXPECT_TRUE(tree.diagnostics().empty());
}

TEST(Parse, ReportsParenthesesThatNestTooDeep) {
    const auto nested = [](std::size_t depth) {
        return SourceText(
            program("x := " + repeated("(", depth) + "1" + repeated(")", depth) + ";"));
    };
    EXPECT_TRUE(parse(nested(10), {.maximum_nesting = 10}).diagnostics().empty());
    const SyntaxTree beyond = parse(nested(11), {.maximum_nesting = 10});
    EXPECT_EQ(count(beyond, DiagnosticId::nesting_too_deep), 1U);
    EXPECT_EQ(beyond.diagnostics().size(), 1U);
    for (const std::size_t depth : {1'000U, 100'000U}) {
        const SyntaxTree deep = parse(nested(depth));
        EXPECT_EQ(count(deep, DiagnosticId::nesting_too_deep), 1U);
        EXPECT_EQ(deep.diagnostics().size(), 1U);
    }
}

TEST(Parse, SurvivesEveryKindOfDeepNesting) {
    for (const auto& [open, close] : {std::pair{"IF TRUE THEN ", " END_IF;"},
                                      {"REPEAT ", " UNTIL TRUE END_REPEAT;"},
                                      {"- ", ""},
                                      {"x[", "]"},
                                      {"f(", ")"},
                                      {"CASE x OF 1: ", " END_CASE;"}}) {
        const SyntaxTree tree =
            parse(SourceText(program(repeated(open, 20'000) + ";" + repeated(close, 20'000))));
        EXPECT_EQ(count(tree, DiagnosticId::nesting_too_deep), 1U) << open;
    }
    const std::string declarations = "VAR a : " + repeated("ARRAY [1..2] OF ", 20'000) +
                                     "INT := " + repeated("[", 20'000) + repeated("]", 20'000) +
                                     "; END_VAR ";
    EXPECT_GE(count(parse(SourceText("PROGRAM p " + declarations + "; END_PROGRAM")),
                    DiagnosticId::nesting_too_deep),
              1U);
    const std::string structures =
        repeated("STRUCT a : ", 20'000) + "INT;" + repeated(" END_STRUCT;", 20'000);
    EXPECT_EQ(count(parse(SourceText("TYPE t : " + structures + " END_TYPE")),
                    DiagnosticId::nesting_too_deep),
              1U);
}

// 2.2.2: the same two characters in three encodings, and as codes.
// The second reading of a unit has as much room as the first one.
TEST(Parse, FindsTheMisplacedTokenOfALongUnit) {
    const auto findings_with = [](std::size_t statements) {
        std::string text = "FUNCTION F : INT\nVAR_INPUT\na : INT;\nEND_VAR\nEND_STRUCT VAR\n"
                           "b : INT;\nEND_VAR\n";
        for (std::size_t i = 0; i < statements; ++i)
            text += "F := -a;\n";
        return parse(SourceText(text + "END_FUNCTION\n")).diagnostics();
    };
    const std::vector<Diagnostic> found = findings_with(3);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].id, DiagnosticId::unexpected_token);
    for (const std::size_t statements : {1000U, 2000U, 5000U, 20'000U})
        EXPECT_EQ(findings_with(statements), found) << statements;
}

// The least `maximum_unit_memory` with which the last unit of a text is read.
std::uint32_t least_memory(const SourceText& source) {
    std::uint32_t refused = 0;
    std::uint32_t enough = 10'000'000;
    while (enough - refused > 1) {
        ParseOptions options;
        options.maximum_unit_memory = refused + (enough - refused) / 2;
        const SyntaxTree tree = parse(source, options);
        const bool read = !tree.slots().back().unit->tokens().empty();
        (read ? enough : refused) = options.maximum_unit_memory;
    }
    return enough;
}

// A unit depends on nothing but its own text and the options: not on the room that was made for one
// before it, nor on what it took to find the misplaced token.
TEST(Parse, RefusesAUnitForItsOwnSizeOnly) {
    std::string statements;
    for (int i = 0; i < 12'000; ++i)
        statements += "F := -a;\n";
    const std::string head = "FUNCTION F : INT\nVAR_INPUT\na : INT;\nEND_VAR\n";
    const std::string end = "END_FUNCTION\n";
    const std::string large = head + statements + statements + statements + end;
    const std::string unit = head + "END_STRUCT VAR\nb : INT;\nEND_VAR\n" + statements + end;
    const std::uint32_t alone = least_memory(SourceText(unit));
    EXPECT_EQ(least_memory(SourceText(large + unit)), alone);
    const std::string correct = head + "VAR\nb : INT;\nEND_VAR\n" + statements + end;
    EXPECT_EQ(alone,
              least_memory(SourceText(correct)) + sizeof(Token) + ParseOptions::memory_of_finding);
}

TEST(Parse, KeepsTheEncodingOfATextThatIsTooLarge) {
    ParseOptions options;
    options.maximum_source_size = 3;
    const SyntaxTree tree = parse(SourceText("TYPE", {}, Encoding::windows_1252), options);
    EXPECT_EQ(tree.encoding(), Encoding::windows_1252);
    EXPECT_EQ(tree.slots()[0].unit->encoding(), Encoding::windows_1252);
}

TEST(Parse, ReadsStringsInEachEncoding) {
    EXPECT_TRUE(parse(SourceText(program("x := '\xC3\x84\xC3\x8B';"))).diagnostics().empty());
    for (const Encoding encoding : {Encoding::iso_8859_1, Encoding::windows_1252})
        EXPECT_TRUE(
            parse(SourceText(program("x := '\xC4\xCB';"), {}, encoding)).diagnostics().empty());
    EXPECT_EQ(count(parse(SourceText(program("x := '\xC4\xCB';"))), DiagnosticId::broken_encoding),
              1U);
}

// A.1.1: three ways to end a line; the trees differ in nothing but the text between tokens.
TEST(Parse, ReadsEveryLineEnd) {
    const std::string text = program("x := 1;\n\n(* c *) IF x = 1 THEN\nx := 2;\nEND_IF;");
    const SyntaxTree reference = parse(SourceText(text));
    for (const std::string end : {"\r\n", "\r"}) {
        std::string changed;
        for (const char c : text)
            changed += c == '\n' ? end : std::string(1, c);
        const SyntaxTree tree = parse(SourceText(changed));
        EXPECT_TRUE(tree.diagnostics().empty());
        EXPECT_TRUE(ast::equal(tree.slots()[0].unit->root(), reference.slots()[0].unit->root()));
        EXPECT_EQ(tree.position(tree.size()).line, reference.position(reference.size()).line);
    }
}

TEST(Parse, KeepsAByteOrderMark) {
    const SyntaxTree tree = parse(SourceText("\xEF\xBB\xBF" + program("x := 1;")));
    EXPECT_TRUE(tree.diagnostics().empty());
    EXPECT_EQ(tree.source().bytes().substr(0, 3), "\xEF\xBB\xBF");
}

TEST(Parse, GivesTheSameForSharedText) {
    const SourceText source(program("x := 1"));
    EXPECT_TRUE(parse(source) == parse(source));
    EXPECT_EQ(parse(source).source().buffer(), source.buffer());
}

} // namespace
} // namespace iecfront
