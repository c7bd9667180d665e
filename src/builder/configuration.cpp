#include "builder/assembly.hpp"

#include <iecfront/builder/configuration.hpp>
#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>

namespace iecfront::build {

Part<ast::TaskInitialization> task_initialization(std::string_view name, const Expression& value) {
    constexpr std::array<std::string_view, 3> inputs{"SINGLE", "INTERVAL", "PRIORITY"};
    const bool is_input = std::ranges::any_of(
        inputs, [name](std::string_view input) { return names_equal(input, name); });
    Assembly assembly;
    assembly.require(is_input, quoted(name) + " is none of SINGLE, INTERVAL and PRIORITY")
        .text(folded(name));
    return std::move(assembly.text(" := ").part(value)).finish<ast::TaskInitialization>();
}

// task_configuration = "TASK" task_name task_initialization
Part<ast::TaskConfiguration>
task_configuration(std::string_view name,
                   const std::vector<Part<ast::TaskInitialization>>& initializations) {
    Assembly assembly;
    assembly.require(!initializations.empty(), "a task has no initialization")
        .text("TASK ")
        .name(name)
        .text(" (")
        .list(initializations)
        .text(")");
    return std::move(assembly).finish<ast::TaskConfiguration>();
}

Part<ast::FbTask> fb_task(const Expression& fb_name, std::string_view task) {
    return std::move(Assembly().part(fb_name).text(" WITH ").name(task)).finish<ast::FbTask>();
}

Part<ast::ProgCnxn> prog_cnxn(const Expression& variable, const Expression& operand, bool output) {
    return std::move(Assembly().part(variable).text(output ? " => " : " := ").part(operand))
        .finish<ast::ProgCnxn>();
}

Part<ast::ProgramConfiguration> program_configuration(std::string_view name, std::string_view task,
                                                      std::string_view type,
                                                      const std::vector<ProgConfElement>& elements,
                                                      ast::BlockQualifier qualifier) {
    Assembly assembly;
    assembly.require(qualifier != ast::BlockQualifier::constant, "a program is not CONSTANT")
        .text("PROGRAM")
        .text(keyword_of(qualifier))
        .text(" ")
        .name(name);
    if (!task.empty())
        assembly.text(" WITH ").name(task);
    assembly.text(" : ").name(type);
    if (!elements.empty())
        assembly.text(" (").list(elements).text(")");
    return std::move(assembly).finish<ast::ProgramConfiguration>();
}

Part<ast::ResourceDeclaration>
resource_declaration(std::string_view name, std::string_view type,
                     const std::vector<ConfigurationElement>& elements) {
    Assembly assembly;
    assembly.require(!elements.empty(), "a resource has no element")
        .text("RESOURCE ")
        .name(name)
        .text(" ON ")
        .name(type)
        .lines(elements)
        .text("\nEND_RESOURCE");
    return std::move(assembly).finish<ast::ResourceDeclaration>();
}

Part<ast::ConfigurationDeclaration>
configuration_declaration(std::string_view name,
                          const std::vector<ConfigurationElement>& elements) {
    Assembly assembly;
    assembly.require(!elements.empty(), "a configuration has no element")
        .text("CONFIGURATION ")
        .name(name)
        .lines(elements)
        .text("\nEND_CONFIGURATION");
    return std::move(assembly).finish<ast::ConfigurationDeclaration>();
}

} // namespace iecfront::build
