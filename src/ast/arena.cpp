#include <iecfront/ast/arena.hpp>

#include <cstdlib>
#include <utility>

namespace iecfront {

Arena::Arena(std::size_t capacity)
    : limit_(capacity),
      block_(std::make_unique_for_overwrite<std::byte[]>(capacity)),
      capacity_(capacity) {}

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

} // namespace iecfront
