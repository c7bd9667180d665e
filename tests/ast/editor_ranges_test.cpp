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

std::vector<std::string> selections(const std::string& text, const std::string& at) {
    std::vector<std::string> result;
    const auto offset = static_cast<std::uint32_t>(text.find(at));
    for (const TextRange range : selection_ranges(parse(SourceText(text)), offset))
        result.push_back(text.substr(range.begin, range.size()));
    return result;
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
