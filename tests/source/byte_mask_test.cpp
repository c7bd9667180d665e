#include "source/byte_mask.hpp"

#include <gtest/gtest.h>
#include <random>
#include <string>
#include <string_view>

using namespace iecfront;

namespace {

TEST(ByteMask, NamesTheBytesThatAreSought) {
    EXPECT_EQ(mask_of("\nabc\ndefghijklm\n", '\n'), 0x8011U);
    EXPECT_EQ(mask_of("0123456789abcdef", '\n'), 0U);
}

// Bytes whose bits are near those of the sought one, at each place.
TEST(ByteMask, IsThatOfEachByteAlone) {
    for (int sought = -128; sought < 128; ++sought)
        for (std::size_t place = 0; place < mask_size; ++place)
            for (const int near : {0, 1, -1, 128, 16}) {
                std::string bytes(mask_size, static_cast<char>(sought + near));
                bytes[place] = static_cast<char>(sought);
                ASSERT_EQ(mask_of(bytes.data(), static_cast<char>(sought)),
                          mask_of_one_by_one(bytes.data(), static_cast<char>(sought)));
            }
}

TEST(AsciiBlock, HoldsNothingElseAnywhere) {
    std::string bytes(block_size, '\x7F');
    EXPECT_TRUE(is_ascii_block(bytes.data()));
    EXPECT_TRUE(is_ascii_block_by_words(bytes.data()));
    for (char& byte : bytes) {
        byte = '\x80';
        EXPECT_FALSE(is_ascii_block(bytes.data()));
        EXPECT_FALSE(is_ascii_block_by_words(bytes.data()));
        byte = '\x7F';
    }
}

TEST(LineEnds, AreCountedAsOneByOne) {
    std::mt19937 random(1);
    // Rows without a carriage return are counted in another way.
    for (const std::string_view letters : {"a\n\x8A\x8D\x0B", "a\n\x8A\x8D\x0B\r"})
        for (std::size_t rows = 0; rows <= most_rows; rows += 1 + rows / 4) {
            std::string bytes(rows * mask_size + 1, ' ');
            for (char& byte : bytes)
                byte = letters[random() % letters.size()];
            ASSERT_EQ(count_line_ends_in(bytes.data(), rows),
                      count_line_ends_one_by_one(bytes.data(), rows));
        }
    const std::string feeds(most_rows * mask_size + 1, '\n');
    EXPECT_EQ(count_line_ends_in(feeds.data(), most_rows), most_rows * mask_size);
}

} // namespace
