#include <iecfront/ast/arena.hpp>

#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <tuple>
#include <utility>
#include <vector>

using iecfront::Arena;

namespace {

bool is_aligned(const void* place, std::size_t alignment) {
    return reinterpret_cast<std::uintptr_t>(place) % alignment == 0;
}

TEST(Arena, OneOfNoCapacityHasNoRoom) {
    Arena arena;
    EXPECT_EQ(arena.capacity(), 0U);
    EXPECT_EQ(arena.try_allocate(1, 1), nullptr);
}

TEST(Arena, GivesAllOfItsCapacityAndNoMore) {
    Arena arena(5000);
    EXPECT_EQ(arena.capacity(), 5000U);
    EXPECT_NE(arena.try_allocate(1, 1), nullptr);
    EXPECT_EQ(arena.try_allocate(5000, 1), nullptr);
    EXPECT_EQ(arena.used(), 1U); // what is refused takes nothing
    EXPECT_NE(arena.try_allocate(4999, 1), nullptr);
    EXPECT_EQ(arena.used(), 5000U);
    EXPECT_EQ(arena.try_allocate(1, 1), nullptr);
}

TEST(Arena, GivesAlignedPlacesThatDoNotOverlap) {
    Arena arena(100'000);
    std::vector<std::uint64_t*> numbers;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        *static_cast<char*>(arena.allocate(1, 1)) = 'x';
        numbers.push_back(arena.create<std::uint64_t>());
        ASSERT_TRUE(is_aligned(numbers.back(), alignof(std::uint64_t)));
        *numbers.back() = i;
    }
    for (std::uint64_t i = 0; i < numbers.size(); ++i)
        ASSERT_EQ(*numbers[i], i);
    EXPECT_TRUE(
        is_aligned(arena.allocate(16, alignof(std::max_align_t)), alignof(std::max_align_t)));
}

TEST(Arena, CopiesASpan) {
    Arena arena(100);
    const std::vector<int> numbers{1, 2, 3};
    const std::span<const int> copy = arena.copy(std::span<const int>(numbers));
    EXPECT_NE(copy.data(), numbers.data());
    EXPECT_EQ(std::vector<int>(copy.begin(), copy.end()), numbers);
    EXPECT_TRUE(arena.copy(std::span<const int>()).empty());
}

TEST(Arena, RewindingGivesTheSamePlaceAgain) {
    Arena arena(100);
    const int* const first = arena.create<int>();
    const std::size_t used = arena.used();
    const int* const second = arena.create<int>();
    arena.rewind(used);
    const int* const third = arena.create<int>();
    EXPECT_NE(first, second);
    EXPECT_EQ(second, third);
}

TEST(Arena, TrimmedHoldsACopyOfWhatWasGivenOut) {
    Arena arena(1000);
    const char* const mark = arena.create<char>();
    int* const number = arena.create<int>();
    *number = 7;
    const Arena copy = arena.trimmed();
    *number = 8;
    EXPECT_EQ(copy.capacity(), arena.used());
    EXPECT_EQ(*copy.counterpart(number, arena), 7);
    EXPECT_EQ(reinterpret_cast<const char*>(copy.counterpart(number, arena)) -
                  copy.counterpart(mark, arena),
              reinterpret_cast<const char*>(number) - mark);
}

TEST(Arena, SplittingLeavesTheRestOfTheBlock) {
    Arena rest(1000);
    int* const number = rest.create<int>();
    *number = 7;
    Arena given = rest.split();
    EXPECT_EQ(given.used(), sizeof(int));
    EXPECT_EQ(given.capacity(), sizeof(int));
    EXPECT_EQ(given.try_allocate(1, 1), nullptr);
    EXPECT_EQ(rest.used(), 0U);
    EXPECT_EQ(rest.capacity(), 1000 - alignof(std::max_align_t));
    auto* const other = rest.create<std::max_align_t>();
    EXPECT_TRUE(is_aligned(other, alignof(std::max_align_t)));
    EXPECT_GE(reinterpret_cast<int*>(other), number + 1);
    EXPECT_EQ(rest.try_allocate(rest.capacity(), 1), nullptr);
    rest = Arena(); // the block is there as long as any part of it
    EXPECT_EQ(*number, 7);
}

TEST(Arena, SplittingGivesAllOfABlock) {
    Arena rest(5);
    std::ignore = rest.allocate(5, 1);
    EXPECT_EQ(rest.split().capacity(), 5U);
    EXPECT_EQ(rest.capacity(), 0U);
    EXPECT_EQ(rest.try_allocate(1, 1), nullptr);
}

TEST(Arena, MovingTakesTheMemoryAlong) {
    Arena first(100);
    int* number = first.create<int>();
    *number = 7;
    Arena second(std::move(first));
    EXPECT_EQ(*number, 7);
    EXPECT_EQ(first.capacity(), 0U);
    EXPECT_EQ(first.try_allocate(1, 1), nullptr);
    *second.create<int>() = 2;
    EXPECT_EQ(*number, 7);
    first = std::move(second);
    EXPECT_EQ(*number, 7);
    EXPECT_EQ(second.capacity(), 0U);
}

TEST(ArenaDeathTest, EndsTheProgramWhereThereMustBeRoom) {
    Arena arena(3);
    EXPECT_DEATH((void)arena.create<int>(), "");
}

} // namespace
