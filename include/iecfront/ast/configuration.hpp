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
    Child<Identifier> name;
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
    Child<Identifier> name;
    Child<Identifier> type;
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
    Child<Identifier> name;
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
    Child<Identifier> name; ///< SINGLE, INTERVAL or PRIORITY
    Child<Expression> value;

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
    Child<Identifier> name;
    Child<Identifier> task; ///< null when not given
    Child<Identifier> type;
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
    Child<Expression> fb_name;
    Child<Identifier> task;

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
    Child<Expression> variable;
    Child<Expression> operand; ///< the source, or the sink

    static constexpr auto members() {
        return std::tuple{MemberDescription{"output", &ProgCnxn::output},
                          MemberDescription{"variable", &ProgCnxn::variable},
                          MemberDescription{"operand", &ProgCnxn::operand}};
    }
};

} // namespace iecfront::ast
