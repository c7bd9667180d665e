#include "source/utf8.hpp"

#include <iecfront/source/encoding.hpp>

#include <gtest/gtest.h>
#include <string>

using namespace iecfront;

namespace {

DecodedCharacter decode(std::string_view text, Encoding encoding = Encoding::utf8) {
    return decode_character(text, 0, encoding);
}

void expect_broken(std::string_view text) {
    const DecodedCharacter character = decode(text);
    EXPECT_FALSE(character.valid);
    EXPECT_EQ(character.size, 1U);
    EXPECT_EQ(character.code_point, U'\uFFFD');
}

TEST(Encoding, EveryCodePointOfUtf8ComesBack) {
    for (char32_t code_point = 0; code_point <= 0x10FFFF; ++code_point) {
        if (code_point == 0xD800)
            code_point = 0xE000;
        std::string text;
        append_utf8(text, code_point);
        const DecodedCharacter character = decode(text);
        ASSERT_TRUE(character.valid) << std::hex << static_cast<unsigned>(code_point);
        ASSERT_EQ(character.code_point, code_point);
        ASSERT_EQ(character.size, text.size());
    }
}

TEST(Encoding, WhatUtf8CannotHoldIsWrittenAsTheReplacementCharacter) {
    constexpr char32_t held_by_none[] = {0xD800, 0xDFFF, 0x110000, 0xFFFFFF};
    for (const char32_t none : held_by_none) {
        std::string text;
        append_utf8(text, none);
        EXPECT_EQ(text, "\xEF\xBF\xBD");
    }
}

TEST(Encoding, OverlongFormsAreBroken) {
    expect_broken("\xC0\x80");
    expect_broken("\xC1\xBF");
    expect_broken("\xE0\x80\x80");
    expect_broken("\xE0\x9F\xBF");
    expect_broken("\xF0\x80\x80\x80");
    expect_broken("\xF0\x8F\xBF\xBF");
}

TEST(Encoding, SurrogatesAreBroken) {
    expect_broken("\xED\xA0\x80");
    expect_broken("\xED\xBF\xBF");
}

TEST(Encoding, NothingLiesAboveTheLastCodePoint) {
    expect_broken("\xF4\x90\x80\x80");
    expect_broken("\xF5\x80\x80\x80");
    expect_broken("\xFF");
}

TEST(Encoding, CutAndStrayBytesAreBroken) {
    expect_broken("\x80");
    expect_broken("\xC3");
    expect_broken("\xC3 ");
    expect_broken("\xE2\x82");
    expect_broken("\xE2\x82x");
    expect_broken("\xF0\x9F\x98");
}

TEST(Encoding, Latin1IsItsOwnCodePoint) {
    for (unsigned byte = 0; byte < 256; ++byte) {
        const DecodedCharacter character =
            decode(std::string(1, static_cast<char>(byte)), Encoding::iso_8859_1);
        EXPECT_TRUE(character.valid);
        EXPECT_EQ(character.code_point, byte);
        EXPECT_EQ(character.size, 1U);
    }
}

TEST(Encoding, Windows1252HasTypographicCharacters) {
    EXPECT_EQ(decode("\x80", Encoding::windows_1252).code_point, U'\u20AC');
    EXPECT_EQ(decode("\x84", Encoding::windows_1252).code_point, U'\u201E');
    EXPECT_EQ(decode("\x9F", Encoding::windows_1252).code_point, U'\u0178');
    EXPECT_EQ(decode("\xC4", Encoding::windows_1252).code_point, U'\u00C4');
    EXPECT_TRUE(decode("\x80", Encoding::windows_1252).valid);
}

TEST(Encoding, Windows1252HasFiveGaps) {
    unsigned gaps = 0;
    for (unsigned byte = 0; byte < 256; ++byte) {
        const DecodedCharacter character =
            decode(std::string(1, static_cast<char>(byte)), Encoding::windows_1252);
        if (character.valid)
            continue;
        ++gaps;
        EXPECT_EQ(character.code_point, byte);
        EXPECT_TRUE(byte == 0x81 || byte == 0x8D || byte == 0x8F || byte == 0x90 || byte == 0x9D);
    }
    EXPECT_EQ(gaps, 5U);
}

TEST(Encoding, NamesAreFoundInAnyCase) {
    EXPECT_EQ(encoding_from_string("UTF-8"), Encoding::utf8);
    EXPECT_EQ(encoding_from_string("utf8"), Encoding::utf8);
    EXPECT_EQ(encoding_from_string("Latin-1"), Encoding::iso_8859_1);
    EXPECT_EQ(encoding_from_string("latin1"), Encoding::iso_8859_1);
    EXPECT_EQ(encoding_from_string("CP1252"), Encoding::windows_1252);
    EXPECT_EQ(encoding_from_string("utf-16"), std::nullopt);
    for (const Encoding encoding : {Encoding::utf8, Encoding::iso_8859_1, Encoding::windows_1252})
        EXPECT_EQ(encoding_from_string(to_string(encoding)), encoding);
}

TEST(Encoding, ByteOrderMarkIsOneOfUtf8Only) {
    EXPECT_EQ(byte_order_mark_size("\xEF\xBB\xBFx", Encoding::utf8), 3U);
    EXPECT_EQ(byte_order_mark_size("\xEF\xBB", Encoding::utf8), 0U);
    EXPECT_EQ(byte_order_mark_size("", Encoding::utf8), 0U);
    EXPECT_EQ(byte_order_mark_size("\xEF\xBB\xBFx", Encoding::iso_8859_1), 0U);
}

} // namespace
