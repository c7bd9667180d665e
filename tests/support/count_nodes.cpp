#include "support/count_nodes.hpp"

#include <iecfront/ast/visitor.hpp>

namespace iecfront::test {

std::size_t count_nodes(const SyntaxTree& tree, ast::NodeKind kind) {
    std::size_t nodes = 0;
    for (const auto& slot : tree.slots())
        ast::walk(slot.unit->root(), [&](const ast::Node& node) {
            nodes += node.kind == kind ? 1 : 0;
            return ast::Walk::into;
        });
    return nodes;
}

} // namespace iecfront::test
