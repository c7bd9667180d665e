#include <iecfront/source/source_text.hpp>

#include <gtest/gtest.h>

using namespace iecfront;

namespace {

TEST(SourceText, KeepsBytesNameAndEncoding) {
    const SourceText source(std::string("a\0b", 3), "tank.st", Encoding::windows_1252);
    EXPECT_EQ(source.bytes(), std::string_view("a\0b", 3));
    EXPECT_EQ(source.name(), "tank.st");
    EXPECT_EQ(source.encoding(), Encoding::windows_1252);
    EXPECT_FALSE(source.too_large());
}

TEST(SourceText, AZeroByteStandsBehindTheLast) {
    const SourceText source("abc");
    EXPECT_EQ(source.bytes().data()[3], '\0');
}

TEST(SourceText, CopiesShareTheBytes) {
    const SourceText source("abc");
    const SourceText copy = source;
    EXPECT_EQ(copy.bytes().data(), source.bytes().data());
    EXPECT_EQ(copy.buffer(), source.buffer());
}

TEST(Origin, CountsColumnsInEachUnit) {
    constexpr Origin ascii{10, 2, 5};
    EXPECT_EQ(ascii.column_in(ColumnUnit::code_points), 5U);
    EXPECT_EQ(ascii.column_in(ColumnUnit::utf16_units), 5U);
    EXPECT_EQ(ascii.column_in(ColumnUnit::bytes), 5U);
    constexpr Origin beyond{10, 2, 5, 6, 8};
    EXPECT_EQ(beyond.column_in(ColumnUnit::code_points), 5U);
    EXPECT_EQ(beyond.column_in(ColumnUnit::utf16_units), 6U);
    EXPECT_EQ(beyond.column_in(ColumnUnit::bytes), 8U);
}

TEST(Origin, EqualityAndThatOfAPlaceSeeEachMember) {
    const Origin origin{1, 2, 3, 4, 5};
    EXPECT_EQ(origin, Origin(origin));
    for (const Origin other : {Origin{9, 2, 3, 4, 5}, Origin{1, 9, 3, 4, 5}, Origin{1, 2, 9, 4, 5},
                               Origin{1, 2, 3, 9, 5}, Origin{1, 2, 3, 4, 9}})
        EXPECT_NE(origin, other);
    const HostPlace place{1, {2, 3}};
    EXPECT_EQ(place, HostPlace(place));
    for (const HostPlace other : {HostPlace{9, {2, 3}}, HostPlace{1, {9, 3}}, HostPlace{1, {2, 9}}})
        EXPECT_NE(place, other);
}

} // namespace
