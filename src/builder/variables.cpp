#include "builder/assembly.hpp"

#include <iecfront/builder/variables.hpp>
#include <iecfront/lexer/name.hpp>

namespace iecfront::build {
namespace {

[[nodiscard]] std::string spelling_of(const DirectVariableValue& value) {
    std::string text = {'%', value.location};
    if (value.incomplete)
        return text + '*';
    text += value.size;
    for (std::size_t i = 0; i < value.hierarchy.size(); ++i)
        text += (i > 0 ? "." : "") + std::to_string(value.hierarchy[i]);
    return text;
}

[[nodiscard]] std::string_view keyword_of(ast::Direction direction) noexcept {
    switch (direction) {
    case ast::Direction::none: return "";
    case ast::Direction::read_only: return " READ_ONLY";
    case ast::Direction::read_write: break;
    }
    return " READ_WRITE";
}

} // namespace

Part<ast::Identifier> identifier(std::string_view name) {
    return std::move(Assembly().name(name)).finish<ast::Identifier>();
}

Part<ast::VariableName> variable_name(std::string_view name) {
    return std::move(Assembly().name(name, NameKind::variable)).finish<ast::VariableName>();
}

Part<ast::DirectVariable> direct_variable(const DirectVariableValue& value) {
    return std::move(Assembly().literal(spelling_of(value))).finish<ast::DirectVariable>();
}

Part<ast::ArrayVariable> array_variable(const Expression& subscripted_variable,
                                        const std::vector<Expression>& subscripts) {
    Assembly assembly;
    assembly.require(!subscripts.empty(), "an array variable has no subscript");
    return std::move(assembly.variable(subscripted_variable).text("[").list(subscripts).text("]"))
        .finish<ast::ArrayVariable>();
}

Part<ast::StructuredVariable> structured_variable(const Expression& record_variable,
                                                  std::string_view field_selector) {
    Assembly assembly;
    assembly.variable(record_variable).text(".").name(field_selector, NameKind::variable);
    return std::move(assembly).finish<ast::StructuredVariable>();
}

Part<ast::StructuredVariable> structured_variable(const Expression& resource,
                                                  const Part<ast::DirectVariable>& variable) {
    return std::move(Assembly().variable(resource).text(".").part(variable))
        .finish<ast::StructuredVariable>();
}

Part<ast::Location> location(const Part<ast::DirectVariable>& variable) {
    return std::move(Assembly().text("AT ").part(variable)).finish<ast::Location>();
}

Part<ast::VariableDeclaration>
variable_declaration(const std::vector<std::string_view>& names,
                     const TypeSpecification& specification,
                     const std::optional<Expression>& initial_value) {
    Assembly assembly;
    assembly.names(names).text(" : ").part(specification).optional(" := ", initial_value);
    return std::move(assembly).finish<ast::VariableDeclaration>();
}

// located_var_decl = [ variable_name ] location ":" located_var_spec_init
Part<ast::VariableDeclaration>
located_variable_declaration(std::string_view name, const Part<ast::Location>& location,
                             const TypeSpecification& specification,
                             const std::optional<Expression>& initial_value) {
    Assembly assembly;
    if (!name.empty())
        assembly.name(name).text(" ");
    assembly.part(location).text(" : ").part(specification).optional(" := ", initial_value);
    return std::move(assembly).finish<ast::VariableDeclaration>();
}

// edge_declaration = var1_list ":" "BOOL" ( "R_EDGE" | "F_EDGE" )
Part<ast::VariableDeclaration> edge_declaration(const std::vector<std::string_view>& names,
                                                ast::Edge edge) {
    Assembly assembly;
    assembly.require(edge != ast::Edge::none, "an edge is rising or falling")
        .names(names)
        .text(edge == ast::Edge::rising ? " : BOOL R_EDGE" : " : BOOL F_EDGE");
    return std::move(assembly).finish<ast::VariableDeclaration>();
}

Part<ast::AccessDeclaration> access_declaration(std::string_view name, const Expression& path,
                                                const TypeSpecification& specification,
                                                ast::Direction direction) {
    Assembly assembly;
    assembly.name(name).text(" : ").part(path).text(" : ").part(specification);
    return std::move(assembly.text(keyword_of(direction))).finish<ast::AccessDeclaration>();
}

Part<ast::InstanceSpecificInit> instance_specific_init(
    const std::vector<std::string_view>& path, const std::optional<Part<ast::Location>>& location,
    const TypeSpecification& specification, const std::optional<Expression>& initial_value) {
    Assembly assembly;
    assembly.names(path, ".").optional(" ", location).text(" : ").part(specification);
    return std::move(assembly.optional(" := ", initial_value)).finish<ast::InstanceSpecificInit>();
}

Part<ast::VariableDeclarations> variable_declarations(ast::VariableBlock block,
                                                      const std::vector<Declaration>& declarations,
                                                      ast::BlockQualifier qualifier) {
    Assembly assembly;
    assembly.require(!declarations.empty(), "a block of variables has no declaration")
        .text(folded(to_string(block)))
        .text(keyword_of(qualifier))
        .lines(declarations)
        .text("\nEND_VAR");
    return std::move(assembly).finish<ast::VariableDeclarations>();
}

} // namespace iecfront::build
