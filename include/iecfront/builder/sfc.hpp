#pragma once

#include <iecfront/builder/part.hpp>

#include <optional>
#include <string_view>
#include <vector>

/// Sequential function charts (B.1.6).
namespace iecfront::build {

/// `N`, `L, T#5s` and so on (Table 45); a time for those that have one.
[[nodiscard]] IECFRONT_API Part<ast::ActionQualifier>
action_qualifier(ast::ActionQualifierKind qualifier, const std::optional<Expression>& time = {});

/// `name(qualifier, indicators)` in a step.
[[nodiscard]] IECFRONT_API Part<ast::ActionAssociation>
action_association(std::string_view action_name,
                   const std::optional<Part<ast::ActionQualifier>>& qualifier = {},
                   const std::vector<Expression>& indicators = {});

/// `INITIAL_STEP name : ... END_STEP`.
[[nodiscard]] IECFRONT_API Part<ast::Step>
initial_step(std::string_view name, const std::vector<Part<ast::ActionAssociation>>& actions = {});
/// `STEP name : ... END_STEP`.
[[nodiscard]] IECFRONT_API Part<ast::Step>
step(std::string_view name, const std::vector<Part<ast::ActionAssociation>>& actions = {});

/// `name`, or `(name, name)`; at least one.
[[nodiscard]] IECFRONT_API Part<ast::Steps> steps(const std::vector<std::string_view>& names);

/// `:= expression;`, or `:` and an instruction list.
[[nodiscard]] IECFRONT_API Part<ast::TransitionCondition>
transition_condition(const Condition& condition);

/// `TRANSITION name (PRIORITY := priority) FROM from TO to condition END_TRANSITION`; without a
/// `name` it has none.
[[nodiscard]] IECFRONT_API Part<ast::Transition>
transition(std::string_view name, const Part<ast::Steps>& from, const Part<ast::Steps>& to,
           const Part<ast::TransitionCondition>& condition,
           const std::optional<Expression>& priority = {});

/// `ACTION name : body END_ACTION`.
[[nodiscard]] IECFRONT_API Part<ast::Action> action(std::string_view name, const Body& body);

/// The elements of a network; at least one.
[[nodiscard]] IECFRONT_API Part<ast::SfcNetwork>
sfc_network(const std::vector<ChartElement>& elements);

/// One or more networks.
[[nodiscard]] IECFRONT_API Part<ast::SequentialFunctionChart>
sequential_function_chart(const std::vector<Part<ast::SfcNetwork>>& networks);

} // namespace iecfront::build
