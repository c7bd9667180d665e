#include "support/edit_faults.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <string>

namespace iecfront {
namespace {

std::string function(int number) {
    const std::string name = "f" + std::to_string(number);
    return "FUNCTION " + name + " : INT\nVAR_INPUT a : INT; END_VAR\n" + name +
           " := a;\nEND_FUNCTION\n";
}

std::string library(int functions) {
    std::string text;
    for (int i = 0; i < functions; ++i)
        text += function(i);
    return text;
}

TextRange place_of(const SyntaxTree& tree, std::string_view words) {
    const auto begin = static_cast<std::uint32_t>(tree.source().bytes().find(words));
    return {begin, begin + static_cast<std::uint32_t>(words.size())};
}

std::size_t shared_units(const SyntaxTree& a, const SyntaxTree& b) {
    std::size_t shared = 0;
    for (const auto& one : a.slots())
        for (const auto& other : b.slots())
            shared += one.unit == other.unit ? 1 : 0;
    return shared;
}

TEST(Edit, SharesTheUnitsItDoesNotTouch) {
    const SyntaxTree tree = parse(SourceText(library(50)));
    ASSERT_EQ(tree.slots().size(), 50U);
    const SyntaxTree edited = tree.edited(place_of(tree, "f25 := a"), "f25 := a + 1");
    EXPECT_TRUE(edited == parse(edited.source()));
    EXPECT_GE(shared_units(tree, edited), 45U);
}

TEST(Edit, SplitsAndJoinsUnits) {
    const SyntaxTree tree = parse(SourceText(library(10)));
    const SyntaxTree joined = tree.edited(place_of(tree, "END_FUNCTION\nFUNCTION f3"), "");
    EXPECT_TRUE(joined == parse(joined.source()));
    EXPECT_EQ(joined.slots().size(), 9U);
    const SyntaxTree split =
        tree.edited(place_of(tree, "f5 := a;"), "END_FUNCTION FUNCTION g : INT VAR");
    EXPECT_TRUE(split == parse(split.source()));
}

TEST(Edit, OpensAndClosesAComment) {
    const SyntaxTree tree = parse(SourceText(library(10) + "(* last *)\n"));
    const SyntaxTree opened = tree.edited({0, 0}, "(* ");
    EXPECT_TRUE(opened == parse(opened.source()));
    const SyntaxTree closed = opened.edited({3, 3}, "*) ");
    EXPECT_TRUE(closed == parse(closed.source()));
    const SyntaxTree back = closed.edited({0, 6}, "");
    EXPECT_TRUE(back == tree);
}

// A comment that nothing closes ends at its line, until an edit far behind closes it.
TEST(Edit, ReadsAgainWhatDependsOnTheRest) {
    const SyntaxTree tree = parse(SourceText("(* open\n" + library(10)));
    const SyntaxTree closed = tree.edited({tree.size(), tree.size()}, "*)");
    EXPECT_TRUE(closed == parse(closed.source()));
    EXPECT_EQ(closed.slots().size(), 1U);
}

TEST(Edit, TakesAnyRange) {
    const SyntaxTree tree = parse(SourceText(library(2)));
    const std::uint32_t size = tree.size();
    EXPECT_TRUE(tree.edited({5, 2}, "x") == tree.edited({2, 5}, "x"));
    EXPECT_TRUE(tree.edited({10, size + 5}, "") == tree.edited({10, size}, ""));
    EXPECT_TRUE(tree.edited({size + 3, size + 9}, ";") == tree.edited({size, size}, ";"));
}

TEST(Edit, GrowsFromNothingAndShrinksToNothing) {
    const std::string text = library(3);
    SyntaxTree tree = parse(SourceText(""));
    for (const char c : text)
        tree = tree.edited({tree.size(), tree.size()}, std::string_view(&c, 1));
    EXPECT_TRUE(tree == parse(SourceText(text)));
    while (tree.size() > 0) {
        tree = tree.edited({0, 1}, "");
        ASSERT_TRUE(tree == parse(tree.source())) << tree.source().bytes();
    }
}

TEST(Edit, LeavesTheOldTreeAsItWas) {
    const SyntaxTree tree = parse(SourceText(library(3)));
    const SyntaxTree copy = tree;
    (void)tree.edited({0, tree.size()}, "");
    EXPECT_TRUE(tree == copy);
    EXPECT_EQ(tree.source().bytes(), library(3));
}

// A finding behind the last token of a unit belongs to that unit.
TEST(Edit, KeepsWhatIsMissingAtTheEndOfAUnit) {
    const SyntaxTree tree = parse(SourceText("TYPE %//\n" + library(3)));
    const SyntaxTree edited = tree.edited(place_of(tree, "f2 := a"), "f2 := b");
    EXPECT_TRUE(edited == parse(edited.source()));
    EXPECT_EQ(edited.slots()[0].unit->diagnostics().front().id,
              DiagnosticId::unknown_location_prefix);
}

// A point can belong to the closing word before it, although a unit ends there.
TEST(Edit, ReadsAPointWithTheWordBeforeIt) {
    const SyntaxTree tree =
        parse(SourceText(library(3) + "END_TYPE.5 a b c d e f g h\n" + library(3)));
    const SyntaxTree before = tree.edited(place_of(tree, "f2 := a"), "f2 := b");
    EXPECT_TRUE(before == parse(before.source()));
    const SyntaxTree behind = tree.edited(place_of(tree, "g h\nFUNCTION"), "g\nFUNCTION");
    EXPECT_TRUE(behind == parse(behind.source()));
}

// What the lexer takes for MOD and OR stands alone: behind other text it is a part of something
// else.
TEST(Edit, ReadsASignOfAnotherLanguageWithTheWordBeforeIt) {
    for (const std::string sign : {"%IX", "|IX", "!", "&&"}) {
        const SyntaxTree tree = parse(SourceText("PROGRAM p\n;\nEND_PROGRAM" + sign + "\n" +
                                                 function(1) + "PROGRAM q\n;\nEND_PROGRAM\n"));
        const SyntaxTree edited = tree.edited(place_of(tree, "\nPROGRAM q"), "\n;PROGRAM q");
        EXPECT_TRUE(edited == parse(edited.source())) << sign;
    }
}

// A `(` that a `*)` makes the begin of a comment does not look beyond its unit.
TEST(Edit, ReadsACommentWithoutStarAlone) {
    for (const std::string between : {" ", "\n"})
        for (const std::string end :
             {"END_PROGRAM;;", "END_FUNCTION BLOCK;", "END_PROGRAM\n;", "END_PROGRAM\nx;",
              "END_VAR;", "; END_PROGRAM THEN", "END_FUNCTION\nBLOCK x;", "END_PROGRAM\nx := 1;",
              "END_PROGRAM\n;;x b : INT;"}) {
            const std::string rest = " (foo *)" + between + "FUNCTION g : INT\n;\nEND_FUNCTION\n";
            const SyntaxTree tree = parse(SourceText("PROGRAM p\n;\n" + end + rest));
            for (std::uint32_t at = 12; at + rest.size() < tree.size(); ++at)
                for (const std::string change : {"", "x", ";"}) {
                    const SyntaxTree edited = tree.edited({at, at + 1}, change);
                    EXPECT_TRUE(edited == parse(edited.source()))
                        << end << rest << " with `" << change << "` for byte " << at;
                }
        }
    const SyntaxTree tree = parse(SourceText(
        "VAR_GLOBAL\n a : INT; (b; END_VAR x1 x2 x3 x4 x5 x6 x7 x8\n b : INT;\nEND_VAR\n"));
    const TextRange behind{place_of(tree, "x8").end, place_of(tree, "x8").end};
    const SyntaxTree edited = tree.edited(behind, " *)");
    EXPECT_TRUE(edited == parse(edited.source()));
}

// Everything in a small text is replaced by everything, so that comments, strings and units open,
// close, split and join.
TEST(Edit, EqualsAFreshTreeForEveryEditOfSmallTexts) {
    for (const char* const text : {
             "PROGRAM p ; END_PROGRAM",
             "TYPE a:INT;END_TYPE(*b*)",
             "(*a(*b*)c*) TYPE\n",
             "x'(*';{*)}'\n",
             "END_TYPE%IX1.5 TYPE",
             "F#1 \"$\"\r\nRET//",
             "/*a*/(*\n*)VAR|x;",
         })
        EXPECT_EQ(test::every_edit_fault(SourceText(text), {}), "") << text;
}

// Of what stands around a unit, an edit in it reads nothing anew.
TEST(Edit, ParsesTheUnitAlone) {
    const SyntaxTree tree = parse(SourceText(library(50)));
    for (const char* const words : {"f25 : INT", "f25 := a", "a : INT; END_VAR\nf25"}) {
        const SyntaxTree edited = tree.edited(place_of(tree, words), words + std::string(" "));
        EXPECT_TRUE(edited == parse(edited.source())) << words;
        EXPECT_EQ(shared_units(tree, edited), 49U) << words;
    }
    // What begins the unit decides about the one before it.
    const SyntaxTree edited = tree.edited(place_of(tree, "f25 : INT"), "f25 + INT");
    EXPECT_TRUE(edited == parse(edited.source()));
}

TEST(Edit, SharesTheUnitsBehindAnOpenComment) {
    const SyntaxTree tree = parse(SourceText(library(50)));
    const SyntaxTree opened = tree.edited({0, 0}, "(* ");
    EXPECT_TRUE(opened == parse(opened.source()));
    EXPECT_TRUE(opened.slots()[0].unit->depends_on_rest());
    EXPECT_GE(shared_units(tree, opened), 48U);
    const SyntaxTree typed = opened.edited(place_of(opened, "f25 := a"), "f25 := b");
    EXPECT_TRUE(typed == parse(typed.source()));
    EXPECT_GE(shared_units(opened, typed), 48U);
}

// A word that adjoins a string depends on its line, and on nothing behind it.
TEST(Edit, SharesTheUnitsBehindAString) {
    std::string text = library(50);
    text.insert(text.find("f25 := a"), "x := 'a'x;\ny := 'b;\n");
    const SyntaxTree tree = parse(SourceText(text));
    for (const auto& slot : tree.slots())
        EXPECT_FALSE(slot.unit->depends_on_rest());
    for (const char* const words : {"f25 := a", "f27 := a"}) {
        const SyntaxTree edited = tree.edited(place_of(tree, words), "z := a");
        EXPECT_TRUE(edited == parse(edited.source()));
        EXPECT_EQ(shared_units(tree, edited), 49U) << words;
    }
}

// A file begins as a line does; elsewhere that takes a line end.
TEST(Edit, ReadsAgainWhatBeganTheFile) {
    const SyntaxTree tree = parse(SourceText("x"));
    const SyntaxTree edited = tree.edited({0, 0}, "PROGRAM p;END_PROGRAM;");
    EXPECT_TRUE(edited == parse(edited.source()));
    EXPECT_TRUE(edited.edited({0, 22}, "") == tree);
}

// Whether the braces nest is decided by what stands behind them, which can be of another unit.
TEST(Edit, ReadsAgainWhatNests) {
    const SyntaxTree tree =
        parse(SourceText("x := {1 {2} PROGRAM p a b c d e f g h } j\nEND_PROGRAM\n"));
    const SyntaxTree edited = tree.edited(place_of(tree, " j\n"), "; j\n");
    EXPECT_TRUE(edited == parse(edited.source()));
}

TEST(Edit, KeepsOffsetsAndLines) {
    const SyntaxTree tree = parse(SourceText(library(9)));
    const SyntaxTree edited = tree.edited(place_of(tree, "f4 := a"), "f4 :=\n\n a");
    const SyntaxTree fresh = parse(edited.source());
    EXPECT_EQ(edited.size(), fresh.size());
    ASSERT_EQ(edited.slots().size(), fresh.slots().size());
    for (std::size_t i = 0; i < fresh.slots().size(); ++i) {
        EXPECT_EQ(edited.slots()[i].offset, fresh.slots()[i].offset);
        EXPECT_EQ(edited.slots()[i].first_line, fresh.slots()[i].first_line);
    }
}

// Once a comment is closed, no unit depends on what follows any more.
TEST(Edit, ForgetsThatACommentWasOpen) {
    const SyntaxTree tree = parse(SourceText(library(20)));
    const SyntaxTree opened = tree.edited({0, 0}, "(* ");
    const SyntaxTree closed = opened.edited({3, 3}, "*) ");
    for (const auto& slot : closed.slots())
        EXPECT_FALSE(slot.unit->depends_on_rest());
    EXPECT_GE(shared_units(opened, closed), 15U);
}

} // namespace
} // namespace iecfront
