#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#define IECFRONT_HAS_SSE2
#endif

namespace iecfront {

/// Bytes that `mask_of` looks at.
inline constexpr std::size_t mask_size = 16;

/// Which of the `mask_size` bytes from `bytes` on are `sought`: the lowest bit is the first byte.
[[nodiscard]] inline std::uint32_t mask_of_one_by_one(const char* bytes, char sought) noexcept {
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < mask_size; ++i)
        mask |= bytes[i] == sought ? 1U << i : 0U;
    return mask;
}

/// The same, all at once where the processor can.
[[nodiscard]] inline std::uint32_t mask_of(const char* bytes, char sought) noexcept {
#ifdef IECFRONT_HAS_SSE2
    const __m128i block = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes));
    return static_cast<std::uint32_t>(
        _mm_movemask_epi8(_mm_cmpeq_epi8(block, _mm_set1_epi8(sought))));
#else
    return mask_of_one_by_one(bytes, sought);
#endif
}

} // namespace iecfront
