#pragma once

#include <iecfront/builder/part.hpp>

#include <string_view>
#include <vector>

/// Program organization units (B.1.5).
namespace iecfront::build {

/// `FUNCTION name : result_type ... END_FUNCTION`.
[[nodiscard]] IECFRONT_API Part<ast::FunctionDeclaration>
function_declaration(std::string_view name, const TypeSpecification& result_type,
                     const std::vector<Part<ast::VariableDeclarations>>& declarations,
                     const Body& body);

/// `FUNCTION_BLOCK name ... END_FUNCTION_BLOCK`.
[[nodiscard]] IECFRONT_API Part<ast::FunctionBlockDeclaration>
function_block_declaration(std::string_view name,
                           const std::vector<Part<ast::VariableDeclarations>>& declarations,
                           const Body& body);

/// `PROGRAM name ... END_PROGRAM`.
[[nodiscard]] IECFRONT_API Part<ast::ProgramDeclaration>
program_declaration(std::string_view name,
                    const std::vector<Part<ast::VariableDeclarations>>& declarations,
                    const Body& body);

} // namespace iecfront::build
