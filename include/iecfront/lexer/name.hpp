#pragma once

#include <iecfront/export.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace iecfront {

/// `A`...`Z` for `a`...`z`, every other byte as it is: the only folding there is in the language
/// (2.1.1, 2.1.2).
[[nodiscard]] constexpr char fold(char c) noexcept {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c;
}

namespace detail {

// `size` bytes, at most eight, as a number whose lowest byte is the first.
[[nodiscard]] constexpr std::uint64_t load_bytes(const char* bytes, std::size_t size) noexcept {
    std::uint64_t word = 0;
    if (std::is_constant_evaluated() || std::endian::native != std::endian::little || size < 4) {
        for (std::size_t i = 0; i < size; ++i)
            word |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
        return word;
    }
    if (size == sizeof(word)) {
        std::memcpy(&word, bytes, sizeof(word));
        return word;
    }
    std::uint32_t first = 0;
    std::uint32_t last = 0; // overlaps with the first
    std::memcpy(&first, bytes, sizeof(first));
    std::memcpy(&last, bytes + size - sizeof(last), sizeof(last));
    return first | std::uint64_t{last} << (8 * (size - sizeof(last)));
}

// `fold` of eight bytes at once: the high bit of each sum tells whether the byte is above a bound.
[[nodiscard]] constexpr std::uint64_t fold_bytes(std::uint64_t word) noexcept {
    constexpr std::uint64_t ones = 0x0101010101010101U;
    constexpr std::uint64_t high_bits = 0x80 * ones;
    const std::uint64_t low = word & ~high_bits;
    const std::uint64_t from_a = low + (0x80 - 'a') * ones;
    const std::uint64_t beyond_z = low + (0x7F - 'z') * ones;
    return word - (((from_a & ~beyond_z & ~word) & high_bits) >> 2);
}

} // namespace detail

/// Hash of a name with its case folded: names that differ in case only have the same (2.1.2).
[[nodiscard]] constexpr std::uint32_t hash_name(std::string_view name) noexcept {
    constexpr std::size_t step = sizeof(std::uint64_t);
    std::uint64_t hash = name.size();
    const auto mix = [&](std::size_t begin, std::size_t size) {
        hash ^= detail::fold_bytes(detail::load_bytes(name.data() + begin, size));
        hash *= 0x9E3779B97F4A7C15U; // odd, of mixed bits; what it mixes is in the upper half
        hash ^= hash >> 32;
    };
    if (name.size() < step) {
        mix(0, name.size());
        return static_cast<std::uint32_t>(hash);
    }
    for (std::size_t i = step; i < name.size(); i += step)
        mix(i - step, step);
    mix(name.size() - step, step); // overlaps with what is before it
    return static_cast<std::uint32_t>(hash);
}

/// True when both are the same name: equal but for case.
[[nodiscard]] constexpr bool names_equal(std::string_view a, std::string_view b) noexcept {
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (fold(a[i]) != fold(b[i]))
            return false;
    return true;
}

/// The name in upper case.
[[nodiscard]] IECFRONT_API std::string folded(std::string_view name);

} // namespace iecfront
