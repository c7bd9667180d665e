#include "support/literal_faults.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace iecfront::tests {

namespace {

using enum TokenKind;
using Codes = std::vector<std::uint16_t>;

Codes codes_of(const StringValue& value) {
    Codes codes;
    for (const StringElement& element : value.elements)
        codes.push_back(element.code);
    return codes;
}

void expect_value(std::string_view text, const Codes& codes, bool double_byte,
                  Encoding encoding = Encoding::utf8) {
    SCOPED_TRACE(text);
    expect_invariants(single_byte_string, text, encoding);
    const auto value = string_value(text, encoding);
    ASSERT_TRUE(value.has_value());
    EXPECT_EQ(codes_of(*value), codes);
    EXPECT_EQ(value->double_byte, double_byte);
    for (std::size_t i = 1; i < value->elements.size(); ++i)
        EXPECT_EQ(value->elements[i - 1].source.end, value->elements[i].source.begin);
}

void expect_string(std::string_view text, const Codes& codes, bool double_byte,
                   Encoding encoding = Encoding::utf8) {
    SCOPED_TRACE(text);
    EXPECT_EQ(faults_of(single_byte_string, text, encoding), "");
    EXPECT_EQ(faults_of(double_byte_string, text, encoding), "");
    EXPECT_EQ(faults_of(typed_literal, text, encoding), "");
    expect_value(text, codes, double_byte, encoding);
}

// Table 5, with the lengths it states.
TEST(StringLiterals, HaveTheContentsOfTable5) {
    expect_string("''", {}, false);
    expect_string("\"\"", {}, true);
    expect_string("'A'", {'A'}, false);
    expect_string("\"A\"", {'A'}, true);
    expect_string("' '", {' '}, false);
    expect_string("\" \"", {' '}, true);
    expect_string("'$''", {'\''}, false);
    expect_string("'\"'", {'"'}, false);
    expect_string("\"'\"", {'\''}, true);
    expect_string("\"$\"\"", {'"'}, true);
    expect_string("'$R$L'", {'\r', '\n'}, false);
    expect_string("\"$R$L\"", {'\r', '\n'}, true);
    expect_string("'$0A'", {'\n'}, false);
    expect_string("\"$000A\"", {'\n'}, true);
    expect_string("'$$1.00'", {'$', '1', '.', '0', '0'}, false);
    expect_string("\"$$1.00\"", {'$', '1', '.', '0', '0'}, true);
    expect_string("'$C4$CB'", {0xC4, 0xCB}, false);
    expect_string("\"$00C4$00CB\"", {0xC4, 0xCB}, true);
    expect_string("STRING#'OK'", {'O', 'K'}, false);
    expect_string("string#'OK'", {'O', 'K'}, false);
    expect_string("WSTRING#'OK'", {'O', 'K'}, true);
    expect_string("'it$'s'", {'i', 't', '\'', 's'}, false);
    expect_string("\"5$\"\"", {'5', '"'}, true);
}

// Table 6, in both kinds of strings and both cases of the letters.
TEST(StringLiterals, TakeTheCombinationsOfTable6) {
    expect_string("'$$$'$L$N$P$R$T'", {'$', '\'', '\n', '\n', '\f', '\r', '\t'}, false);
    expect_string("'$l$n$p$r$t'", {'\n', '\n', '\f', '\r', '\t'}, false);
    expect_string("\"$$$\"$L$N$P$R$T\"", {'$', '"', '\n', '\n', '\f', '\r', '\t'}, true);
    expect_string("\"$l$n$p$r$t\"", {'\n', '\n', '\f', '\r', '\t'}, true);
    expect_string("'$00$7F$FF$414'", {0, 0x7F, 0xFF, 0x41, '4'}, false);
    expect_string("\"$0000$FFFF$D800$00414\"", {0, 0xFFFF, 0xD800, 0x41, '4'}, true);
}

TEST(StringLiterals, TakeMarksOfOtherThingsAsCharacters) {
    expect_string("'#'", {'#'}, false);
    expect_string("'(*{}*)//'", {'(', '*', '{', '}', '*', ')', '/', '/'}, false);
}

TEST(StringLiterals, OfATypeTakeItsWidthAndTheDelimitersQuote) {
    expect_string("WSTRING#'$0041$''", {'A', '\''}, true);
    expect_string("WSTRING#'\"'", {'"'}, true);
    expect_value("WSTRING#\"$0041$\"'\"", {'A', '"', '\''}, true);
    expect_value("STRING#\"$41$\"'\"", {'A', '"', '\''}, false);
    expect_string("MyString#'$41'", {'A'}, false);
    expect_string("MyString#\"$0041\"", {'A'}, true);
}

TEST(StringLiterals, AreTheSameInEveryEncoding) {
    const Codes codes = {0xC4, 0xCB};
    expect_string("'\xC3\x84\xC3\x8B'", codes, false, Encoding::utf8);
    expect_string("\"\xC3\x84\xC3\x8B\"", codes, true, Encoding::utf8);
    for (const Encoding encoding : {Encoding::iso_8859_1, Encoding::windows_1252}) {
        expect_string("'\xC4\xCB'", codes, false, encoding);
        expect_string("\"\xC4\xCB\"", codes, true, encoding);
    }
    expect_string("'\xFF'", {0xFF}, false, Encoding::iso_8859_1);
    expect_string("\"\xE2\x82\xAC\"", {0x20AC}, true, Encoding::utf8);
    expect_string("\"\x80\"", {0x20AC}, true, Encoding::windows_1252);
    EXPECT_EQ(faults_of(single_byte_string, "'a\x80'", Encoding::windows_1252), "1406@2..3");
}

TEST(StringLiterals, KnowWhereEachCodeComesFrom) {
    const auto value = string_value("STRING#'a$N\xC3\x84$C4b'", Encoding::utf8);
    ASSERT_TRUE(value.has_value());
    const std::vector<TextRange> expected = {{8, 9}, {9, 11}, {11, 13}, {13, 16}, {16, 17}};
    ASSERT_EQ(value->elements.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(value->elements[i].source, expected[i]);
}

TEST(StringLiterals, WithAFaultAreReportedWhereItIs) {
    const std::vector<LiteralCase> cases = {
        // 1402
        {single_byte_string, "'$x'", "1402@1..3", "'$$x'"},
        {single_byte_string, "'5$ each'", "1402@2..4", "'5$$ each'"},
        {single_byte_string, "'a$\xC3\x84'", "1402@2..5", "'a$$\xC3\x84'"},
        {double_byte_string, "\"$x$y\"", "1402@1..3 1402@3..5", "\"$$x$$y\""},
        // 1403
        {single_byte_string, "'$\"'", "1403@1..3", "'\"'"},
        {double_byte_string, "\"$'\"", "1403@1..3", "\"'\""},
        {double_byte_string, "WSTRING#'$\"'", "1403@9..11", "WSTRING#'\"'"},
        // 1404
        {single_byte_string, "'$4'", "1404@1..3", "'$$4'"},
        {single_byte_string, "'$5.00'", "1404@1..3", "'$$5.00'"},
        {single_byte_string, "'$A'", "1404@1..3", "'$0A'"},
        {double_byte_string, "\"$0A\"", "1404@1..4", "\"$000A\""},
        {double_byte_string, "\"$0A3x\"", "1404@1..5", "\"$00A3x\""},
        {double_byte_string, "WSTRING#'$0A'", "1404@9..12", "WSTRING#'$000A'"},
        // 1405
        {single_byte_string, "'a\tb'", "1405@2..3", "'a$Tb'"},
        {single_byte_string, "'\f\x01\x7F'", "1405@1..2 1405@2..3 1405@3..4", "'$P$01$7F'"},
        {double_byte_string, "\"\x1B\"", "1405@1..2", "\"$001B\""},
        {single_byte_string, std::string_view("'\0'", 3), "1405@1..2", "'$00'"},
        // 1406, 1407
        {single_byte_string, "'\xE2\x82\xAC'", "1406@1..4"},
        {single_byte_string, "'\xC4\x80\xC4\x81 \xC4\x80'", "1406@1..5 1406@6..8"},
        {double_byte_string, "\"a\xF0\x9F\x98\x80\"", "1407@2..6"},
        {double_byte_string, "WSTRING#'\xF0\x90\x80\x80'", "1407@9..13"},
        // 5010
        {single_byte_string, "STRING#\"OK\"", "5010@7..8", "STRING#'OK'"},
        {single_byte_string, "STRING#\"it's\"", "5010@7..8"},
        {single_byte_string, "STRING#\"$x\"", "5010@7..8 1402@8..10", "STRING#'$$x'"},
        {double_byte_string, "WSTRING#\"OK\"", "5010@8..9", "WSTRING#'OK'"},
        // 5005
        {single_byte_string, "'$0a'", "5005@3..4", "'$0A'"},
        {single_byte_string, "'$aB$c4'", "5005@2..3 5005@5..6", "'$AB$C4'"},
        {double_byte_string, "\"$a0Bc\"", "5005@2..6", "\"$A0BC\""},
    };
    for (const LiteralCase& literal : cases)
        expect_faults(literal);
    EXPECT_EQ(codes_of(string_value("'$0a'", Encoding::utf8).value()), Codes{0x0A});
}

// The rest of the line may be code, so nothing but the missing quote is reported.
TEST(StringLiterals, WithoutAnEndGetTheirQuoteWhereItIsMissing) {
    const std::vector<LiteralCase> cases = {
        {single_byte_string, "'", "1401@0..1", "''"},
        {single_byte_string, "'abc", "1401@0..1", "'abc'"},
        {double_byte_string, "\"abc", "1401@0..1", "\"abc\""},
        {single_byte_string, "STRING#'abc", "1401@7..8", "STRING#'abc'"},
        {single_byte_string, "'abc  ", "1401@0..1", "'abc'  "},
        {single_byte_string, "'abc;", "1401@0..1", "'abc';"},
        {single_byte_string, "'abc,", "1401@0..1", "'abc',"},
        {single_byte_string, "'abc);", "1401@0..1", "'abc');"},
        {single_byte_string, "'abc)) ; ", "1401@0..1", "'abc')) ; "},
        {single_byte_string, "'abc),", "1401@0..1", "'abc'),"},
        {single_byte_string, "'see (1);", "1401@0..1", "'see (1)';"},
        {single_byte_string, "'see (1));", "1401@0..1", "'see (1)');"},
        {single_byte_string, "'abc; (* note *)", "1401@0..1", "'abc'; (* note *)"},
        {single_byte_string, "'$x $4;", "1401@0..1", "'$x $4';"},
        {single_byte_string, "'abc$", "1401@0..1", "'abc$$'"},
        {single_byte_string, "'abc$;", "1401@0..1", "'abc$$';"},
        {single_byte_string, "'$'", "1401@0..1", "'$$'"},
        {single_byte_string, "'5 $');", "1401@0..1", "'5 $$');"},
        {single_byte_string, "'it$'s;", "1401@0..1", "'it$'s';"},
        {double_byte_string, "\"it's;", "1401@0..1", "\"it's\";"},
    };
    for (const LiteralCase& literal : cases)
        expect_faults(literal);
}

TEST(StringLiterals, WithBrokenBytesHaveNoValue) {
    for (const std::string_view text : {"'\xC3'", "'a\xFF'", "'$\xC3'", "'\x80'"}) {
        EXPECT_EQ(faults_of(single_byte_string, text), "") << text; // the lexer reports them
        EXPECT_FALSE(string_value(text, Encoding::utf8).has_value()) << text;
    }
    EXPECT_EQ(faults_of(single_byte_string, "'\xFF$x'"), "1402@2..4");
}

TEST(StringLiterals, TakeNoTextOfAnotherClass) {
    for (const std::string_view text : {"", "x", "5", "STRING#", "STRING# 'a'", "'a'b", "'a''b'",
                                        "x'a'", "A#B#'a'", "INT#'a'", "T#'a'"})
        EXPECT_FALSE(string_value(text, Encoding::utf8).has_value()) << text;
    EXPECT_EQ(faults_of(single_byte_string, "STRING# '$x'"), "");
}

} // namespace

} // namespace iecfront::tests
