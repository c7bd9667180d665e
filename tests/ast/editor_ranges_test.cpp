#include <iecfront/ast/editor_ranges.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <string>

using namespace iecfront;

namespace {

std::string folds(const std::string& text) {
    std::string out;
    for (const FoldingRange range : folding_ranges(parse(SourceText(text)))) {
        out += out.empty() ? "" : " ";
        out += std::to_string(range.first_line) + '-' + std::to_string(range.last_line);
        out += range.kind == FoldingKind::comment ? "c" : "";
    }
    return out;
}

TEST(FoldingRanges, FoldWhatTakesSeveralLines) {
    EXPECT_EQ(folds("PROGRAM p\nVAR\n a : INT;\nEND_VAR\nIF a = 1 THEN\n a := 2;\nEND_IF;\n"
                    "a := 1;\nEND_PROGRAM\n"),
              "1-9 2-4 5-7");
    EXPECT_EQ(folds("PROGRAM p VAR a : INT; END_VAR a := 1; END_PROGRAM\n"), "");
}

TEST(FoldingRanges, TheLongestBeginsOnALine) {
    EXPECT_EQ(folds("PROGRAM p VAR a : INT;\nEND_VAR\na := 1; END_PROGRAM\n"), "1-3");
}

TEST(FoldingRanges, CountLinesInTheFile) {
    EXPECT_EQ(folds("PROGRAM p\n;\nEND_PROGRAM\nPROGRAM q\n;\nEND_PROGRAM"), "1-3 4-6");
}

TEST(FoldingRanges, FoldCommentsThatFollowEachOther) {
    EXPECT_EQ(folds("(* a\nb *)\nPROGRAM p ; END_PROGRAM"), "1-2c");
    EXPECT_EQ(folds("(* a *)\n(* b *)\n\n(* c *)\nPROGRAM p ; END_PROGRAM"), "1-2c");
    EXPECT_EQ(folds("PROGRAM p VAR\na : INT; (* a *)\nb : INT; (* b *)\nEND_VAR ; END_PROGRAM"),
              "1-4");
}

// 2.1.5: comments may stand anywhere, and a fold of them must not take code with it.
TEST(FoldingRanges, OnlyCommentsAloneOnTheirLinesAreFoldedTogether) {
    const auto in_block = [](const std::string& lines) {
        return folds("PROGRAM p VAR\n" + lines + "END_VAR ; END_PROGRAM");
    };
    EXPECT_EQ(in_block(" a : INT; (* 1 *)\n (* 2 *) b : INT;\n"), "1-4");
    EXPECT_EQ(in_block(" a : INT; (* 1 *)\n (* about b *)\n b : INT;\n"), "1-5");
    EXPECT_EQ(in_block(" (* 1 *)\n (* 2 *) b : INT;\n"), "1-4");
    EXPECT_EQ(in_block(" (* 1 *) (* 2 *)\n (* 3 *)\n b : INT;\n"), "1-5 2-3c");
    EXPECT_EQ(in_block(" {p} (* 1 *)\n (* 2 *)\n (* 3 *)\n b : INT;\n"), "1-6 3-4c");
}

TEST(FoldingRanges, ACommentIsFoldedUpToTheCodeBehindIt) {
    EXPECT_EQ(folds("PROGRAM p\na := 1; (* 1\n2\n3 *)\n(* 4 *)\n;\nEND_PROGRAM"), "1-7 2-4c");
    EXPECT_EQ(folds("PROGRAM p\n(* 1\n2\n3 *) a := 1;\nEND_PROGRAM"), "1-5 2-3c");
}

// B.3.2.3
TEST(FoldingRanges, FoldEachBranch) {
    EXPECT_EQ(folds("PROGRAM p\nIF a THEN\n b := 1;\nELSIF c THEN\n b := 2;\nELSE\n b := 3;\n"
                    "END_IF;\nEND_PROGRAM"),
              "1-9 2-8 4-5 6-7");
    EXPECT_EQ(folds("PROGRAM p\nCASE a OF\n1:\n b := 2;\nELSE\n b := 3;\nEND_CASE;\nEND_PROGRAM"),
              "1-8 2-7 3-4 5-6");
}

// B.3.1, B.1.3.3
TEST(FoldingRanges, FoldCallsAndInitialValues) {
    EXPECT_EQ(folds("PROGRAM p\nx := f(a := 1,\n b := 2);\nx :=\n f(a,\n b\n) + 1;\nEND_PROGRAM"),
              "1-8 2-3 5-6");
    EXPECT_EQ(folds("PROGRAM p\nVAR\na : t := (b := 1,\n c := 2);\nd : ARRAY [1..2] OF INT := [\n"
                    "1, 2];\nEND_VAR\n;\nEND_PROGRAM"),
              "1-9 2-7 3-4 5-6");
}

TEST(FoldingRanges, LeaveALineOnWhichSomethingElseGoesOn) {
    EXPECT_EQ(folds("PROGRAM p\nIF a THEN\n b := 1;\nEND_IF; b := 2;\nEND_PROGRAM"), "1-5 2-3");
}

std::vector<std::string> selections_at(const std::string& text, std::size_t offset) {
    std::vector<std::string> result;
    const SyntaxTree tree = parse(SourceText(text));
    for (const TextRange range : selection_ranges(tree, static_cast<std::uint32_t>(offset)))
        result.push_back(text.substr(range.begin, range.size()));
    return result;
}

std::vector<std::string> selections(const std::string& text, const std::string& at) {
    return selections_at(text, text.find(at));
}

// What is selected first with the caret at `|`.
std::string selected(std::string text) {
    const std::size_t caret = text.find('|');
    text.erase(caret, 1);
    const std::vector<std::string> all = selections_at(text, caret);
    return all.empty() ? "" : all.front();
}

TEST(SelectionRanges, TakeTheWordThatEndsAtTheCaret) {
    EXPECT_EQ(selected("PROGRAM p foo| := 1; END_PROGRAM"), "foo");
    EXPECT_EQ(selected("PROGRAM p foo|(a := 1); END_PROGRAM"), "foo");
    EXPECT_EQ(selected("PROGRAM p foo(|a := 1); END_PROGRAM"), "a");
    EXPECT_EQ(selected("PROGRAM p x := 1|; END_PROGRAM"), "1");
    EXPECT_EQ(selected("PROGRAM p x := f(1)|; END_PROGRAM"), ";");
    EXPECT_EQ(selected("PROGRAM p x := 1;| END_PROGRAM"), ";");
    EXPECT_EQ(selected("PROGRAM p ; (* c *)| END_PROGRAM"), "(* c *)");
    EXPECT_EQ(selected("PROGRAM p ; END_PROGRAM|"), "END_PROGRAM");
    EXPECT_EQ(selected("PROGRAM p ; END_PROGRAM|\nPROGRAM q ; END_PROGRAM"), "END_PROGRAM");
}

TEST(SelectionRanges, GrowFromTheWordBeforeTheCaret) {
    const std::string text = "PROGRAM p x := foo; END_PROGRAM";
    EXPECT_EQ(selections_at(text, text.find(';')),
              (std::vector<std::string>{"foo", "x := foo", "x := foo;", text}));
}

TEST(SelectionRanges, GrowFromTheTokenToTheFile) {
    const std::string text = "(* c *)\nPROGRAM p\n x := y + 1;\nEND_PROGRAM\n";
    EXPECT_EQ(selections(text, "y"),
              (std::vector<std::string>{"y", "y + 1", "x := y + 1", "x := y + 1;",
                                        "PROGRAM p\n x := y + 1;\nEND_PROGRAM", text}));
}

TEST(SelectionRanges, BeginWithAComment) {
    const std::string text = "PROGRAM p\n(* c *)\n;\nEND_PROGRAM";
    EXPECT_EQ(selections(text, "c *"), (std::vector<std::string>{"(* c *)", text}));
}

TEST(SelectionRanges, HoldInAnEmptyFile) {
    EXPECT_TRUE(selection_ranges(parse(SourceText("")), 0).empty());
}

} // namespace
