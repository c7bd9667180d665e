#pragma once

#include <iecfront/ast/nodes.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace iecfront::ast {

/// How a traversal goes on after a node was entered.
enum class Walk : std::uint8_t {
    into, ///< to its children
    over, ///< past its children; the node is left at once
    stop, ///< end the traversal
};

/// Goes through `root` and all nodes below it, in source order. Calls `enter(const Node&)`, which
/// gives a `Walk`, before the children and `leave(const Node&)` after them. Needs no recursion,
/// however deep the tree. Returns false when it was stopped.
template<class Enter, class Leave>
bool walk(const Node& root, Enter&& enter, Leave&& leave) {
    struct Entry {
        const Node* node;
        bool leaving;
    };
    std::vector<Entry> pending{{&root, false}};
    while (!pending.empty()) {
        const Entry entry = pending.back();
        if (entry.leaving) {
            pending.pop_back();
            leave(*entry.node);
            continue;
        }
        const Walk next = enter(*entry.node);
        if (next == Walk::stop)
            return false;
        pending.back().leaving = true;
        if (next == Walk::over)
            continue;
        const std::size_t begin = pending.size();
        for_each_child(*entry.node, [&](const Node& child) { pending.push_back({&child, false}); });
        std::reverse(pending.begin() + static_cast<std::ptrdiff_t>(begin), pending.end());
    }
    return true;
}

/// The same without `leave`.
template<class Enter>
bool walk(const Node& root, Enter&& enter) {
    std::vector<const Node*> pending{&root};
    while (!pending.empty()) {
        const Node& node = *pending.back();
        pending.pop_back();
        const Walk next = enter(node);
        if (next == Walk::stop)
            return false;
        if (next == Walk::over || !can_have_children(node.kind))
            continue;
        const std::size_t begin = pending.size();
        for_each_child(node, [&](const Node& child) { pending.push_back(&child); });
        std::reverse(pending.begin() + static_cast<std::ptrdiff_t>(begin), pending.end());
    }
    return true;
}

/// True when the traversal class `V` has a `visit`, or a `leave`, that takes a `Struct`.
template<class V, class Struct>
concept Visits = requires(V& visitor, const Struct& node) {
    visitor.visit(node);
};
template<class V, class Struct>
concept Leaves = requires(V& visitor, const Struct& node) {
    visitor.leave(node);
};

/// A traversal as a class. Derive, and write `visit` for the structs or categories of interest; the
/// most specific one is called, and what has none is walked into:
///
///     struct Loops : iecfront::ast::Visitor<Loops> {
///         Walk visit(const ForStatement&) { ++count; return Walk::into; }
///         int count = 0;
///     };
///
/// `leave` works the same way, gives nothing, and is called after the children. Both are public.
template<class Derived>
class Visitor {
public:
    /// Goes through `root` and everything below it; false when a `visit` stopped it.
    bool traverse(const Node& root) {
        static_assert(handles_something(), "no public visit or leave takes a (const) node");
        auto& self = static_cast<Derived&>(*this);
        return walk(
            root,
            [&](const Node& node) {
                return dispatch(node, [&](const auto& typed) { return visit_one(self, typed); });
            },
            [&](const Node& node) {
                dispatch(node, [&](const auto& typed) { leave_one(self, typed); });
            });
    }

private:
    template<class Struct>
    static Walk visit_one(Derived& self, const Struct& node) {
        if constexpr (Visits<Derived, Struct>)
            return self.visit(node);
        else
            return Walk::into;
    }

    template<class Struct>
    static void leave_one(Derived& self, const Struct& node) {
        if constexpr (Leaves<Derived, Struct>)
            self.leave(node);
    }

    // A `visit` that cannot be called is taken for one that is not there; so at least one must be.
    static constexpr bool handles_something() {
        return
#define IECFRONT_NODE(enumerator, Struct, Category, production)                                    \
    Visits<Derived, Struct> || Leaves<Derived, Struct> ||
#include <iecfront/ast/nodes.def>
            false;
    }
};

} // namespace iecfront::ast
