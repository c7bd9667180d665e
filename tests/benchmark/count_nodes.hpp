#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/ast/visitor.hpp>

#include <cstddef>

namespace iecfront::bench {

/// By a walk over all of them.
[[nodiscard]] inline std::size_t count_nodes(const SyntaxTree& tree) {
    std::size_t nodes = 0;
    for (const SyntaxTree::Slot& slot : tree.slots())
        ast::walk(slot.unit->root(), [&nodes](const ast::Node&) {
            ++nodes;
            return ast::Walk::into;
        });
    return nodes;
}

/// As they are stored.
[[nodiscard]] inline std::size_t count_stored_nodes(const SyntaxTree& tree) {
    std::size_t nodes = 0;
    for (const SyntaxTree::Slot& slot : tree.slots())
        for ([[maybe_unused]] const ast::Node& node : slot.unit->nodes())
            ++nodes;
    return nodes;
}

} // namespace iecfront::bench
