#pragma once

#include <iecfront/ast/node.hpp>
#include <iecfront/ast/unit.hpp>
#include <iecfront/export.hpp>
#include <iecfront/lexer/token.hpp>

#include <span>

namespace iecfront {

/// The comments that speak of a declaration or statement. Both are stretches of `Unit::trivia()`.
struct AttachedComments {
    /// Those directly above: on lines of their own, without an empty line between them or between
    /// the last of them and the node.
    std::span<const Trivia> before;
    /// Those behind it, beginning on the line where the node ends; a `;` or `,` may stand between.
    std::span<const Trivia> behind;
};

/// The comments of `node`, a node of `unit` with at least one token. The spans live as long as the
/// unit. Pragmas do not count as comments.
[[nodiscard]] IECFRONT_API AttachedComments attached_comments(const Unit& unit,
                                                              const ast::Node& node);

} // namespace iecfront
