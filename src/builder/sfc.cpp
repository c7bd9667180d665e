#include "builder/assembly.hpp"

#include <iecfront/builder/sfc.hpp>

namespace iecfront::build {
namespace {

using ActionAssociations = std::vector<Part<ast::ActionAssociation>>;

[[nodiscard]] Part<ast::Step> make_step(std::string_view keyword, std::string_view name,
                                        const ActionAssociations& actions) {
    Assembly assembly;
    assembly.text(keyword).name(name).text(":").lines(actions).text("\nEND_STEP");
    return std::move(assembly).finish<ast::Step>();
}

} // namespace

Part<ast::ActionQualifier> action_qualifier(ast::ActionQualifierKind qualifier,
                                            const std::optional<Expression>& time) {
    Assembly assembly;
    assembly.require(qualifier != ast::ActionQualifierKind::unknown, "this is no action qualifier")
        .require(time.has_value() == is_timed(qualifier),
                 "the action qualifiers L, D, SD, DS and SL have a time, the others none")
        .text(to_string(qualifier))
        .optional(", ", time);
    return std::move(assembly).finish<ast::ActionQualifier>();
}

// action_association = action_name "(" [ action_qualifier ] { "," indicator_name } ")"
Part<ast::ActionAssociation>
action_association(std::string_view action_name,
                   const std::optional<Part<ast::ActionQualifier>>& qualifier,
                   const std::vector<Expression>& indicators) {
    Assembly assembly;
    assembly.name(action_name).text("(").optional("", qualifier);
    for (const Expression& indicator : indicators)
        assembly.text(", ").part(indicator);
    return std::move(assembly.text(")")).finish<ast::ActionAssociation>();
}

Part<ast::Step> initial_step(std::string_view name, const ActionAssociations& actions) {
    return make_step("INITIAL_STEP ", name, actions);
}

Part<ast::Step> step(std::string_view name, const ActionAssociations& actions) {
    return make_step("STEP ", name, actions);
}

Part<ast::Steps> steps(const std::vector<std::string_view>& names) {
    const bool several = names.size() > 1;
    Assembly assembly;
    assembly.text(several ? "(" : "").names(names).text(several ? ")" : "");
    return std::move(assembly).finish<ast::Steps>();
}

// transition_condition = ":" { EOL } simple_instr_list | ":=" expression ";"
Part<ast::TransitionCondition> transition_condition(const Condition& condition) {
    Assembly assembly;
    if (condition.kind() == ast::NodeKind::instruction_list)
        assembly.text(":").indented(condition);
    else
        assembly.text(":= ").part(condition).text(";");
    return std::move(assembly).finish<ast::TransitionCondition>();
}

Part<ast::Transition> transition(std::string_view name, const Part<ast::Steps>& from,
                                 const Part<ast::Steps>& to,
                                 const Part<ast::TransitionCondition>& condition,
                                 const std::optional<Expression>& priority) {
    Assembly assembly;
    assembly.text("TRANSITION ");
    if (!name.empty())
        assembly.name(name).text(" ");
    if (priority)
        assembly.text("(PRIORITY := ").part(*priority).text(") ");
    assembly.text("FROM ").part(from).text(" TO ").part(to).indented(condition);
    return std::move(assembly.text("\nEND_TRANSITION")).finish<ast::Transition>();
}

Part<ast::Action> action(std::string_view name, const Body& body) {
    Assembly assembly;
    assembly.text("ACTION ").name(name).text(":").indented(body).text("\nEND_ACTION");
    return std::move(assembly).finish<ast::Action>();
}

Part<ast::SfcNetwork> sfc_network(const std::vector<ChartElement>& elements) {
    Assembly assembly;
    assembly.require(!elements.empty(), "a network has no element");
    return std::move(assembly.list(elements, "\n")).finish<ast::SfcNetwork>();
}

Part<ast::SequentialFunctionChart>
sequential_function_chart(const std::vector<Part<ast::SfcNetwork>>& networks) {
    Assembly assembly;
    assembly.require(!networks.empty(), "a chart has no network");
    return std::move(assembly.list(networks, "\n")).finish<ast::SequentialFunctionChart>();
}

} // namespace iecfront::build
