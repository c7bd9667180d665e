#pragma once

#include "format/pieces.hpp"

#include <cstdint>
#include <span>

namespace iecfront::layout {

/// Aligns what stands in lines: the colons and initial values of declarations, the values of
/// arguments that have lines of their own, and the comments behind.
void align(std::span<Piece> pieces, std::uint32_t line_length);

} // namespace iecfront::layout
