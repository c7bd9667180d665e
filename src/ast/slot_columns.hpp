#pragma once

#include <iecfront/ast/syntax_tree.hpp>

#include <cstdint>

namespace iecfront {

// How many columns the bytes [begin, end) of a unit take; no line ends before `end`.
[[nodiscard]] std::uint32_t columns_between(const SyntaxTree::Slot& slot, std::uint32_t begin,
                                            std::uint32_t end, ColumnUnit unit) noexcept;

} // namespace iecfront
