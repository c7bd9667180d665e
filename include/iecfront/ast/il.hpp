#pragma once

#include <iecfront/ast/node.hpp>
#include <iecfront/export.hpp>

#include <cstdint>
#include <string_view>
#include <tuple>

/// Instruction List (B.2).
namespace iecfront::ast {

struct IlInstruction;

/// The operators of Table 52 and the input operators of Table 54, without their modifiers.
enum class IlOperator : std::uint8_t {
    none, ///< the name of a function stands in the operator field
    load,
    store,
    set,
    reset,
    logical_and, ///< `AND` or `&`; the token says which
    logical_or,
    exclusive_or,
    logical_not,
    add,
    subtract,
    multiply,
    divide,
    modulo,
    greater,
    greater_equal,
    equal,
    not_equal,
    less_equal,
    less,
    jump,
    call,
    return_,
    s1,
    r1,
    clk,
    cu,
    cd,
    pv,
    in,
    pt,
};

/// The operator as the standard spells it: `LD`, `AND`, `CLK`; `none` for none.
[[nodiscard]] IECFRONT_API std::string_view to_string(IlOperator op) noexcept;

/// What is joined to an operator (Table 52). Of the modifier `(` the kind of node tells.
enum class IlModifier : std::uint8_t {
    none,
    negated,             ///< `N`: of the operand, or of the value that is stored
    conditional,         ///< `C`: when the current result is TRUE
    conditional_negated, ///< `CN`: when the current result is FALSE
};

/// `N`, `C` or `CN`; `none` for none.
[[nodiscard]] IECFRONT_API std::string_view to_string(IlModifier modifier) noexcept;

/// The lines of an IL body, or of what stands in parentheses (B.2.1).
struct InstructionList : Body {
    static constexpr NodeKind node_kind = NodeKind::instruction_list;
    InstructionList() noexcept : Body(node_kind) {}
    List<IlInstruction> instructions;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"instructions", &InstructionList::instructions}};
    }
};

/// One line: `label: operation` (B.2.1).
struct IlInstruction : Node {
    static constexpr NodeKind node_kind = NodeKind::il_instruction;
    IlInstruction() noexcept : Node(node_kind) {}
    Child<Identifier> label;      ///< null when not given
    Child<IlOperation> operation; ///< null for a label alone

    static constexpr auto members() {
        return std::tuple{MemberDescription{"label", &IlInstruction::label},
                          MemberDescription{"operation", &IlInstruction::operation}};
    }
};

/// `LD x`, `ADD 1`, `NOT`; or a function with operands, `LIMIT a, b` (B.2.1). AND, ADD and the like
/// with several operands are functions.
struct IlSimpleOperation : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_simple_operation;
    IlSimpleOperation() noexcept : IlOperation(node_kind) {}
    IlOperator op = IlOperator::none; ///< none for a function
    IlModifier modifier = IlModifier::none;
    Child<Identifier> function_name; ///< null for an operator
    List<Expression> operands;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"op", &IlSimpleOperation::op},
                          MemberDescription{"modifier", &IlSimpleOperation::modifier},
                          MemberDescription{"function_name", &IlSimpleOperation::function_name},
                          MemberDescription{"operands", &IlSimpleOperation::operands}};
    }
};

/// `ADD( x` ... `)` (B.2.1): the operation waits for the result of the instructions.
struct IlExpression : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_expression;
    IlExpression() noexcept : IlOperation(node_kind) {}
    IlOperator op = IlOperator::none;
    IlModifier modifier = IlModifier::none;
    Child<Expression> operand;           ///< null when not given
    Child<InstructionList> instructions; ///< empty when there are none

    static constexpr auto members() {
        return std::tuple{MemberDescription{"op", &IlExpression::op},
                          MemberDescription{"modifier", &IlExpression::modifier},
                          MemberDescription{"operand", &IlExpression::operand},
                          MemberDescription{"instructions", &IlExpression::instructions}};
    }
};

/// `JMP label`, `JMPC label`, `JMPCN label` (B.2.1).
struct IlJumpOperation : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_jump_operation;
    IlJumpOperation() noexcept : IlOperation(node_kind) {}
    IlModifier modifier = IlModifier::none;
    Child<Identifier> label;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"modifier", &IlJumpOperation::modifier},
                          MemberDescription{"label", &IlJumpOperation::label}};
    }
};

/// `CAL instance(...)`, `CALC instance(...)`, `CALCN instance(...)` (B.2.1).
struct IlFbCall : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_fb_call;
    IlFbCall() noexcept : IlOperation(node_kind) {}
    IlModifier modifier = IlModifier::none;
    Child<Expression> fb_name; ///< `VariableName`; anything else is an extension
    List<Node> arguments;      ///< `InputArgument` or `OutputArgument`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"modifier", &IlFbCall::modifier},
                          MemberDescription{"fb_name", &IlFbCall::fb_name},
                          MemberDescription{"arguments", &IlFbCall::arguments}};
    }
};

/// `LIMIT(` and formal arguments on lines of their own `)` (B.2.1).
struct IlFormalFunctCall : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_formal_funct_call;
    IlFormalFunctCall() noexcept : IlOperation(node_kind) {}
    Child<Identifier> function_name;
    List<Node> arguments; ///< `InputArgument` or `OutputArgument`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"function_name", &IlFormalFunctCall::function_name},
                          MemberDescription{"arguments", &IlFormalFunctCall::arguments}};
    }
};

/// `RET`, `RETC`, `RETCN` (B.2.1).
struct IlReturnOperation : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_return_operation;
    IlReturnOperation() noexcept : IlOperation(node_kind) {}
    IlModifier modifier = IlModifier::none;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"modifier", &IlReturnOperation::modifier}};
    }
};

/// Stands for an operation that cannot be read.
struct IlErrorOperation : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_error_operation;
    IlErrorOperation() noexcept : IlOperation(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

} // namespace iecfront::ast
