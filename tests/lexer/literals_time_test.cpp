#include "support/literal_faults.hpp"

#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace iecfront::tests {

namespace {

using enum TokenKind;

constexpr std::int64_t ns = 1;
constexpr std::int64_t ms = 1'000'000 * ns;
constexpr std::int64_t s = 1000 * ms;
constexpr std::int64_t min = 60 * s;
constexpr std::int64_t h = 60 * min;
constexpr std::int64_t d = 24 * h;
constexpr std::int64_t highest = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();

// ---- durations -------------------------------------------------------------------------------

struct DurationCase {
    std::string_view text;
    std::int64_t nanoseconds;
    std::string_view faults = {};
};

void expect_duration(const DurationCase& expected) {
    SCOPED_TRACE(expected.text);
    expect_invariants(duration, expected.text);
    EXPECT_EQ(faults_of(duration, expected.text), expected.faults);
    const auto value = duration_value(expected.text);
    ASSERT_TRUE(value.has_value());
    EXPECT_EQ(value->nanoseconds, expected.nanoseconds);
    EXPECT_EQ(value->inexact, expected.faults.find("9007") != std::string_view::npos);
    EXPECT_EQ(value->overflow, expected.faults.find("9006") != std::string_view::npos);
}

TEST(Durations, HaveTheValuesOfTable7) {
    const std::vector<DurationCase> cases = {
        {"T#14ms", 14 * ms},
        {"T#-14ms", -14 * ms},
        {"T#14.7s", 14 * s + 700 * ms},
        {"T#14.7m", 14 * min + 42 * s},
        {"T#14.7h", 14 * h + 42 * min},
        {"t#14.7d", 14 * d + 16 * h + 48 * min},
        {"t#25h15m", 25 * h + 15 * min},
        {"t#5d14h12m18s3.5ms", 5 * d + 14 * h + 12 * min + 18 * s + 3 * ms + 500'000},
        {"TIME#14ms", 14 * ms},
        {"TIME#-14ms", -14 * ms},
        {"time#14.7s", 14 * s + 700 * ms},
        {"t#25h_15m", 25 * h + 15 * min},
        {"t#5d_14h_12m_18s_3.5ms", 5 * d + 14 * h + 12 * min + 18 * s + 3 * ms + 500'000},
        {"TIME#25h_15m", 25 * h + 15 * min},
        {"time#5d_14h_12m_18s_3.5ms", 5 * d + 14 * h + 12 * min + 18 * s + 3 * ms + 500'000},
    };
    for (const DurationCase& expected : cases)
        expect_duration(expected);
}

TEST(Durations, TakeAnyDescendingUnits) {
    const std::vector<DurationCase> cases = {
        {"T#1h30s", h + 30 * s},
        {"T#5d3ms", 5 * d + 3 * ms},
        {"T#1D2H3M4S5MS", d + 2 * h + 3 * min + 4 * s + 5 * ms},
        {"T#1h30.5m", h + 30 * min + 30 * s},
        {"T#1h_30m", h + 30 * min},
        {"T#0.5ms", 500'000},
        {"T#5s_3ms", 5 * s + 3 * ms},
        {"T#1m", min},
        {"T#1ms", ms},
        {"T#0s", 0},
        {"T#-0d", 0},
        {"T#1_000ms", s},
        {"T#0.1_5s", 150 * ms},
    };
    for (const DurationCase& expected : cases)
        expect_duration(expected);
}

TEST(Durations, CanOverflowInTheirFirstUnit) {
    const std::vector<DurationCase> cases = {
        {"T#90s", 90 * s},
        {"T#1000ms", s},
        {"T#100m_59s", 100 * min + 59 * s},
        {"T#99999h_59m", 99999 * h + 59 * min},
        {"T#1d23h59m59s999ms", d + 23 * h + 59 * min + 59 * s + 999 * ms},
        {"T#1d_59.999m", d + 59 * min + 59 * s + 940 * ms},
    };
    for (const DurationCase& expected : cases)
        expect_duration(expected);
}

TEST(Durations, AreExactToTheNanosecond) {
    const std::vector<DurationCase> cases = {
        {"T#0.000000001s", 1},
        {"T#0.000001ms", 1},
        {"T#0.123456789s", 123456789},
        {"T#0.1000000000000000000000000000000000000s", 100 * ms},
        {"T#1.0000000001s", s, "9007@13..14"},
        {"T#0.0000000005s", 0, "9007@13..14"},
        {"T#-0.000_000_000_59s", 0, "9007@17..19"},
        {"T#0.0000001ms", 0, "9007@10..11"},
        {"T#0.00000000001d", 864},
        {"T#0.000000000001d", 86, "9007@15..16"},
        {"T#0.0000000000125d", 1080},
        {"T#0.33333333333333333333d", 28'799'999'999'999, "9007@15..24"},
        {"T#0.99999999999999999999d", d - 1, "9007@15..24"},
        {"T#0.0000000000025h", 9},
        {"T#0.00000000005m", 3},
    };
    for (const DurationCase& expected : cases)
        expect_duration(expected);
}

TEST(Durations, BeyondTheRangeStayAtItsEnd) {
    const std::vector<DurationCase> cases = {
        {"T#9223372036854.775807ms", highest},
        {"T#-9223372036854.775808ms", lowest},
        {"T#106751d23h47m16s854.775807ms", highest},
        {"T#-106751d23h47m16s854.775808ms", lowest},
        {"T#9223372036854.775808ms", highest, "9006@2..24"},
        {"T#-9223372036854.775809ms", lowest, "9006@2..25"},
        {"T#106752d", highest, "9006@2..9"},
        {"T#-106752d", lowest, "9006@2..10"},
        {"T#999999999999999999999999999ms", highest, "9006@2..31"},
        {"T#18446744073709551615d_23h", highest, "9006@2..27"},
        {"T#106751d23h47m16s854.7758079ms", highest, "9007@28..29"},
    };
    for (const DurationCase& expected : cases)
        expect_duration(expected);
}

TEST(Durations, WithAFaultAreReportedWhereItIs) {
    const std::vector<LiteralCase> cases = {
        // 1501
        {duration, "T#", "1501@2..2"},
        {duration, "TIME#-", "1501@6..6"},
        {duration, "T#ms", "1501@2..4"},
        {duration, "T#abc", "1501@2..5"},
        {duration, "T#'5 s'", "1501@2..7"},
        {duration, "T#_", "1501@2..3"},
        {duration, "T#--5s", "1501@3..6"},
        // 1502
        {duration, "T#5", "1502@2..3"},
        {duration, "TIME#5", "1502@5..6"},
        {typed_literal, "TIME#5", "1502@5..6"},
        {duration, "T#1.5", "1502@2..5"},
        {duration, "T#5_", "1502@2..3"},
        {duration, "T#1h30", "1502@4..6"},
        // 5008
        {duration, "T#5us", "5008@3..5"},
        {duration, "T#1ms5us3ns", "5008@6..8"},
        // 1503
        {duration, "T#5\xC2\xB5s", "1503@3..6"},
        {duration, "T#1h5min", "1503@5..8"},
        {duration, "T#1E3s", "1503@3..4"},
        // 1504
        {duration, "T#5m3h", "1504@5..6"},
        {duration, "T#5ms_3s", "1504@7..8"},
        // 1511
        {duration, "T#1h-5m", "1511@4..5"},
        {duration, "T#1h_-5m", "1511@5..6"},
        {duration, "T#1h+5m", "1511@4..5", "T#1h5m"},
        {duration, "T#1h+5m+3.5s", "1511@4..5 1511@7..8", "T#1h5m3.5s"},
        {duration, "T#-1h-5ms", "1511@5..6"},
        // 1505
        {duration, "T#5s5s", "1505@5..6"},
        {duration, "T#1h5m_2H", "1505@8..9"},
        // 1506
        {duration, "T#1.5h30m", "1506@3..5"},
        {duration, "T#1.5h2.5m3s", "1506@3..5 1506@7..9"},
        // 1507
        {duration, "T#1h_75m", "1507@5..7"},
        {duration, "T#1h60m", "1507@4..6"},
        {duration, "T#1d24h60m60s1000ms", "1507@4..6 1507@7..9 1507@10..12 1507@13..17"},
        {duration, "T#1m60.0s", "1507@4..6"},
        {duration, "T#1m99999999999999999999999s", "1507@4..27"},
        // 1508
        {duration, "T#5_s", "1508@3..4", "T#5s"},
        {duration, "T#1.5_s", "1508@5..6", "T#1.5s"},
        {duration, "T#5s_", "1508@4..5", "T#5s"},
        {duration, "T#_5s", "1508@2..3", "T#5s"},
        {duration, "T#-_5s", "1508@3..4", "T#-5s"},
        {duration, "T#1h__30m", "1508@5..6", "T#1h_30m"},
        {duration, "T#1__000ms", "1508@4..5", "T#1_000ms"},
        {duration, "T#1_.5s", "1508@3..4", "T#1.5s"},
        {duration, "T#1._5s", "1508@4..5", "T#1.5s"},
        // 1509
        {duration, "T#+5s", "1509@2..3", "T#5s"},
        // 1304
        {duration, "T#.5s", "1304@2..2", "T#0.5s"},
        {duration, "T#5.s", "1304@4..4", "T#5.0s"},
        {duration, "T#1h.5m", "1304@4..4", "T#1h0.5m"},
        {duration, "T#1h_m", "1304@5..5"},
        // several
        {duration, "T#+1__0h_75_m", "1509@2..3 1508@5..6 1507@9..11 1508@11..12", "T#1_0h_75m"},
    };
    for (const LiteralCase& literal : cases)
        expect_faults(literal);
}

TEST(Durations, PointAtTheFirstOfTwoEqualUnits) {
    const auto faults = check_literal(duration, "T#5s_3S", Encoding::utf8);
    ASSERT_EQ(faults.size(), 1U);
    ASSERT_EQ(faults[0].labels.size(), 1U);
    EXPECT_EQ(faults[0].labels[0].range, (TextRange{3, 4}));
    EXPECT_EQ(message(faults[0]), "unit `S` is given twice");
}

TEST(Durations, TakeNoTextOfAnotherClass) {
    for (const std::string_view text : {"", "5s", "T", "D#5s", "LTIME#5s", "T# 5s", "T #5s"}) {
        EXPECT_FALSE(duration_value(text).has_value()) << text;
        EXPECT_EQ(faults_of(duration, text), "") << text;
    }
}

// ---- dates and times of day ------------------------------------------------------------------

struct DateCase {
    std::string_view text;
    DateValue value;
};

TEST(Dates, HaveTheValuesOfTable9) {
    const std::vector<DateCase> cases = {
        {"D#1984-06-25", {1984, 6, 25}},
        {"DATE#1984-06-25", {1984, 6, 25}},
        {"d#1984-06-25", {1984, 6, 25}},
        {"date#1984-06-25", {1984, 6, 25}},
        {"D#1984-6-5", {1984, 6, 5}},
        {"D#0001-01-01", {1, 1, 1}},
        {"D#1-1-1", {1, 1, 1}},
        {"D#9999-12-31", {9999, 12, 31}},
        {"D#1_984-0_6-2_5", {1984, 6, 25}},
        {"D#2000-02-29", {2000, 2, 29}},
        {"D#1984-02-29", {1984, 2, 29}},
        {"D#1985-02-28", {1985, 2, 28}},
        {"D#0002000-00012-031", {2000, 12, 31}},
    };
    for (const DateCase& expected : cases) {
        EXPECT_EQ(faults_of(date, expected.text), "") << expected.text;
        EXPECT_EQ(date_value(expected.text), expected.value) << expected.text;
        EXPECT_EQ(faults_of(typed_literal, expected.text), "") << expected.text;
    }
}

TEST(Dates, FollowTheCalendar) {
    constexpr std::array days = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    for (const int year : {1, 4, 1900, 1999, 2000, 2024, 2100, 9999}) {
        const bool leap = year == 4 || year == 2000 || year == 2024;
        for (int month = 1; month <= 12; ++month) {
            const std::string text =
                "D#" + std::to_string(year) + '-' + std::to_string(month) + '-';
            const int last = days.at(static_cast<std::size_t>(month - 1)) + (leap && month == 2);
            EXPECT_TRUE(date_value(text + "1").has_value()) << text;
            EXPECT_TRUE(date_value(text + std::to_string(last)).has_value()) << text;
            EXPECT_FALSE(date_value(text + std::to_string(last + 1)).has_value()) << text;
            EXPECT_FALSE(date_value(text + "0").has_value()) << text;
        }
    }
}

TEST(Dates, WithAFaultAreReportedWhereItIs) {
    const std::vector<LiteralCase> cases = {
        // 1601
        {date, "D#", "1601@2..2"},
        {date, "D#1984", "1601@6..6"},
        {date, "D#1984-06", "1601@9..9"},
        {date, "D#1984-06-", "1601@10..10"},
        {date, "D#1984-06-25-10", "1601@12..15"},
        {date, "D#1984-06-25abc", "1601@12..15"},
        {date, "D#1984-Jun-25", "1601@7..13"},
        {date, "D#1984:06:25", "1601@6..12"},
        {date, "D#-5-1-1", "1601@2..8"},
        {date, "D#'1984'", "1601@2..8"},
        {date_and_time, "DT#1984-06", "1601@10..10"},
        // 1603
        {date, "D#1984-13-01", "1603@7..9"},
        {date, "D#1984-00-01", "1603@7..9"},
        {date, "D#1984-99999999999999999999999-01", "1603@7..30"},
        // 1604
        {date, "D#1984-06-31", "1604@10..12"},
        {date, "D#1984-06-00", "1604@10..12"},
        {date, "D#1985-02-29", "1604@10..12"},
        {date, "D#1900-02-29", "1604@10..12"},
        {date, "D#1984-01-32", "1604@10..12"},
        // 1302
        {date, "D#1984_-06-25", "1302@6..7", "D#1984-06-25"},
        {date, "D#1984-0__6-25", "1302@9..10", "D#1984-0_6-25"},
        // 9008
        {date, "D#0000-01-01", "9008@2..6"},
        {date, "D#10000-01-01", "9008@2..7"},
        {date, "D#99999999999999999999999-01-01", "9008@2..25"},
        {date, "D#10000-02-30", "9008@2..7 1604@11..13"},
    };
    for (const LiteralCase& literal : cases)
        expect_faults(literal);
    // A limit only, but the value has no room for such a year.
    EXPECT_FALSE(date_value("D#0000-01-01").has_value());
    EXPECT_FALSE(date_value("D#10000-01-01").has_value());
}

TEST(Dates, TellTheirFaultsInTheUsersWords) {
    const auto words = [](TokenKind kind, std::string_view text) {
        return message(check_literal(kind, text, Encoding::utf8).at(0));
    };
    EXPECT_EQ(words(date, "D#1984"), "a date has the form `D#1984-06-25`");
    EXPECT_EQ(words(date, "date#x"), "a date has the form `date#1984-06-25`");
    EXPECT_EQ(words(date, "D#1984-13-1"), "there is no month 13");
    EXPECT_EQ(words(date, "D#1984-06-31"), "June has no day 31");
    EXPECT_EQ(words(date, "D#1985-02-29"), "February 1985 has no day 29");
    EXPECT_EQ(words(time_of_day, "TOD#12"),
              "a literal with a time of day has the form `TOD#15:36:55.36`");
    EXPECT_EQ(words(date_and_time, "DT#1984-06-25"),
              "a literal with a time of day has the form `DT#1984-06-25-15:36:55.36`");
    EXPECT_EQ(words(duration, "T#1h75m"),
              "`m` goes up to 59 here: only the first unit can overflow");
    EXPECT_EQ(words(duration, "T#5m3h"), "`h` cannot follow `m`: larger units come first");
}

struct TimeCase {
    std::string_view text;
    TimeOfDayValue value;
};

TEST(TimesOfDay, HaveTheValuesOfTable9) {
    const std::vector<TimeCase> cases = {
        {"TOD#15:36:55.36", {15, 36, 55, 360'000'000}},
        {"TIME_OF_DAY#15:36:55.36", {15, 36, 55, 360'000'000}},
        {"tod#15:36:55.36", {15, 36, 55, 360'000'000}},
        {"time_of_day#15:36:55.36", {15, 36, 55, 360'000'000}},
        {"TOD#0:0:0", {0, 0, 0, 0}},
        {"TOD#00:00:00.000000001", {0, 0, 0, 1}},
        {"TOD#23:59:59.999999999", {23, 59, 59, 999'999'999}},
        {"TOD#23:59:59.999_999_999_000_000_000", {23, 59, 59, 999'999'999}},
        {"TOD#1:2:3", {1, 2, 3, 0}},
    };
    for (const TimeCase& expected : cases) {
        EXPECT_EQ(faults_of(time_of_day, expected.text), "") << expected.text;
        EXPECT_EQ(time_of_day_value(expected.text), expected.value) << expected.text;
        EXPECT_EQ(faults_of(typed_literal, expected.text), "") << expected.text;
    }
}

TEST(TimesOfDay, WithAFaultAreReportedWhereItIs) {
    const std::vector<LiteralCase> cases = {
        // 1602
        {time_of_day, "TOD#", "1602@4..4"},
        {time_of_day, "TOD#15", "1602@6..6"},
        {time_of_day, "TOD#15:36", "1602@9..9"},
        {time_of_day, "TOD#15:36:", "1602@10..10"},
        {time_of_day, "TOD#15::55", "1602@7..10"},
        {time_of_day, "TOD#15.5:36:55", "1602@6..14"},
        {time_of_day, "TOD#15:36:55:10", "1602@12..15"},
        {time_of_day, "TOD#15:36:55.1.2", "1602@14..16"},
        {time_of_day, "TOD#15:36:55pm", "1602@12..14"},
        // 1605 to 1607
        {time_of_day, "TOD#24:00:00", "1605@4..6"},
        {time_of_day, "TOD#23:60:00", "1606@7..9"},
        {time_of_day, "TOD#23:59:60", "1607@10..12"},
        {time_of_day, "TOD#23:59:60.0", "1607@10..12"},
        {time_of_day, "TOD#99:99:99", "1605@4..6 1606@7..9 1607@10..12"},
        // 1302, 1304
        {time_of_day, "TOD#15:36_:55", "1302@9..10", "TOD#15:36:55"},
        {time_of_day, "TOD#15:36:55.", "1304@13..13", "TOD#15:36:55.0"},
        // 9007
        {time_of_day, "TOD#15:36:55.1234567891", "9007@22..23"},
    };
    for (const LiteralCase& literal : cases)
        expect_faults(literal);
    EXPECT_EQ(time_of_day_value("TOD#15:36:55.1234567891"),
              (TimeOfDayValue{15, 36, 55, 123'456'789}));
}

TEST(DatesAndTimes, HaveTheValuesOfTable9) {
    const DateAndTimeValue expected = {{1984, 6, 25}, {15, 36, 55, 360'000'000}};
    for (const std::string_view text :
         {"DT#1984-06-25-15:36:55.36", "DATE_AND_TIME#1984-06-25-15:36:55.36",
          "dt#1984-06-25-15:36:55.36", "date_and_time#1984-6-25-15:36:55.360"}) {
        EXPECT_EQ(faults_of(date_and_time, text), "") << text;
        EXPECT_EQ(date_and_time_value(text), expected) << text;
        EXPECT_EQ(faults_of(typed_literal, text), "") << text;
    }
}

TEST(DatesAndTimes, WithAFaultAreReportedWhereItIs) {
    const std::vector<LiteralCase> cases = {
        {date_and_time, "DT#", "1601@3..3"},
        {date_and_time, "DT#1984-06-25", "1602@13..13"},
        {date_and_time, "DT#1984-06-25-15:36", "1602@19..19"},
        {date_and_time, "DT#1984-06-25:15:36:55", "1602@13..22"},
        {date_and_time, "DT#1984-02-30-24:00:00", "1604@11..13 1605@14..16"},
        {date_and_time, "DT#0000-02-01-00:00:60", "9008@3..7 1607@20..22"},
    };
    for (const LiteralCase& literal : cases)
        expect_faults(literal);
}

TEST(DatesAndTimes, TakeNoTextOfAnotherClass) {
    for (const std::string_view text :
         {"", "1984-06-25", "LD#1984-06-25", "D# 1984-06-25", "T#5s", "LTOD#1:2:3", "x"}) {
        EXPECT_FALSE(date_value(text).has_value()) << text;
        EXPECT_FALSE(time_of_day_value(text).has_value()) << text;
        EXPECT_FALSE(date_and_time_value(text).has_value()) << text;
        EXPECT_EQ(faults_of(date, text), "") << text;
    }
    EXPECT_FALSE(date_value("DT#1984-06-25-15:36:55").has_value());
    EXPECT_FALSE(date_and_time_value("D#1984-06-25").has_value());
}

} // namespace

} // namespace iecfront::tests
