#pragma once

#include <iecfront/ast/node.hpp>
#include <iecfront/ast/unit.hpp>
#include <iecfront/export.hpp>
#include <iecfront/lexer/token.hpp>

#include <vector>

namespace iecfront {

/// The comments that speak of a declaration or statement, out of `Unit::trivia()`. Pragmas do not
/// count as comments, and are looked over.
struct AttachedComments {
    /// Those directly above: on lines of their own, without an empty line between them or between
    /// the last of them and the node.
    std::vector<Trivia> before;
    /// Those behind it, beginning on the line where the node ends; a `;` or `,` may stand between.
    /// One before another token of that line speaks of that, but for one behind a `;`.
    std::vector<Trivia> behind;
};

/// The comments of `node`, a node of `unit` with at least one token.
[[nodiscard]] IECFRONT_API AttachedComments attached_comments(const Unit& unit,
                                                              const ast::Node& node);

} // namespace iecfront
