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
    return walk(root, std::forward<Enter>(enter), [](const Node&) {});
}

/// A traversal as a class. Derive, and write `visit` for the structs or categories of interest; the
/// most specific one is called, and what has none is walked into:
///
///     struct Loops : iecfront::ast::Visitor<Loops> {
///         using Visitor::visit;
///         Walk visit(const ForStatement&) { ++count; return Walk::into; }
///         int count = 0;
///     };
///
/// `leave` works the same way and is called after the children.
template<class Derived>
class Visitor {
public:
    /// Goes through `root` and everything below it; false when a `visit` stopped it.
    bool traverse(const Node& root) {
        auto& self = static_cast<Derived&>(*this);
        return walk(
            root,
            [&](const Node& node) {
                return dispatch(node, [&](const auto& typed) -> Walk { return self.visit(typed); });
            },
            [&](const Node& node) {
                dispatch(node, [&](const auto& typed) { self.leave(typed); });
            });
    }

    Walk visit(const Node&) { return Walk::into; }
    void leave(const Node&) {}
};

} // namespace iecfront::ast
