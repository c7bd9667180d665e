#include "builder/assembly.hpp"

#include <iecfront/builder/pous.hpp>

namespace iecfront::build {
namespace {

using Declarations = std::vector<Part<ast::VariableDeclarations>>;

// Behind the head: blocks of variables, and the body.
[[nodiscard]] Assembly& contents(Assembly& assembly, const Declarations& declarations,
                                 const Body& body) {
    return assembly.lines(declarations).indented(body);
}

} // namespace

Part<ast::FunctionDeclaration> function_declaration(std::string_view name,
                                                    const TypeSpecification& result_type,
                                                    const Declarations& declarations,
                                                    const Body& body) {
    Assembly assembly;
    assembly.text("FUNCTION ").name(name).text(" : ").part(result_type);
    return std::move(contents(assembly, declarations, body).text("\nEND_FUNCTION"))
        .finish<ast::FunctionDeclaration>();
}

Part<ast::FunctionBlockDeclaration> function_block_declaration(std::string_view name,
                                                               const Declarations& declarations,
                                                               const Body& body) {
    Assembly assembly;
    assembly.text("FUNCTION_BLOCK ").name(name);
    return std::move(contents(assembly, declarations, body).text("\nEND_FUNCTION_BLOCK"))
        .finish<ast::FunctionBlockDeclaration>();
}

Part<ast::ProgramDeclaration>
program_declaration(std::string_view name, const Declarations& declarations, const Body& body) {
    Assembly assembly;
    assembly.text("PROGRAM ").name(name);
    return std::move(contents(assembly, declarations, body).text("\nEND_PROGRAM"))
        .finish<ast::ProgramDeclaration>();
}

} // namespace iecfront::build
