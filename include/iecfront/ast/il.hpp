#pragma once

#include <iecfront/ast/node.hpp>

#include <cstdint>
#include <string_view>
#include <tuple>

/// Instruction List (B.2).
namespace iecfront::ast {

struct IlInstruction;

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
    const Identifier* label = nullptr;      ///< null when not given
    const IlOperation* operation = nullptr; ///< null for a label alone

    static constexpr auto members() {
        return std::tuple{MemberDescription{"label", &IlInstruction::label},
                          MemberDescription{"operation", &IlInstruction::operation}};
    }
};

/// `LD x`, `ADD 1`, `NOT`; or a function with operands, `LIMIT a, b` (B.2.1). The first token is
/// the operator.
struct IlSimpleOperation : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_simple_operation;
    IlSimpleOperation() noexcept : IlOperation(node_kind) {}
    List<Expression> operands;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"operands", &IlSimpleOperation::operands}};
    }
};

/// `ADD( x` ... `)` (B.2.1). The first token is the operator.
struct IlExpression : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_expression;
    IlExpression() noexcept : IlOperation(node_kind) {}
    const Expression* operand = nullptr; ///< null when not given
    const InstructionList* instructions = nullptr;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"operand", &IlExpression::operand},
                          MemberDescription{"instructions", &IlExpression::instructions}};
    }
};

/// `JMP label`, `JMPC label`, `JMPCN label` (B.2.1). The first token is the operator.
struct IlJumpOperation : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_jump_operation;
    IlJumpOperation() noexcept : IlOperation(node_kind) {}
    const Identifier* label = nullptr;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"label", &IlJumpOperation::label}};
    }
};

/// `CAL instance(...)`, also CALC and CALCN (B.2.1). The first token is the operator.
struct IlFbCall : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_fb_call;
    IlFbCall() noexcept : IlOperation(node_kind) {}
    const Expression* fb_name = nullptr;
    List<Node> arguments; ///< `InputArgument` or `OutputArgument`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"fb_name", &IlFbCall::fb_name},
                          MemberDescription{"arguments", &IlFbCall::arguments}};
    }
};

/// `LIMIT(` and formal arguments on lines of their own `)` (B.2.1).
struct IlFormalFunctCall : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_formal_funct_call;
    IlFormalFunctCall() noexcept : IlOperation(node_kind) {}
    const Identifier* function_name = nullptr;
    List<Node> arguments; ///< `InputArgument` or `OutputArgument`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"function_name", &IlFormalFunctCall::function_name},
                          MemberDescription{"arguments", &IlFormalFunctCall::arguments}};
    }
};

/// `RET`, `RETC`, `RETCN` (B.2.1): the first token says which.
struct IlReturnOperation : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_return_operation;
    IlReturnOperation() noexcept : IlOperation(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// Stands for an operation that cannot be read.
struct IlErrorOperation : IlOperation {
    static constexpr NodeKind node_kind = NodeKind::il_error_operation;
    IlErrorOperation() noexcept : IlOperation(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

} // namespace iecfront::ast
