#pragma once

#include <iecfront/builder/part.hpp>

#include <optional>
#include <string_view>
#include <vector>

/// Instruction List (B.2).
namespace iecfront::build {

/// What stands in the operator field, with its operands.
using IlOperation = Part<ast::IlOperation>;

/// `LD x`, `ADD 1`, `NOT`; operators of Table 52 that jump, call or return have functions of their
/// own.
[[nodiscard]] IECFRONT_API Part<ast::IlSimpleOperation>
il_simple_operation(ast::IlOperator op, const std::vector<Expression>& operands = {},
                    ast::IlModifier modifier = ast::IlModifier::none);

/// `LIMIT a, b`: a function that is called with the current result as its first input. With several
/// operands, AND, ADD and the like are functions as well.
[[nodiscard]] IECFRONT_API Part<ast::IlSimpleOperation>
il_simple_operation(std::string_view function_name, const std::vector<Expression>& operands = {});

/// `ADD( operand` and the instructions up to `)`.
[[nodiscard]] IECFRONT_API Part<ast::IlExpression>
il_expression(ast::IlOperator op, const std::optional<Expression>& operand,
              const Part<ast::InstructionList>& instructions,
              ast::IlModifier modifier = ast::IlModifier::none);

/// `JMP label`, `JMPC label`, `JMPCN label`.
[[nodiscard]] IECFRONT_API Part<ast::IlJumpOperation>
il_jump_operation(std::string_view label, ast::IlModifier modifier = ast::IlModifier::none);

/// `CAL instance(...)`, `CALC instance(...)`, `CALCN instance(...)`.
[[nodiscard]] IECFRONT_API Part<ast::IlFbCall>
il_fb_call(std::string_view fb_name, const std::vector<Argument>& arguments,
           ast::IlModifier modifier = ast::IlModifier::none);

/// `LIMIT(` and arguments with names, each on a line of its own.
[[nodiscard]] IECFRONT_API Part<ast::IlFormalFunctCall>
il_formal_funct_call(std::string_view function_name, const std::vector<Argument>& arguments);

/// `RET`, `RETC`, `RETCN`.
[[nodiscard]] IECFRONT_API Part<ast::IlReturnOperation>
il_return_operation(ast::IlModifier modifier = ast::IlModifier::none);

/// A line with an operation.
[[nodiscard]] IECFRONT_API Part<ast::IlInstruction> il_instruction(const IlOperation& operation);
/// `label: operation`, or the label alone.
[[nodiscard]] IECFRONT_API Part<ast::IlInstruction>
il_instruction(std::string_view label, const std::optional<IlOperation>& operation);

/// Lines one below the other.
[[nodiscard]] IECFRONT_API Part<ast::InstructionList>
instruction_list(const std::vector<Part<ast::IlInstruction>>& instructions);

} // namespace iecfront::build
