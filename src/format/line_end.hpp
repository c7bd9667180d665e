#pragma once

#include <iecfront/ast/syntax_tree.hpp>

#include <cstddef>
#include <string_view>

namespace iecfront::layout {

/// The line end that stands at byte `at` of `text`.
[[nodiscard]] std::string_view line_end_at(std::string_view text, std::size_t at) noexcept;

/// What the first line ends in that is no empty one; a line of a comment when there is no other,
/// and LF when there is none at all.
[[nodiscard]] std::string_view line_end_of(const SyntaxTree& tree);

} // namespace iecfront::layout
