#include <iecfront/source/text_range.hpp>

#include <gtest/gtest.h>
#include <vector>

using namespace iecfront;

namespace {

using Edits = std::vector<TextEdit>;

TEST(TextRange, ContainsWhatLiesInside) {
    constexpr TextRange range{2, 5};
    EXPECT_TRUE(range.contains(2) && range.contains(4));
    EXPECT_FALSE(range.contains(1) || range.contains(5));
    EXPECT_TRUE(range.contains(TextRange{5, 5}));
    EXPECT_FALSE(range.contains(TextRange{4, 6}));
    EXPECT_FALSE(range.contains(TextRange{1, 3}));
    EXPECT_EQ(range.shifted(3), (TextRange{5, 8}));
}

TEST(ApplyEdits, ReplacesInsertsAndRemoves) {
    EXPECT_EQ(apply_edits("x = 1", Edits{{{2, 3}, ":="}}), "x := 1");
    EXPECT_EQ(apply_edits("x", Edits{{{1, 1}, ";"}}), "x;");
    EXPECT_EQ(apply_edits("x;;", Edits{{{1, 2}, ""}}), "x;");
    EXPECT_EQ(apply_edits("", Edits{{{0, 0}, "x"}}), "x");
    EXPECT_EQ(apply_edits("x", Edits{}), "x");
}

TEST(ApplyEdits, CountsAllRangesInTheTextAsItWas) {
    EXPECT_EQ(apply_edits("a b c", Edits{{{0, 1}, "long"}, {{2, 3}, ""}, {{4, 5}, "d"}}),
              "long  d");
    EXPECT_EQ(apply_edits("ab", Edits{{{1, 1}, "1"}, {{1, 1}, "2"}}), "a12b");
}

TEST(ApplyEdits, LeavesOutWhatCannotBeMade) {
    EXPECT_EQ(apply_edits("abc", Edits{{{0, 2}, "x"}, {{1, 3}, "y"}}), "xc");
    EXPECT_EQ(apply_edits("abc", Edits{{{2, 4}, "x"}}), "abc");
    EXPECT_EQ(apply_edits("abc", Edits{{{2, 1}, "x"}, {{3, 3}, "y"}}), "abcy");
}

} // namespace
