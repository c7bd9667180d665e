#pragma once

#include <iecfront/lexer/standard_names.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace iecfront {

// What one look at a word tells.
struct NameLook {
    std::uint32_t hash;   // what `hash_name` gives
    bool may_be_standard; // false for most words that are no names of the standard
};

// The same for the `size` bytes at `begin` in a text. A short word is loaded at once, with what is
// before it.
[[nodiscard]] NameLook look_at_name(const char* text, std::size_t begin, std::size_t size) noexcept;

// What `standard_name` gives, for who has the `hash_name` of `name` already.
[[nodiscard]] StandardName find_standard_name(std::string_view name, std::uint32_t hash) noexcept;

} // namespace iecfront
