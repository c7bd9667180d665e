#pragma once

#include <iecfront/ast/syntax_tree.hpp>

#include <string>

namespace iecfront::test {

/// Makes the tree of a text without findings anew, node by node, with the functions of the builder;
/// constants, and locations that say no size, are copied. Gives what differs then: nothing, or the
/// case of keywords, is empty.
[[nodiscard]] std::string rebuild_fault(const SyntaxTree& tree);

} // namespace iecfront::test
