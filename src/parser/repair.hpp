#pragma once

#include "parser/parser_arena.hpp"

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/lexer/token.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace iecfront {

/// What the parser reads of a unit.
struct ParserInput {
    std::string_view text;
    std::span<Token> tokens;             // the last one is end_of_unit
    std::span<const Diagnostic> lexical; // what the lexer reported, ordered by place
    std::uint32_t opener;
    bool balanced; // see UnitCut
    const ParseOptions& options;
};

/// What it makes of it.
struct Reading {
    const ast::LibraryUnit* root;
    std::vector<Diagnostic> reports;
};

/// Looks for a token that explains several of `reports`, which the parser made, at once: when it is
/// passed over or taken for another one, they are not made, and no new one. Gives what is read
/// then, with a report about that token, and nothing when there is no such token. Makes nodes in
/// `arena`, of which what is used beyond `kept` bytes is that of the reading before.
[[nodiscard]] std::optional<Reading> repair(const ParserInput& input,
                                            const std::vector<Diagnostic>& reports,
                                            ParserArena& arena, std::size_t kept);

} // namespace iecfront
