#include "ast/unused_nodes.hpp"

#include <iecfront/ast/stored_nodes.hpp>
#include <iecfront/ast/visitor.hpp>

#include <algorithm>
#include <vector>

namespace iecfront::ast {
namespace {

/// In bytes.
[[nodiscard]] std::size_t place_of(const Node& node, std::span<const std::byte> memory) noexcept {
    return static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&node) - memory.data());
}

} // namespace

void mark_unused(const Node& node, std::span<std::byte> memory) noexcept {
    const std::size_t size = detail::node_sizes[static_cast<std::size_t>(node.kind)];
    std::ranges::fill(memory.subspan(place_of(node, memory), size), StoredNodes::unused);
}

void mark_unused_but_below(const Node& root, std::span<std::byte> memory) {
    std::vector<bool> used(memory.size() / alignof(Node));
    walk(root, [&](const Node& node) {
        used[place_of(node, memory) / alignof(Node)] = true;
        return Walk::into;
    });
    const StoredNodes nodes(memory);
    for (auto next = nodes.begin(); next != nodes.end();) {
        const Node& node = *next++;
        if (!used[place_of(node, memory) / alignof(Node)])
            mark_unused(node, memory);
    }
}

} // namespace iecfront::ast
