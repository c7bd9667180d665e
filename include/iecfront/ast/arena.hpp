#pragma once

#include <iecfront/ast/node.hpp>
#include <iecfront/export.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <vector>

namespace iecfront {

/// Memory that is given out piece by piece and released as a whole. Holds the tokens and nodes of a
/// unit; nothing in it is ever destroyed, so only trivially destructible types may live there.
class IECFRONT_API Arena {
public:
    Arena() = default;
    /// Gets its first chunk, of `first_chunk` bytes, at the first allocation.
    explicit Arena(std::size_t first_chunk) noexcept : next_chunk_(first_chunk) {}
    /// Takes over all memory; `other` is then a new arena.
    Arena(Arena&& other) noexcept;
    Arena& operator=(Arena&& other) noexcept;

    /// Memory for `size` bytes, at least one, aligned to `alignment` (a power of two, at most that
    /// of `std::max_align_t`). Never null; running out of memory ends the program, as `new` does.
    [[nodiscard]] void* allocate(std::size_t size, std::size_t alignment) {
        std::size_t begin = (used_ + alignment - 1) & ~(alignment - 1);
        if (begin + size > capacity_) {
            grow(size);
            begin = 0;
        }
        used_ = begin + size;
        return chunk_ + begin;
    }

    /// A new node or other value.
    template<class T>
    [[nodiscard]] T* create() {
        static_assert(std::is_trivially_destructible_v<T>);
        return ::new (allocate(sizeof(T), alignof(T))) T();
    }

    /// A copy of `items`.
    template<class T>
    [[nodiscard]] std::span<const T> copy(std::span<const T> items) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (items.empty())
            return {};
        auto* data = static_cast<T*>(allocate(items.size_bytes(), alignof(T)));
        std::memcpy(data, items.data(), items.size_bytes());
        return {data, items.size()};
    }

    /// Bytes taken from the system.
    [[nodiscard]] std::size_t reserved_bytes() const noexcept { return reserved_; }

private:
    void grow(std::size_t at_least);

    std::vector<std::unique_ptr<std::byte[]>> chunks_;
    std::byte* chunk_ = nullptr; // the last of chunks_
    std::size_t used_ = 0;       // of chunk_
    std::size_t capacity_ = 0;   // of chunk_
    std::size_t next_chunk_ = 1024;
    std::size_t reserved_ = 0;
};

} // namespace iecfront
