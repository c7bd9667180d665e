#pragma once

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/unit.hpp>
#include <iecfront/export.hpp>

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

/// Makes programs by program. Each function is called as the node that it makes is in `nodes.def`,
/// and takes the parts of the production that Annex B gives it: `assignment_statement` makes what
/// `ast::AssignmentStatement` stands for. Parentheses that the operators need come by themselves.
///
/// Parts are values. A tree is made of them by `tree`, and changed with them by `Changes`. What the
/// kinds of parts do not rule out (a name that is declared twice, a block of variables where none
/// can stand) is found when that tree is examined, as in any text.
namespace iecfront::build {

/// See below.
class AnyPart;
template<class Kind>
class Part;

namespace detail {
// What only the functions of the builder do: it says what kind a part is.
struct PartAccess {
    template<class Kind>
    static Part<Kind> part(AnyPart part);
};
} // namespace detail

/// A part of a program without what kind it is.
class IECFRONT_API AnyPart {
public:
    /// What node it is the text of.
    [[nodiscard]] ast::NodeKind kind() const noexcept { return kind_; }
    /// Standard text in UTF-8, without the `;` behind a statement or declaration. Its lines end in
    /// LF, and begin where the part begins.
    [[nodiscard]] const std::string& text() const noexcept { return text_; }
    /// What is wrong with what the part was made of: a name that is none, a value that no literal
    /// has, a list without an element that it needs. In English, for a programmer; empty when all
    /// is well. A part with a faulty part in it has the first fault of them.
    [[nodiscard]] const std::string& fault() const noexcept { return fault_; }

private:
    friend class Assembly;
    AnyPart(ast::NodeKind kind, std::string text, std::string fault, std::uint8_t strength)
        : kind_(kind), strength_(strength), text_(std::move(text)), fault_(std::move(fault)) {}

    ast::NodeKind kind_;
    std::uint8_t strength_; // of an expression: how tightly its operator binds
    std::string text_;
    std::string fault_;
};

/// An argument of a call: an `ast::InputArgument`, an `ast::OutputArgument`, or an expression for
/// an input without its name.
struct AnyArgument;
/// A label of a CASE element: an `ast::Subrange` or an expression.
struct AnyCaseLabel;
/// What a block of variables declares: an `ast::VariableDeclaration`, in VAR_ACCESS an
/// `ast::AccessDeclaration`, in VAR_CONFIG an `ast::InstanceSpecificInit`.
struct AnyDeclaration;
/// An `ast::Step`, `ast::Transition` or `ast::Action`.
struct AnyChartElement;
/// An `ast::VariableDeclarations`, `ast::TaskConfiguration` or `ast::ProgramConfiguration`; in a
/// configuration an `ast::ResourceDeclaration`, too.
struct AnyConfigurationElement;
/// An `ast::FbTask` or `ast::ProgCnxn` (prog_conf_element).
struct AnyProgConfElement;
/// An expression, or an `ast::InstructionList`: what a transition waits for, and the value of an
/// argument in Instruction List.
struct AnyCondition;

/// True when a part that is a `Kind` can stand where a `Category` is asked for.
template<class Kind, class Category>
inline constexpr bool stands_for = std::derived_from<Kind, Category>;
template<class Kind>
inline constexpr bool stands_for<Kind, AnyArgument> =
    std::derived_from<Kind, ast::Expression> || std::same_as<Kind, ast::InputArgument> ||
    std::same_as<Kind, ast::OutputArgument>;
template<class Kind>
inline constexpr bool stands_for<Kind, AnyCaseLabel> =
    std::derived_from<Kind, ast::Expression> || std::same_as<Kind, ast::Subrange>;
template<class Kind>
inline constexpr bool stands_for<Kind, AnyDeclaration> =
    std::same_as<Kind, ast::VariableDeclaration> || std::same_as<Kind, ast::AccessDeclaration> ||
    std::same_as<Kind, ast::InstanceSpecificInit>;
template<class Kind>
inline constexpr bool stands_for<Kind, AnyChartElement> =
    std::same_as<Kind, ast::Step> || std::same_as<Kind, ast::Transition> ||
    std::same_as<Kind, ast::Action>;
template<class Kind>
inline constexpr bool stands_for<Kind, AnyConfigurationElement> =
    std::same_as<Kind, ast::VariableDeclarations> || std::same_as<Kind, ast::TaskConfiguration> ||
    std::same_as<Kind, ast::ProgramConfiguration> || std::same_as<Kind, ast::ResourceDeclaration>;
template<class Kind>
inline constexpr bool stands_for<Kind, AnyProgConfElement> =
    std::same_as<Kind, ast::FbTask> || std::same_as<Kind, ast::ProgCnxn>;
template<class Kind>
inline constexpr bool stands_for<Kind, AnyCondition> =
    std::derived_from<Kind, ast::Expression> || std::same_as<Kind, ast::InstructionList>;

/// A part of a program that is a `Kind`: a node struct, a category such as `ast::Statement`, or one
/// of the sets above.
template<class Kind>
class Part : public AnyPart {
public:
    /// A part can stand wherever its category can.
    template<class Other>
    requires(!std::same_as<Other, Kind> && stands_for<Other, Kind>) Part(Part<Other> part)
        : AnyPart(std::move(part)) {} // NOLINT: meant to convert

private:
    friend struct detail::PartAccess;
    Part(detail::PartAccess, AnyPart part) : AnyPart(std::move(part)) {}
};

/// What only the functions of the builder call.
template<class Kind>
Part<Kind> detail::PartAccess::part(AnyPart part) {
    return Part<Kind>(PartAccess(), std::move(part));
}

/// Parts by their category.
using Expression = Part<ast::Expression>;                   ///< B.3.1
using Statement = Part<ast::Statement>;                     ///< B.3.2
using TypeSpecification = Part<ast::TypeSpecification>;     ///< B.1.3
using LibraryElement = Part<ast::LibraryElement>;           ///< B.0
using Body = Part<ast::Body>;                               ///< B.1.5, B.1.6
using Argument = Part<AnyArgument>;                         ///< B.3.2.2, B.2.1
using CaseLabel = Part<AnyCaseLabel>;                       ///< case_list_element, B.3.2.3
using Declaration = Part<AnyDeclaration>;                   ///< B.1.4.3
using ChartElement = Part<AnyChartElement>;                 ///< B.1.6
using ConfigurationElement = Part<AnyConfigurationElement>; ///< B.1.7
using ProgConfElement = Part<AnyProgConfElement>;           ///< B.1.7
using Condition = Part<AnyCondition>;                       ///< B.1.6

} // namespace iecfront::build
