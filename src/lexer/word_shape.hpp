#pragma once

#include "lexer/characters.hpp"

#include <iecfront/lexer/name.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace iecfront {

/// A word: letters, digits and underscores, as many of them as there are.
struct WordShape {
    const char* end;        // behind the last one
    std::uint64_t head;     // the first eight bytes in capitals; the first byte is the lowest
    bool stray_underscores; // two in a row, or one at the end

    friend bool operator==(const WordShape&, const WordShape&) = default;
};

namespace words {

inline constexpr std::size_t glance = sizeof(std::uint64_t); // bytes that are looked at at once
inline constexpr std::uint64_t ones = 0x0101010101010101U;
inline constexpr std::uint64_t high_bits = 0x8080808080808080U;

/// `shape_of_word`, a byte at a time.
[[nodiscard]] constexpr WordShape shape_bytewise(const char* begin) noexcept {
    WordShape shape{begin, 0, false};
    for (const char*& p = shape.end; is_word_part(*p); ++p) {
        const auto place = static_cast<std::size_t>(p - begin);
        if (place < glance)
            shape.head |= std::uint64_t{static_cast<unsigned char>(fold(*p))} << (8 * place);
        if (*p == '_' && (p[1] == '_' || !is_word_part(p[1])))
            shape.stray_underscores = true;
    }
    return shape;
}

/// The high bits of those bytes that lie from `first` to `last`; the other bits are of no use. No
/// byte may have its high bit set.
[[nodiscard]] constexpr std::uint64_t bytes_between(std::uint64_t bytes, unsigned first,
                                                    unsigned last) noexcept {
    return (bytes + (0x80 - first) * ones) & ~(bytes + (0x7F - last) * ones);
}

} // namespace words

/// The word at `begin`. Eight bytes at once as far as the text goes, for no processor foresees
/// where a word ends, and most are no longer.
[[nodiscard]] inline WordShape shape_of_word(const char* begin, const char* text_end) noexcept {
    using words::high_bits;
    using words::ones;
    if constexpr (std::endian::native != std::endian::little)
        return words::shape_bytewise(begin);
    std::uint64_t head = 0;
    std::uint64_t stray = 0;
    std::uint64_t before = 0; // 0x80 when an underscore stands before the eight bytes
    for (const char* p = begin; static_cast<std::size_t>(text_end - p) >= words::glance;
         p += words::glance) {
        const std::uint64_t bytes = detail::load_bytes(p, words::glance);
        const std::uint64_t low = bytes & ~high_bits;
        const std::uint64_t letters = words::bytes_between(low | (high_bits >> 2), 'a', 'z');
        const std::uint64_t digits = words::bytes_between(low, '0', '9');
        const std::uint64_t not_underscores = (low ^ '_' * ones) + ~high_bits;
        const std::uint64_t others = ((~(letters | digits) & not_underscores) | bytes) & high_bits;
        const std::uint64_t first_other = others & (0 - others);
        const std::uint64_t of_word = (first_other >> 7) - 1; // the bits of all bytes before it
        const std::uint64_t underscores = ~not_underscores & high_bits & of_word;
        stray |= underscores & ((underscores << 8) | (first_other >> 8) | before);
        stray |= first_other & before;
        if (p == begin) // a capital has one bit less than the small letter
            head = bytes & of_word & ~((letters & high_bits) >> 2);
        if (others != 0)
            return {p + std::countr_zero(others) / 8, head, stray != 0};
        before = underscores >> 56;
    }
    return words::shape_bytewise(begin);
}

} // namespace iecfront
