#pragma once

#include <iecfront/ast/configuration.hpp>
#include <iecfront/ast/constants.hpp>
#include <iecfront/ast/il.hpp>
#include <iecfront/ast/node.hpp>
#include <iecfront/ast/pous.hpp>
#include <iecfront/ast/sfc.hpp>
#include <iecfront/ast/st.hpp>
#include <iecfront/ast/types.hpp>
#include <iecfront/ast/variables.hpp>
#include <iecfront/export.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

/// All node structs, and the means that work on any of them.
namespace iecfront::ast {

/// Calls `function` with `node` as its own struct: `dispatch(node, [](const auto& n) { ... })`.
template<class Function>
constexpr decltype(auto) dispatch(const Node& node, Function&& function) {
    switch (node.kind) {
#define IECFRONT_NODE(enumerator, Struct, Category, production)                                    \
    case NodeKind::enumerator:                                                                     \
        return function(static_cast<const Struct&>(node));
#include <iecfront/ast/nodes.def>
    }
    return function(static_cast<const SkippedText&>(node)); // not reached: all kinds are above
}

/// True when nodes of this kind are `T`s; `T` is a node struct or a category (`Expression`).
template<class T>
[[nodiscard]] constexpr bool is(NodeKind kind) noexcept {
    switch (kind) {
#define IECFRONT_NODE(enumerator, Struct, Category, production)                                    \
    case NodeKind::enumerator:                                                                     \
        return std::is_base_of_v<T, Struct>;
#include <iecfront/ast/nodes.def>
    }
    return false;
}

/// `node` as a `T`, or null when it is null or something else.
template<class T>
[[nodiscard]] constexpr const T* as(const Node* node) noexcept {
    return node != nullptr && is<T>(node->kind) ? static_cast<const T*>(node) : nullptr;
}

/// True of a member that holds one child, or null.
template<class Member>
inline constexpr bool is_child_member = false;
template<class T>
inline constexpr bool is_child_member<Child<T>> = true;

/// True of a member that holds a `List` of children.
template<class Member>
inline constexpr bool is_list_member = false;
template<class T>
inline constexpr bool is_list_member<List<T>> = true;

/// Calls `function(name, value)` for each member of `node`, in source order. The types of the
/// values differ: see `is_child_member` and `is_list_member`; all others are scalars.
template<class Struct, class Function>
constexpr void for_each_member(const Struct& node, Function&& function) {
    if constexpr (requires { Struct::members(); }) {
        std::apply(
            [&](const auto&... member) { (function(member.name, node.*(member.pointer)), ...); },
            Struct::members());
    } else {
        dispatch(node, [&](const auto& typed) { for_each_member(typed, function); });
    }
}

/// Calls `function(const Node&)` for each child of `node` that is there, in source order.
template<class Function>
constexpr void for_each_child(const Node& node, Function&& function) {
    for_each_member(node, [&](std::string_view, const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (is_child_member<Member>) {
            if (member != nullptr)
                function(static_cast<const Node&>(*member));
        } else if constexpr (is_list_member<Member>) {
            for (const auto* child : member)
                function(static_cast<const Node&>(*child));
        }
    });
}

namespace detail {

/// True of a struct with a member for children.
template<class Struct>
[[nodiscard]] constexpr bool holds_children() {
    return std::apply(
        []<class... Base, class... Member>(const MemberDescription<Base, Member>&...) {
            return (... || (is_child_member<Member> || is_list_member<Member>));
        },
        Struct::members());
}

/// The same by kind.
inline constexpr std::array<bool, node_kind_count> kinds_with_children = {
#define IECFRONT_NODE(enumerator, Struct, Category, production) holds_children<Struct>(),
#include <iecfront/ast/nodes.def>
};

} // namespace detail

/// True when nodes of this kind can have children: of half of all nodes there is none to ask for.
[[nodiscard]] constexpr bool can_have_children(NodeKind kind) noexcept {
    return detail::kinds_with_children[static_cast<std::size_t>(kind)];
}

/// True when both trees have the same nodes over the same token numbers, with equal members.
[[nodiscard]] IECFRONT_API bool equal(const Node& a, const Node& b);

} // namespace iecfront::ast
