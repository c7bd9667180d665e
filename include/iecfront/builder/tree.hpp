#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/builder/part.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// From trees to parts and back.
namespace iecfront::build {

namespace detail {
[[nodiscard]] IECFRONT_API AnyPart copied(const Unit& unit, const ast::Node& node);
[[nodiscard]] IECFRONT_API AnyPart with_comment(const AnyPart& part, std::string_view comment);
} // namespace detail

/// The whole text of `node`, a node of `unit`, as a part: with the comments inside it, but without
/// those around it. It has a fault when something in it is missing or could not be read.
template<class Kind>
[[nodiscard]] Part<Kind> copy(const Unit& unit, const Kind& node) {
    return detail::PartAccess::part<Kind>(detail::copied(unit, node));
}

/// True for what stands on lines of its own, so that a comment can stand above it.
template<class Kind>
inline constexpr bool stands_on_lines =
    std::derived_from<Kind, ast::Statement> || std::derived_from<Kind, ast::LibraryElement> ||
    stands_for<Kind, AnyDeclaration> || stands_for<Kind, AnyChartElement> ||
    stands_for<Kind, AnyConfigurationElement> || std::same_as<Kind, AnyDeclaration> ||
    std::same_as<Kind, AnyChartElement> || std::same_as<Kind, AnyConfigurationElement> ||
    std::same_as<Kind, ast::TypeDeclaration> || std::same_as<Kind, ast::CaseElement> ||
    std::same_as<Kind, ast::StructureElementDeclaration> || std::same_as<Kind, ast::IlInstruction>;

/// `part` with `(* comment *)` on the line above it. `comment` is UTF-8, of one line or several.
template<class Kind>
requires stands_on_lines<Kind>
[[nodiscard]] Part<Kind> commented(const Part<Kind>& part, std::string_view comment) {
    return detail::PartAccess::part<Kind>(detail::with_comment(part, comment));
}

/// A file with these elements, in the agreed layout. `name` is what diagnostics call it. Nothing
/// when one of the elements has a fault.
[[nodiscard]] IECFRONT_API std::optional<SyntaxTree>
library(const std::vector<LibraryElement>& elements, std::string name = {});

/// The tree of a piece of a program, as `ParseOptions::read_as` gives it. Nothing when a part has a
/// fault.
[[nodiscard]] IECFRONT_API std::optional<SyntaxTree> fragment(const Expression& expression);
[[nodiscard]] IECFRONT_API std::optional<SyntaxTree> fragment(const Body& body);
[[nodiscard]] IECFRONT_API std::optional<SyntaxTree>
fragment(const std::vector<Part<ast::VariableDeclarations>>& blocks);

} // namespace iecfront::build
