#include "lexer/keywords.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

using namespace iecfront;

namespace {

std::string in_lower_case(std::string_view word) {
    std::string result(word);
    std::ranges::transform(result, result.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
    });
    return result;
}

std::string in_mixed_case(std::string_view word) {
    std::string result = in_lower_case(word);
    for (std::size_t i = 0; i < result.size(); i += 2)
        result[i] = fold(result[i]);
    return result;
}

TEST(Keywords, AreFoundInAnyCase) {
    for (std::size_t i = 0; i < keywords::spellings.size(); ++i) {
        const auto kind = static_cast<TokenKind>(i);
        const std::string_view word = spelling(kind);
        EXPECT_EQ(keyword_kind(word), kind) << word;
        EXPECT_EQ(keyword_kind(in_lower_case(word)), kind) << word;
        EXPECT_EQ(keyword_kind(in_mixed_case(word)), kind) << word;
    }
}

// Annex C, table C.2, written out, in its order.
TEST(Keywords, AreThoseOfAnnexC) {
    const std::string_view annex_c[] = {"BOOL",
                                        "SINT",
                                        "INT",
                                        "DINT",
                                        "LINT",
                                        "USINT",
                                        "UINT",
                                        "UDINT",
                                        "ULINT",
                                        "REAL",
                                        "LREAL",
                                        "TIME",
                                        "DATE",
                                        "TIME_OF_DAY",
                                        "TOD",
                                        "DATE_AND_TIME",
                                        "DT",
                                        "STRING",
                                        "WSTRING",
                                        "BYTE",
                                        "WORD",
                                        "DWORD",
                                        "LWORD",
                                        "ANY",
                                        "ANY_DERIVED",
                                        "ANY_ELEMENTARY",
                                        "ANY_MAGNITUDE",
                                        "ANY_NUM",
                                        "ANY_REAL",
                                        "ANY_INT",
                                        "ANY_BIT",
                                        "ANY_STRING",
                                        "ANY_DATE",
                                        "TYPE",
                                        "END_TYPE",
                                        "STRUCT",
                                        "END_STRUCT",
                                        "ARRAY",
                                        "OF",
                                        "VAR",
                                        "VAR_INPUT",
                                        "VAR_OUTPUT",
                                        "VAR_IN_OUT",
                                        "VAR_TEMP",
                                        "VAR_EXTERNAL",
                                        "VAR_GLOBAL",
                                        "VAR_ACCESS",
                                        "VAR_CONFIG",
                                        "END_VAR",
                                        "CONSTANT",
                                        "RETAIN",
                                        "NON_RETAIN",
                                        "AT",
                                        "R_EDGE",
                                        "F_EDGE",
                                        "READ_ONLY",
                                        "READ_WRITE",
                                        "FUNCTION",
                                        "END_FUNCTION",
                                        "FUNCTION_BLOCK",
                                        "END_FUNCTION_BLOCK",
                                        "PROGRAM",
                                        "END_PROGRAM",
                                        "CONFIGURATION",
                                        "END_CONFIGURATION",
                                        "RESOURCE",
                                        "ON",
                                        "END_RESOURCE",
                                        "TASK",
                                        "WITH",
                                        "INITIAL_STEP",
                                        "STEP",
                                        "END_STEP",
                                        "TRANSITION",
                                        "FROM",
                                        "TO",
                                        "END_TRANSITION",
                                        "ACTION",
                                        "END_ACTION",
                                        "IF",
                                        "THEN",
                                        "ELSIF",
                                        "ELSE",
                                        "END_IF",
                                        "CASE",
                                        "END_CASE",
                                        "FOR",
                                        "BY",
                                        "DO",
                                        "END_FOR",
                                        "WHILE",
                                        "END_WHILE",
                                        "REPEAT",
                                        "UNTIL",
                                        "END_REPEAT",
                                        "EXIT",
                                        "RETURN",
                                        "NOT",
                                        "MOD",
                                        "AND",
                                        "XOR",
                                        "OR",
                                        "EN",
                                        "ENO",
                                        "TRUE",
                                        "FALSE"};
    EXPECT_EQ(std::size(annex_c), keywords::spellings.size());
    for (const std::string_view word : annex_c)
        EXPECT_NE(keyword_kind(word), TokenKind::identifier) << word;
}

// Terminals of Annex B that are no keywords.
TEST(Keywords, WordsOfContextAreIdentifiers) {
    const std::string_view words[] = {
        "LD",  "LDN",  "ST",    "STN", "S",    "R",        "S1",     "R1",       "CLK",  "CU",
        "CD",  "PV",   "IN",    "PT",  "ANDN", "ORN",      "XORN",   "CAL",      "CALC", "CALCN",
        "RET", "RETC", "RETCN", "JMP", "JMPC", "JMPCN",    "N",      "P",        "L",    "D",
        "SD",  "DS",   "SL",    "P0",  "P1",   "PRIORITY", "SINGLE", "INTERVAL", "T",    "h",
        "m",   "s",    "ms",    "X",   "Q",    "I",        "M",      "B",        "W"};
    for (const std::string_view word : words) {
        EXPECT_EQ(keyword_kind(word), TokenKind::identifier) << word;
        EXPECT_EQ(keyword_kind(in_lower_case(word)), TokenKind::identifier) << word;
    }
}

void expect_no_keyword(const std::string& word) {
    EXPECT_EQ(keyword_kind(word), TokenKind::identifier) << word;
    EXPECT_EQ(keyword_kind(word, keywords::head_of(word)), TokenKind::identifier) << word;
}

TEST(Keywords, NoOtherWordIsOne) {
    for (const std::string_view word : keywords::spellings) {
        for (std::size_t i = 0; i < word.size(); ++i) {
            std::string other(word);
            other[i] = other[i] == 'Q' ? 'J' : 'Q';
            expect_no_keyword(other);
            other[i] = '7';
            expect_no_keyword(other);
        }
        expect_no_keyword(std::string(word) + "_");
        expect_no_keyword(std::string(word) + "1");
    }
    EXPECT_EQ(keyword_kind(""), TokenKind::identifier);
    EXPECT_EQ(keyword_kind("I"), TokenKind::identifier);
    EXPECT_EQ(keyword_kind("END\x7FIF"), TokenKind::identifier); // differs from `_` in one bit
    EXPECT_EQ(keyword_kind(std::string(1000, 'A')), TokenKind::identifier);
}

} // namespace
