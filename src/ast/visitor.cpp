#include <iecfront/ast/visitor.hpp>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

namespace iecfront::ast::detail {
namespace {

/// Asks for what lies some way behind `node`, where compilers can: nodes lie about in the order in
/// which they are walked, and by then memory has it ready.
void fetch_ahead(const Node& node) noexcept {
#ifdef __GNUC__
    constexpr std::uintptr_t distance = 16 * 1024; // bytes
    __builtin_prefetch(
        reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(&node) + distance));
#else
    static_cast<void>(node);
#endif
}

/// No more children than these are in a member of a node.
template<class Member>
[[nodiscard]] std::size_t child_bound(const Member& member) noexcept {
    if constexpr (is_list_member<Member>)
        return member.size();
    else
        return is_child_member<Member> ? 1 : 0;
}

/// Puts the children in a member down at `end`, from the last one to the first.
template<class Member>
void put_backwards(const Member& member, const Node**& end) noexcept {
    if constexpr (is_child_member<Member>) {
        if (const Node* const child = member.get(); child != nullptr)
            *end++ = child;
    } else if constexpr (is_list_member<Member>) {
        for (std::size_t i = member.size(); i > 0; --i)
            *end++ = member[i - 1];
    }
}

} // namespace

// Out of line: with a row of cases for each kind of node, it would make each program that walks
// slow to compile.
void PendingNodes::push_children(const Node& node) {
    fetch_ahead(node);
    dispatch(node, [this](const auto& typed) {
        constexpr auto members = std::remove_cvref_t<decltype(typed)>::members();
        constexpr std::size_t count = std::tuple_size_v<decltype(members)>;
        [&]<std::size_t... Index>(std::index_sequence<Index...>) {
            const std::size_t bound =
                (std::size_t{0} + ... + child_bound(typed.*(std::get<Index>(members).pointer)));
            if (nodes_.size() - size_ < bound)
                nodes_.resize(2 * nodes_.size() + bound);
            const Node** end = nodes_.data() + size_;
            (put_backwards(typed.*(std::get<count - 1 - Index>(members).pointer), end), ...);
            size_ = static_cast<std::size_t>(end - nodes_.data());
        }
        (std::make_index_sequence<count>());
    });
}

} // namespace iecfront::ast::detail
