#pragma once

#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/standard_names.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace iecfront {

namespace detail {

// The hashes of some names, shortened to ten bits.
class HashBits {
public:
    constexpr void add(std::uint32_t hash) noexcept { bits_[word(hash)] |= bit(hash); }
    [[nodiscard]] constexpr bool may_hold(std::uint32_t hash) const noexcept {
        return (bits_[word(hash)] & bit(hash)) != 0;
    }

private:
    static constexpr std::size_t word(std::uint32_t hash) noexcept { return hash / 64 % 16; }
    static constexpr std::uint64_t bit(std::uint32_t hash) noexcept {
        return std::uint64_t{1} << (hash % 64);
    }
    std::array<std::uint64_t, 16> bits_{};
};

// Of the names that are listed.
extern const HashBits standard_name_bits;

// True when the last two letters are those of an elementary type, or of TIME_OF_DAY, in which the
// names end that are not listed.
[[nodiscard]] constexpr bool may_end_in_type(std::string_view name) noexcept {
    if (name.size() < 2)
        return false;
    const char before = fold(name[name.size() - 2]);
    switch (fold(name.back())) {
    case 'D': return before == 'R' || before == 'O';
    case 'E': return before == 'M' || before == 'T';
    case 'G': return before == 'N';
    case 'L': return before == 'O' || before == 'A';
    case 'T': return before == 'N' || before == 'D';
    case 'Y': return before == 'A';
    default: return false;
    }
}

} // namespace detail

// False for most names that are none of the standard; `hash` is the `hash_name` of `name`.
[[nodiscard]] inline bool may_be_standard_name(std::string_view name, std::uint32_t hash) noexcept {
    return detail::standard_name_bits.may_hold(hash) || detail::may_end_in_type(name);
}

// What `standard_name` gives, for who has the `hash_name` of `name` already.
[[nodiscard]] StandardName find_standard_name(std::string_view name, std::uint32_t hash) noexcept;

} // namespace iecfront
