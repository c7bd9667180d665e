#pragma once

#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/standard_names.hpp>

#include <cstdint>
#include <string_view>

namespace iecfront {

// The same for who has the `hash_name` of `name` already.
[[nodiscard]] StandardName standard_name(std::string_view name, std::uint32_t hash) noexcept;

} // namespace iecfront
