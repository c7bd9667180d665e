#include <iecfront/ast/arena.hpp>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace iecfront {
namespace {

constexpr std::size_t block_alignment = alignof(std::max_align_t);

[[nodiscard]] constexpr std::size_t aligned(std::size_t size) noexcept {
    return (size + block_alignment - 1) & ~(block_alignment - 1);
}

/// Aligned for whatever may live in it, and one piece of memory along with its count of owners.
[[nodiscard]] std::shared_ptr<std::byte[]> make_block(std::size_t size) {
    struct alignas(block_alignment) Row {
        std::byte bytes[block_alignment];
    };
    const std::size_t count = size / sizeof(Row) + (size % sizeof(Row) == 0 ? 0 : 1);
    auto rows = std::make_shared_for_overwrite<Row[]>(count);
    auto* const begin = reinterpret_cast<std::byte*>(rows.get());
    return {std::move(rows), begin};
}

} // namespace

Arena::Arena(std::size_t capacity)
    : limit_(capacity), block_(make_block(capacity)), capacity_(capacity) {}

Arena::Arena(Arena&& other) noexcept
    : limit_(std::exchange(other.limit_, 0)),
      block_(std::move(other.block_)),
      capacity_(std::exchange(other.capacity_, 0)),
      used_(std::exchange(other.used_, 0)) {}

Arena& Arena::operator=(Arena&& other) noexcept {
    limit_ = std::exchange(other.limit_, 0);
    block_ = std::move(other.block_);
    capacity_ = std::exchange(other.capacity_, 0);
    used_ = std::exchange(other.used_, 0);
    return *this;
}

void* Arena::allocate(std::size_t size, std::size_t alignment) {
    void* const memory = try_allocate(size, alignment);
    if (memory == nullptr)
        std::abort();
    return memory;
}

// In pieces that are copied by a few plain instructions each: a block is too small to be worth what
// a copy of any size begins with.
Arena Arena::trimmed() const {
    constexpr std::size_t piece = 256;
    Arena copy(used_);
    copy.used_ = used_;
    std::byte* const to = copy.block_.get();
    const std::byte* const from = block_.get();
    std::size_t at = 0;
    for (; used_ - at >= piece; at += piece)
        std::memcpy(to + at, from + at, piece);
    if (at < used_)
        std::memcpy(to + at, from + at, used_ - at);
    return copy;
}

Arena Arena::split() {
    Arena given;
    given.block_ = block_;
    given.capacity_ = used_;
    given.used_ = used_;
    const std::size_t begin = std::min(aligned(used_), capacity_);
    block_ = std::shared_ptr<std::byte[]>(std::move(block_), given.block_.get() + begin);
    capacity_ -= begin;
    used_ = 0;
    limit_ = capacity_;
    return given;
}

} // namespace iecfront
