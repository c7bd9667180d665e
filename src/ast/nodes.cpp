#include <iecfront/ast/nodes.hpp>

#include <vector>

namespace iecfront::ast {
namespace {

struct Pair {
    const Node* a;
    const Node* b;
};

[[nodiscard]] bool same_header(const Node& a, const Node& b) noexcept {
    return a.kind == b.kind && a.missing == b.missing && a.first_token == b.first_token &&
           a.end_token == b.end_token;
}

// Compares one member of two nodes, and leaves the children in it for later.
template<class Member>
[[nodiscard]] bool same_member(const Member& a, const Member& b, std::vector<Pair>& pending) {
    if constexpr (is_child_member<Member>) {
        if (a != nullptr && b != nullptr)
            pending.push_back({a, b});
        return (a == nullptr) == (b == nullptr);
    } else if constexpr (is_list_member<Member>) {
        if (a.size() != b.size())
            return false;
        for (std::size_t i = 0; i < a.size(); ++i)
            pending.push_back({a[i], b[i]});
        return true;
    } else {
        return a == b;
    }
}

template<class Struct>
[[nodiscard]] bool same_members(const Struct& a, const Struct& b, std::vector<Pair>& pending) {
    return std::apply(
        [&](const auto&... member) {
            return (same_member(a.*(member.pointer), b.*(member.pointer), pending) && ...);
        },
        Struct::members());
}

} // namespace

bool equal(const Node& a, const Node& b) {
    std::vector<Pair> pending{{&a, &b}};
    while (!pending.empty()) {
        const Pair pair = pending.back();
        pending.pop_back();
        const bool same =
            same_header(*pair.a, *pair.b) && dispatch(*pair.a, [&](const auto& node) {
                using Struct = std::remove_cvref_t<decltype(node)>;
                return same_members(node, static_cast<const Struct&>(*pair.b), pending);
            });
        if (!same)
            return false;
    }
    return true;
}

} // namespace iecfront::ast
