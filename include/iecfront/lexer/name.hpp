#pragma once

#include <iecfront/export.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace iecfront {

/// `A`...`Z` for `a`...`z`, every other byte as it is: the only folding there is in the language
/// (2.1.1, 2.1.2).
[[nodiscard]] constexpr char fold(char c) noexcept {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c;
}

/// Hash of a name with its case folded: names that differ in case only have the same (2.1.2).
[[nodiscard]] constexpr std::uint32_t hash_name(std::string_view name) noexcept {
    std::uint32_t hash = 2166136261U;
    for (const char c : name)
        hash = (hash ^ static_cast<unsigned char>(fold(c))) * 16777619U;
    return hash;
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
