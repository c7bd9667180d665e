#include "lexer/standard_names.hpp"

#include <iecfront/lexer/name.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <string_view>

using namespace iecfront;

namespace {

TEST(Name, CaseIsNotSignificant) {
    EXPECT_TRUE(names_equal("abCd_1", "ABcD_1"));
    EXPECT_EQ(hash_name("abCd_1"), hash_name("ABcD_1"));
    EXPECT_EQ(folded("abCd_1"), "ABCD_1");
}

TEST(Name, UnderscoresAreSignificant) {
    EXPECT_FALSE(names_equal("A_BCD", "AB_CD"));
    EXPECT_NE(hash_name("A_BCD"), hash_name("AB_CD"));
}

TEST(Name, LengthIsSignificant) {
    EXPECT_FALSE(names_equal("ABC", "ABCD"));
    EXPECT_FALSE(names_equal("", "A"));
    EXPECT_TRUE(names_equal("", ""));
    EXPECT_EQ(folded(""), "");
}

// What is loaded eight bytes at a time, and with what stands before a name, is what a compiler
// computes from single bytes.
TEST(Name, HashDoesNotDependOnWhereTheNameStands) {
    constexpr std::string_view text = "aZ_09bYc1_X8dWv7E_u6Ft";
    constexpr auto hashes = [text] {
        std::array<std::uint32_t, text.size() + 1> of_prefixes{};
        for (std::size_t size = 0; size <= text.size(); ++size)
            of_prefixes[size] = hash_name(text.substr(0, size));
        return of_prefixes;
    }();
    for (std::size_t size = 0; size <= text.size(); ++size)
        for (std::size_t before = 0; before < 10; ++before)
            for (std::size_t behind = 0; behind < 10; ++behind) {
                const std::string name(text.substr(0, size));
                const std::string all = std::string(before, '~') + name + std::string(behind, '}');
                EXPECT_EQ(hash_name(name), hashes[size]) << name;
                if (size > 0) {
                    EXPECT_EQ(look_at_name(all.data(), before, size).hash, hashes[size]) << all;
                }
            }
}

TEST(Name, OnlyLettersOfAsciiFold) {
    for (int byte = 0; byte < 256; ++byte) {
        const char c = static_cast<char>(byte);
        const bool lower = byte >= 'a' && byte <= 'z';
        EXPECT_EQ(fold(c), lower ? static_cast<char>(byte - 32) : c) << byte;
    }
    EXPECT_FALSE(names_equal("@", "`")); // they differ as `A` and `a` do
    EXPECT_EQ(folded("\xC3\xA4"), "\xC3\xA4");
}

// Names are told apart by hashes, and tables of so many slots as a power of two take the lower
// bits.
TEST(NameHash, TellsNumberedNamesApart) {
    std::set<std::uint32_t> all;
    std::set<std::uint32_t> lower;
    for (int first = 10; first < 100; ++first)
        for (int second = 10; second < 100; ++second) {
            const std::uint32_t hash = hash_name("Motor_" + std::to_string(first) + "_Valve_" +
                                                 std::to_string(second) + "_x");
            all.insert(hash);
            lower.insert(hash % 0x10000);
        }
    EXPECT_EQ(all.size(), 8100U);
    EXPECT_GT(lower.size(), 6000U);
}

} // namespace
