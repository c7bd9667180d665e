#pragma once

#include "lexer/characters.hpp"
#include "source/byte_mask.hpp"

#include <iecfront/lexer/name.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace iecfront {

/// A word: letters, digits and underscores, as many of them as there are.
struct WordShape {
    const char* end;    // behind the last one
    std::uint64_t head; // the first eight bytes, folded; the first byte is the lowest
    bool odd;           // two underscores in a row, one at the end, or longer than a token can be

    friend bool operator==(const WordShape&, const WordShape&) = default;
};

namespace words {

inline constexpr std::size_t head_size = sizeof(std::uint64_t);

[[nodiscard]] constexpr bool is_too_long(const char* begin, const char* end) noexcept {
    return static_cast<std::size_t>(end - begin) > Token::maximum_length;
}

/// `shape_of_word`, a byte at a time.
[[nodiscard]] constexpr WordShape shape_bytewise(const char* begin) noexcept {
    WordShape shape{begin, 0, false};
    for (const char*& p = shape.end; is_word_part(*p); ++p) {
        const auto place = static_cast<std::size_t>(p - begin);
        if (place < head_size)
            shape.head |= std::uint64_t{static_cast<unsigned char>(*p)} << (8 * place);
        if (*p == '_' && (p[1] == '_' || !is_word_part(p[1])))
            shape.odd = true;
    }
    shape.head = detail::fold_name_bytes(shape.head);
    shape.odd = shape.odd || is_too_long(begin, shape.end);
    return shape;
}

/// Which of `mask_size` bytes are letters, digits and underscores, and which are underscores: the
/// lowest bit is the first byte.
struct Masks {
    std::uint32_t parts = 0;
    std::uint32_t underscores = 0;

    friend bool operator==(const Masks&, const Masks&) = default;
};

inline constexpr std::uint64_t ones = 0x0101010101010101U;
inline constexpr std::uint64_t high_bits = 0x80 * ones;

/// The high bits of those of eight bytes that lie from `first` to `last`; the other bits are of no
/// use. No byte may have its high bit set.
[[nodiscard]] constexpr std::uint64_t bytes_between(std::uint64_t bytes, unsigned first,
                                                    unsigned last) noexcept {
    return (bytes + (0x80 - first) * ones) & ~(bytes + (0x7F - last) * ones);
}

/// The high bits of eight bytes side by side.
[[nodiscard]] constexpr std::uint32_t gathered_high_bits(std::uint64_t bytes) noexcept {
    // Moves the bit of byte i, counted from the lowest, by 49 - 7i places: to place 56 + i.
    return static_cast<std::uint32_t>(((bytes & high_bits) >> 7) * 0x0102040810204080U >> 56);
}

[[nodiscard]] inline Masks masks_by_words(const char* bytes) noexcept {
    Masks masks;
    for (std::size_t i = 0; i < mask_size; i += word_size) {
        const std::uint64_t word = detail::load_bytes(bytes + i, word_size);
        const std::uint64_t low = word & ~high_bits;
        const std::uint64_t letters = bytes_between(low | (high_bits >> 2), 'a', 'z');
        const std::uint64_t digits = bytes_between(low, '0', '9');
        const std::uint64_t underscores = bytes_between(low, '_', '_') & ~word;
        masks.parts |= gathered_high_bits(((letters | digits) & ~word) | underscores) << i;
        masks.underscores |= gathered_high_bits(underscores) << i;
    }
    return masks;
}

/// The same, all at once where the processor can.
[[nodiscard]] inline Masks masks_of(const char* bytes) noexcept {
#ifdef IECFRONT_HAS_SSE2
    const __m128i block = load_block(bytes);
    // Moves the bytes from `first` on to the least there are, and takes those that are less than
    // `count` above these.
    const auto range = [](__m128i of, char first, int count) {
        const __m128i moved = _mm_sub_epi8(of, _mm_set1_epi8(static_cast<char>(first - INT8_MIN)));
        return _mm_cmplt_epi8(moved, _mm_set1_epi8(static_cast<char>(INT8_MIN + count)));
    };
    const __m128i letters = range(_mm_or_si128(block, _mm_set1_epi8(0x20)), 'a', 26);
    const __m128i digits = range(block, '0', 10);
    const __m128i underscores = _mm_cmpeq_epi8(block, _mm_set1_epi8('_'));
    const __m128i parts = _mm_or_si128(_mm_or_si128(letters, digits), underscores);
    return {static_cast<std::uint32_t>(_mm_movemask_epi8(parts)),
            static_cast<std::uint32_t>(_mm_movemask_epi8(underscores))};
#else
    return masks_by_words(bytes);
#endif
}

/// Those underscores of the word that the masks begin with which no letter or digit follows; of the
/// last byte this is not known.
[[nodiscard]] constexpr std::uint32_t stray_underscores(Masks masks) noexcept {
    const std::uint32_t of_word =
        masks.parts & ~(masks.parts + 1); // the ones before the first zero
    return masks.underscores & of_word & ((masks.underscores | ~masks.parts) >> 1) &
           ~(1U << (mask_size - 1));
}

/// By the size of a word, what of its first eight bytes belongs to it and is left when it is
/// folded.
inline constexpr auto head_masks = [] {
    std::array<std::uint64_t, mask_size> table{};
    for (std::size_t size = 0; size < table.size(); ++size)
        table[size] = detail::fold_name_bytes(
            size < head_size ? (std::uint64_t{1} << (8 * size)) - 1 : ~std::uint64_t{0});
    return table;
}();

/// `shape_of_word` of one that is as long as what is looked at at once, or longer.
[[nodiscard]] inline WordShape shape_of_long_word(const char* begin,
                                                  const char* text_end) noexcept {
    std::uint32_t stray = 0;
    // The last byte of each step is the first of the next.
    for (const char* p = begin; static_cast<std::size_t>(text_end - p) >= mask_size;
         p += mask_size - 1) {
        const Masks masks = masks_of(p);
        stray |= stray_underscores(masks);
        const auto size = static_cast<std::size_t>(std::countr_one(masks.parts));
        if (size < mask_size)
            return {p + size, detail::fold_name_bytes(detail::load_bytes(begin, head_size)),
                    stray != 0 || is_too_long(begin, p + size)};
    }
    return shape_bytewise(begin);
}

} // namespace words

/// The word at `begin`, where one is. Many bytes at once as far as the text goes, for no processor
/// foresees where a word ends, and most are no longer.
[[nodiscard]] inline WordShape shape_of_word(const char* begin, const char* text_end) noexcept {
    if (static_cast<std::size_t>(text_end - begin) < mask_size) [[unlikely]]
        return words::shape_bytewise(begin);
    const words::Masks masks = words::masks_of(begin);
    const auto size = static_cast<std::size_t>(std::countr_one(masks.parts));
    if (size >= mask_size) [[unlikely]]
        return words::shape_of_long_word(begin, text_end);
    const std::uint64_t head = detail::load_bytes(begin, words::head_size);
    return {begin + size, head & words::head_masks[size], words::stray_underscores(masks) != 0};
}

} // namespace iecfront
