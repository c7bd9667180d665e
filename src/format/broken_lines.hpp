#pragma once

#include <iecfront/ast/unit.hpp>
#include <iecfront/source/text_range.hpp>

#include <vector>

namespace iecfront::layout {

/// The lines of `unit` that stay as they are, because something in them could not be read:
/// stretches of the unit's text, without their line ends, ordered and apart from each other.
[[nodiscard]] std::vector<TextRange> broken_lines(const Unit& unit);

} // namespace iecfront::layout
