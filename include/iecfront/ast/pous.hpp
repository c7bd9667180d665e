#pragma once

#include <iecfront/ast/node.hpp>
#include <iecfront/ast/types.hpp>
#include <iecfront/ast/variables.hpp>

#include <tuple>

/// Program organization units (B.1.5).
namespace iecfront::ast {

/// `FUNCTION name : type ... END_FUNCTION` (B.1.5.1).
struct FunctionDeclaration : LibraryElement {
    static constexpr NodeKind node_kind = NodeKind::function_declaration;
    FunctionDeclaration() noexcept : LibraryElement(node_kind) {}
    Child<Identifier> name;
    Child<TypeSpecification> result_type;
    List<VariableDeclarations> declarations;
    Child<Body> body;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &FunctionDeclaration::name},
                          MemberDescription{"result_type", &FunctionDeclaration::result_type},
                          MemberDescription{"declarations", &FunctionDeclaration::declarations},
                          MemberDescription{"body", &FunctionDeclaration::body}};
    }
};

/// `FUNCTION_BLOCK name ... END_FUNCTION_BLOCK` (B.1.5.2).
struct FunctionBlockDeclaration : LibraryElement {
    static constexpr NodeKind node_kind = NodeKind::function_block_declaration;
    FunctionBlockDeclaration() noexcept : LibraryElement(node_kind) {}
    Child<Identifier> name;
    List<VariableDeclarations> declarations;
    Child<Body> body;

    static constexpr auto members() {
        return std::tuple{
            MemberDescription{"name", &FunctionBlockDeclaration::name},
            MemberDescription{"declarations", &FunctionBlockDeclaration::declarations},
            MemberDescription{"body", &FunctionBlockDeclaration::body}};
    }
};

/// `PROGRAM name ... END_PROGRAM` (B.1.5.3).
struct ProgramDeclaration : LibraryElement {
    static constexpr NodeKind node_kind = NodeKind::program_declaration;
    ProgramDeclaration() noexcept : LibraryElement(node_kind) {}
    Child<Identifier> name;
    List<VariableDeclarations> declarations;
    Child<Body> body;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &ProgramDeclaration::name},
                          MemberDescription{"declarations", &ProgramDeclaration::declarations},
                          MemberDescription{"body", &ProgramDeclaration::body}};
    }
};

} // namespace iecfront::ast
