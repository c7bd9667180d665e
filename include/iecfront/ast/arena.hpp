#pragma once

#include <iecfront/export.hpp>

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace iecfront {

/// A block of memory, or a part of one, that is given out piece by piece and released as a whole.
/// Holds the tokens and nodes of a unit; nothing in it is ever destroyed, so only trivially
/// destructible types may live there. What is in it refers to each other by distances
/// (`ast::RelativePointer`), so that a copy of the block is a copy of all.
class IECFRONT_API Arena {
public:
    /// One without room.
    Arena() = default;
    /// One of `capacity` bytes.
    explicit Arena(std::size_t capacity);
    /// Takes over all memory; `other` is then an arena without room.
    Arena(Arena&& other) noexcept;
    Arena& operator=(Arena&& other) noexcept;
    ~Arena() = default;

    /// Memory for `size` bytes, at least one, aligned to `alignment` (a power of two, at most that
    /// of `std::max_align_t`); null when there is no room for them.
    [[nodiscard]] void* try_allocate(std::size_t size, std::size_t alignment) noexcept {
        const std::size_t begin = (used_ + alignment - 1) & ~(alignment - 1);
        if (begin + size > limit_)
            return nullptr;
        used_ = begin + size;
        return block_.get() + begin;
    }
    /// The same where there must be room: ends the program otherwise, as running out of memory
    /// does.
    [[nodiscard]] void* allocate(std::size_t size, std::size_t alignment);

    /// A new node or other value; there must be room.
    template<class T>
    [[nodiscard]] T* create() {
        static_assert(std::is_trivially_destructible_v<T>);
        return ::new (allocate(sizeof(T), alignof(T))) T();
    }

    /// A copy of `items`; there must be room.
    template<class T>
    [[nodiscard]] std::span<const T> copy(std::span<const T> items) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (items.empty())
            return {};
        auto* data = static_cast<T*>(allocate(items.size_bytes(), alignof(T)));
        std::memcpy(data, items.data(), items.size_bytes());
        return {data, items.size()};
    }

    /// Bytes of the block, or of the part of one, and how many of them were given out.
    [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
    [[nodiscard]] std::size_t used() const noexcept { return used_; }
    /// What was given out.
    [[nodiscard]] std::span<std::byte> bytes() noexcept { return {block_.get(), used_}; }
    [[nodiscard]] std::span<const std::byte> bytes() const noexcept {
        return {block_.get(), used_};
    }
    /// Takes back what was given out behind the first `used` bytes.
    void rewind(std::size_t used) noexcept { used_ = used; }

    /// A block that is just large enough for what was given out, with a copy of it.
    [[nodiscard]] Arena trimmed() const;
    /// What was given out, as an arena without room. This one goes on with the rest of the block,
    /// which is released with the last of its parts.
    [[nodiscard]] Arena split();
    /// What lies in this arena, a copy of `other`, where `place` lies in that.
    template<class T>
    [[nodiscard]] const T* counterpart(const T* place, const Arena& other) const noexcept {
        return reinterpret_cast<const T*>(
            block_.get() + (reinterpret_cast<const std::byte*>(place) - other.block_.get()));
    }

protected:
    std::size_t limit_ = 0; ///< how many bytes can be given out

private:
    std::shared_ptr<std::byte[]> block_;
    std::size_t capacity_ = 0;
    std::size_t used_ = 0;
};

} // namespace iecfront
