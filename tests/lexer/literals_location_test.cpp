#include "support/literal_faults.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace iecfront::tests {

namespace {

using enum TokenKind;

struct LocationCase {
    std::string_view text;
    char location;
    char size;
    std::vector<std::uint64_t> hierarchy;
};

TEST(DirectVariables, HaveTheirParts) {
    const std::vector<LocationCase> cases = {
        {"%IX1", 'I', 'X', {1}},
        {"%QX1.2.3", 'Q', 'X', {1, 2, 3}},
        {"%I1", 'I', 'X', {1}},
        {"%q0.7", 'Q', 'X', {0, 7}},
        {"%MB5", 'M', 'B', {5}},
        {"%MW10", 'M', 'W', {10}},
        {"%md48", 'M', 'D', {48}},
        {"%Ml2", 'M', 'L', {2}},
        {"%IW2.5.7.1", 'I', 'W', {2, 5, 7, 1}},
        {"%IX1_0.0_1", 'I', 'X', {10, 1}},
        {"%MW18446744073709551615", 'M', 'W', {std::numeric_limits<std::uint64_t>::max()}},
    };
    for (const LocationCase& expected : cases) {
        SCOPED_TRACE(expected.text);
        EXPECT_EQ(faults_of(direct_variable, expected.text), "");
        const auto value = direct_variable_value(expected.text);
        ASSERT_TRUE(value.has_value());
        EXPECT_EQ(value->location, expected.location);
        EXPECT_EQ(value->size, expected.size);
        EXPECT_EQ(value->hierarchy, expected.hierarchy);
        EXPECT_FALSE(value->incomplete);
    }
}

TEST(DirectVariables, CanBeIncomplete) {
    for (const std::string_view text : {"%I*", "%Q*", "%M*", "%i*", "%q*", "%m*"}) {
        EXPECT_EQ(faults_of(incomplete_location, text), "") << text;
        const auto value = direct_variable_value(text);
        ASSERT_TRUE(value.has_value());
        EXPECT_TRUE(value->incomplete);
        EXPECT_EQ(value->location, text[1] & 0x5F);
        EXPECT_TRUE(value->hierarchy.empty());
    }
}

TEST(DirectVariables, WithAFaultAreReportedWhereItIs) {
    const std::vector<LiteralCase> cases = {
        // 1701
        {direct_variable, "%", "1701@1..1"},
        {direct_variable, "%X1", "1701@1..2"},
        {direct_variable, "%1", "1701@1..2"},
        {direct_variable, "%\xC3\x84", "1701@1..3"},
        {direct_variable, "%*", "1701@1..2"},
        // 1702
        {direct_variable, "%IZ1", "1702@2..3"},
        {direct_variable, "%IXX1", "1702@2..4"},
        {direct_variable, "%IZ1.", "1702@2..3 1703@5..5"},
        // 1703
        {direct_variable, "%I", "1703@2..2"},
        {direct_variable, "%IX", "1703@3..3"},
        {direct_variable, "%IX1.", "1703@5..5"},
        {direct_variable, "%IX.1", "1703@3..3"},
        {direct_variable, "%IX1..2", "1703@5..5", "%IX1.2"},
        {direct_variable, "%IX1.a", "1703@5..5"},
        // 1704
        {incomplete_location, "%IX*", "1704@2..3", "%I*"},
        {incomplete_location, "%I*1", "1704@3..4", "%I*"},
        {incomplete_location, "%IX1*", "1704@2..4", "%I*"},
        {incomplete_location, "%QX*1.2", "1704@2..3 1704@4..7", "%Q*"},
        {direct_variable, "%I**", "1704@3..4", "%I*"},
        // 1302, 1305, 1308
        {direct_variable, "%IX1__2", "1302@5..6", "%IX1_2"},
        {direct_variable, "%IX_1", "1302@3..4", "%IX1"},
        {direct_variable, "%IX1_.2", "1302@4..5", "%IX1.2"},
        {direct_variable, "%IX1a", "1305@4..5"},
        {direct_variable, "%IX1.2x3", "1305@6..8"},
        {direct_variable, "%MW18446744073709551616", "1308@3..23"},
    };
    for (const LiteralCase& literal : cases)
        expect_faults(literal);
    EXPECT_FALSE(direct_variable_value("%MW18446744073709551616").has_value());
}

TEST(DirectVariables, SayWhatIsMissing) {
    const auto words = [](std::string_view text) {
        return message(check_literal(direct_variable, text, Encoding::utf8).at(0));
    };
    EXPECT_EQ(words("%IX"), "a number is missing after `%IX`");
    EXPECT_EQ(words("%IX1."), "a number is missing after `.`");
    EXPECT_EQ(words("%ix*"), "a location that is not yet specified has the form `%I*`");
    EXPECT_EQ(words("%IQ1"), "`Q` is not a size: these are X, B, W, D and L");
}

TEST(DirectVariables, TakeNoTextOfAnotherClass) {
    for (const std::string_view text : {"", "IX1", "5", "%IX 1", "% IX1"}) {
        EXPECT_FALSE(direct_variable_value(text).has_value()) << text;
        EXPECT_EQ(faults_of(direct_variable, text), "") << text;
    }
}

} // namespace

} // namespace iecfront::tests
