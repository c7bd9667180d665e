#include <iecfront/ast/fetch_ahead.hpp>
#include <iecfront/ast/visitor.hpp>

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace iecfront::ast::detail {
namespace {

/// No more children than these are in a member of a node.
template<class Member>
[[nodiscard]] std::size_t child_bound(const Member& member) noexcept {
    if constexpr (is_list_member<Member>)
        return member.size();
    else
        return is_child_member<Member> ? 1 : 0;
}

/// Puts the children in a member down at `end`, from the last one to the first, and gives the new
/// end.
template<class Member>
[[nodiscard]] const Node** put_backwards(const Member& member, const Node** end) noexcept {
    if constexpr (is_child_member<Member>) {
        if (const Node* const child = member.get(); child != nullptr)
            *end++ = child;
    } else if constexpr (is_list_member<Member>) {
        for (std::size_t i = member.size(); i > 0; --i)
            *end++ = member[i - 1];
    }
    return end;
}

} // namespace

/// Moves them to where there is room for `count` more, and gives the new top.
const Node** PendingNodes::make_room(const Node** top, std::size_t count) {
    const std::ptrdiff_t size = top - nodes_.data();
    nodes_.resize(2 * nodes_.size() + count);
    return nodes_.data() + size;
}

template<class Struct>
const Node** PendingNodes::push_children_of(const Struct& node, const Node** top) {
    constexpr auto members = Struct::members();
    constexpr std::size_t count = std::tuple_size_v<decltype(members)>;
    return [&]<std::size_t... Index>(std::index_sequence<Index...>) {
        const std::size_t bound =
            (std::size_t{0} + ... + child_bound(node.*(std::get<Index>(members).pointer)));
        const Node** end = has_room(top, bound) ? top : make_room(top, bound);
        ((end = put_backwards(node.*(std::get<count - 1 - Index>(members).pointer), end)), ...);
        return end;
    }
    (std::make_index_sequence<count>());
}

// Out of line: with a row of cases for each kind of node, it would make each program that walks
// slow to compile. The cases stand here, as `dispatch` would hand the top on in memory.
const Node** PendingNodes::push_children(const Node& node, const Node** top) {
    fetch_ahead(&node);
    switch (node.kind) {
#define IECFRONT_NODE(enumerator, Struct, Category, production)                                    \
    case NodeKind::enumerator:                                                                     \
        return push_children_of(static_cast<const Struct&>(node), top);
#include <iecfront/ast/nodes.def>
    }
    return top; // not reached: all kinds are above
}

} // namespace iecfront::ast::detail
