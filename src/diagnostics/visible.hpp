#pragma once

#include <iecfront/source/encoding.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace iecfront {

/// True when `code_point` can be seen and leaves the line as it is: no control character, no
/// unassigned plane end, nothing that breaks the line, has no width, or turns the direction of
/// writing.
[[nodiscard]] bool is_visible(char32_t code_point) noexcept;

/// Appends `text` as UTF-8 in which everything can be seen: `\x1B` for control characters and
/// broken bytes, `\u202E` for other invisible ones.
void append_visible(std::string& out, std::string_view text, Encoding encoding);

/// The same with at most `width` characters: a longer text loses its middle.
void append_shortened(std::string& out, std::string_view text, std::size_t width,
                      Encoding encoding);

/// `U+0041`, with at least four digits.
void append_code_point_number(std::string& out, char32_t code_point);

} // namespace iecfront
