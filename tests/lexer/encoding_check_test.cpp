#include "lexer/encoding_check.hpp"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace iecfront::test {
namespace {

/// Where the first broken byte is; -1 when there is none.
[[nodiscard]] int place(std::string_view text, Encoding encoding = Encoding::utf8) {
    const auto found = check_encoding(text, encoding);
    return found ? static_cast<int>(found->range.begin) : -1;
}

TEST(EncodingCheck, FindsTheFirstBrokenByteWhereverItStands) {
    EXPECT_EQ(place("(* \xE4 *) '\xE4' x"), 3);
    EXPECT_EQ(place("12345678(* 1234567 \xE4 *)"), 19);
    EXPECT_EQ(place("x \xC3\xA4 \xE4"), 5);
    EXPECT_EQ(place("1234567\xE4"), 7);
    EXPECT_EQ(place("\xE4"), 0);
    EXPECT_EQ(place("12345678\xC3"), 8);
}

TEST(EncodingCheck, FindsNothingInGoodText) {
    EXPECT_EQ(place(""), -1);
    EXPECT_EQ(place("\xEF\xBB\xBF(* 1234567 \xE2\x82\xAC 12345678 *)"), -1);
}

TEST(EncodingCheck, KnowsTheEncodings) {
    EXPECT_EQ(place("x\x81", Encoding::windows_1252), 1);
    EXPECT_EQ(place("x\x80", Encoding::windows_1252), -1);
    EXPECT_EQ(place("(*\x81*)", Encoding::iso_8859_1), -1);
}

TEST(EncodingCheck, NamesTheByteAndTheEncoding) {
    const auto found = check_encoding("x \xE4", Encoding::utf8);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->id, DiagnosticId::broken_encoding);
    EXPECT_EQ(found->range, (TextRange{2, 3}));
    EXPECT_EQ(found->arguments,
              (std::vector<DiagnosticArgument>{std::string("16#E4"), std::string("utf-8")}));
}

} // namespace
} // namespace iecfront::test
