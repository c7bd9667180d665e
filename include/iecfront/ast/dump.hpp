#pragma once

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/ast/unit.hpp>
#include <iecfront/export.hpp>

#include <string>

namespace iecfront {

/// The node and all below it as one short S-expression without positions: kinds, members of other
/// than node type, and the text of leaves, as in
/// `(assignment_statement variable:(variable_name "x") expression:(integer_literal "1"))`.
/// `node` belongs to `unit`.
[[nodiscard]] IECFRONT_API std::string s_expression(const Unit& unit, const ast::Node& node);

/// The tree for reading: a node a line, indented, with line and column of its range.
[[nodiscard]] IECFRONT_API std::string dump_tree(const SyntaxTree& tree);

/// The tree as one JSON object: `{"file": …, "units": [{"kind": …, "offset": …, "endOffset": …,
/// …}]}`. Offsets are bytes from the start of the file. Each node has `kind`, `offset`,
/// `endOffset`, its members by name, `"missing": true` where nothing stands for it, and `text` when
/// it is a leaf.
[[nodiscard]] IECFRONT_API std::string dump_json(const SyntaxTree& tree);

} // namespace iecfront
