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
    const auto byte = [bytes](std::size_t i) {
        return std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    };
    if (std::is_constant_evaluated() || std::endian::native != std::endian::little) {
        for (std::size_t i = 0; i < size; ++i)
            word |= byte(i);
        return word;
    }
    if (size < 4) // first, middle and last, which may be the same
        return size == 0 ? 0 : byte(0) | byte(size / 2) | byte(size - 1);
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

// Eight bytes without the bit that tells small letters from capitals. Of what names are made of,
// only a letter and its capital become the same.
[[nodiscard]] constexpr std::uint64_t fold_name_bytes(std::uint64_t word) noexcept {
    return word & 0xDFDFDFDFDFDFDFDFU;
}

// Takes the next bytes of a name, folded, into its hash. A product mixes bits upwards only: what is
// mixed already comes down for the next one.
[[nodiscard]] constexpr std::uint64_t mix_folded(std::uint64_t hash, std::uint64_t bytes) noexcept {
    return (std::rotl(hash, 32) ^ bytes) * 0x9E3779B97F4A7C15U; // odd, of mixed bits
}
// The same of bytes as they stand.
[[nodiscard]] constexpr std::uint64_t mix_name(std::uint64_t hash, std::uint64_t bytes) noexcept {
    return mix_folded(hash, fold_name_bytes(bytes));
}

// `names_equal` of names of the same size.
[[nodiscard]] constexpr bool are_equal_folded(const char* a, const char* b,
                                              std::size_t size) noexcept {
    for (std::size_t i = 0; i < size; ++i)
        if (fold(a[i]) != fold(b[i]))
            return false;
    return true;
}
// The same, compiled once.
[[nodiscard]] IECFRONT_API bool are_equal_names(const char* a, const char* b,
                                                std::size_t size) noexcept;

} // namespace detail

/// Hash of a name with its case folded: names that differ in case only have the same (2.1.2).
[[nodiscard]] constexpr std::uint32_t hash_name(std::string_view name) noexcept {
    constexpr std::size_t step = sizeof(std::uint64_t);
    const std::size_t size = std::min(name.size(), step);
    const char* const last = name.data() + name.size() - size; // overlaps with what is before it
    std::uint64_t hash = detail::mix_name(name.size(), detail::load_bytes(name.data(), size));
    for (std::size_t i = step; i + step < name.size(); i += step)
        hash = detail::mix_name(hash, detail::load_bytes(name.data() + i, step));
    return static_cast<std::uint32_t>(detail::mix_name(hash, detail::load_bytes(last, size)) >> 32);
}

/// True when both are the same name: equal but for case.
[[nodiscard]] constexpr bool names_equal(std::string_view a, std::string_view b) noexcept {
    if (a.size() != b.size())
        return false;
    return std::is_constant_evaluated() ? detail::are_equal_folded(a.data(), b.data(), a.size())
                                        : detail::are_equal_names(a.data(), b.data(), a.size());
}

/// The name in upper case.
[[nodiscard]] IECFRONT_API std::string folded(std::string_view name);

} // namespace iecfront
