#pragma once

#include <iecfront/ast/constants.hpp>
#include <iecfront/ast/node.hpp>
#include <iecfront/ast/types.hpp>
#include <iecfront/export.hpp>

#include <cstdint>
#include <string_view>
#include <tuple>

/// Variables and their declaration (B.1.4).
namespace iecfront::ast {

struct Location;

/// What kind of declaration block it is (Table 16 a).
enum class VariableBlock : std::uint8_t {
    var,
    var_input,
    var_output,
    var_in_out,
    var_temp,
    var_external,
    var_global,
    var_access,
    var_config,
};

/// `var_input` and so on.
[[nodiscard]] IECFRONT_API std::string_view to_string(VariableBlock block) noexcept;

/// What is said of a whole declaration block (Table 16 a).
enum class BlockQualifier : std::uint8_t { none, constant, retain, non_retain };

/// `none`, `constant`, `retain` or `non_retain`.
[[nodiscard]] IECFRONT_API std::string_view to_string(BlockQualifier qualifier) noexcept;

/// An edge input (2.5.2.2).
enum class Edge : std::uint8_t { none, rising, falling };

/// `none`, `rising` or `falling`.
[[nodiscard]] IECFRONT_API std::string_view to_string(Edge edge) noexcept;

/// Direction of an access path (B.1.7); `none` when not written.
enum class Direction : std::uint8_t { none, read_only, read_write };

/// `none`, `read_only` or `read_write`.
[[nodiscard]] IECFRONT_API std::string_view to_string(Direction direction) noexcept;

/// `VAR_INPUT ... END_VAR` and its like: a declaration block (B.1.4.3, B.1.7). As a library element
/// of its own, a block of global variables is an extension.
struct VariableDeclarations : LibraryElement {
    static constexpr NodeKind node_kind = NodeKind::variable_declarations;
    VariableDeclarations() noexcept : LibraryElement(node_kind) {}
    VariableBlock block = VariableBlock::var;
    BlockQualifier qualifier = BlockQualifier::none;
    /// `VariableDeclaration`, in VAR_ACCESS `AccessDeclaration`, in VAR_CONFIG
    /// `InstanceSpecificInit`; or `ErrorDeclaration`
    List<Node> declarations;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"block", &VariableDeclarations::block},
                          MemberDescription{"qualifier", &VariableDeclarations::qualifier},
                          MemberDescription{"declarations", &VariableDeclarations::declarations}};
    }
};

/// `a, b AT location : type := initial value` (B.1.4.3).
struct VariableDeclaration : Node {
    static constexpr NodeKind node_kind = NodeKind::variable_declaration;
    VariableDeclaration() noexcept : Node(node_kind) {}
    Edge edge = Edge::none;   ///< `BOOL R_EDGE`
    List<Identifier> names;   ///< none for `AT %IX1 : BOOL`
    Child<Location> location; ///< null when not given
    Child<TypeSpecification> specification;
    Child<Expression> initial_value; ///< null when not given

    static constexpr auto members() {
        return std::tuple{MemberDescription{"edge", &VariableDeclaration::edge},
                          MemberDescription{"names", &VariableDeclaration::names},
                          MemberDescription{"location", &VariableDeclaration::location},
                          MemberDescription{"specification", &VariableDeclaration::specification},
                          MemberDescription{"initial_value", &VariableDeclaration::initial_value}};
    }
};

/// `AT %QX1.0`, or `AT %I*` for a location that is not yet specified (B.1.4.3).
struct Location : Node {
    static constexpr NodeKind node_kind = NodeKind::location;
    Location() noexcept : Node(node_kind) {}
    Child<Expression> variable; ///< `DirectVariable` or `ErrorExpression`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"variable", &Location::variable}};
    }
};

/// `name : path : type READ_WRITE` in VAR_ACCESS (B.1.5.3, B.1.7).
struct AccessDeclaration : Node {
    static constexpr NodeKind node_kind = NodeKind::access_declaration;
    AccessDeclaration() noexcept : Node(node_kind) {}
    Direction direction = Direction::none;
    Child<Identifier> name;
    Child<Expression> path;
    Child<TypeSpecification> specification;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"direction", &AccessDeclaration::direction},
                          MemberDescription{"name", &AccessDeclaration::name},
                          MemberDescription{"path", &AccessDeclaration::path},
                          MemberDescription{"specification", &AccessDeclaration::specification}};
    }
};

/// `resource.program.instance.variable AT location : type := value` in VAR_CONFIG (B.1.7).
struct InstanceSpecificInit : Node {
    static constexpr NodeKind node_kind = NodeKind::instance_specific_init;
    InstanceSpecificInit() noexcept : Node(node_kind) {}
    List<Identifier> path;
    Child<Location> location; ///< null when not given
    Child<TypeSpecification> specification;
    Child<Expression> initial_value; ///< null when not given

    static constexpr auto members() {
        return std::tuple{MemberDescription{"path", &InstanceSpecificInit::path},
                          MemberDescription{"location", &InstanceSpecificInit::location},
                          MemberDescription{"specification", &InstanceSpecificInit::specification},
                          MemberDescription{"initial_value", &InstanceSpecificInit::initial_value}};
    }
};

/// Stands for a declaration that cannot be read.
struct ErrorDeclaration : Node {
    static constexpr NodeKind node_kind = NodeKind::error_declaration;
    ErrorDeclaration() noexcept : Node(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// `%IX1.0`; as the variable of a `Location` also `%I*` (B.1.4.1).
struct DirectVariable : Expression {
    static constexpr NodeKind node_kind = NodeKind::direct_variable;
    DirectVariable() noexcept : Expression(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// A name as an operand: a variable, an enumerated value without its type, or what is called or
/// selected from (B.1.4).
struct VariableName : Expression {
    static constexpr NodeKind node_kind = NodeKind::variable_name;
    VariableName() noexcept : Expression(node_kind) {}
    std::uint32_t hash = 0; ///< of the case-folded spelling, see `hash_name`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"hash", &VariableName::hash}};
    }
};

/// `variable[1, i + 1]` (B.1.4.2).
struct ArrayVariable : Expression {
    static constexpr NodeKind node_kind = NodeKind::array_variable;
    ArrayVariable() noexcept : Expression(node_kind) {}
    Child<Expression> subscripted_variable;
    List<Expression> subscripts;

    static constexpr auto members() {
        return std::tuple{
            MemberDescription{"subscripted_variable", &ArrayVariable::subscripted_variable},
            MemberDescription{"subscripts", &ArrayVariable::subscripts}};
    }
};

/// `%X3` behind the point of `x.%X3`, an extension: the bit (`X`), byte (`B`), word (`W`), double
/// word (`D`) or long word (`L`) with that number.
struct PartSelector : Node {
    static constexpr NodeKind node_kind = NodeKind::part_selector;
    PartSelector() noexcept : Node(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// `variable.field` (B.1.4.2). A bit (`x.3` or `x.%X3`, an extension) has an `IntegerLiteral` or a
/// `PartSelector` as its selector, and a place in an access path (`resource.%IX1.0`, B.1.7) a
/// `DirectVariable`.
struct StructuredVariable : Expression {
    static constexpr NodeKind node_kind = NodeKind::structured_variable;
    StructuredVariable() noexcept : Expression(node_kind) {}
    Child<Expression> record_variable;
    Child<Node> field_selector; ///< `Identifier`, or one of these

    static constexpr auto members() {
        return std::tuple{
            MemberDescription{"record_variable", &StructuredVariable::record_variable},
            MemberDescription{"field_selector", &StructuredVariable::field_selector}};
    }
};

/// `reference^`, what a reference refers to: of the third edition and other dialects.
struct DereferencedVariable : Expression {
    static constexpr NodeKind node_kind = NodeKind::dereferenced_variable;
    DereferencedVariable() noexcept : Expression(node_kind) {}
    Child<Expression> reference;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"reference", &DereferencedVariable::reference}};
    }
};

} // namespace iecfront::ast
