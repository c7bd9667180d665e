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

} // namespace
