#include "lexer/plain_literals.hpp"

#include <iecfront/lexer/literals.hpp>
#include <iecfront/lexer/token.hpp>

#include <gtest/gtest.h>
#include <random>
#include <string>
#include <string_view>

using namespace iecfront;

namespace {

struct Form {
    TokenKind kind;
    std::string_view begin; // of what is made at random
    std::string_view characters;
};

constexpr Form forms[] = {
    {TokenKind::integer, "", "019_"},
    {TokenKind::real, "", "019_.eE+-"},
    {TokenKind::based_integer, "16#", "09aF_G#"},
    {TokenKind::based_integer, "8#", "0178_"},
    {TokenKind::based_integer, "2#", "0112_"},
    {TokenKind::based_integer, "", "01268#_"},
    {TokenKind::duration, "T#", "0199dhmsMS_-."},
    {TokenKind::duration, "time#", "0199dhmsu"},
    {TokenKind::duration, "", "T#5s"},
    {TokenKind::direct_variable, "%", "IQMXWb019..*_"},
    {TokenKind::direct_variable, "%ix", "019._"},
    {TokenKind::single_byte_string, "'", "ab $'\t\xE4"},
    {TokenKind::double_byte_string, "\"", "ab $\"'\t\xE4"},
    {TokenKind::single_byte_string, "", "'Sa$'"},
    {TokenKind::double_byte_string, "", "\"Wa$\""},
};

// A quicker way to the answer of the scanners, which know what the standard says.
TEST(PlainLiteral, HasNoFault) {
    std::mt19937 random(61131); // fixed: a failure has to come back
    for (const Form& form : forms) {
        int plain = 0;
        for (int round = 0; round < 20000; ++round) {
            std::string text(form.begin);
            for (auto size = 1 + random() % 24; size > 0; --size)
                text += form.characters[random() % form.characters.size()];
            if (text.front() == '\'' || text.front() == '"')
                text += text.front();
            // Short ones are seldom made by chance, and mostly plain.
            for (std::size_t size = form.begin.size() + 1; size <= text.size(); ++size) {
                const std::string_view part = std::string_view(text).substr(0, size);
                if (!is_plain_literal(form.kind, part))
                    continue;
                ++plain;
                for (const Encoding encoding : {Encoding::utf8, Encoding::iso_8859_1})
                    ASSERT_TRUE(check_literal(form.kind, part, encoding).empty()) << part;
            }
        }
        EXPECT_GT(plain, 100) << form.begin << form.characters;
    }
}

// Table 1, Table 2, Table 7 and Table 15: what most literals of a program look like.
TEST(PlainLiteral, IsWhatProgramsMostlyHold) {
    for (const std::string_view text : {"0", "1_000_000", "123456789012345678"})
        EXPECT_TRUE(is_plain_literal(TokenKind::integer, text)) << text;
    for (const std::string_view text : {"0.0", "12.75", "1.0E3", "2.5e-3"})
        EXPECT_TRUE(is_plain_literal(TokenKind::real, text)) << text;
    for (const std::string_view text : {"16#FF", "16#ff_00", "8#17", "2#1010_0101"})
        EXPECT_TRUE(is_plain_literal(TokenKind::based_integer, text)) << text;
    for (const std::string_view text : {"T#5s", "t#250MS", "TIME#99999d", "time#1h"})
        EXPECT_TRUE(is_plain_literal(TokenKind::duration, text)) << text;
    for (const std::string_view text : {"%I5", "%IX1.7", "%qw12", "%MD1.2.3"})
        EXPECT_TRUE(is_plain_literal(TokenKind::direct_variable, text)) << text;
    EXPECT_TRUE(is_plain_literal(TokenKind::single_byte_string, "'it is \"on\"'"));
    EXPECT_TRUE(is_plain_literal(TokenKind::double_byte_string, "\"\""));
}

TEST(PlainLiteral, IsNoneWithAFault) {
    for (const std::string_view text : {"", "_1", "1_", "1__0", "99999999999999999999"})
        EXPECT_FALSE(is_plain_literal(TokenKind::integer, text)) << text;
    for (const std::string_view text : {"", "1", "1.", ".5", "1.5E", "1.5E+", "1.5F3", "1.5E999"})
        EXPECT_FALSE(is_plain_literal(TokenKind::real, text)) << text;
    for (const std::string_view text :
         {"16", "16#", "10#5", "2#2", "8#8", "16#_F", "16#11112222333344445"})
        EXPECT_FALSE(is_plain_literal(TokenKind::based_integer, text)) << text;
    for (const std::string_view text : {"T#", "T#5", "T#5x", "T#100000d", "X#5s", "5s", "T#5us"})
        EXPECT_FALSE(is_plain_literal(TokenKind::duration, text)) << text;
    for (const std::string_view text : {"%", "%I", "%IX", "%X1", "%IX1.", "%IX1..2", "%I*"})
        EXPECT_FALSE(is_plain_literal(TokenKind::direct_variable, text)) << text;
    for (const std::string_view text : {"'", "'a", "'$'", "'a$'", "'a'b'", "'\xE4'", "'\t'",
                                        "STRING#'ABS", "string#'a s", "STRING#'a'"})
        EXPECT_FALSE(is_plain_literal(TokenKind::single_byte_string, text)) << text;
}

} // namespace
