#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/export.hpp>
#include <iecfront/source/text_range.hpp>

#include <cstdint>
#include <vector>

namespace iecfront {

/// What an editor can fold away.
enum class FoldingKind : std::uint8_t {
    code,    ///< a library element, a declaration block, a statement, a branch, a call, a step ...
    comment, ///< a comment of several lines, or several that are alone on lines in a row
};

/// Lines that can be folded, leaving the first one. Where something else goes on behind what is
/// folded, the line of its end is left as well: a fold never hides what does not belong to it.
struct FoldingRange {
    std::uint32_t first_line = 1; ///< 1-based
    std::uint32_t last_line = 1;  ///< 1-based, above `first_line`
    FoldingKind kind{};           ///< for editors that treat comments in a way of their own

    friend constexpr bool operator==(FoldingRange, FoldingRange) noexcept = default;
};

/// All of them, ordered by their first line; on one line only the longest begins.
[[nodiscard]] IECFRONT_API std::vector<FoldingRange> folding_ranges(const SyntaxTree& tree);

/// What an editor selects around a caret before the byte at `offset` when it is asked for more and
/// more: the token or comment there, each node around it, the unit, the file. A word that ends at
/// the caret is taken when none begins there. Each range contains the one before it and is larger.
/// Counted from the start of the file.
[[nodiscard]] IECFRONT_API std::vector<TextRange> selection_ranges(const SyntaxTree& tree,
                                                                   std::uint32_t offset);

} // namespace iecfront
