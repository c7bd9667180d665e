#pragma once

#include <iecfront/builder/part.hpp>

#include <string_view>
#include <vector>

/// Configurations, resources and tasks (B.1.7).
namespace iecfront::build {

/// `SINGLE := source`, `INTERVAL := source` or `PRIORITY := number`.
[[nodiscard]] IECFRONT_API Part<ast::TaskInitialization>
task_initialization(std::string_view name, const Expression& value);

/// `TASK name (...)`; at least one initialization.
[[nodiscard]] IECFRONT_API Part<ast::TaskConfiguration>
task_configuration(std::string_view name,
                   const std::vector<Part<ast::TaskInitialization>>& initializations);

/// `instance WITH task` in a program configuration.
[[nodiscard]] IECFRONT_API Part<ast::FbTask> fb_task(const Expression& fb_name,
                                                     std::string_view task);

/// `variable := operand`, or `variable => operand` for an `output`, in a program configuration.
[[nodiscard]] IECFRONT_API Part<ast::ProgCnxn>
prog_cnxn(const Expression& variable, const Expression& operand, bool output = false);

/// `PROGRAM name WITH task : type (elements)`; without a `task`, and without parentheses when there
/// are no elements. `qualifier` is RETAIN, NON_RETAIN or none.
[[nodiscard]] IECFRONT_API Part<ast::ProgramConfiguration>
program_configuration(std::string_view name, std::string_view task, std::string_view type,
                      const std::vector<ProgConfElement>& elements = {},
                      ast::BlockQualifier qualifier = ast::BlockQualifier::none);

/// `RESOURCE name ON type ... END_RESOURCE`; at least one element.
[[nodiscard]] IECFRONT_API Part<ast::ResourceDeclaration>
resource_declaration(std::string_view name, std::string_view type,
                     const std::vector<ConfigurationElement>& elements);

/// `CONFIGURATION name ... END_CONFIGURATION`; at least one element.
[[nodiscard]] IECFRONT_API Part<ast::ConfigurationDeclaration>
configuration_declaration(std::string_view name, const std::vector<ConfigurationElement>& elements);

} // namespace iecfront::build
