#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace iecfront {
namespace {

/// The steps of a chart in groups that transitions connect: the networks of 2.6.2.
class StepGroups {
public:
    void add(const std::string& name) {
        if (indices_.try_emplace(name, parents_.size()).second)
            parents_.push_back(parents_.size());
    }
    [[nodiscard]] bool contains(const std::string& name) const { return indices_.contains(name); }
    void connect(const std::string& a, const std::string& b) {
        parents_[group_of(a)] = group_of(b);
    }

    /// A number that is the same for all steps of a group.
    [[nodiscard]] std::size_t group_of(const std::string& name) {
        std::size_t step = indices_.at(name);
        while (parents_[step] != step)
            step = parents_[step] = parents_[parents_[step]]; // shortens the way for the next time
        return step;
    }

private:
    std::map<std::string, std::size_t> indices_;
    std::vector<std::size_t> parents_; // of each step, another one of its group; itself at the end
};

template<typename Function>
void for_each_element(const ast::SequentialFunctionChart& chart, Function function) {
    for (const ast::SfcNetwork* network : chart.networks)
        for (const ast::Node* element : network->elements)
            function(element);
}

[[nodiscard]] std::size_t initial_step_count(const ast::SequentialFunctionChart& chart) {
    std::size_t count = 0;
    for_each_element(chart, [&count](const ast::Node* element) {
        const auto* step = ast::as<ast::Step>(element);
        count += step != nullptr && step->initial ? 1 : 0;
    });
    return count;
}

struct ChartElements {
    std::vector<const ast::Step*> steps;
    std::vector<const ast::Transition*> transitions;
};

[[nodiscard]] ChartElements elements_of(const ast::SequentialFunctionChart& chart) {
    ChartElements found;
    for_each_element(chart, [&found](const ast::Node* element) {
        if (const auto* step = ast::as<ast::Step>(element))
            found.steps.push_back(step);
        else if (const auto* transition = ast::as<ast::Transition>(element))
            found.transitions.push_back(transition);
    });
    return found;
}

/// All that the transition leaves and enters becomes one group. False when a step of them is not
/// known. `name_of` gives the name of an identifier, folded.
template<typename NameOf>
[[nodiscard]] bool connect(StepGroups& groups, const ast::Transition& transition, NameOf name_of) {
    if (transition.from->missing || transition.to->missing)
        return false;
    const std::string first = name_of(*transition.from->names.front());
    for (const ast::Steps* steps : {transition.from.get(), transition.to.get()})
        for (const ast::Identifier* name : steps->names) {
            const std::string step = name_of(*name);
            if (!groups.contains(step))
                return false;
            groups.connect(step, first);
        }
    return true;
}

} // namespace

/// Each network has one initial step (2.6.2, Annex E row 22). Transitions say what a network is, so
/// that of a chart with a step that is nowhere declared no more is known than that one is initial.
void Parser::check_initial_steps(const ast::SequentialFunctionChart& chart) {
    const auto name_of = [this](const ast::Identifier& name) {
        return folded(text(name.first_token));
    };
    const std::size_t initial_steps = initial_step_count(chart);
    if (initial_steps == 0)
        report_at(chart.first_token, DiagnosticId::no_initial_step);
    if (initial_steps < 2) // as in most charts
        return;
    const ChartElements elements = elements_of(chart);
    StepGroups groups;
    for (const ast::Step* step : elements.steps)
        groups.add(name_of(*step->name));
    for (const ast::Transition* transition : elements.transitions)
        if (!connect(groups, *transition, name_of))
            return;
    std::map<std::size_t, const ast::Step*> found; // the first initial step of each group
    for (const ast::Step* step : elements.steps) {
        if (!step->initial)
            continue;
        const auto [place, is_first] =
            found.try_emplace(groups.group_of(name_of(*step->name)), step);
        if (!is_first)
            report_node(*step->name, DiagnosticId::second_initial_step,
                        {text(step->name->first_token)})
                .label(LabelId::first_given, place->second->name->first_token);
    }
}

} // namespace iecfront
