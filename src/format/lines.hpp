#pragma once

#include "format/pieces.hpp"

#include <cstdint>
#include <span>

namespace iecfront::layout {

/// Where lines end: sets `begins_line`, `spaces` and `column` of each piece. Long lines are broken
/// where they may be, outermost parentheses first.
void break_lines(std::span<Piece> pieces, std::uint32_t indent_width, std::uint32_t line_length);

} // namespace iecfront::layout
