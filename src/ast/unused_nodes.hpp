#pragma once

#include <iecfront/ast/node.hpp>

#include <cstddef>
#include <span>

namespace iecfront::ast {

/// Takes `node`, which is in no tree, out of those that are stored in `memory`: it becomes words
/// that `StoredNodes` passes over.
void mark_unused(const Node& node, std::span<std::byte> memory) noexcept;

/// The same of all nodes in `memory` that are not below `root`.
void mark_unused_but_below(const Node& root, std::span<std::byte> memory);

} // namespace iecfront::ast
