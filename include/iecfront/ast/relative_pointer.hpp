#pragma once

#include <cstddef>
#include <cstdint>

namespace iecfront::ast {

/// A pointer to a `T` in the same block of memory, or null. It holds the distance from itself, in
/// 4 bytes: half of what a pointer takes, and the block can be copied to another place as a whole.
/// Converts to `const T*`, and is used like one. It cannot be copied: `const T* p = x;` does it.
/// Both ends are aligned to 4 bytes and at most 8 GiB apart.
template<class T>
class RelativePointer {
public:
    RelativePointer() = default;
    explicit RelativePointer(const T* target) noexcept { *this = target; }
    RelativePointer(const RelativePointer&) = delete;
    RelativePointer& operator=(const RelativePointer&) = delete;

    /// Points to `target`, which lies in the same block, or is null.
    RelativePointer& operator=(const T* target) noexcept {
        distance_ =
            target == nullptr ? 0 : static_cast<std::int32_t>((at(target) - at(this)) >> shift);
        return *this;
    }

    /// What it points to, or null.
    [[nodiscard]] const T* get() const noexcept {
        if (distance_ == 0)
            return nullptr;
        return reinterpret_cast<const T*>(at(this) + (std::ptrdiff_t{distance_} << shift));
    }
    operator const T*() const noexcept { return get(); }
    [[nodiscard]] const T* operator->() const noexcept { return get(); }
    [[nodiscard]] const T& operator*() const noexcept { return *get(); }

private:
    [[nodiscard]] static const std::byte* at(const void* place) noexcept {
        return static_cast<const std::byte*>(place);
    }

    static constexpr unsigned shift = 2; // the distance is counted in units of 4 bytes
    std::int32_t distance_ = 0;          // from itself; 0 is null
};

} // namespace iecfront::ast
