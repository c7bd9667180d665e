#pragma once

#include <iecfront/builder/part.hpp>
#include <iecfront/lexer/literals.hpp>

#include <optional>
#include <string_view>
#include <vector>

/// Variables and their declaration (B.1.4).
namespace iecfront::build {

/// A name where it is declared, for `Changes`: all functions that make declarations take text.
[[nodiscard]] IECFRONT_API Part<ast::Identifier> identifier(std::string_view name);

/// A name as an operand. EN and ENO are variables as well.
[[nodiscard]] IECFRONT_API Part<ast::VariableName> variable_name(std::string_view name);

/// `%IX1.0`; `incomplete`, as the variable of a `location`, `%I*`.
[[nodiscard]] IECFRONT_API Part<ast::DirectVariable>
direct_variable(const DirectVariableValue& value);

/// `variable[1, i + 1]`; at least one subscript.
[[nodiscard]] IECFRONT_API Part<ast::ArrayVariable>
array_variable(const Expression& subscripted_variable, const std::vector<Expression>& subscripts);

/// `variable.field`.
[[nodiscard]] IECFRONT_API Part<ast::StructuredVariable>
structured_variable(const Expression& record_variable, std::string_view field_selector);
/// `resource.%IX1.0`, in an access path.
[[nodiscard]] IECFRONT_API Part<ast::StructuredVariable>
structured_variable(const Expression& resource, const Part<ast::DirectVariable>& variable);

/// `AT %QX1.0`, `AT %I*`.
[[nodiscard]] IECFRONT_API Part<ast::Location> location(const Part<ast::DirectVariable>& variable);

/// `a, b : specification := initial_value`; at least one name.
[[nodiscard]] IECFRONT_API Part<ast::VariableDeclaration>
variable_declaration(const std::vector<std::string_view>& names,
                     const TypeSpecification& specification,
                     const std::optional<Expression>& initial_value = {});

/// `a AT %QX1.0 : specification := initial_value` (located_var_decl); without a `name` the location
/// stands alone.
[[nodiscard]] IECFRONT_API Part<ast::VariableDeclaration>
located_variable_declaration(std::string_view name, const Part<ast::Location>& location,
                             const TypeSpecification& specification,
                             const std::optional<Expression>& initial_value = {});

/// `a, b : BOOL R_EDGE` (edge_declaration); at least one name.
[[nodiscard]] IECFRONT_API Part<ast::VariableDeclaration>
edge_declaration(const std::vector<std::string_view>& names, ast::Edge edge);

/// `name : path : specification READ_WRITE` in VAR_ACCESS.
[[nodiscard]] IECFRONT_API Part<ast::AccessDeclaration>
access_declaration(std::string_view name, const Expression& path,
                   const TypeSpecification& specification,
                   ast::Direction direction = ast::Direction::none);

/// `resource.program.variable AT location : specification := initial_value` in VAR_CONFIG. `path`
/// has the names between the points.
[[nodiscard]] IECFRONT_API Part<ast::InstanceSpecificInit> instance_specific_init(
    const std::vector<std::string_view>& path, const std::optional<Part<ast::Location>>& location,
    const TypeSpecification& specification, const std::optional<Expression>& initial_value = {});

/// `VAR_INPUT RETAIN ... END_VAR`: a declaration block; at least one declaration.
[[nodiscard]] IECFRONT_API Part<ast::VariableDeclarations>
variable_declarations(ast::VariableBlock block, const std::vector<Declaration>& declarations,
                      ast::BlockQualifier qualifier = ast::BlockQualifier::none);

} // namespace iecfront::build
