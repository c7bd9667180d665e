#include <iecfront/source/line_table.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

using namespace iecfront;

namespace {

std::vector<std::uint32_t> starts(std::string_view text) {
    const LineTable table(text);
    std::vector<std::uint32_t> result;
    for (std::uint32_t line = 0; line <= table.line_end_count(); ++line)
        result.push_back(table.line_start(line));
    return result;
}

using Starts = std::vector<std::uint32_t>;

TEST(LineTable, AnEmptyTextHasOneLine) {
    EXPECT_EQ(starts(""), Starts({0}));
    EXPECT_EQ(LineTable("").line_of(0), 0U);
    EXPECT_EQ(LineTable().line_of(7), 0U);
}

TEST(LineTable, EachKindOfLineEndEndsOneLine) {
    EXPECT_EQ(starts("a\nb"), Starts({0, 2}));
    EXPECT_EQ(starts("a\r\nb"), Starts({0, 3}));
    EXPECT_EQ(starts("a\rb"), Starts({0, 2}));
    EXPECT_EQ(starts("\n\r\r\n"), Starts({0, 1, 2, 4}));
    EXPECT_EQ(starts("a\n"), Starts({0, 2}));
    EXPECT_EQ(starts("a\r"), Starts({0, 2}));
}

// Columns that are noted in long lines are those that counting from the line's start gives, also
// with characters of several bytes, broken ones and a byte order mark.
TEST(LineTable, KnowsColumnsInLongLines) {
    std::mt19937 random(1);
    const std::vector<std::string> characters{
        "a", "\xC3\x84", "\xE2\x82\xAC", "\xF0\x9F\x98\x80", "\xFF", "\xE2\x82"};
    for (const Encoding encoding : {Encoding::utf8, Encoding::iso_8859_1}) {
        std::string text = "\xEF\xBB\xBF";
        for (const std::size_t length : std::vector<std::size_t>{20'000, 10, 5'000, 30'000}) {
            for (const std::size_t end = text.size() + length; text.size() < end;)
                text += characters[random() % characters.size()];
            text += "\r\n";
        }
        const LineTable plain(text);
        const LineTable table(text, encoding);
        std::uint32_t furthest = 0;
        for (std::uint32_t offset = 0; offset <= text.size(); offset += 31) {
            const std::uint32_t start = plain.line_start(plain.line_of(offset));
            const LineTable::KnownColumn known = table.known_column(offset);
            ASSERT_LE(known.offset, offset);
            furthest = std::max(furthest, offset - known.offset);
            ASSERT_EQ(known.column - 1 +
                          column_of(text, known.offset, offset, encoding, ColumnUnit::code_points),
                      column_of(text, start, offset, encoding, ColumnUnit::code_points))
                << offset;
        }
        EXPECT_LT(furthest, 9'000U);
    }
}

TEST(LineTable, FindsTheEndOfALine) {
    const std::string_view text = "ab\r\nc\rd\n\ne";
    const LineTable table(text);
    EXPECT_EQ(table.line_end(text, 0), 2U);
    EXPECT_EQ(table.line_end(text, 1), 5U);
    EXPECT_EQ(table.line_end(text, 2), 7U);
    EXPECT_EQ(table.line_end(text, 3), 8U);
    EXPECT_EQ(table.line_end(text, 4), 10U);
    EXPECT_EQ(LineTable().line_end("", 0), 0U);
}

TEST(LineTable, FindsTheLineOfAnOffset) {
    const LineTable table("ab\r\nc\n");
    EXPECT_EQ(table.line_of(0), 0U);
    EXPECT_EQ(table.line_of(3), 0U); // the LF of CR LF
    EXPECT_EQ(table.line_of(4), 1U);
    EXPECT_EQ(table.line_of(5), 1U);
    EXPECT_EQ(table.line_of(6), 2U); // end of text
}

TEST(LineTable, EqualsASlowOneOnRandomTexts) {
    std::mt19937 random(1);
    constexpr std::string_view letters = "ab\n\r\x8A\x8D\x0B\x09";
    for (int round = 0; round < 2000; ++round) {
        std::string text(random() % (round % 100 == 0 ? 10'000 : 200), ' ');
        for (char& c : text)
            c = letters[random() % letters.size()];
        Starts expected{0};
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n' ||
                (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')))
                expected.push_back(static_cast<std::uint32_t>(i + 1));
        ASSERT_EQ(starts(text), expected);
        ASSERT_EQ(count_line_ends(text), expected.size() - 1);
    }
}

std::uint32_t code_points(std::string_view text, std::uint32_t offset) {
    return column_of(text, 0, offset, Encoding::utf8, ColumnUnit::code_points);
}

TEST(Column, ATabIsOneColumn) {
    EXPECT_EQ(code_points("\t\tx", 2), 3U);
}

TEST(Column, CountsCharactersOfUtf8) {
    const std::string_view text = "\xC3\x84\xE2\x82\xAC\xF0\x9F\x98\x80x"; // A-umlaut, euro, face
    EXPECT_EQ(column_of(text, 0, 9, Encoding::utf8, ColumnUnit::bytes), 10U);
    EXPECT_EQ(column_of(text, 0, 9, Encoding::utf8, ColumnUnit::code_points), 4U);
    EXPECT_EQ(column_of(text, 0, 9, Encoding::utf8, ColumnUnit::utf16_units), 5U);
    EXPECT_EQ(column_of(text, 0, 9, Encoding::iso_8859_1, ColumnUnit::code_points), 10U);
}

TEST(Column, AnOffsetInsideACharacterHasItsColumn) {
    EXPECT_EQ(code_points("a\xE2\x82\xAC", 2), 2U);
    EXPECT_EQ(code_points("a\xE2\x82\xAC", 3), 2U);
    EXPECT_EQ(code_points("a\xE2\x82\xAC", 4), 3U);
}

TEST(Column, ABrokenByteIsOneColumn) {
    EXPECT_EQ(code_points("\xFF\xC3\xE2\x82z", 4), 5U);
    EXPECT_EQ(column_of("\xF0\x9F\x98z", 0, 3, Encoding::utf8, ColumnUnit::utf16_units), 4U);
}

TEST(Column, CountsFromTheStartOfTheLine) {
    const std::string_view text = "\xC3\x84\r\n\xC3\x84x";
    EXPECT_EQ(column_of(text, 4, 6, Encoding::utf8, ColumnUnit::code_points), 2U);
    EXPECT_EQ(column_of(text, 0, 3, Encoding::utf8, ColumnUnit::code_points), 3U); // the LF
}

TEST(Column, AByteOrderMarkTakesNoColumn) {
    const std::string_view text = "\xEF\xBB\xBFx\n\xEF\xBB\xBFy";
    EXPECT_EQ(code_points(text, 0), 1U);
    EXPECT_EQ(code_points(text, 3), 1U);
    EXPECT_EQ(code_points(text, 4), 2U);
    EXPECT_EQ(column_of(text, 0, 3, Encoding::utf8, ColumnUnit::bytes), 4U);
    EXPECT_EQ(column_of(text, 5, 8, Encoding::utf8, ColumnUnit::code_points), 2U); // no mark there
}

TEST(OffsetOfColumn, StopsAtTheLineEnd) {
    const std::string_view text = "ab\r\ncd";
    for (const ColumnUnit unit :
         {ColumnUnit::bytes, ColumnUnit::code_points, ColumnUnit::utf16_units}) {
        EXPECT_EQ(offset_of_column(text, 0, 1, Encoding::utf8, unit), 0U);
        EXPECT_EQ(offset_of_column(text, 0, 3, Encoding::utf8, unit), 2U);
        EXPECT_EQ(offset_of_column(text, 0, 99, Encoding::utf8, unit), 2U);
        EXPECT_EQ(offset_of_column(text, 4, 2, Encoding::utf8, unit), 5U);
        EXPECT_EQ(offset_of_column(text, 4, 4294967295U, Encoding::utf8, unit), 6U);
    }
}

TEST(OffsetOfColumn, TheSecondHalfOfASurrogatePairIsItsCharacter) {
    const std::string_view text = "\xF0\x9F\x98\x80x";
    EXPECT_EQ(offset_of_column(text, 0, 2, Encoding::utf8, ColumnUnit::utf16_units), 0U);
    EXPECT_EQ(offset_of_column(text, 0, 3, Encoding::utf8, ColumnUnit::utf16_units), 4U);
}

TEST(OffsetOfColumn, IsTheInverseOnRandomLines) {
    std::mt19937 random(2);
    constexpr std::string_view letters = "ab\t\xC3\x84\xE2\x82\xAC\xF0\x9F\x98\x80";
    for (int round = 0; round < 2000; ++round) {
        std::string text(random() % (round % 100 == 0 ? 10'000 : 200), ' ');
        for (char& c : text)
            c = letters[random() % letters.size()];
        for (const ColumnUnit unit :
             {ColumnUnit::bytes, ColumnUnit::code_points, ColumnUnit::utf16_units}) {
            for (std::uint32_t at = 0; at < text.size();) {
                const std::uint32_t column = column_of(text, 0, at, Encoding::utf8, unit);
                ASSERT_EQ(offset_of_column(text, 0, column, Encoding::utf8, unit), at);
                at += decode_character(text, at, Encoding::utf8).size;
            }
        }
    }
}

} // namespace
