#pragma once

#include "lexer/characters.hpp"
#include "lexer/extents.hpp"

#include <iecfront/lexer/name.hpp>

#include <string_view>

namespace iecfront {

// What stands at a place, as far as some characters tell. All rely on the zero byte behind the
// text.

[[nodiscard]] inline bool begins_number(const char* p) noexcept {
    return is_digit(is_sign(*p) ? p[1] : *p);
}

[[nodiscard]] inline bool is_lone_dot(const char* p) noexcept {
    return *p == '.' && p[1] != '.';
}

// What stands behind a string at the end of a statement or argument.
[[nodiscard]] inline bool ends_operand_at(const char* p) noexcept {
    return std::string_view(";,)]").find(*Extents::blanks_end(p)) != std::string_view::npos;
}

// `IX1`, `Q5`, `M*` behind the `%`.
[[nodiscard]] inline bool is_location(const char* p) noexcept {
    const auto is_one_of = [](char c, std::string_view letters) {
        return letters.find(fold(c)) != std::string_view::npos;
    };
    if (!is_one_of(*p, "IQM"))
        return false;
    ++p;
    return *p == '*' || is_digit(*p) || (is_one_of(*p, "XBWDL") && is_digit(p[1]));
}

} // namespace iecfront
