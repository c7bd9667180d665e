#pragma once

#include <iecfront/builder/constants.hpp>
#include <iecfront/builder/part.hpp>

#include <optional>
#include <string_view>
#include <vector>

/// Data types and their initial values (B.1.3).
namespace iecfront::build {

/// `INT`, `TIME` and the other names of 2.3.1, in any case.
[[nodiscard]] IECFRONT_API Part<ast::ElementaryTypeName>
elementary_type_name(std::string_view name);

/// The name of a user-defined type or of a function block type.
[[nodiscard]] IECFRONT_API Part<ast::DerivedTypeName> derived_type_name(std::string_view name);

/// `lower..upper`; both inclusive.
[[nodiscard]] IECFRONT_API Part<ast::Subrange> subrange(const Expression& lower,
                                                        const Expression& upper);

/// `INT (-10..10)`.
[[nodiscard]] IECFRONT_API Part<ast::SubrangeSpecification>
subrange_specification(const TypeSpecification& base, const Part<ast::Subrange>& range);

/// A value in the list of an enumeration; `Type#name` with a `type`, which the grammar allows
/// there.
[[nodiscard]] IECFRONT_API Part<ast::EnumeratedValueDeclaration>
enumerated_value_declaration(std::string_view name, std::string_view type = {});

/// `(Idle, Heat, Cool)`; at least one value.
[[nodiscard]] IECFRONT_API Part<ast::EnumeratedSpecification>
enumerated_specification(const std::vector<Part<ast::EnumeratedValueDeclaration>>& values);

/// `ARRAY [1..10, 0..3] OF element_type`; at least one subrange.
[[nodiscard]] IECFRONT_API Part<ast::ArraySpecification>
array_specification(const std::vector<Part<ast::Subrange>>& subranges,
                    const TypeSpecification& element_type);

/// `STRING[10]`, `WSTRING[10]`.
[[nodiscard]] IECFRONT_API Part<ast::StringSpecification>
string_specification(StringWidth width, const Expression& length);

/// `name : specification := initial_value` in a structure.
[[nodiscard]] IECFRONT_API Part<ast::StructureElementDeclaration>
structure_element_declaration(std::string_view name, const TypeSpecification& specification,
                              const std::optional<Expression>& initial_value = {});

/// `STRUCT ... END_STRUCT`; at least one element.
[[nodiscard]] IECFRONT_API Part<ast::StructureDeclaration>
structure_declaration(const std::vector<Part<ast::StructureElementDeclaration>>& elements);

/// `name : specification := initial_value` in a TYPE block.
[[nodiscard]] IECFRONT_API Part<ast::TypeDeclaration>
type_declaration(std::string_view name, const TypeSpecification& specification,
                 const std::optional<Expression>& initial_value = {});

/// `TYPE ... END_TYPE`; at least one declaration.
[[nodiscard]] IECFRONT_API Part<ast::DataTypeDeclaration>
data_type_declaration(const std::vector<Part<ast::TypeDeclaration>>& declarations);

/// `[1, 2, 3(0)]`; at least one element.
[[nodiscard]] IECFRONT_API Part<ast::ArrayInitialization>
array_initialization(const std::vector<Expression>& elements);

/// `3(0)`, or `3()` for elements with their default: a repetition in an array initialization.
[[nodiscard]] IECFRONT_API Part<ast::ArrayInitialElements>
array_initial_elements(const Expression& count, const std::optional<Expression>& element = {});

/// `name := value` in a structure initialization.
[[nodiscard]] IECFRONT_API Part<ast::StructureElementInitialization>
structure_element_initialization(std::string_view name, const Expression& value);

/// `(a := 1, b := 2)`: of a structure or of a function block instance; at least one element.
[[nodiscard]] IECFRONT_API Part<ast::StructureInitialization>
structure_initialization(const std::vector<Part<ast::StructureElementInitialization>>& elements);

} // namespace iecfront::build
