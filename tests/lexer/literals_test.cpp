#include "support/literal_faults.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace iecfront::tests {

namespace {

using enum TokenKind;

constexpr std::array literal_kinds = {
    integer,  based_integer, real, typed_literal, single_byte_string, double_byte_string,
    duration, time_of_day,   date, date_and_time, direct_variable,    incomplete_location};

constexpr std::array encodings = {Encoding::utf8, Encoding::iso_8859_1, Encoding::windows_1252};

TEST(Literals, OfOtherKindsHaveNoFaults) {
    for (std::size_t i = 0; i < token_kind_count; ++i) {
        const auto kind = static_cast<TokenKind>(i);
        const bool literal =
            std::find(literal_kinds.begin(), literal_kinds.end(), kind) != literal_kinds.end();
        EXPECT_TRUE(literal || check_literal(kind, "1__2", Encoding::utf8).empty())
            << to_string(kind);
    }
}

TEST(Literals, SplitEnumeratedValues) {
    const auto expect_split = [](std::string_view text, std::string_view type,
                                 std::string_view value) {
        const EnumeratedValueName name = split_enumerated_value(text);
        EXPECT_EQ(name.type, type) << text;
        EXPECT_EQ(name.value, value) << text;
    };
    expect_split("Color#Red", "Color", "Red");
    expect_split("Red", "", "Red");
    expect_split("Color # Red", "Color", "Red"); // the blanks are the lexer's to report
    expect_split("Color(*#*)#{p} Red", "Color", "Red");
    expect_split("Color#", "Color", "");
    expect_split("#Red", "", "Red");
    expect_split("", "", "");
    expect_split(" # ", "", "");
}

// Pieces that literals are made of, so that random texts come near them.
constexpr std::array<std::string_view, 62> pieces = {"0",
                                                     "1",
                                                     "2#",
                                                     "8#",
                                                     "16#",
                                                     "9",
                                                     "_",
                                                     "__",
                                                     ".",
                                                     "..",
                                                     "E",
                                                     "e+",
                                                     "-",
                                                     "+",
                                                     "#",
                                                     "INT#",
                                                     "REAL#",
                                                     "WORD#",
                                                     "BOOL#",
                                                     "STRING#",
                                                     "WSTRING#",
                                                     "T#",
                                                     "TIME#",
                                                     "D#",
                                                     "TOD#",
                                                     "DT#",
                                                     "DATE#",
                                                     "TRUE",
                                                     "FF",
                                                     "g",
                                                     "'",
                                                     "\"",
                                                     "$",
                                                     "$'",
                                                     "$\"",
                                                     "$0A",
                                                     "$0a",
                                                     "$x",
                                                     "$$",
                                                     "$L",
                                                     "d",
                                                     "h",
                                                     "m",
                                                     "s",
                                                     "ms",
                                                     "us",
                                                     "12",
                                                     "30",
                                                     "1984",
                                                     ":",
                                                     "%",
                                                     "I",
                                                     "X",
                                                     "*",
                                                     " ",
                                                     "\t",
                                                     "\xC3\x84",
                                                     "\xE2\x82\xAC",
                                                     "\xF0\x9F\x98\x80",
                                                     "\xFF",
                                                     ";",
                                                     ")"};

std::string random_text(std::mt19937& random) {
    std::string text;
    for (auto count = random() % 10; count > 0; --count) {
        if (random() % 8 == 0)
            text += static_cast<char>(random() % 256);
        else
            text += pieces[random() % pieces.size()];
    }
    return text;
}

TEST(Literals, OfAnyTextKeepTheInvariants) {
    std::mt19937 random(2003); // NOLINT: the same texts in every run
    for (int i = 0; i < 20'000; ++i) {
        const std::string text = random_text(random);
        for (const TokenKind kind : literal_kinds)
            expect_invariants(kind, text, encodings[random() % encodings.size()]);
        EXPECT_LE(split_enumerated_value(text).value.size(), text.size());
        if (testing::Test::HasFailure())
            FAIL() << "by text " << i << ": " << text;
    }
}

// Each literal cut at every place, and with every byte dropped.
TEST(Literals, CutAnywhereKeepTheInvariants) {
    const std::vector<std::string> texts = {"INT#-16#FF_FF",
                                            "LREAL#-3.14159_26E+1_0",
                                            "T#-5d_14h_12m_18s_3.5ms",
                                            "BOOL#TRUE",
                                            "DT#1984-06-25-15:36:55.36",
                                            "STRING#'a$'$0A\xC3\x84$$'",
                                            "WSTRING#\"$0041$\"\"",
                                            "%QX1.2_3.4",
                                            "%M*",
                                            "TIME_OF_DAY#1:2:3.4",
                                            "2#1111_0000"};
    for (const std::string& text : texts) {
        for (std::size_t at = 0; at < text.size(); ++at) {
            for (const TokenKind kind : literal_kinds) {
                expect_invariants(kind, text.substr(0, at));
                expect_invariants(kind, text.substr(at));
                expect_invariants(kind, text.substr(0, at) + text.substr(at + 1));
            }
        }
    }
}

// Long texts take no longer than their length.
TEST(Literals, CanBeLong) {
    const std::string digits(1'000'000, '9');
    EXPECT_EQ(faults_of(integer, digits), "1308@0..1000000");
    EXPECT_EQ(faults_of(real, "0." + digits), "");
    EXPECT_EQ(faults_of(duration, "T#0." + digits + "s"), "9007@13..1000004");
    EXPECT_EQ(string_value('\'' + digits + '\'', Encoding::utf8).value().elements.size(),
              digits.size());
}

} // namespace

} // namespace iecfront::tests
