#include <iecfront/lexer/token.hpp>

#include <gtest/gtest.h>
#include <set>
#include <string>

using namespace iecfront;

namespace {

TEST(Token, HoldsWhatItIsMadeOf) {
    const Token token(TokenKind::duration, 17, 5, true, false);
    EXPECT_EQ(token.kind(), TokenKind::duration);
    EXPECT_EQ(token.offset(), 17U);
    EXPECT_EQ(token.length(), 5U);
    EXPECT_EQ(token.end(), 22U);
    EXPECT_EQ(token.range(), (TextRange{17, 22}));
    EXPECT_TRUE(token.first_on_line());
    EXPECT_FALSE(token.malformed());
}

TEST(Token, FieldsDoNotTouchEachOther) {
    const Token token(TokenKind::unknown, 0xFFFFFFFFU - Token::maximum_length,
                      Token::maximum_length, false, true);
    EXPECT_EQ(token.kind(), TokenKind::unknown);
    EXPECT_EQ(token.length(), Token::maximum_length);
    EXPECT_EQ(token.end(), 0xFFFFFFFFU);
    EXPECT_FALSE(token.first_on_line());
    EXPECT_TRUE(token.malformed());
}

TEST(Token, MovesBackAndKeepsTheRest) {
    const Token token(TokenKind::real, 100, 3, true, true);
    EXPECT_EQ(token.moved_back(90), Token(TokenKind::real, 10, 3, true, true));
}

TEST(TokenKind, HasTheSpellingOfTheStandard) {
    EXPECT_EQ(spelling(TokenKind::kw_end_if), "END_IF");
    EXPECT_EQ(spelling(TokenKind::kw_date_and_time), "DATE_AND_TIME");
    EXPECT_EQ(spelling(TokenKind::assign), ":=");
    EXPECT_EQ(spelling(TokenKind::bar_bar), "||");
    EXPECT_EQ(spelling(TokenKind::integer), "an integer");
    EXPECT_EQ(spelling(TokenKind::unknown), "an unknown character");
}

TEST(TokenKind, HasANameForDumps) {
    EXPECT_EQ(to_string(TokenKind::kw_end_if), "kw_end_if");
    EXPECT_EQ(to_string(TokenKind::assign), "assign");
    EXPECT_EQ(to_string(TokenKind::incomplete_location), "incomplete_location");
}

TEST(TokenKind, SpellingsAndNamesAreUnique) {
    std::set<std::string_view> spellings;
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < token_kind_count; ++i) {
        const auto kind = static_cast<TokenKind>(i);
        EXPECT_TRUE(spellings.insert(spelling(kind)).second) << i;
        EXPECT_TRUE(names.insert(to_string(kind)).second) << i;
    }
}

TEST(TokenKind, FallsIntoGroups) {
    EXPECT_TRUE(is_keyword(TokenKind::kw_bool));
    EXPECT_TRUE(is_keyword(TokenKind::kw_eno));
    EXPECT_FALSE(is_keyword(TokenKind::assign));
    EXPECT_TRUE(is_elementary_type_name(TokenKind::kw_wstring));
    EXPECT_FALSE(is_elementary_type_name(TokenKind::kw_any));
    EXPECT_TRUE(is_generic_type_name(TokenKind::kw_any_date));
    EXPECT_FALSE(is_generic_type_name(TokenKind::kw_type));
    EXPECT_TRUE(is_delimiter(TokenKind::caret));
    EXPECT_FALSE(is_delimiter(TokenKind::end_of_unit));
}

TEST(TriviaKind, HasANameForDumps) {
    EXPECT_EQ(to_string(TriviaKind::comment), "comment");
    EXPECT_EQ(to_string(TriviaKind::pragma), "pragma");
    EXPECT_EQ(to_string(TriviaKind::line_comment), "line_comment");
    EXPECT_EQ(to_string(TriviaKind::c_comment), "c_comment");
}

} // namespace
