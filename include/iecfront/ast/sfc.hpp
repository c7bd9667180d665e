#pragma once

#include <iecfront/ast/node.hpp>

#include <cstdint>
#include <string_view>
#include <tuple>

/// Sequential function charts (B.1.6).
namespace iecfront::ast {

struct SfcNetwork;
struct ActionAssociation;
struct ActionQualifier;
struct Steps;
struct TransitionCondition;

/// One or more networks (B.1.6).
struct SequentialFunctionChart : Body {
    static constexpr NodeKind node_kind = NodeKind::sequential_function_chart;
    SequentialFunctionChart() noexcept : Body(node_kind) {}
    List<SfcNetwork> networks;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"networks", &SequentialFunctionChart::networks}};
    }
};

/// Steps, transitions and actions from one initial step on (B.1.6).
struct SfcNetwork : Node {
    static constexpr NodeKind node_kind = NodeKind::sfc_network;
    SfcNetwork() noexcept : Node(node_kind) {}
    List<Node> elements; ///< `Step`, `Transition`, `Action`, or `SkippedText`

    static constexpr auto members() {
        return std::tuple{MemberDescription{"elements", &SfcNetwork::elements}};
    }
};

/// `STEP name : ... END_STEP`, or `INITIAL_STEP` (B.1.6).
struct Step : Node {
    static constexpr NodeKind node_kind = NodeKind::step;
    Step() noexcept : Node(node_kind) {}
    bool initial = false;
    const Identifier* name = nullptr;
    List<ActionAssociation> actions;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"initial", &Step::initial},
                          MemberDescription{"name", &Step::name},
                          MemberDescription{"actions", &Step::actions}};
    }
};

/// `name(qualifier, time, indicators)` in a step (B.1.6).
struct ActionAssociation : Node {
    static constexpr NodeKind node_kind = NodeKind::action_association;
    ActionAssociation() noexcept : Node(node_kind) {}
    const Identifier* action_name = nullptr;
    const ActionQualifier* qualifier = nullptr; ///< null when not given: N
    List<Expression> indicators;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"action_name", &ActionAssociation::action_name},
                          MemberDescription{"qualifier", &ActionAssociation::qualifier},
                          MemberDescription{"indicators", &ActionAssociation::indicators}};
    }
};

/// `N`, `L, T#5s` ... (Table 45): its first token names it.
struct ActionQualifier : Node {
    static constexpr NodeKind node_kind = NodeKind::action_qualifier;
    ActionQualifier() noexcept : Node(node_kind) {}
    const Expression* time = nullptr; ///< null for an untimed one

    static constexpr auto members() {
        return std::tuple{MemberDescription{"time", &ActionQualifier::time}};
    }
};

/// `TRANSITION name (PRIORITY := 1) FROM a TO b ... END_TRANSITION` (B.1.6).
struct Transition : Node {
    static constexpr NodeKind node_kind = NodeKind::transition;
    Transition() noexcept : Node(node_kind) {}
    const Identifier* name = nullptr;     ///< null when not given
    const Expression* priority = nullptr; ///< null when not given
    const Steps* from = nullptr;
    const Steps* to = nullptr;
    const TransitionCondition* condition = nullptr;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &Transition::name},
                          MemberDescription{"priority", &Transition::priority},
                          MemberDescription{"from", &Transition::from},
                          MemberDescription{"to", &Transition::to},
                          MemberDescription{"condition", &Transition::condition}};
    }
};

/// `name`, or `(name, name)` (B.1.6).
struct Steps : Node {
    static constexpr NodeKind node_kind = NodeKind::steps;
    Steps() noexcept : Node(node_kind) {}
    List<Identifier> names;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"names", &Steps::names}};
    }
};

/// `:= expression;`, or `:` and an instruction list (B.1.6). `condition` is an `Expression` or an
/// `InstructionList`.
struct TransitionCondition : Node {
    static constexpr NodeKind node_kind = NodeKind::transition_condition;
    TransitionCondition() noexcept : Node(node_kind) {}
    const Node* condition = nullptr;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"condition", &TransitionCondition::condition}};
    }
};

/// `ACTION name : body END_ACTION` (B.1.6).
struct Action : Node {
    static constexpr NodeKind node_kind = NodeKind::action;
    Action() noexcept : Node(node_kind) {}
    const Identifier* name = nullptr;
    const Body* body = nullptr;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &Action::name},
                          MemberDescription{"body", &Action::body}};
    }
};

} // namespace iecfront::ast
