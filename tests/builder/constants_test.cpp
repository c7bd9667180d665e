#include <iecfront/builder/constants.hpp>
#include <iecfront/parser/parse.hpp>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

// Each constant has the value that it was made of, and is read as the node that its function is
// called after (B.1.2).

namespace iecfront::test {
namespace {

using namespace build;
using namespace std::chrono_literals;

void expect_read_as(const AnyPart& part) {
    EXPECT_EQ(part.fault(), "");
    ParseOptions options;
    options.read_as = FragmentKind::expression;
    const SyntaxTree tree = parse(SourceText(part.text()), options);
    EXPECT_TRUE(tree.diagnostics().empty()) << part.text();
    EXPECT_EQ(tree.slots()[0].unit->root().elements[0]->kind, part.kind()) << part.text();
}

TEST(BuiltConstants, Integers) {
    EXPECT_EQ(integer_literal(0).text(), "0");
    EXPECT_EQ(integer_literal(-5).text(), "-5");
    EXPECT_EQ(integer_literal(-5, "int").text(), "int#-5");
    EXPECT_EQ(integer_literal(std::numeric_limits<std::int64_t>::min()).text(),
              "-9223372036854775808");
    EXPECT_EQ(based_integer_literal(255, 16).text(), "16#FF");
    EXPECT_EQ(based_integer_literal(8, 8, "UINT").text(), "UINT#8#10");
    EXPECT_EQ(based_integer_literal(5, 2).text(), "2#101");
    EXPECT_EQ(based_integer_literal(std::numeric_limits<std::uint64_t>::max(), 10).text(),
              "18446744073709551615");
    for (const std::int64_t value : {std::int64_t{0}, std::int64_t{-17}, std::int64_t{1} << 40})
        expect_read_as(integer_literal(value));
    expect_read_as(based_integer_literal(200, 16, "USINT"));
}

TEST(BuiltConstants, Reals) {
    EXPECT_EQ(real_literal(1.5).text(), "1.5");
    EXPECT_EQ(real_literal(-2).text(), "-2.0");
    EXPECT_EQ(real_literal(1e100).text(), "1.0E+100");
    EXPECT_EQ(real_literal(1.25e-7, "LREAL").text(), "LREAL#1.25E-07");
    for (const double value : {0.1, 1e300, 5e-324, 1e21, 123456.789, 0.0, 1e15})
        EXPECT_EQ(real_value(real_literal(value).text())->value, value);
    expect_read_as(real_literal(-1e22));
    expect_read_as(real_literal(1e22, "REAL"));
}

TEST(BuiltConstants, BitStringsAndBooleans) {
    EXPECT_EQ(bit_string_literal(255, "WORD").text(), "WORD#16#00FF");
    EXPECT_EQ(bit_string_literal(0xABCDE, "DWORD").text(), "DWORD#16#000ABCDE");
    EXPECT_EQ(bit_string_literal(~std::uint64_t{0}, "LWORD").text(), "LWORD#16#FFFFFFFFFFFFFFFF");
    expect_read_as(bit_string_literal(1, "BYTE"));
    expect_read_as(boolean_literal(true));
    expect_read_as(boolean_literal(false));
}

TEST(BuiltConstants, Strings) {
    EXPECT_EQ(character_string("it's $5").text(), "'it$'s $$5'");
    EXPECT_EQ(character_string("say \"so\"", StringWidth::double_byte).text(), "\"say $\"so$\"\"");
    EXPECT_EQ(character_string("\xC3\x84\n\t\r\f").text(), "'$C4$L$T$R$P'");
    EXPECT_EQ(character_string("\xE2\x82\xAC", StringWidth::double_byte).text(), "\"$20AC\"");
    EXPECT_EQ(character_string(std::string_view("\0", 1)).text(), "'$00'");
    expect_read_as(character_string(""));
    std::string all;
    for (char c = 1; c < 127; ++c)
        all += c;
    for (const StringWidth width : {StringWidth::single_byte, StringWidth::double_byte}) {
        const std::optional<StringValue> value =
            string_value(character_string(all, width).text(), Encoding::utf8);
        ASSERT_TRUE(value.has_value());
        ASSERT_EQ(value->elements.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            EXPECT_EQ(value->elements[i].code, static_cast<unsigned char>(all[i]));
    }
}

TEST(BuiltConstants, Durations) {
    EXPECT_EQ(duration(0s).text(), "T#0s");
    EXPECT_EQ(duration(90min).text(), "T#1h30m");
    EXPECT_EQ(duration(-1500ms).text(), "T#-1s500ms");
    EXPECT_EQ(duration(24h + 1ns).text(), "T#1d0.000001ms");
    for (const std::chrono::nanoseconds value :
         {std::chrono::nanoseconds(1), std::chrono::nanoseconds(25h + 61min + 3ms + 7us),
          std::chrono::nanoseconds(-5us), std::chrono::nanoseconds::max(),
          std::chrono::nanoseconds::min()}) {
        EXPECT_EQ(duration_value(duration(value).text())->nanoseconds, value.count());
        expect_read_as(duration(value));
    }
}

TEST(BuiltConstants, Dates) {
    constexpr DateValue day{1984, 6, 5};
    constexpr TimeOfDayValue time{5, 6, 7, 360'000'000};
    EXPECT_EQ(date(day).text(), "D#1984-06-05");
    EXPECT_EQ(time_of_day(time).text(), "TOD#05:06:07.36");
    EXPECT_EQ(date_and_time({day, time}).text(), "DT#1984-06-05-05:06:07.36");
    EXPECT_EQ(date_value(date(day).text()), day);
    EXPECT_EQ(time_of_day_value(time_of_day(time).text()), time);
    EXPECT_EQ(time_of_day_value(time_of_day({1, 2, 30, 1}).text())->nanosecond, 1U);
    expect_read_as(date_and_time({day, time}));
}

TEST(BuiltConstants, ThatAreNoneHaveAFault) {
    const std::array<AnyPart, 14> none = {
        integer_literal(5, "REAL"),
        integer_literal(5, "MyInt"),
        based_integer_literal(5, 3),
        based_integer_literal(5, 16, "BOOL"),
        real_literal(std::numeric_limits<double>::infinity()),
        real_literal(std::nan("")),
        real_literal(1, "INT"),
        bit_string_literal(256, "BYTE"),
        bit_string_literal(1, "BOOL"),
        character_string("\xE2\x82\xAC"),
        character_string("\xF0\x9F\x98\x80", StringWidth::double_byte),
        character_string("\xFF"),
        date({1999, 2, 29}),
        time_of_day({25, 0, 0, 0}),
    };
    for (const AnyPart& part : none)
        EXPECT_NE(part.fault(), "") << part.text();
}

} // namespace
} // namespace iecfront::test
