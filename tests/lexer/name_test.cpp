#include <iecfront/lexer/name.hpp>

#include <gtest/gtest.h>

using namespace iecfront;

namespace {

TEST(Name, CaseIsNotSignificant) {
    EXPECT_TRUE(names_equal("abCd_1", "ABcD_1"));
    EXPECT_EQ(hash_name("abCd_1"), hash_name("ABcD_1"));
    EXPECT_EQ(folded("abCd_1"), "ABCD_1");
}

TEST(Name, UnderscoresAreSignificant) {
    EXPECT_FALSE(names_equal("A_BCD", "AB_CD"));
    EXPECT_NE(hash_name("A_BCD"), hash_name("AB_CD"));
}

TEST(Name, LengthIsSignificant) {
    EXPECT_FALSE(names_equal("ABC", "ABCD"));
    EXPECT_FALSE(names_equal("", "A"));
    EXPECT_TRUE(names_equal("", ""));
    EXPECT_EQ(folded(""), "");
}

TEST(Name, OnlyLettersOfAsciiFold) {
    for (int byte = 0; byte < 256; ++byte) {
        const char c = static_cast<char>(byte);
        const bool lower = byte >= 'a' && byte <= 'z';
        EXPECT_EQ(fold(c), lower ? static_cast<char>(byte - 32) : c) << byte;
    }
    EXPECT_FALSE(names_equal("@", "`")); // they differ as `A` and `a` do
    EXPECT_EQ(folded("\xC3\xA4"), "\xC3\xA4");
}

} // namespace
