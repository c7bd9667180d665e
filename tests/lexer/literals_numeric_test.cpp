#include "support/literal_faults.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace iecfront::tests {

namespace {

using enum TokenKind;

constexpr std::uint64_t highest = std::numeric_limits<std::uint64_t>::max();

// ---- integers --------------------------------------------------------------------------------

struct IntegerCase {
    TokenKind kind;
    std::string_view text;
    std::uint64_t magnitude;
    bool negative = false;
    std::optional<TokenKind> type = {};
    std::uint8_t base = 10;
};

void expect_integer(const IntegerCase& expected) {
    SCOPED_TRACE(expected.text);
    EXPECT_EQ(faults_of(expected.kind, expected.text), "");
    expect_invariants(expected.kind, expected.text);
    const auto value = integer_value(expected.text);
    ASSERT_TRUE(value.has_value());
    EXPECT_EQ(value->magnitude, expected.magnitude);
    EXPECT_EQ(value->negative, expected.negative);
    EXPECT_EQ(value->type, expected.type);
    EXPECT_EQ(value->base, expected.base);
    EXPECT_FALSE(value->overflow);
    EXPECT_FALSE(real_value(expected.text).has_value());
}

// Table 4, features 1 and 4 to 9; the sign of an untyped literal is a token of its own.
TEST(IntegerLiterals, HaveTheValuesOfTable4) {
    const std::vector<IntegerCase> cases = {
        {integer, "12", 12},
        {integer, "0", 0},
        {integer, "1", 1},
        {integer, "123_456", 123456},
        {integer, "986", 986},
        {based_integer, "2#1111_1111", 255, false, {}, 2},
        {based_integer, "2#1110_0000", 224, false, {}, 2},
        {based_integer, "8#377", 255, false, {}, 8},
        {based_integer, "8#340", 224, false, {}, 8},
        {based_integer, "16#FF", 255, false, {}, 16},
        {based_integer, "16#ff", 255, false, {}, 16},
        {based_integer, "16#E0", 224, false, {}, 16},
        {based_integer, "16#e0", 224, false, {}, 16},
        {based_integer, "16#1E3", 0x1E3, false, {}, 16},
        {based_integer, "16#DEAD_beef", 0xDEADBEEF, false, {}, 16},
        {typed_literal, "DINT#5", 5, false, kw_dint},
        {typed_literal, "UINT#16#9AF", 0x9AF, false, kw_uint, 16},
        {typed_literal, "BOOL#0", 0, false, kw_bool},
        {typed_literal, "BOOL#1", 1, false, kw_bool},
        {typed_literal, "BOOL#TRUE", 1, false, kw_bool},
        {typed_literal, "BOOL#FALSE", 0, false, kw_bool},
        {typed_literal, "bool#true", 1, false, kw_bool},
        {typed_literal, "INT#16#7FFF", 0x7FFF, false, kw_int, 16},
        {typed_literal, "int#+5", 5, false, kw_int},
        {typed_literal, "INT#-5", 5, true, kw_int},
        {typed_literal, "INT#-0", 0, false, kw_int},
        {typed_literal, "DINT#-12", 12, true, kw_dint},
        {typed_literal, "DINT#+986", 986, false, kw_dint},
        {typed_literal, "WORD#16#FFFF", 0xFFFF, false, kw_word, 16},
        {typed_literal, "BYTE#2#1000_0001", 0x81, false, kw_byte, 2},
        {typed_literal, "DWORD#8#777", 0777, false, kw_dword, 8},
        {typed_literal, "LWORD#1_000", 1000, false, kw_lword},
        {integer, "000000000000000000000000000000000000000042", 42},
        {integer, "18446744073709551615", highest},
        {based_integer, "16#FFFF_FFFF_FFFF_FFFF", highest, false, {}, 16},
        {based_integer, "16#0000_0000_FFFF_FFFF_FFFF_FFFF", highest, false, {}, 16},
        {kw_true, "TRUE", 1, false, kw_bool},
        {kw_false, "False", 0, false, kw_bool},
    };
    for (const IntegerCase& expected : cases)
        expect_integer(expected);
}

TEST(IntegerLiterals, OfADerivedTypeAreReadLeniently) {
    expect_integer({typed_literal, "MyInt#5", 5});
    expect_integer({typed_literal, "MyInt#-5", 5, true});
    expect_integer({typed_literal, "My_Int2#16#FF", 255, false, {}, 16});
    expect_integer({typed_literal, "MyBool#TRUE", 1});
    EXPECT_DOUBLE_EQ(real_value("MyReal#-1.5").value().value, -1.5);
    EXPECT_EQ(faults_of(typed_literal, "MyInt#1__2"), "1302@8..9");
    EXPECT_EQ(faults_of(typed_literal, "MyInt#2#12"), "1301@9..10");
    EXPECT_EQ(faults_of(typed_literal, "MyInt#"), ""); // the lexer's to say
    EXPECT_FALSE(integer_value("MyInt#").has_value());
}

struct RangeCase {
    std::string_view type;
    std::string_view low;
    std::string_view below_low;
    std::string_view high;
    std::string_view above_high;
};

const std::vector<RangeCase> ranges = {
    {"SINT", "-128", "-129", "127", "128"},
    {"INT", "-32768", "-32769", "32767", "32768"},
    {"DINT", "-2147483648", "-2147483649", "2147483647", "2147483648"},
    {"LINT", "-9223372036854775808", "-9223372036854775809", "9223372036854775807",
     "9223372036854775808"},
    {"USINT", "0", "-1", "255", "256"},
    {"UINT", "0", "-1", "65535", "65536"},
    {"UDINT", "0", "-1", "4294967295", "4294967296"},
    {"ULINT", "0", "-1", "18446744073709551615", "18446744073709551616"},
    {"BYTE", "0", "", "255", "256"},
    {"WORD", "0", "", "65535", "65536"},
    {"DWORD", "0", "", "4294967295", "4294967296"},
    {"LWORD", "0", "", "18446744073709551615", "18446744073709551616"},
};

void expect_in_range(const std::string& prefix, std::string_view number) {
    const std::string text = prefix + std::string(number);
    EXPECT_EQ(faults_of(typed_literal, text), "") << text;
    EXPECT_TRUE(integer_value(text).has_value()) << text;
}

void expect_out_of_range(const RangeCase& range, std::string_view number) {
    const std::string text = std::string(range.type) + '#' + std::string(number);
    const auto faults = check_literal(typed_literal, text, Encoding::utf8);
    ASSERT_EQ(faults.size(), 1U) << text;
    EXPECT_EQ(faults[0].id, DiagnosticId::literal_out_of_range);
    EXPECT_EQ(faults[0].range, (TextRange{static_cast<std::uint32_t>(range.type.size() + 1),
                                          static_cast<std::uint32_t>(text.size())}));
    EXPECT_EQ(faults[0].arguments,
              (std::vector<DiagnosticArgument>{std::string(range.type), std::string(range.low),
                                               std::string(range.high)}));
    EXPECT_FALSE(integer_value(text).has_value()) << text;
}

TEST(IntegerLiterals, FitTheirTypeAtBothEndsOfItsRange) {
    for (const RangeCase& range : ranges) {
        const std::string prefix = std::string(range.type) + '#';
        expect_in_range(prefix, range.low);
        expect_in_range(prefix, range.high);
        expect_out_of_range(range, range.above_high);
        if (!range.below_low.empty())
            expect_out_of_range(range, range.below_low);
        expect_out_of_range(range, "99999999999999999999999");
        expect_out_of_range(range, "16#1_0000_0000_0000_0000");
    }
    expect_out_of_range(ranges[1], "16#FFFF"); // the value 65535, not -1
}

TEST(IntegerLiterals, AboveEveryTypeKeepTheLargestValue) {
    for (const std::string_view text : {"18446744073709551616", "99999999999999999999999999999"}) {
        EXPECT_EQ(faults_of(integer, text), "1308@0.." + std::to_string(text.size()));
        const auto value = integer_value(text);
        ASSERT_TRUE(value.has_value());
        EXPECT_TRUE(value->overflow);
        EXPECT_EQ(value->magnitude, highest);
    }
    EXPECT_EQ(faults_of(based_integer, "16#1_0000_0000_0000_0000"), "1308@0..24");
    EXPECT_TRUE(integer_value("2#1" + std::string(64, '0')).value().overflow);
    EXPECT_FALSE(integer_value("2#" + std::string(64, '1')).value().overflow);
}

// ---- reals -----------------------------------------------------------------------------------

struct RealCase {
    TokenKind kind;
    std::string_view text;
    double value;
    std::optional<TokenKind> type = {};
    std::string_view faults = {};
};

void expect_real(const RealCase& expected) {
    SCOPED_TRACE(expected.text);
    expect_invariants(expected.kind, expected.text);
    EXPECT_EQ(faults_of(expected.kind, expected.text), expected.faults);
    const auto value = real_value(expected.text);
    ASSERT_TRUE(value.has_value());
    EXPECT_EQ(value->value, expected.value);
    EXPECT_EQ(value->type, expected.type);
    EXPECT_EQ(value->overflow, std::isinf(expected.value));
    EXPECT_FALSE(integer_value(expected.text).has_value());
}

// Table 4, features 2 and 3.
TEST(RealLiterals, HaveTheValuesOfTable4) {
    const std::vector<RealCase> cases = {
        {real, "12.0", 12.0},
        {real, "0.0", 0.0},
        {real, "0.4560", 0.456},
        {real, "3.14159_26", 3.1415926},
        {real, "1.34E-12", 1.34e-12},
        {real, "1.34e-12", 1.34e-12},
        {real, "1.0E+6", 1e6},
        {real, "1.0e+6", 1e6},
        {real, "1.234E6", 1.234e6},
        {real, "1.234e6", 1.234e6},
        {real, "1_0.0_5E1_0", 10.05e10},
        {typed_literal, "REAL#1.5", 1.5, kw_real},
        {typed_literal, "REAL#-12.0", -12.0, kw_real},
        {typed_literal, "lreal#+1.0E-3", 1e-3, kw_lreal},
    };
    for (const RealCase& expected : cases)
        expect_real(expected);
}

TEST(RealLiterals, AreRoundedToTheirType) {
    const std::vector<RealCase> cases = {
        {typed_literal, "REAL#0.1", static_cast<double>(0.1F), kw_real},
        {typed_literal, "LREAL#0.1", 0.1, kw_lreal},
        // Rounding to LREAL first would give 1.0 here.
        {typed_literal, "REAL#1.000000059604644775390626", 1.0 + 0x1p-23, kw_real},
        {typed_literal, "REAL#1.000000059604644775390625", 1.0, kw_real},
        {typed_literal, "REAL#16777217.0", 16777216.0, kw_real},
        {real, "9007199254740993.0", 9007199254740992.0},
        {real, "9007199254740993.00000000000000000000000000000000000001", 9007199254740994.0},
        {real, "0.1000000000000000055511151231257827021181583404541015625", 0.1},
        {real, "123456789012345678901234567890.0", 123456789012345678901234567890.0},
    };
    for (const RealCase& expected : cases)
        expect_real(expected);
    const std::string long_text = "1." + std::string(2000, '0') + "1";
    EXPECT_EQ(real_value(long_text).value().value, 1.0);
}

TEST(RealLiterals, AtTheEndsOfTheRangeOfTheirType) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::vector<RealCase> cases = {
        {typed_literal, "REAL#3.4028234663852886E38", 3.4028234663852886e38, kw_real},
        {typed_literal, "REAL#3.4028235E38", 3.4028234663852886e38, kw_real},
        {typed_literal, "REAL#3.4028236E38", infinity, kw_real, "1311@5..17"},
        {typed_literal, "REAL#-1.0E39", -infinity, kw_real, "1311@5..12"},
        {typed_literal, "LREAL#1.0E39", 1e39, kw_lreal},
        {typed_literal, "LREAL#1.7976931348623157E308", 1.7976931348623157e308, kw_lreal},
        {typed_literal, "LREAL#1.7976931348623159E308", infinity, kw_lreal, "1311@6..28"},
        {real, "1.0E308", 1e308},
        {real, "1.0E309", infinity, {}, "1311@0..7"},
        {real, "1.0E99999999999999999999999", infinity, {}, "1311@0..27"},
        {real, "0.0E99999999999999999999999", 0},
        {real, "1.0E-99999999999999999999999", 0},
        {real, "1.0E-400", 0},
        {real, "4.9406564584124654E-324", 4.9406564584124654e-324},
        {typed_literal, "REAL#1.4E-45", 0x1p-149, kw_real},
        {typed_literal, "REAL#1.0E-50", 0, kw_real},
    };
    for (const RealCase& expected : cases)
        expect_real(expected);
    // As many zeros as the exponent takes back.
    EXPECT_EQ(real_value("0." + std::string(9999, '0') + "1E10000").value().value, 1.0);
    EXPECT_EQ(real_value("1" + std::string(10000, '0') + ".0E-10000").value().value, 1.0);
}

TEST(RealLiterals, OfOtherDialectsHaveAValueToo) {
    const std::vector<RealCase> cases = {
        {real, "1E3", 1e3, {}, "5003@0..3"},
        {real, "1e-3", 1e-3, {}, "5003@0..4"},
        {typed_literal, "REAL#-1E3", -1e3, kw_real, "5003@6..9"},
        {real, ".5", 0.5, {}, "5004@0..1"},
        {real, ".5E1", 5, {}, "5004@0..1"},
        {typed_literal, "REAL#.5", 0.5, kw_real, "5004@5..6"},
        {real, "1.", 1, {}, "5007@1..2"},
        {real, "1.E3", 1e3, {}, "5007@1..2"},
    };
    for (const RealCase& expected : cases)
        expect_real(expected);
}

// ---- faults ----------------------------------------------------------------------------------

TEST(NumericLiterals, WithAFaultAreReportedWhereItIs) {
    const std::vector<LiteralCase> cases = {
        // 1301
        {based_integer, "2#12", "1301@3..4"},
        {based_integer, "8#9", "1301@2..3"},
        {based_integer, "8#1_98_7", "1301@4..6"},
        {based_integer, "2#1213", "1301@3..4 1301@5..6"},
        {based_integer, "16#G", "1301@3..4"},
        {based_integer, "16#FFG", "1301@5..6"},
        {based_integer, "2#1E3", "1301@3..5"},
        {typed_literal, "INT#2#12", "1301@7..8"},
        // 1302
        {integer, "1__2", "1302@2..3", "1_2"},
        {integer, "1____2", "1302@2..5", "1_2"},
        {integer, "1_", "1302@1..2", "1"},
        {integer, "1__", "1302@1..3", "1"},
        {integer, "1__2__3", "1302@2..3 1302@5..6", "1_2_3"},
        {real, "1_.0", "1302@1..2", "1.0"},
        {real, "1._0", "1302@2..3", "1.0"},
        {real, "1.0_", "1302@3..4", "1.0"},
        {real, "1.0_E3", "1302@3..4", "1.0E3"},
        {real, "1.0E_3", "1302@4..5", "1.0E3"},
        {real, "1.0E+_3_", "1302@5..6 1302@7..8", "1.0E+3"},
        {real, "1_E3", "5003@0..4 1302@1..2", "1.0E3"},
        {based_integer, "2#_1", "1302@2..3", "2#1"},
        {based_integer, "16#F_", "1302@4..5", "16#F"},
        {based_integer, "16#F__F", "1302@5..6", "16#F_F"},
        {based_integer, "16_#FF", "1302@2..3", "16#FF"},
        {typed_literal, "INT#_5", "1302@4..5", "INT#5"},
        {typed_literal, "INT#-_5", "1302@5..6", "INT#-5"},
        // 1303
        {based_integer, "10#5", "1303@0..2", "5"},
        {based_integer, "3#12", "1303@0..1"},
        {based_integer, "0#1", "1303@0..1"},
        {based_integer, "1_6#FF", "1303@0..3"},
        {based_integer, "016#FF", "1303@0..3"},
        {based_integer, "10#FF", "1303@0..2"},
        {typed_literal, "INT#10#5", "1303@4..6", "INT#5"},
        // 1304
        {based_integer, "16#", "1304@3..3"},
        {typed_literal, "INT#16#", "1304@7..7"},
        {real, "1.0E", "1304@4..4"},
        {real, "1.0E+", "1304@5..5"},
        {real, "1.0e-", "1304@5..5"},
        {typed_literal, "INT#", "1304@4..4"},
        {typed_literal, "INT#-", "1304@5..5"},
        {typed_literal, "REAL#", "1304@5..5"},
        {typed_literal, "WORD#", "1304@5..5"},
        {typed_literal, "BOOL#", "1304@5..5"},
        {typed_literal, "STRING#", "1312@6..7"},
        // 1305
        {real, "1.5abc", "1305@3..6"},
        {real, "1.5_abc", "1305@3..7"},
        {real, "1.0E3x", "1305@5..6"},
        {real, "1.5\xC3\x84", "1305@3..5"},
        {real, "1.2.3", "1305@3..5"},
        {integer, "12ab", "1305@2..4"},
        {integer, "12_ab", "1305@2..5"},
        {typed_literal, "INT#5x", "1305@5..6"},
        {based_integer, "16#FF#2", "1305@5..7"},
        // 1306
        {typed_literal, "REAL#5", "1306@5..6", "REAL#5.0"},
        {typed_literal, "REAL#-5", "1306@5..7", "REAL#-5.0"},
        {typed_literal, "REAL#16#FF", "1306@5..10"},
        {typed_literal, "INT#5.0", "1306@4..7"},
        {typed_literal, "INT#1E3", "1306@4..7"},
        {typed_literal, "INT#1.", "1306@4..6"},
        {typed_literal, "WORD#-1", "1306@5..7"},
        {typed_literal, "WORD#+1", "1306@5..7", "WORD#1"},
        {typed_literal, "WORD#1.5", "1306@5..8"},
        {typed_literal, "BOOL#2", "1306@5..6"},
        {typed_literal, "BOOL#01", "1306@5..7"},
        {typed_literal, "BOOL#2#1", "1306@5..8"},
        {typed_literal, "BOOL#-1", "1306@5..7"},
        {typed_literal, "BOOL#YES", "1306@5..8"},
        {typed_literal, "INT#TRUE", "1306@4..8"},
        {typed_literal, "INT#FF", "1306@4..6"},
        {typed_literal, "INT##5", "1306@4..6"},
        {typed_literal, "INT#--5", "1306@4..7"},
        {typed_literal, "INT#'a b'", "1306@4..9"},
        {typed_literal, "STRING#5", "1306@7..8"},
        {typed_literal, "WSTRING#TRUE", "1306@8..12"},
        // 1307: FitTheirTypeAtBothEndsOfItsRange
        {typed_literal, "SINT#200", "1307@5..8"},
        {typed_literal, "INT#16#FFFF", "1307@4..11"},
        // 1309
        {typed_literal, "INT#-16#FF", "1309@4..5", "INT#-255"},
        {typed_literal, "INT#+16#FF", "1309@4..5", "INT#16#FF"},
        {typed_literal, "SINT#-2#1000_0000", "1309@5..6", "SINT#-128"},
        {typed_literal, "SINT#-2#1000_0001", "1309@5..6"},
        {typed_literal, "WORD#-16#FF", "1309@5..6"},
        // 1318
        {based_integer, "16#1.5", "1318@4..6"},
        {based_integer, "16#FF.5", "1318@5..7"},
        {typed_literal, "INT#16#1.5x", "1318@8..11"},
        {typed_literal, "WORD#16#F.F", "1318@9..11"},
        // other dialects
        {real, "1E3", "5003@0..3", "1.0E3"},
        {real, ".5", "5004@0..1", "0.5"},
        {real, "1.", "5007@1..2", "1.0"},
        {real, "1.e3", "5007@1..2", "1.0e3"},
    };
    for (const LiteralCase& literal : cases)
        expect_faults(literal);
}

TEST(NumericLiterals, TellTheirFaultsInTheUsersWords) {
    const auto words = [](TokenKind kind, std::string_view text) {
        return message(check_literal(kind, text, Encoding::utf8).at(0));
    };
    EXPECT_EQ(words(based_integer, "16#FFgh"), "`gh` is not a digit of base 16");
    EXPECT_EQ(words(based_integer, "16#"), "digits are missing after `16#`");
    EXPECT_EQ(words(real, "1.0E+"), "digits are missing after `E+`");
    EXPECT_EQ(words(typed_literal, "int#"), "digits are missing after `int#`");
    EXPECT_EQ(words(typed_literal, "real#5"), "`REAL#` needs a real literal, found `5`");
    EXPECT_EQ(words(typed_literal, "BOOL#2"), "`BOOL#` needs 0, 1, TRUE or FALSE, found `2`");
    EXPECT_EQ(words(typed_literal, "WORD#-1"),
              "`WORD#` needs an integer without a sign, found `-1`");
    EXPECT_EQ(words(typed_literal, "STRING#5"),
              "`STRING#` needs a string in single quotes, found `5`");
    EXPECT_EQ(words(typed_literal, "SINT#200"),
              "the value does not fit SINT: its range is -128 to 127");
}

TEST(NumericLiterals, TakeNoTextOfAnotherClass) {
    for (const std::string_view text :
         {"", "x", "#", "#5", "-5", "+5", "'5'", "T#5", "D#5", "TIME#5", "%I1", "+", "D#1984-06-25",
          "_", "MyType#abc", "MyType##"}) {
        EXPECT_FALSE(integer_value(text).has_value()) << text;
        EXPECT_FALSE(real_value(text).has_value()) << text;
    }
}

TEST(NumericLiterals, WithWhiteSpaceAreTheLexersToReport) {
    for (const std::string_view text : {"INT# 5", "INT #5", "16# FFG", "1 000", "INT#\t99999"}) {
        EXPECT_EQ(faults_of(typed_literal, text), "") << text;
        EXPECT_FALSE(integer_value(text).has_value()) << text;
    }
}

} // namespace

} // namespace iecfront::tests
