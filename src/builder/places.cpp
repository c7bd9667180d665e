#include "builder/places.hpp"

#include "builder/assembly.hpp"

#include <iecfront/ast/visitor.hpp>

#include <algorithm>

namespace iecfront::build {

const ast::Node* parent_of(const Unit& unit, const ast::Node& node) {
    const ast::Node* parent = nullptr;
    ast::walk(unit.root(), [&](const ast::Node& candidate) {
        if (candidate.first_token > node.first_token || candidate.end_token < node.end_token)
            return ast::Walk::over;
        ast::for_each_child(candidate, [&](const ast::Node& child) {
            if (&child == &node)
                parent = &candidate;
        });
        return parent != nullptr ? ast::Walk::stop : ast::Walk::into;
    });
    return parent;
}

Siblings siblings_of(const Unit& unit, const ast::Node& node) {
    Siblings found{parent_of(unit, node), {}};
    if (found.parent == nullptr || found.parent->kind == ast::NodeKind::instance_specific_init)
        return found;
    ast::for_each_member(*found.parent, [&](std::string_view, const auto& member) {
        if constexpr (ast::is_list_member<std::remove_cvref_t<decltype(member)>>) {
            const auto is_it = [&](const ast::Node* element) { return element == &node; };
            if (std::ranges::any_of(member, is_it))
                found.elements.assign(member.begin(), member.end());
        }
    });
    return found;
}

bool is_blank(char c) noexcept {
    return c == ' ' || c == '\t';
}

std::uint32_t line_start(const Unit& unit, std::uint32_t offset) {
    return unit.lines().line_start(unit.lines().line_of(offset));
}

std::string_view indentation(const Unit& unit, std::uint32_t offset) {
    const std::string_view line = unit.text().substr(line_start(unit, offset));
    const auto end = std::ranges::find_if_not(line, is_blank);
    return line.substr(0, static_cast<std::size_t>(end - line.begin()));
}

bool begins_line(const Unit& unit, std::uint32_t offset) {
    return line_start(unit, offset) + indentation(unit, offset).size() == offset;
}

bool has_comma(ast::NodeKind kind) noexcept {
    switch (kind) {
    case ast::NodeKind::identifier:
    case ast::NodeKind::input_argument:
    case ast::NodeKind::output_argument:
    case ast::NodeKind::enumerated_value_declaration:
    case ast::NodeKind::subrange:
    case ast::NodeKind::structure_element_initialization:
    case ast::NodeKind::task_initialization:
    case ast::NodeKind::fb_task:
    case ast::NodeKind::prog_cnxn: return true;
    default: return ast::is<ast::Expression>(kind);
    }
}

std::optional<Token> token_at(const Unit& unit, std::size_t index, TokenKind kind) {
    if (index < unit.tokens().size() && unit.tokens()[index].kind() == kind)
        return unit.tokens()[index];
    return std::nullopt;
}

std::uint32_t end_with_semicolon(const Unit& unit, const ast::Node& node) {
    if (has_semicolon(node.kind))
        if (const std::optional<Token> found = token_at(unit, node.end_token, TokenKind::semicolon))
            return found->end();
    return unit.range(node).end;
}

} // namespace iecfront::build
