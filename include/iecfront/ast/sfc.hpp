#pragma once

#include <iecfront/ast/node.hpp>
#include <iecfront/export.hpp>

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

/// Steps, transitions and actions up to the next initial step (B.1.6). The text says no more of
/// where a network ends than that each has one initial step; which steps the transitions connect is
/// not looked at here.
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
    Child<Identifier> name;
    List<ActionAssociation> actions;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"initial", &Step::initial},
                          MemberDescription{"name", &Step::name},
                          MemberDescription{"actions", &Step::actions}};
    }
};

/// `name(qualifier, time, indicators)` in a step (B.1.6). When nothing in it could be read, its
/// name is missing.
struct ActionAssociation : Node {
    static constexpr NodeKind node_kind = NodeKind::action_association;
    ActionAssociation() noexcept : Node(node_kind) {}
    Child<Identifier> action_name;
    Child<ActionQualifier> qualifier; ///< null when not given: N
    List<Expression> indicators;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"action_name", &ActionAssociation::action_name},
                          MemberDescription{"qualifier", &ActionAssociation::qualifier},
                          MemberDescription{"indicators", &ActionAssociation::indicators}};
    }
};

/// How an action depends on its step (Table 45).
enum class ActionQualifierKind : std::uint8_t {
    non_stored,              ///< N
    overriding_reset,        ///< R
    set,                     ///< S, also called stored
    time_limited,            ///< L
    time_delayed,            ///< D
    pulse,                   ///< P
    stored_and_time_delayed, ///< SD
    delayed_and_stored,      ///< DS
    stored_and_time_limited, ///< SL
    pulse_rising_edge,       ///< P1
    pulse_falling_edge,      ///< P0
    unknown                  ///< a word that is none of these, or none at all
};

/// `N`, `R` and so on, or `unknown`.
[[nodiscard]] IECFRONT_API std::string_view to_string(ActionQualifierKind kind) noexcept;

/// True for L, D, SD, DS and SL, which have a time.
[[nodiscard]] constexpr bool is_timed(ActionQualifierKind kind) noexcept {
    switch (kind) {
    case ActionQualifierKind::time_limited:
    case ActionQualifierKind::time_delayed:
    case ActionQualifierKind::stored_and_time_delayed:
    case ActionQualifierKind::delayed_and_stored:
    case ActionQualifierKind::stored_and_time_limited: return true;
    default: return false;
    }
}

/// `N`, `L, T#5s` and so on (Table 45).
struct ActionQualifier : Node {
    static constexpr NodeKind node_kind = NodeKind::action_qualifier;
    ActionQualifier() noexcept : Node(node_kind) {}
    ActionQualifierKind qualifier = ActionQualifierKind::unknown;
    Child<Expression> time; ///< null for one that has none

    static constexpr auto members() {
        return std::tuple{MemberDescription{"qualifier", &ActionQualifier::qualifier},
                          MemberDescription{"time", &ActionQualifier::time}};
    }
};

/// `TRANSITION name (PRIORITY := 1) FROM a TO b ... END_TRANSITION` (B.1.6).
struct Transition : Node {
    static constexpr NodeKind node_kind = NodeKind::transition;
    Transition() noexcept : Node(node_kind) {}
    Child<Identifier> name;     ///< null when not given
    Child<Expression> priority; ///< null when not given
    Child<Steps> from;
    Child<Steps> to;
    Child<TransitionCondition> condition;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &Transition::name},
                          MemberDescription{"priority", &Transition::priority},
                          MemberDescription{"from", &Transition::from},
                          MemberDescription{"to", &Transition::to},
                          MemberDescription{"condition", &Transition::condition}};
    }
};

/// `name`, or `(name, name)`: several are left or entered together (B.1.6).
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
    Child<Node> condition;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"condition", &TransitionCondition::condition}};
    }
};

/// `ACTION name : body END_ACTION` (B.1.6).
struct Action : Node {
    static constexpr NodeKind node_kind = NodeKind::action;
    Action() noexcept : Node(node_kind) {}
    Child<Identifier> name;
    Child<Body> body;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"name", &Action::name},
                          MemberDescription{"body", &Action::body}};
    }
};

} // namespace iecfront::ast
