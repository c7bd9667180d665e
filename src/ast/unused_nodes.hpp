#pragma once

#include <iecfront/ast/node.hpp>

#include <cstddef>
#include <span>

namespace iecfront::ast {

/// Where `node` lies in `memory`, in bytes.
[[nodiscard]] std::size_t place_of(const Node& node, std::span<const std::byte> memory) noexcept;

/// Takes `node`, which is in no tree, out of those that are stored in `memory`: it becomes words
/// that `StoredNodes` passes over, and nobody may look at it any more.
void mark_unused(const Node& node, std::span<std::byte> memory) noexcept;

/// The same of all nodes in `memory` from `root` on, but for this one and those below it.
void mark_all_unused_but(const Node& root, std::span<std::byte> memory);

} // namespace iecfront::ast
