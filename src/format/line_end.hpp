#pragma once

#include <iecfront/ast/syntax_tree.hpp>

#include <string_view>

namespace iecfront::layout {

/// What the first line ends in that is no empty one, a line of a comment aside; LF when there is
/// none.
[[nodiscard]] std::string_view line_end_of(const SyntaxTree& tree);

} // namespace iecfront::layout
