#include "builder/assembly.hpp"

#include <iecfront/builder/il.hpp>

namespace iecfront::build {
namespace {

[[nodiscard]] std::string_view letters_of(ast::IlModifier modifier) noexcept {
    return modifier == ast::IlModifier::none ? std::string_view() : to_string(modifier);
}

// ADD, GT and their like, which take an expression in parentheses (il_expr_operator).
[[nodiscard]] bool is_expr_operator(ast::IlOperator op) noexcept {
    return op >= ast::IlOperator::logical_and && op <= ast::IlOperator::less &&
           op != ast::IlOperator::logical_not;
}

// LD, ST, AND, OR and XOR can negate their operand (Table 52).
[[nodiscard]] bool can_be_negated(ast::IlOperator op) noexcept {
    return op == ast::IlOperator::load || op == ast::IlOperator::store ||
           (op >= ast::IlOperator::logical_and && op <= ast::IlOperator::exclusive_or);
}

[[nodiscard]] bool has_own_function(ast::IlOperator op) noexcept {
    return op == ast::IlOperator::none || op == ast::IlOperator::jump ||
           op == ast::IlOperator::call || op == ast::IlOperator::return_;
}

Assembly& operator_field(Assembly& assembly, ast::IlOperator op, ast::IlModifier modifier) {
    const bool fits = modifier == ast::IlModifier::none ||
                      (modifier == ast::IlModifier::negated && can_be_negated(op));
    return assembly.require(fits, "an operator does not have this modifier")
        .text(to_string(op))
        .text(letters_of(modifier));
}

// JMP, CAL and RET.
Assembly& conditional_field(Assembly& assembly, ast::IlOperator op, ast::IlModifier modifier) {
    return assembly
        .require(modifier != ast::IlModifier::negated, "an operator does not have this modifier")
        .text(to_string(op))
        .text(letters_of(modifier));
}

// Those with names have lines of their own.
Assembly& formal_arguments(Assembly& assembly, const std::vector<Argument>& arguments) {
    assembly.text("(");
    for (std::size_t i = 0; i < arguments.size(); ++i)
        assembly.indented(arguments[i], i + 1 < arguments.size() ? "," : "");
    return assembly.text("\n)");
}

[[nodiscard]] bool is_formal(const Argument& argument) noexcept {
    return argument.kind() == ast::NodeKind::input_argument ||
           argument.kind() == ast::NodeKind::output_argument;
}

} // namespace

Part<ast::IlSimpleOperation> il_simple_operation(ast::IlOperator op,
                                                 const std::vector<Expression>& operands,
                                                 ast::IlModifier modifier) {
    Assembly assembly;
    assembly.require(!has_own_function(op), "this is no simple operator");
    operator_field(assembly, op, modifier).text(operands.empty() ? "" : " ").list(operands);
    return std::move(assembly).finish<ast::IlSimpleOperation>();
}

Part<ast::IlSimpleOperation> il_simple_operation(std::string_view function_name,
                                                 const std::vector<Expression>& operands) {
    Assembly assembly;
    assembly.name(function_name, NameKind::function)
        .text(operands.empty() ? "" : " ")
        .list(operands);
    return std::move(assembly).finish<ast::IlSimpleOperation>();
}

// il_expression = il_expr_operator "(" [ il_operand ] EOL { EOL } [ simple_instr_list ] ")"
Part<ast::IlExpression> il_expression(ast::IlOperator op, const std::optional<Expression>& operand,
                                      const Part<ast::InstructionList>& instructions,
                                      ast::IlModifier modifier) {
    Assembly assembly;
    assembly.require(is_expr_operator(op), "this operator has no parentheses");
    operator_field(assembly, op, modifier).text("(").optional(" ", operand);
    if (!instructions.text().empty())
        assembly.indented(instructions);
    return std::move(assembly.text("\n)")).finish<ast::IlExpression>();
}

Part<ast::IlJumpOperation> il_jump_operation(std::string_view label, ast::IlModifier modifier) {
    Assembly assembly;
    conditional_field(assembly, ast::IlOperator::jump, modifier).text(" ").name(label);
    return std::move(assembly).finish<ast::IlJumpOperation>();
}

Part<ast::IlFbCall> il_fb_call(std::string_view fb_name, const std::vector<Argument>& arguments,
                               ast::IlModifier modifier) {
    Assembly assembly;
    conditional_field(assembly, ast::IlOperator::call, modifier).text(" ").name(fb_name);
    if (!arguments.empty() && is_formal(arguments.front()))
        formal_arguments(assembly, arguments);
    else if (!arguments.empty())
        assembly.text("(").list(arguments).text(")");
    return std::move(assembly).finish<ast::IlFbCall>();
}

Part<ast::IlFormalFunctCall> il_formal_funct_call(std::string_view function_name,
                                                  const std::vector<Argument>& arguments) {
    Assembly assembly;
    assembly.name(function_name, NameKind::function);
    return std::move(formal_arguments(assembly, arguments)).finish<ast::IlFormalFunctCall>();
}

Part<ast::IlReturnOperation> il_return_operation(ast::IlModifier modifier) {
    Assembly assembly;
    return std::move(conditional_field(assembly, ast::IlOperator::return_, modifier))
        .finish<ast::IlReturnOperation>();
}

Part<ast::IlInstruction> il_instruction(const IlOperation& operation) {
    return std::move(Assembly().part(operation)).finish<ast::IlInstruction>();
}

Part<ast::IlInstruction> il_instruction(std::string_view label,
                                        const std::optional<IlOperation>& operation) {
    return std::move(Assembly().name(label).text(":").optional(" ", operation))
        .finish<ast::IlInstruction>();
}

Part<ast::InstructionList>
instruction_list(const std::vector<Part<ast::IlInstruction>>& instructions) {
    return std::move(Assembly().list(instructions, "\n")).finish<ast::InstructionList>();
}

} // namespace iecfront::build
