#include "lexer/keywords.hpp"
#include "lexer/word_shape.hpp"

#include <gtest/gtest.h>
#include <random>
#include <string>
#include <string_view>

using namespace iecfront;

namespace {

WordShape shape(const std::string& text) {
    return shape_of_word(text.data(), text.data() + text.size());
}

TEST(WordShape, EndsWhereTheWordDoes) {
    for (const char* const word : {"a", "Motor_1", "END_FUNCTION_BLOCK", "x2345678", "_9"})
        for (const char* const rest : {"", ";", " := 1; // more", "@x", "[1", "`a", "{p}", ":=b",
                                       "/a", "\xE4xxxxxxxx", "\x80", "\xDF\x5F__"}) {
            const std::string text = std::string(word) + rest;
            EXPECT_EQ(shape(text).end, text.data() + std::string_view(word).size()) << text;
        }
}

TEST(WordShape, SeesStrayUnderscores) {
    for (const char* const word : {"a_", "a__b", "_", "__", "abcdefg_", "abcdefgh_", "abcdefg__i",
                                   "abcdefgh__", "abcdefg_hijklmn_", "a_b_c_d__e",
                                   "abcdefghijklmno__p", "abcdefghijklmnop_", "abcdefghijklmno_"})
        for (const char* const rest : {"", " ", " and so on, and so on", "\xDF and so on"})
            EXPECT_TRUE(shape(word + std::string(rest)).odd) << word << rest;
    for (const char* const word : {"a_b", "_a", "abcdefg_h", "abcdefgh_i", "a_b_c_d_e_f_g_h_i_j",
                                   "abcdefghijklmno_p", "abcdefghijklmn_o"})
        for (const char* const rest : {"", " ", " _ and so on, and __", "\xDF_ and so on"})
            EXPECT_FALSE(shape(word + std::string(rest)).odd) << word << rest;
}

// A word of any size is one word, but not one token.
TEST(WordShape, SeesWhatIsLongerThanAToken) {
    const std::string longest(Token::maximum_length, 'a');
    EXPECT_FALSE(shape(longest + ";                ").odd);
    EXPECT_TRUE(shape(longest + "a;                ").odd);
    EXPECT_FALSE(words::shape_bytewise(longest.data()).odd);
    EXPECT_TRUE(words::shape_bytewise((longest + 'a').data()).odd);
}

words::Masks masks_one_by_one(const std::string& bytes) {
    words::Masks masks;
    for (std::size_t i = 0; i < mask_size; ++i) {
        masks.parts |= is_word_part(bytes[i]) ? 1U << i : 0U;
        masks.underscores |= bytes[i] == '_' ? 1U << i : 0U;
    }
    return masks;
}

TEST(WordShape, MasksAreTheSameInAllWays) {
    std::mt19937 random(20034); // fixed: a failure has to come back
    std::string bytes(mask_size, '\0');
    for (int round = 0; round < 50000; ++round) {
        for (char& byte : bytes)
            byte = static_cast<char>(random() % (round % 2 == 0 ? 256 : 128));
        const words::Masks masks = masks_one_by_one(bytes);
        ASSERT_EQ(words::masks_of(bytes.data()), masks) << testing::PrintToString(bytes);
        ASSERT_EQ(words::masks_by_words(bytes.data()), masks) << testing::PrintToString(bytes);
    }
}

// Near the end of a text it is read a byte at a time, elsewhere by sixteens.
TEST(WordShape, IsTheSameInBothWays) {
    constexpr std::string_view characters = "azAZ_09@[`{/: m_M5";
    std::mt19937 random(20033); // fixed: a failure has to come back
    for (int round = 0; round < 50000; ++round) {
        std::string text;
        for (auto size = random() % 70; size > 0; --size)
            text += random() % 16 == 0 ? static_cast<char>(random() % 256)
                                       : characters[random() % characters.size()];
        const WordShape bytewise = words::shape_bytewise(text.data());
        ASSERT_EQ(shape(text), bytewise) << testing::PrintToString(text);
        const std::string_view word(text.data(),
                                    static_cast<std::size_t>(bytewise.end - text.data()));
        ASSERT_EQ(bytewise.head, keywords::head_of(word)) << word;
        ASSERT_EQ(keyword_kind(word, bytewise.head), keyword_kind(word)) << word;
    }
}

} // namespace
