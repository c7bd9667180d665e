#pragma once

#include <iecfront/ast/syntax_tree.hpp>

#include <cstddef>

namespace iecfront::test {

/// How many nodes of the tree are of this kind.
[[nodiscard]] std::size_t count_nodes(const SyntaxTree& tree, ast::NodeKind kind);

} // namespace iecfront::test
