#pragma once

#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/standard_names.hpp>

#include <cstdint>
#include <string_view>

namespace iecfront {

// False for most names that are none of the standard; `hash` is the `hash_name` of `name`, which is
// not empty.
[[nodiscard]] bool may_be_standard_name(std::string_view name, std::uint32_t hash) noexcept;

// What `standard_name` gives, for who has the `hash_name` of `name` already.
[[nodiscard]] StandardName find_standard_name(std::string_view name, std::uint32_t hash) noexcept;

} // namespace iecfront
