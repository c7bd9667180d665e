#pragma once

#include <iecfront/ast/node.hpp>
#include <iecfront/ast/types.hpp>
#include <iecfront/ast/variables.hpp>
#include <iecfront/export.hpp>

#include <cstdint>
#include <string_view>
#include <tuple>

/// Structured Text (B.3).
namespace iecfront::ast {

struct ElsifClause;
struct CaseElement;

/// The binary operators of Table 55, weakest last.
enum class BinaryOperator : std::uint8_t {
    power,
    multiply,
    divide,
    modulo,
    add,
    subtract,
    less,
    greater,
    less_equal,
    greater_equal,
    equal,
    not_equal,
    logical_and, ///< `&` or `AND`; the token says which
    exclusive_or,
    logical_or,
};

/// The operator as the standard spells it: `**`, `AND`, `<=`.
[[nodiscard]] IECFRONT_API std::string_view to_string(BinaryOperator op) noexcept;

/// The unary operators of Table 55. `plus` is an extension.
enum class UnaryOperator : std::uint8_t { minus, logical_not, plus };

/// `-`, `NOT` or `+`.
[[nodiscard]] IECFRONT_API std::string_view to_string(UnaryOperator op) noexcept;

/// `left operator right`, associating to the left (B.3.1). The operator is the token before
/// `right`.
struct BinaryExpression : Expression {
    static constexpr NodeKind node_kind = NodeKind::binary_expression;
    BinaryExpression() noexcept : Expression(node_kind) {}
    BinaryOperator op = BinaryOperator::power;
    Child<Expression> left;
    Child<Expression> right;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"op", &BinaryExpression::op},
                          MemberDescription{"left", &BinaryExpression::left},
                          MemberDescription{"right", &BinaryExpression::right}};
    }
};

/// `-x`, `NOT x` (B.3.1). A sign directly before a number belongs to the constant instead.
struct UnaryExpression : Expression {
    static constexpr NodeKind node_kind = NodeKind::unary_expression;
    UnaryExpression() noexcept : Expression(node_kind) {}
    UnaryOperator op = UnaryOperator::minus;
    Child<Expression> operand;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"op", &UnaryExpression::op},
                          MemberDescription{"operand", &UnaryExpression::operand}};
    }
};

/// `(expression)` (B.3.1).
struct ParenthesizedExpression : Expression {
    static constexpr NodeKind node_kind = NodeKind::parenthesized_expression;
    ParenthesizedExpression() noexcept : Expression(node_kind) {}
    Child<Expression> expression;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"expression", &ParenthesizedExpression::expression}};
    }
};

/// `function(arguments)` as an operand (B.3.1).
struct FunctionCall : Expression {
    static constexpr NodeKind node_kind = NodeKind::function_call;
    FunctionCall() noexcept : Expression(node_kind) {}
    Child<Expression> function; ///< `VariableName`; anything else is an extension
    List<Node> arguments;       ///< `InputArgument` or `OutputArgument`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"function", &FunctionCall::function},
                          MemberDescription{"arguments", &FunctionCall::arguments}};
    }
};

/// `name := expression`, or the expression alone (B.3.2.2). `value` is an `Expression`; in IL it
/// may be an `InstructionList`.
struct InputArgument : Node {
    static constexpr NodeKind node_kind = NodeKind::input_argument;
    InputArgument() noexcept : Node(node_kind) {}
    Child<Identifier> name; ///< null in a non-formal list
    Child<Node> value;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &InputArgument::name},
                          MemberDescription{"value", &InputArgument::value}};
    }
};

/// `name => variable`, `NOT name => variable` (B.3.2.2).
struct OutputArgument : Node {
    static constexpr NodeKind node_kind = NodeKind::output_argument;
    OutputArgument() noexcept : Node(node_kind) {}
    bool negated = false;
    Child<Identifier> name;
    Child<Expression> variable;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"negated", &OutputArgument::negated},
                          MemberDescription{"name", &OutputArgument::name},
                          MemberDescription{"variable", &OutputArgument::variable}};
    }
};

/// `Type#Value`, or `Value` where only a constant can stand (B.1.3.3). Its two names:
/// `split_enumerated_value` of its text.
struct EnumeratedValue : Expression {
    static constexpr NodeKind node_kind = NodeKind::enumerated_value;
    EnumeratedValue() noexcept : Expression(node_kind) {}
    std::uint32_t hash = 0; ///< of the case-folded value without its type, see `hash_name`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"hash", &EnumeratedValue::hash}};
    }
};

/// Stands where an expression is missing or cannot be read.
struct ErrorExpression : Expression {
    static constexpr NodeKind node_kind = NodeKind::error_expression;
    ErrorExpression() noexcept : Expression(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// Statements with their `;` (B.3.2).
struct StatementList : Body {
    static constexpr NodeKind node_kind = NodeKind::statement_list;
    StatementList() noexcept : Body(node_kind) {}
    List<Statement> statements;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"statements", &StatementList::statements}};
    }
};

/// Nothing before a `;` (B.3.2); it has no token.
struct EmptyStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::empty_statement;
    EmptyStatement() noexcept : Statement(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// `variable := expression` (B.3.2.1).
struct AssignmentStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::assignment_statement;
    AssignmentStatement() noexcept : Statement(node_kind) {}
    Child<Expression> variable;
    Child<Expression> expression;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"variable", &AssignmentStatement::variable},
                          MemberDescription{"expression", &AssignmentStatement::expression}};
    }
};

/// `instance(arguments)` (B.3.2.2).
struct FbInvocation : Statement {
    static constexpr NodeKind node_kind = NodeKind::fb_invocation;
    FbInvocation() noexcept : Statement(node_kind) {}
    Child<Expression> fb_name; ///< `VariableName`; anything else is an extension
    List<Node> arguments;      ///< `InputArgument` or `OutputArgument`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"fb_name", &FbInvocation::fb_name},
                          MemberDescription{"arguments", &FbInvocation::arguments}};
    }
};

/// `RETURN` (B.3.2.2).
struct ReturnStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::return_statement;
    ReturnStatement() noexcept : Statement(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// `IF ... THEN ... ELSIF ... ELSE ... END_IF` (B.3.2.3).
struct IfStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::if_statement;
    IfStatement() noexcept : Statement(node_kind) {}
    Child<Expression> condition;
    Child<StatementList> then_list;
    List<ElsifClause> elsif_clauses;
    Child<StatementList> else_list; ///< null when there is no ELSE

    static constexpr auto members() {
        return std::tuple{MemberDescription{"condition", &IfStatement::condition},
                          MemberDescription{"then_list", &IfStatement::then_list},
                          MemberDescription{"elsif_clauses", &IfStatement::elsif_clauses},
                          MemberDescription{"else_list", &IfStatement::else_list}};
    }
};

/// `ELSIF condition THEN statements` (B.3.2.3).
struct ElsifClause : Node {
    static constexpr NodeKind node_kind = NodeKind::elsif_clause;
    ElsifClause() noexcept : Node(node_kind) {}
    Child<Expression> condition;
    Child<StatementList> statements;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"condition", &ElsifClause::condition},
                          MemberDescription{"statements", &ElsifClause::statements}};
    }
};

/// `CASE selector OF ... ELSE ... END_CASE` (B.3.2.3).
struct CaseStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::case_statement;
    CaseStatement() noexcept : Statement(node_kind) {}
    Child<Expression> selector;
    List<CaseElement> elements;
    Child<StatementList> else_list; ///< null when there is no ELSE

    static constexpr auto members() {
        return std::tuple{MemberDescription{"selector", &CaseStatement::selector},
                          MemberDescription{"elements", &CaseStatement::elements},
                          MemberDescription{"else_list", &CaseStatement::else_list}};
    }
};

/// `1, 3..5, Idle: statements` (B.3.2.3).
struct CaseElement : Node {
    static constexpr NodeKind node_kind = NodeKind::case_element;
    CaseElement() noexcept : Node(node_kind) {}
    List<Node> labels; ///< `Subrange`, or an `Expression`: `IntegerLiteral`, `EnumeratedValue`
    Child<StatementList> statements;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"labels", &CaseElement::labels},
                          MemberDescription{"statements", &CaseElement::statements}};
    }
};

/// `FOR variable := from TO to BY by DO statements END_FOR` (B.3.2.4).
struct ForStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::for_statement;
    ForStatement() noexcept : Statement(node_kind) {}
    Child<Expression> control_variable; ///< `VariableName`; anything else is an extension
    Child<Expression> from;
    Child<Expression> to;
    Child<Expression> by; ///< null when not given: 1
    Child<StatementList> statements;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"control_variable", &ForStatement::control_variable},
                          MemberDescription{"from", &ForStatement::from},
                          MemberDescription{"to", &ForStatement::to},
                          MemberDescription{"by", &ForStatement::by},
                          MemberDescription{"statements", &ForStatement::statements}};
    }
};

/// `WHILE condition DO statements END_WHILE` (B.3.2.4).
struct WhileStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::while_statement;
    WhileStatement() noexcept : Statement(node_kind) {}
    Child<Expression> condition;
    Child<StatementList> statements;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"condition", &WhileStatement::condition},
                          MemberDescription{"statements", &WhileStatement::statements}};
    }
};

/// `REPEAT statements UNTIL condition END_REPEAT` (B.3.2.4).
struct RepeatStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::repeat_statement;
    RepeatStatement() noexcept : Statement(node_kind) {}
    Child<StatementList> statements;
    Child<Expression> condition;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"statements", &RepeatStatement::statements},
                          MemberDescription{"condition", &RepeatStatement::condition}};
    }
};

/// `EXIT` (B.3.2.4).
struct ExitStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::exit_statement;
    ExitStatement() noexcept : Statement(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// `CONTINUE` of the third edition: an extension.
struct ContinueStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::continue_statement;
    ContinueStatement() noexcept : Statement(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// An expression with nothing done to it, `x;`: an extension.
struct ExpressionStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::expression_statement;
    ExpressionStatement() noexcept : Statement(node_kind) {}
    Child<Expression> expression;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"expression", &ExpressionStatement::expression}};
    }
};

/// Stands for a statement that cannot be read.
struct ErrorStatement : Statement {
    static constexpr NodeKind node_kind = NodeKind::error_statement;
    ErrorStatement() noexcept : Statement(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

} // namespace iecfront::ast
