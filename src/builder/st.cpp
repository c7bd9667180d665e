#include "builder/assembly.hpp"

#include <iecfront/builder/st.hpp>

namespace iecfront::build {
namespace {

using StatementList = Part<ast::StatementList>;

[[nodiscard]] Assembly& else_part(Assembly& assembly,
                                  const std::optional<StatementList>& else_list) {
    return else_list ? assembly.text("\nELSE").indented(*else_list) : assembly;
}

[[nodiscard]] Assembly for_head(std::string_view control_variable, const Expression& from,
                                const Expression& to) {
    Assembly assembly;
    assembly.text("FOR ").name(control_variable).text(" := ").part(from).text(" TO ").part(to);
    return assembly;
}

[[nodiscard]] Part<ast::ForStatement> for_body(Assembly head, const StatementList& statements) {
    return std::move(head.text(" DO").indented(statements).text("\nEND_FOR"))
        .finish<ast::ForStatement>();
}

} // namespace

// ---- expressions (B.3.1) -----------------------------------------------------------------------

Part<ast::BinaryExpression> binary_expression(ast::BinaryOperator op, const Expression& left,
                                              const Expression& right) {
    const std::uint8_t own = strength_of(op);
    Assembly assembly;
    assembly.operand(left, own).text(" ").text(to_string(op)).text(" ");
    return std::move(assembly.operand(right, static_cast<std::uint8_t>(own + 1)))
        .finish<ast::BinaryExpression>(own);
}

Part<ast::UnaryExpression> unary_expression(ast::UnaryOperator op, const Expression& operand) {
    Assembly assembly;
    assembly.require(op != ast::UnaryOperator::plus, "`+` is no unary operator");
    assembly.text(op == ast::UnaryOperator::minus ? "-" : "NOT ");
    return std::move(assembly.operand(operand, op)).finish<ast::UnaryExpression>(strength::unary);
}

Part<ast::ParenthesizedExpression> parenthesized_expression(const Expression& expression) {
    return std::move(Assembly().text("(").part(expression).text(")"))
        .finish<ast::ParenthesizedExpression>();
}

Part<ast::EnumeratedValue> enumerated_value(std::string_view value, std::string_view type) {
    return std::move(Assembly().enumerated_value(value, type)).finish<ast::EnumeratedValue>();
}

Part<ast::FunctionCall> function_call(std::string_view function,
                                      const std::vector<Argument>& arguments) {
    Assembly assembly;
    assembly.require(!arguments.empty(), "the call of a function has no argument")
        .name(function, NameKind::function)
        .text("(")
        .list(arguments)
        .text(")");
    return std::move(assembly).finish<ast::FunctionCall>();
}

Part<ast::InputArgument> input_argument(std::string_view name, const Condition& value) {
    Assembly assembly;
    assembly.name(name, NameKind::variable).text(" := ");
    if (value.kind() == ast::NodeKind::instruction_list)
        assembly.text("(").indented(value).text("\n)");
    else
        assembly.part(value);
    return std::move(assembly).finish<ast::InputArgument>();
}

Part<ast::OutputArgument> output_argument(std::string_view name, const Expression& variable,
                                          bool negated) {
    Assembly assembly;
    assembly.text(negated ? "NOT " : "").name(name, NameKind::variable);
    return std::move(assembly.text(" => ").part(variable)).finish<ast::OutputArgument>();
}

// ---- statements (B.3.2) ------------------------------------------------------------------------

// statement_list = statement ";" { statement ";" }
StatementList statement_list(const std::vector<Statement>& statements) {
    if (statements.empty())
        return statement_list({empty_statement()});
    return std::move(Assembly().list(statements, ";\n").text(";")).finish<ast::StatementList>();
}

Part<ast::EmptyStatement> empty_statement() {
    return Assembly().finish<ast::EmptyStatement>();
}

Part<ast::AssignmentStatement> assignment_statement(const Expression& variable,
                                                    const Expression& expression) {
    return std::move(Assembly().part(variable).text(" := ").part(expression))
        .finish<ast::AssignmentStatement>();
}

Part<ast::FbInvocation> fb_invocation(std::string_view fb_name,
                                      const std::vector<Argument>& arguments) {
    return std::move(Assembly().name(fb_name).text("(").list(arguments).text(")"))
        .finish<ast::FbInvocation>();
}

Part<ast::ReturnStatement> return_statement() {
    return std::move(Assembly().text("RETURN")).finish<ast::ReturnStatement>();
}

Part<ast::ElsifClause> elsif_clause(const Expression& condition, const StatementList& statements) {
    return std::move(Assembly().text("ELSIF ").part(condition).text(" THEN").indented(statements))
        .finish<ast::ElsifClause>();
}

Part<ast::IfStatement> if_statement(const Expression& condition, const StatementList& then_list,
                                    const std::optional<StatementList>& else_list) {
    return if_statement(condition, then_list, std::vector<Part<ast::ElsifClause>>(), else_list);
}

Part<ast::IfStatement> if_statement(const Expression& condition, const StatementList& then_list,
                                    const std::vector<Part<ast::ElsifClause>>& elsif_clauses,
                                    const std::optional<StatementList>& else_list) {
    Assembly assembly;
    assembly.text("IF ").part(condition).text(" THEN").indented(then_list);
    for (const Part<ast::ElsifClause>& clause : elsif_clauses)
        assembly.text("\n").part(clause);
    return std::move(else_part(assembly, else_list).text("\nEND_IF")).finish<ast::IfStatement>();
}

Part<ast::CaseElement> case_element(const std::vector<CaseLabel>& labels,
                                    const StatementList& statements) {
    Assembly assembly;
    assembly.require(!labels.empty(), "a CASE element has no label");
    return std::move(assembly.list(labels).text(":").indented(statements))
        .finish<ast::CaseElement>();
}

Part<ast::CaseStatement> case_statement(const Expression& selector,
                                        const std::vector<Part<ast::CaseElement>>& elements,
                                        const std::optional<StatementList>& else_list) {
    Assembly assembly;
    assembly.require(!elements.empty(), "a CASE statement has no element");
    assembly.text("CASE ").part(selector).text(" OF").lines(elements);
    return std::move(else_part(assembly, else_list).text("\nEND_CASE"))
        .finish<ast::CaseStatement>();
}

Part<ast::ForStatement> for_statement(std::string_view control_variable, const Expression& from,
                                      const Expression& to, const StatementList& statements) {
    return for_body(for_head(control_variable, from, to), statements);
}

Part<ast::ForStatement> for_statement(std::string_view control_variable, const Expression& from,
                                      const Expression& to, const Expression& by,
                                      const StatementList& statements) {
    return for_body(for_head(control_variable, from, to).text(" BY ").part(by), statements);
}

Part<ast::WhileStatement> while_statement(const Expression& condition,
                                          const StatementList& statements) {
    Assembly assembly;
    assembly.text("WHILE ").part(condition).text(" DO").indented(statements);
    return std::move(assembly.text("\nEND_WHILE")).finish<ast::WhileStatement>();
}

Part<ast::RepeatStatement> repeat_statement(const StatementList& statements,
                                            const Expression& condition) {
    Assembly assembly;
    assembly.text("REPEAT").indented(statements).text("\nUNTIL ").part(condition);
    return std::move(assembly.text("\nEND_REPEAT")).finish<ast::RepeatStatement>();
}

Part<ast::ExitStatement> exit_statement() {
    return std::move(Assembly().text("EXIT")).finish<ast::ExitStatement>();
}

} // namespace iecfront::build
