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

#include <type_traits>

/// All node structs, and the means that work on any of them.
namespace iecfront::ast {

/// Calls `function` with `node` as its own struct: `dispatch(node, [](const auto& n) { … })`.
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

/// Calls `function(const Node&)` for each child of `node` that is there, in source order.
template<class Function>
constexpr void for_each_child(const Node& node, Function&& function) {
    const auto visit_member = [&](const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (std::is_pointer_v<Member>) {
            if (member != nullptr)
                function(static_cast<const Node&>(*member));
        } else if constexpr (requires { member.begin(); }) {
            for (const auto* child : member)
                function(static_cast<const Node&>(*child));
        }
    };
    dispatch(node, [&](const auto& self) {
        using Self = std::remove_cvref_t<decltype(self)>;
        std::apply(
            [&](const auto&... description) { (visit_member(self.*(description.pointer)), ...); },
            Self::members());
    });
}

} // namespace iecfront::ast
