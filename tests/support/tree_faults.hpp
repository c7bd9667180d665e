#pragma once

#include <iecfront/ast/syntax_tree.hpp>

#include <string>
#include <string_view>

namespace iecfront::test {

/// What is wrong with the tree of `text`, in words; empty when all that has to hold does:
/// units tile the text, tokens and trivia with white space between them make up each unit, nodes
/// nest in order and none is missing, those stored are those of the tree, diagnostics are ordered
/// and refer to what is there.
[[nodiscard]] std::string tree_fault(const SyntaxTree& tree, std::string_view text);

/// What is wrong with what is written of the tree: dumps, messages, positions. Costs more.
[[nodiscard]] std::string output_fault(const SyntaxTree& tree);

} // namespace iecfront::test
