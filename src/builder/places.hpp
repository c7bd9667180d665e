#pragma once

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/unit.hpp>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

/// Where nodes stand: in their parents, and in the text.
namespace iecfront::build {

/// The node that `node` is a child of; null for the root.
[[nodiscard]] const ast::Node* parent_of(const Unit& unit, const ast::Node& node);

/// The list that a node is an element of.
struct Siblings {
    const ast::Node* parent = nullptr;
    std::vector<const ast::Node*> elements; ///< none when the node is in no list
};
/// A path is no list: points stand between its names.
[[nodiscard]] Siblings siblings_of(const Unit& unit, const ast::Node& node);

/// Elements of lists with commas.
[[nodiscard]] bool has_comma(ast::NodeKind kind) noexcept;

/// The token with this index when it is a `kind`.
[[nodiscard]] std::optional<Token> token_at(const Unit& unit, std::size_t index, TokenKind kind);

/// Where `node` ends with its `;`, when one stands behind it.
[[nodiscard]] std::uint32_t end_with_semicolon(const Unit& unit, const ast::Node& node);

[[nodiscard]] bool is_blank(char c) noexcept;
[[nodiscard]] std::uint32_t line_start(const Unit& unit, std::uint32_t offset);
/// The blanks that the line of `offset` begins with.
[[nodiscard]] std::string_view indentation(const Unit& unit, std::uint32_t offset);
[[nodiscard]] bool begins_line(const Unit& unit, std::uint32_t offset);

} // namespace iecfront::build
