#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

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

/// Bytes that `is_ascii_block` looks at.
inline constexpr std::size_t block_size = 128;

inline constexpr std::size_t word_size = sizeof(std::uint64_t);

/// True when the `word_size` bytes from `bytes` on are ASCII.
[[nodiscard]] inline bool is_ascii_word(const char* bytes) noexcept {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, word_size);
    return (word & 0x8080808080808080U) == 0;
}

/// True when the `block_size` bytes from `bytes` on are.
[[nodiscard]] inline bool is_ascii_block_by_words(const char* bytes) noexcept {
    bool ascii = true;
    for (std::size_t i = 0; i < block_size; i += word_size)
        ascii = is_ascii_word(bytes + i) && ascii;
    return ascii;
}

/// True when a line ends with `here`, before `next`: LF, CR LF and CR each are one line end.
[[nodiscard]] constexpr bool ends_line(char here, char next) noexcept {
    return here == '\n' || (here == '\r' && next != '\n');
}

/// Rows of `mask_size` bytes that `count_line_ends_in` counts in, at most.
inline constexpr std::size_t most_rows = 255;

/// How many lines end in so many rows of `mask_size` bytes; the byte behind them is looked at.
[[nodiscard]] inline std::uint32_t count_line_ends_one_by_one(const char* bytes,
                                                              std::size_t rows) noexcept {
    std::uint32_t count = 0;
    for (const char* const end = bytes + rows * mask_size; bytes != end; ++bytes)
        count += ends_line(bytes[0], bytes[1]) ? 1 : 0;
    return count;
}

#ifdef IECFRONT_HAS_SSE2

[[nodiscard]] inline __m128i load_block(const char* bytes) noexcept {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes));
}

/// What the functions above give, all at once where the processor can.
[[nodiscard]] inline std::uint32_t mask_of(const char* bytes, char sought) noexcept {
    return static_cast<std::uint32_t>(
        _mm_movemask_epi8(_mm_cmpeq_epi8(load_block(bytes), _mm_set1_epi8(sought))));
}
[[nodiscard]] inline bool is_ascii_block(const char* bytes) noexcept {
    __m128i all = _mm_setzero_si128();
    for (std::size_t i = 0; i < block_size; i += mask_size)
        all = _mm_or_si128(all, load_block(bytes + i));
    return _mm_movemask_epi8(all) == 0;
}
/// The sum of sixteen bytes without sign.
[[nodiscard]] inline std::uint32_t sum_of_bytes(__m128i bytes) noexcept {
    const __m128i sums = _mm_sad_epu8(bytes, _mm_setzero_si128()); // of either half
    return static_cast<std::uint32_t>(_mm_cvtsi128_si32(sums) + _mm_extract_epi16(sums, 4));
}
[[nodiscard]] inline std::uint32_t count_line_ends_in(const char* bytes,
                                                      std::size_t rows) noexcept {
    const __m128i feed = _mm_set1_epi8('\n');
    const __m128i carriage_return = _mm_set1_epi8('\r');
    const char* const end = bytes + rows * mask_size;
    __m128i counts = _mm_setzero_si128(); // sixteen of one byte
    __m128i returns = _mm_setzero_si128();
    for (const char* p = bytes; p != end; p += mask_size) {
        const __m128i here = load_block(p);
        counts = _mm_sub_epi8(counts, _mm_cmpeq_epi8(here, feed)); // which is -1 where there is one
        returns = _mm_or_si128(returns, _mm_cmpeq_epi8(here, carriage_return));
    }
    if (_mm_movemask_epi8(returns) == 0)
        return sum_of_bytes(counts);
    for (const char* p = bytes; p != end; p += mask_size) { // and those that no line feed follows
        const __m128i lone = _mm_andnot_si128(_mm_cmpeq_epi8(load_block(p + 1), feed),
                                              _mm_cmpeq_epi8(load_block(p), carriage_return));
        counts = _mm_sub_epi8(counts, lone);
    }
    return sum_of_bytes(counts);
}

#else

[[nodiscard]] inline std::uint32_t mask_of(const char* bytes, char sought) noexcept {
    return mask_of_one_by_one(bytes, sought);
}
[[nodiscard]] inline bool is_ascii_block(const char* bytes) noexcept {
    return is_ascii_block_by_words(bytes);
}
[[nodiscard]] inline std::uint32_t count_line_ends_in(const char* bytes,
                                                      std::size_t rows) noexcept {
    return count_line_ends_one_by_one(bytes, rows);
}

#endif

} // namespace iecfront
