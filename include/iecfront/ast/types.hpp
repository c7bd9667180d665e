#pragma once

#include <iecfront/ast/node.hpp>

#include <cstdint>
#include <string_view>
#include <tuple>

/// Data types and their initial values (B.1.3).
namespace iecfront::ast {

struct Subrange;
struct EnumeratedValueDeclaration;
struct StructureElementInitialization;

/// `TYPE ... END_TYPE` (B.1.3.3).
struct DataTypeDeclaration : LibraryElement {
    static constexpr NodeKind node_kind = NodeKind::data_type_declaration;
    DataTypeDeclaration() noexcept : LibraryElement(node_kind) {}
    List<Node> declarations; ///< `TypeDeclaration`, or `ErrorDeclaration`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"declarations", &DataTypeDeclaration::declarations}};
    }
};

/// `name : specification [:= initial value]` in a TYPE block (B.1.3.3).
struct TypeDeclaration : Node {
    static constexpr NodeKind node_kind = NodeKind::type_declaration;
    TypeDeclaration() noexcept : Node(node_kind) {}
    Child<Identifier> name;
    Child<TypeSpecification> specification;
    Child<Expression> initial_value; ///< null when not given

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &TypeDeclaration::name},
                          MemberDescription{"specification", &TypeDeclaration::specification},
                          MemberDescription{"initial_value", &TypeDeclaration::initial_value}};
    }
};

/// `INT`, `BOOL`, `TIME` ... (B.1.3.1): the kind of the token says which. Also a generic name such
/// as `ANY_INT`, which is reported.
struct ElementaryTypeName : TypeSpecification {
    static constexpr NodeKind node_kind = NodeKind::elementary_type_name;
    ElementaryTypeName() noexcept : TypeSpecification(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// The name of a user-defined type or of a function block type; which of them, only its declaration
/// tells (B.1.3.3, B.1.5.2).
struct DerivedTypeName : TypeSpecification {
    static constexpr NodeKind node_kind = NodeKind::derived_type_name;
    DerivedTypeName() noexcept : TypeSpecification(node_kind) {}
    std::uint32_t hash = 0; ///< of the case-folded spelling, see `hash_name`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"hash", &DerivedTypeName::hash}};
    }
};

/// `INT (-10..10)` (B.1.3.3).
struct SubrangeSpecification : TypeSpecification {
    static constexpr NodeKind node_kind = NodeKind::subrange_specification;
    SubrangeSpecification() noexcept : TypeSpecification(node_kind) {}
    Child<TypeSpecification> base;
    Child<Subrange> range;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"base", &SubrangeSpecification::base},
                          MemberDescription{"range", &SubrangeSpecification::range}};
    }
};

/// `(Idle, Heat, Cool)` (B.1.3.3).
struct EnumeratedSpecification : TypeSpecification {
    static constexpr NodeKind node_kind = NodeKind::enumerated_specification;
    EnumeratedSpecification() noexcept : TypeSpecification(node_kind) {}
    Child<TypeSpecification> base; ///< `INT (A, B)`: an extension; else null
    List<EnumeratedValueDeclaration> values;
    Child<TypeSpecification> base_behind; ///< `(A, B) INT`: an extension; else null

    static constexpr auto members() {
        return std::tuple{MemberDescription{"base", &EnumeratedSpecification::base},
                          MemberDescription{"values", &EnumeratedSpecification::values},
                          MemberDescription{"base_behind", &EnumeratedSpecification::base_behind}};
    }
};

/// One value in the list of an enumeration (B.1.3.3).
struct EnumeratedValueDeclaration : Node {
    static constexpr NodeKind node_kind = NodeKind::enumerated_value_declaration;
    EnumeratedValueDeclaration() noexcept : Node(node_kind) {}
    Child<Identifier> name;
    Child<Expression> value; ///< `A := 1`: an extension; null when not given

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &EnumeratedValueDeclaration::name},
                          MemberDescription{"value", &EnumeratedValueDeclaration::value}};
    }
};

/// `ARRAY [1..10, 0..3] OF element type` (B.1.3.3).
struct ArraySpecification : TypeSpecification {
    static constexpr NodeKind node_kind = NodeKind::array_specification;
    ArraySpecification() noexcept : TypeSpecification(node_kind) {}
    List<Subrange> subranges; ///< one for each subscript
    Child<TypeSpecification> element_type;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"subranges", &ArraySpecification::subranges},
                          MemberDescription{"element_type", &ArraySpecification::element_type}};
    }
};

/// `lower..upper` (B.1.3.3); both inclusive.
struct Subrange : Node {
    static constexpr NodeKind node_kind = NodeKind::subrange;
    Subrange() noexcept : Node(node_kind) {}
    Child<Expression> lower;
    Child<Expression> upper;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"lower", &Subrange::lower},
                          MemberDescription{"upper", &Subrange::upper}};
    }
};

/// `STRUCT ... END_STRUCT` (B.1.3.3).
struct StructureDeclaration : TypeSpecification {
    static constexpr NodeKind node_kind = NodeKind::structure_declaration;
    StructureDeclaration() noexcept : TypeSpecification(node_kind) {}
    List<Node> elements; ///< `StructureElementDeclaration`, or `ErrorDeclaration`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"elements", &StructureDeclaration::elements}};
    }
};

/// `name : specification [:= initial value];` in a structure (B.1.3.3).
struct StructureElementDeclaration : Node {
    static constexpr NodeKind node_kind = NodeKind::structure_element_declaration;
    StructureElementDeclaration() noexcept : Node(node_kind) {}
    List<Identifier> names; ///< one; several are an extension
    Child<TypeSpecification> specification;
    Child<Expression> initial_value; ///< null when not given

    static constexpr auto members() {
        return std::tuple{
            MemberDescription{"names", &StructureElementDeclaration::names},
            MemberDescription{"specification", &StructureElementDeclaration::specification},
            MemberDescription{"initial_value", &StructureElementDeclaration::initial_value}};
    }
};

/// `STRING[10]`, `WSTRING[10]`; without a length it is an `ElementaryTypeName` (B.1.4.3).
struct StringSpecification : TypeSpecification {
    static constexpr NodeKind node_kind = NodeKind::string_specification;
    StringSpecification() noexcept : TypeSpecification(node_kind) {}
    bool double_byte = false; ///< WSTRING
    Child<Expression> length;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"double_byte", &StringSpecification::double_byte},
                          MemberDescription{"length", &StringSpecification::length}};
    }
};

/// Stands where a type is missing or cannot be read.
struct ErrorType : TypeSpecification {
    static constexpr NodeKind node_kind = NodeKind::error_type;
    ErrorType() noexcept : TypeSpecification(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// `[1, 2, 3(0)]` (B.1.3.3).
struct ArrayInitialization : Expression {
    static constexpr NodeKind node_kind = NodeKind::array_initialization;
    ArrayInitialization() noexcept : Expression(node_kind) {}
    List<Expression> elements;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"elements", &ArrayInitialization::elements}};
    }
};

/// `3(0)`: a repetition in an array initialization (B.1.3.3).
struct ArrayInitialElements : Expression {
    static constexpr NodeKind node_kind = NodeKind::array_initial_elements;
    ArrayInitialElements() noexcept : Expression(node_kind) {}
    Child<Expression> count;
    List<Expression> elements; ///< none: the default; more than one is an extension

    static constexpr auto members() {
        return std::tuple{MemberDescription{"count", &ArrayInitialElements::count},
                          MemberDescription{"elements", &ArrayInitialElements::elements}};
    }
};

/// `(a := 1, b := 2)`: of a structure or of a function block instance (B.1.3.3).
struct StructureInitialization : Expression {
    static constexpr NodeKind node_kind = NodeKind::structure_initialization;
    StructureInitialization() noexcept : Expression(node_kind) {}
    List<StructureElementInitialization> elements;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"elements", &StructureInitialization::elements}};
    }
};

/// `name := value` in a structure initialization (B.1.3.3).
struct StructureElementInitialization : Node {
    static constexpr NodeKind node_kind = NodeKind::structure_element_initialization;
    StructureElementInitialization() noexcept : Node(node_kind) {}
    Child<Identifier> name;
    Child<Expression> value;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &StructureElementInitialization::name},
                          MemberDescription{"value", &StructureElementInitialization::value}};
    }
};

} // namespace iecfront::ast
