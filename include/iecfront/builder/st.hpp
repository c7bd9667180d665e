#pragma once

#include <iecfront/builder/part.hpp>

#include <optional>
#include <string_view>
#include <vector>

/// Structured Text (B.3).
namespace iecfront::build {

// ---- expressions (B.3.1) -----------------------------------------------------------------------

/// `left operator right`. Operands that bind less tightly come into parentheses.
[[nodiscard]] IECFRONT_API Part<ast::BinaryExpression>
binary_expression(ast::BinaryOperator op, const Expression& left, const Expression& right);

/// `-x`, `NOT x`; an operand that is an operation comes into parentheses. A number with a sign is
/// an `integer_literal` or `real_literal`. `plus` is no operator of the standard.
[[nodiscard]] IECFRONT_API Part<ast::UnaryExpression> unary_expression(ast::UnaryOperator op,
                                                                       const Expression& operand);

/// `(expression)`, where no operator needs the parentheses.
[[nodiscard]] IECFRONT_API Part<ast::ParenthesizedExpression>
parenthesized_expression(const Expression& expression);

/// `Type#Value`; without a `type` the value alone, as CASE labels and initial values have it.
[[nodiscard]] IECFRONT_API Part<ast::EnumeratedValue> enumerated_value(std::string_view value,
                                                                       std::string_view type = {});

/// `function(arguments)`; at least one argument. AND, OR, XOR and MOD are functions as well.
[[nodiscard]] IECFRONT_API Part<ast::FunctionCall>
function_call(std::string_view function, const std::vector<Argument>& arguments);

/// `name := value`. A condition that is an instruction list is for calls in Instruction List.
[[nodiscard]] IECFRONT_API Part<ast::InputArgument> input_argument(std::string_view name,
                                                                   const Condition& value);

/// `name => variable`, `NOT name => variable`.
[[nodiscard]] IECFRONT_API Part<ast::OutputArgument>
output_argument(std::string_view name, const Expression& variable, bool negated = false);

// ---- statements (B.3.2) ------------------------------------------------------------------------

/// Statements, each with its `;`. Without any it is a `;`, an empty statement.
[[nodiscard]] IECFRONT_API Part<ast::StatementList>
statement_list(const std::vector<Statement>& statements);

/// Nothing.
[[nodiscard]] IECFRONT_API Part<ast::EmptyStatement> empty_statement();

/// `variable := expression`.
[[nodiscard]] IECFRONT_API Part<ast::AssignmentStatement>
assignment_statement(const Expression& variable, const Expression& expression);

/// `instance(arguments)`; there may be none.
[[nodiscard]] IECFRONT_API Part<ast::FbInvocation>
fb_invocation(std::string_view fb_name, const std::vector<Argument>& arguments);

/// `RETURN`.
[[nodiscard]] IECFRONT_API Part<ast::ReturnStatement> return_statement();

/// `ELSIF condition THEN statements`.
[[nodiscard]] IECFRONT_API Part<ast::ElsifClause>
elsif_clause(const Expression& condition, const Part<ast::StatementList>& statements);

/// `IF condition THEN then_list ELSE else_list END_IF`.
[[nodiscard]] IECFRONT_API Part<ast::IfStatement>
if_statement(const Expression& condition, const Part<ast::StatementList>& then_list,
             const std::optional<Part<ast::StatementList>>& else_list = {});
/// The same with ELSIF.
[[nodiscard]] IECFRONT_API Part<ast::IfStatement>
if_statement(const Expression& condition, const Part<ast::StatementList>& then_list,
             const std::vector<Part<ast::ElsifClause>>& elsif_clauses,
             const std::optional<Part<ast::StatementList>>& else_list = {});

/// `1, 3..5, Idle: statements`; at least one label.
[[nodiscard]] IECFRONT_API Part<ast::CaseElement>
case_element(const std::vector<CaseLabel>& labels, const Part<ast::StatementList>& statements);

/// `CASE selector OF ... ELSE ... END_CASE`; at least one element.
[[nodiscard]] IECFRONT_API Part<ast::CaseStatement>
case_statement(const Expression& selector, const std::vector<Part<ast::CaseElement>>& elements,
               const std::optional<Part<ast::StatementList>>& else_list = {});

/// `FOR control_variable := from TO to DO statements END_FOR`.
[[nodiscard]] IECFRONT_API Part<ast::ForStatement>
for_statement(std::string_view control_variable, const Expression& from, const Expression& to,
              const Part<ast::StatementList>& statements);
/// The same with `BY by`.
[[nodiscard]] IECFRONT_API Part<ast::ForStatement>
for_statement(std::string_view control_variable, const Expression& from, const Expression& to,
              const Expression& by, const Part<ast::StatementList>& statements);

/// `WHILE condition DO statements END_WHILE`.
[[nodiscard]] IECFRONT_API Part<ast::WhileStatement>
while_statement(const Expression& condition, const Part<ast::StatementList>& statements);

/// `REPEAT statements UNTIL condition END_REPEAT`.
[[nodiscard]] IECFRONT_API Part<ast::RepeatStatement>
repeat_statement(const Part<ast::StatementList>& statements, const Expression& condition);

/// `EXIT`.
[[nodiscard]] IECFRONT_API Part<ast::ExitStatement> exit_statement();

} // namespace iecfront::build
