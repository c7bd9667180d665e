#include <iecfront/ast/relative_pointer.hpp>

#include <array>
#include <cstring>
#include <gtest/gtest.h>
#include <type_traits>

using iecfront::ast::RelativePointer;

namespace {

struct Pair {
    int before = 1;
    RelativePointer<int> first;
    RelativePointer<int> second;
    int behind = 2;
};

static_assert(sizeof(RelativePointer<int>) == 4);
static_assert(!std::is_copy_constructible_v<RelativePointer<int>>);
static_assert(!std::is_copy_assignable_v<RelativePointer<int>>);

TEST(RelativePointer, IsNullAtFirstAndWhenItIsMadeSo) {
    Pair pair;
    EXPECT_EQ(pair.first, nullptr);
    EXPECT_FALSE(pair.first);
    pair.first = &pair.before;
    EXPECT_TRUE(pair.first);
    pair.first = nullptr;
    EXPECT_EQ(pair.first.get(), nullptr);
}

TEST(RelativePointer, PointsToWhatStandsBeforeAndBehind) {
    Pair pair;
    pair.first = &pair.before;
    pair.second = &pair.behind;
    EXPECT_EQ(pair.first, &pair.before);
    EXPECT_EQ(*pair.first, 1);
    const int* const plain = pair.second;
    EXPECT_EQ(plain, &pair.behind);
}

TEST(RelativePointer, PointsIntoTheCopyOfABlock) {
    alignas(Pair) std::array<std::byte, sizeof(Pair)> block;
    auto* const pair = ::new (block.data()) Pair();
    pair->first = &pair->before;
    pair->second = &pair->behind;
    alignas(Pair) std::array<std::byte, sizeof(Pair)> other;
    std::memcpy(other.data(), block.data(), block.size());
    pair->before = pair->behind = 0;
    const auto* const copy = reinterpret_cast<const Pair*>(other.data());
    EXPECT_EQ(*copy->first, 1);
    EXPECT_EQ(*copy->second, 2);
}

} // namespace
