#include "ast/unused_nodes.hpp"

#include <iecfront/ast/stored_nodes.hpp>
#include <iecfront/ast/visitor.hpp>

#include <algorithm>
#include <vector>

namespace iecfront::ast {

std::size_t place_of(const Node& node, std::span<const std::byte> memory) noexcept {
    return static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&node) - memory.data());
}

void mark_unused(const Node& node, std::span<std::byte> memory) noexcept {
    const std::size_t size = detail::node_sizes[static_cast<std::size_t>(node.kind)];
    std::ranges::fill(memory.subspan(place_of(node, memory), size), StoredNodes::unused);
}

void mark_all_unused_but(const Node& root, std::span<std::byte> memory) {
    const auto word_of = [memory](const Node& node) {
        return place_of(node, memory) / alignof(Node);
    };
    std::vector<bool> used(memory.size() / alignof(Node));
    walk(root, [&](const Node& node) {
        used[word_of(node)] = true;
        return Walk::into;
    });
    const StoredNodes nodes(memory.subspan(place_of(root, memory)));
    for (auto next = nodes.begin(); next != nodes.end();) {
        const Node& node = *next++;
        if (!used[word_of(node)])
            mark_unused(node, memory);
    }
}

} // namespace iecfront::ast
