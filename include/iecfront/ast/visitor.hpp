#pragma once

#include <iecfront/ast/nodes.hpp>
#include <iecfront/export.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace iecfront::ast {

/// How a traversal goes on after a node was entered.
enum class Walk : std::uint8_t {
    into, ///< to its children
    over, ///< past its children; the node is left at once
    stop, ///< end the traversal
};

namespace detail {

/// Nodes that a traversal has still to come to, the next one on top. The traversal keeps the
/// pointer behind the top in a local variable, so that it is not read back from memory for each
/// node.
class PendingNodes {
public:
    PendingNodes() : nodes_(128) {}
    PendingNodes(const PendingNodes&) = delete;
    PendingNodes& operator=(const PendingNodes&) = delete;

    /// The top when none is left.
    [[nodiscard]] const Node** bottom() noexcept { return nodes_.data(); }
    /// Puts the children of `node` on top, the first one last, and gives the new top.
    [[nodiscard]] IECFRONT_API const Node** push_children(const Node& node, const Node** top);

private:
    [[nodiscard]] bool has_room(const Node** top, std::size_t count) noexcept {
        return static_cast<std::size_t>(nodes_.data() + nodes_.size() - top) >= count;
    }
    template<class Struct>
    [[nodiscard]] const Node** push_children_of(const Struct& node, const Node** top);
    [[nodiscard]] const Node** make_room(const Node** top, std::size_t count);

    std::vector<const Node*> nodes_; // those from the top on are not used
};

} // namespace detail

/// Goes through `root` and all nodes below it, in source order. Calls `enter(const Node&)`, which
/// gives a `Walk`, before the children and `leave(const Node&)` after them. Needs no recursion,
/// however deep the tree. Returns false when it was stopped.
template<class Enter, class Leave>
bool walk(const Node& root, Enter&& enter, Leave&& leave) {
    struct Open {
        const Node* node;
        std::size_t pending; // when all its children are done
    };
    std::vector<Open> open;
    detail::PendingNodes pending;
    const Node** top = pending.bottom();
    *top++ = &root;
    while (top != pending.bottom()) {
        const Node& node = **--top;
        const Walk next = enter(node);
        if (next == Walk::stop)
            return false;
        open.push_back({&node, static_cast<std::size_t>(top - pending.bottom())});
        if (next == Walk::into && can_have_children(node.kind))
            top = pending.push_children(node, top);
        const auto left = static_cast<std::size_t>(top - pending.bottom());
        for (; !open.empty() && open.back().pending == left; open.pop_back())
            leave(*open.back().node);
    }
    return true;
}

/// The same without `leave`.
template<class Enter>
bool walk(const Node& root, Enter&& enter) {
    detail::PendingNodes pending;
    const Node** top = pending.bottom();
    *top++ = &root;
    while (top != pending.bottom()) {
        const Node& node = **--top;
        const Walk next = enter(node);
        if (next == Walk::stop)
            return false;
        if (next == Walk::into && can_have_children(node.kind))
            top = pending.push_children(node, top);
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
