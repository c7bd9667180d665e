#include <iecfront/ast/arena.hpp>

#include <gtest/gtest.h>

using namespace iecfront;

namespace {

bool is_aligned(const void* place, std::size_t alignment) {
    return reinterpret_cast<std::uintptr_t>(place) % alignment == 0;
}

TEST(Arena, TakesNothingBeforeTheFirstAllocation) {
    EXPECT_EQ(Arena().reserved_bytes(), 0U);
    EXPECT_EQ(Arena(5000).reserved_bytes(), 0U);
}

TEST(Arena, TheFirstChunkIsAsLargeAsAsked) {
    Arena arena(5000);
    (void)arena.allocate(1, 1);
    EXPECT_EQ(arena.reserved_bytes(), 5000U);
    (void)arena.allocate(4999, 1);
    EXPECT_EQ(arena.reserved_bytes(), 5000U);
}

TEST(Arena, GivesAlignedPlacesThatDoNotOverlap) {
    Arena arena(0);
    std::vector<std::uint64_t*> numbers;
    for (std::uint64_t i = 0; i < 10000; ++i) {
        *static_cast<char*>(arena.allocate(1, 1)) = 'x';
        numbers.push_back(arena.create<std::uint64_t>());
        ASSERT_TRUE(is_aligned(numbers.back(), alignof(std::uint64_t)));
        ASSERT_EQ(*numbers.back(), 0U);
        *numbers.back() = i;
    }
    for (std::uint64_t i = 0; i < numbers.size(); ++i)
        ASSERT_EQ(*numbers[i], i);
    EXPECT_TRUE(
        is_aligned(arena.allocate(16, alignof(std::max_align_t)), alignof(std::max_align_t)));
}

TEST(Arena, GrowsInFewChunksAndWastesLittle) {
    Arena arena;
    constexpr std::size_t total = 10'000'000;
    for (std::size_t i = 0; i < total / 10; ++i)
        (void)arena.allocate(10, 1);
    EXPECT_GE(arena.reserved_bytes(), total);
    EXPECT_LE(arena.reserved_bytes(), total + total / 8 + 1024);
}

TEST(Arena, TakesWhatIsLargerThanAChunk) {
    Arena arena;
    auto* place = static_cast<char*>(arena.allocate(1'000'000, 1));
    place[0] = 'a';
    place[999'999] = 'z';
    EXPECT_GE(arena.reserved_bytes(), 1'000'000U);
}

TEST(Arena, CopiesASpan) {
    Arena arena;
    const std::vector<int> numbers{1, 2, 3};
    const std::span<const int> copy = arena.copy(std::span<const int>(numbers));
    EXPECT_NE(copy.data(), numbers.data());
    EXPECT_EQ(std::vector<int>(copy.begin(), copy.end()), numbers);
    EXPECT_TRUE(arena.copy(std::span<const int>()).empty());
}

TEST(Arena, MovingTakesTheMemoryAlong) {
    Arena first;
    int* number = first.create<int>();
    *number = 7;
    Arena second(std::move(first));
    EXPECT_EQ(*number, 7);
    EXPECT_EQ(first.reserved_bytes(), 0U); // and what it gives out now is its own
    *first.create<int>() = 1;
    *second.create<int>() = 2;
    EXPECT_EQ(*number, 7);
    first = std::move(second);
    EXPECT_EQ(*number, 7);
    EXPECT_EQ(second.reserved_bytes(), 0U);
}

} // namespace
