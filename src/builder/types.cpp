#include "builder/assembly.hpp"
#include "lexer/keywords.hpp"

#include <iecfront/builder/types.hpp>
#include <iecfront/lexer/name.hpp>

namespace iecfront::build {
namespace {

// name : specification [:= initial value]
[[nodiscard]] Assembly& declare(Assembly& assembly, std::string_view name,
                                const TypeSpecification& specification,
                                const std::optional<Expression>& initial_value) {
    return assembly.name(name).text(" : ").part(specification).optional(" := ", initial_value);
}

} // namespace

Part<ast::ElementaryTypeName> elementary_type_name(std::string_view name) {
    Assembly assembly;
    assembly.require(is_elementary_type_name(keyword_kind(name)),
                     quoted(name) + " is no elementary type");
    return std::move(assembly.text(folded(name))).finish<ast::ElementaryTypeName>();
}

Part<ast::DerivedTypeName> derived_type_name(std::string_view name) {
    return std::move(Assembly().name(name)).finish<ast::DerivedTypeName>();
}

// subrange = signed_integer ".." signed_integer
Part<ast::Subrange> subrange(const Expression& lower, const Expression& upper) {
    return std::move(Assembly().part(lower).text("..").part(upper)).finish<ast::Subrange>();
}

Part<ast::SubrangeSpecification> subrange_specification(const TypeSpecification& base,
                                                        const Part<ast::Subrange>& range) {
    return std::move(Assembly().part(base).text(" (").part(range).text(")"))
        .finish<ast::SubrangeSpecification>();
}

Part<ast::EnumeratedValueDeclaration> enumerated_value_declaration(std::string_view name,
                                                                   std::string_view type) {
    return std::move(Assembly().enumerated_value(name, type))
        .finish<ast::EnumeratedValueDeclaration>();
}

Part<ast::EnumeratedSpecification>
enumerated_specification(const std::vector<Part<ast::EnumeratedValueDeclaration>>& values) {
    Assembly assembly;
    assembly.require(!values.empty(), "an enumeration has no value");
    return std::move(assembly.text("(").list(values).text(")"))
        .finish<ast::EnumeratedSpecification>();
}

Part<ast::ArraySpecification> array_specification(const std::vector<Part<ast::Subrange>>& subranges,
                                                  const TypeSpecification& element_type) {
    Assembly assembly;
    assembly.require(!subranges.empty(), "an array has no subrange")
        .text("ARRAY [")
        .list(subranges)
        .text("] OF ")
        .part(element_type);
    return std::move(assembly).finish<ast::ArraySpecification>();
}

Part<ast::StringSpecification> string_specification(StringWidth width, const Expression& length) {
    const bool double_byte = width == StringWidth::double_byte;
    return std::move(Assembly().text(double_byte ? "WSTRING[" : "STRING[").part(length).text("]"))
        .finish<ast::StringSpecification>();
}

Part<ast::StructureElementDeclaration>
structure_element_declaration(std::string_view name, const TypeSpecification& specification,
                              const std::optional<Expression>& initial_value) {
    Assembly assembly;
    return std::move(declare(assembly, name, specification, initial_value))
        .finish<ast::StructureElementDeclaration>();
}

Part<ast::StructureDeclaration>
structure_declaration(const std::vector<Part<ast::StructureElementDeclaration>>& elements) {
    Assembly assembly;
    assembly.require(!elements.empty(), "a structure has no element");
    return std::move(assembly.text("STRUCT").lines(elements).text("\nEND_STRUCT"))
        .finish<ast::StructureDeclaration>();
}

Part<ast::TypeDeclaration> type_declaration(std::string_view name,
                                            const TypeSpecification& specification,
                                            const std::optional<Expression>& initial_value) {
    Assembly assembly;
    return std::move(declare(assembly, name, specification, initial_value))
        .finish<ast::TypeDeclaration>();
}

Part<ast::DataTypeDeclaration>
data_type_declaration(const std::vector<Part<ast::TypeDeclaration>>& declarations) {
    Assembly assembly;
    assembly.require(!declarations.empty(), "a TYPE block has no declaration");
    return std::move(assembly.text("TYPE").lines(declarations).text("\nEND_TYPE"))
        .finish<ast::DataTypeDeclaration>();
}

Part<ast::ArrayInitialization> array_initialization(const std::vector<Expression>& elements) {
    Assembly assembly;
    assembly.require(!elements.empty(), "an array initialization has no element");
    return std::move(assembly.text("[").list(elements).text("]"))
        .finish<ast::ArrayInitialization>();
}

Part<ast::ArrayInitialElements> array_initial_elements(const Expression& count,
                                                       const std::optional<Expression>& element) {
    return std::move(Assembly().part(count).text("(").optional("", element).text(")"))
        .finish<ast::ArrayInitialElements>();
}

Part<ast::StructureElementInitialization>
structure_element_initialization(std::string_view name, const Expression& value) {
    return std::move(Assembly().name(name).text(" := ").part(value))
        .finish<ast::StructureElementInitialization>();
}

Part<ast::StructureInitialization>
structure_initialization(const std::vector<Part<ast::StructureElementInitialization>>& elements) {
    Assembly assembly;
    assembly.require(!elements.empty(), "a structure initialization has no element");
    return std::move(assembly.text("(").list(elements).text(")"))
        .finish<ast::StructureInitialization>();
}

} // namespace iecfront::build
