#include <iecfront/ast/node.hpp>

#include <array>

namespace iecfront::ast {
namespace {

constexpr std::array<std::string_view, node_kind_count> names = {
#define IECFRONT_NODE(enumerator, Struct, Category, production) #enumerator,
#include <iecfront/ast/nodes.def>
};

constexpr std::array<std::string_view, node_kind_count> productions = {
#define IECFRONT_NODE(enumerator, Struct, Category, production) production,
#include <iecfront/ast/nodes.def>
};

static_assert(!names.back().empty(), "node_kind_count is not the number of rows");

} // namespace

std::string_view to_string(NodeKind kind) noexcept {
    return names[static_cast<std::size_t>(kind)];
}

std::string_view production(NodeKind kind) noexcept {
    return productions[static_cast<std::size_t>(kind)];
}

} // namespace iecfront::ast
