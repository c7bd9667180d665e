#include "lexer/meant_number.hpp"

#include <gtest/gtest.h>

using namespace iecfront;

namespace {

TEST(MeantNumber, IsHexadecimalInOtherLanguages) {
    EXPECT_EQ(meant_hexadecimal("$FF"), "16#FF");
    EXPECT_EQ(meant_hexadecimal("0FFh"), "16#FF");
    EXPECT_EQ(meant_hexadecimal("0A0H"), "16#A0");
    EXPECT_EQ(meant_hexadecimal("1Fh"), "16#1F");
    EXPECT_EQ(meant_hexadecimal("00h"), "16#00");
    EXPECT_EQ(meant_hexadecimal("16FF"), "16#FF");
    EXPECT_EQ(meant_hexadecimal("16a0"), "16#a0");
}

TEST(MeantNumber, IsNothingElse) {
    for (const std::string_view word :
         {"", "$", "$GG", "h", "5th", "1600", "16", "16A", "16x1", "16th", "2FF", "1_6FF"})
        EXPECT_EQ(meant_hexadecimal(word), "") << word;
}

TEST(MeantNumber, EndsBeforeAKeyword) {
    EXPECT_EQ(size_before_keyword("3MOD"), 1U);
    EXPECT_EQ(size_before_keyword("1.5xor"), 3U);
    EXPECT_EQ(size_before_keyword("16#FFDO"), 5U);
    EXPECT_EQ(size_before_keyword("10END_REPEAT"), 2U);
    for (const std::string_view text : {"", "MOD", "3", "3IF", "3MODE"})
        EXPECT_EQ(size_before_keyword(text), 0U) << text;
}

} // namespace
