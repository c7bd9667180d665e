#pragma once

#include <iecfront/ast/node.hpp>
#include <iecfront/ast/variables.hpp>

#include <cstdint>
#include <string_view>
#include <tuple>

/// Configurations, resources and tasks (B.1.7).
namespace iecfront::ast {

struct TaskInitialization;

/// `CONFIGURATION name ... END_CONFIGURATION` (B.1.7).
struct ConfigurationDeclaration : LibraryElement {
    static constexpr NodeKind node_kind = NodeKind::configuration_declaration;
    ConfigurationDeclaration() noexcept : LibraryElement(node_kind) {}
    const Identifier* name = nullptr;
    /// `VariableDeclarations`, `ResourceDeclaration`, or the `TaskConfiguration` and
    /// `ProgramConfiguration` of a single resource; `SkippedText`
    List<Node> elements;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &ConfigurationDeclaration::name},
                          MemberDescription{"elements", &ConfigurationDeclaration::elements}};
    }
};

/// `RESOURCE name ON type ... END_RESOURCE` (B.1.7).
struct ResourceDeclaration : Node {
    static constexpr NodeKind node_kind = NodeKind::resource_declaration;
    ResourceDeclaration() noexcept : Node(node_kind) {}
    const Identifier* name = nullptr;
    const Identifier* type = nullptr;
    /// `VariableDeclarations`, `TaskConfiguration`, `ProgramConfiguration`, `SkippedText`
    List<Node> elements;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &ResourceDeclaration::name},
                          MemberDescription{"type", &ResourceDeclaration::type},
                          MemberDescription{"elements", &ResourceDeclaration::elements}};
    }
};

/// `TASK name (...)` (B.1.7).
struct TaskConfiguration : Node {
    static constexpr NodeKind node_kind = NodeKind::task_configuration;
    TaskConfiguration() noexcept : Node(node_kind) {}
    const Identifier* name = nullptr;
    List<TaskInitialization> initializations;

    static constexpr auto members() {
        return std::tuple{
            MemberDescription{"name", &TaskConfiguration::name},
            MemberDescription{"initializations", &TaskConfiguration::initializations}};
    }
};

/// `SINGLE := source`, `INTERVAL := source` or `PRIORITY := number` (B.1.7).
struct TaskInitialization : Node {
    static constexpr NodeKind node_kind = NodeKind::task_initialization;
    TaskInitialization() noexcept : Node(node_kind) {}
    const Identifier* name = nullptr; ///< SINGLE, INTERVAL or PRIORITY
    const Expression* value = nullptr;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &TaskInitialization::name},
                          MemberDescription{"value", &TaskInitialization::value}};
    }
};

/// `PROGRAM name WITH task : type (...)` (B.1.7).
struct ProgramConfiguration : Node {
    static constexpr NodeKind node_kind = NodeKind::program_configuration;
    ProgramConfiguration() noexcept : Node(node_kind) {}
    BlockQualifier qualifier = BlockQualifier::none; ///< RETAIN or NON_RETAIN
    const Identifier* name = nullptr;
    const Identifier* task = nullptr; ///< null when not given
    const Identifier* type = nullptr;
    List<Node> elements; ///< `FbTask` or `ProgCnxn`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"qualifier", &ProgramConfiguration::qualifier},
                          MemberDescription{"name", &ProgramConfiguration::name},
                          MemberDescription{"task", &ProgramConfiguration::task},
                          MemberDescription{"type", &ProgramConfiguration::type},
                          MemberDescription{"elements", &ProgramConfiguration::elements}};
    }
};

/// `instance WITH task` in a program configuration (B.1.7).
struct FbTask : Node {
    static constexpr NodeKind node_kind = NodeKind::fb_task;
    FbTask() noexcept : Node(node_kind) {}
    const Expression* fb_name = nullptr;
    const Identifier* task = nullptr;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"fb_name", &FbTask::fb_name},
                          MemberDescription{"task", &FbTask::task}};
    }
};

/// `variable := source` or `variable => sink` in a program configuration (B.1.7).
struct ProgCnxn : Node {
    static constexpr NodeKind node_kind = NodeKind::prog_cnxn;
    ProgCnxn() noexcept : Node(node_kind) {}
    bool output = false; ///< `=>`
    const Expression* variable = nullptr;
    const Expression* operand = nullptr; ///< the source, or the sink

    static constexpr auto members() {
        return std::tuple{MemberDescription{"output", &ProgCnxn::output},
                          MemberDescription{"variable", &ProgCnxn::variable},
                          MemberDescription{"operand", &ProgCnxn::operand}};
    }
};

} // namespace iecfront::ast
