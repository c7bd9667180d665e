#pragma once

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/ast/unit.hpp>
#include <iecfront/export.hpp>

#include <string>

namespace iecfront {

/// The node and all below it as one short line without positions. `node` belongs to `unit`.
///
///     (if_statement condition:(variable_name "x") then_list:(statement_list [(exit_statement)]))
///
/// Behind the kind stand, in this order: `missing` when nothing in the source stands for the node;
/// the members that are no nodes, as bare words (`var_input`, `constant`, `>=`, `negated`; what is
/// false or `none` is left out, and so are hashes and token numbers); the text of a node that has
/// no members of node type, as a JSON string, cut behind 40 bytes; the children. Their names are
/// written where the struct has several members of node type; lists stand in brackets; null
/// members and empty lists are left out. An identifier is its text alone: `"x"`.
[[nodiscard]] IECFRONT_API std::string s_expression(const Unit& unit, const ast::Node& node);

/// The tree for reading: a node a line, in the words of `s_expression`, indented below its parent,
/// with line and column of its first character and of the one behind its last. From 60 levels down
/// the level is written as a number instead.
///
///     assignment_statement 3:1-3:7
///       variable: variable_name "x" 3:1-3:2
///       expression: integer_literal "1" 3:6-3:7
///
/// Both numbers are 1-based, and columns count code points.
[[nodiscard]] IECFRONT_API std::string dump_tree(const SyntaxTree& tree);

/// The tree as one JSON object, `{"file": "tank.st", "units": [{"kind": "library_unit", "offset":
/// 0, "endOffset": 99, "elements": [...]}]}`. Offsets are bytes from the start of the file. Each
/// node has `kind`, `offset`, `endOffset`; `"missing": true` where nothing stands for it; its
/// members by name, where null is `null` and enumerations are strings, without hashes and token
/// numbers; and `text` when its struct has no members of node type.
[[nodiscard]] IECFRONT_API std::string dump_json(const SyntaxTree& tree);

} // namespace iecfront
