#pragma once

#include <iecfront/ast/fetch_ahead.hpp>
#include <iecfront/ast/nodes.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <ranges>
#include <span>

namespace iecfront::ast {
namespace detail {

/// Bytes that a node of each kind takes.
inline constexpr std::array<std::uint8_t, node_kind_count> node_sizes = {
#define IECFRONT_NODE(enumerator, Struct, Category, production) sizeof(Struct),
#include <iecfront/ast/nodes.def>
};

/// True when nodes of all kinds consist of words, and nothing is left free between two of them.
inline constexpr bool nodes_are_words =
#define IECFRONT_NODE(enumerator, Struct, Category, production)                                    \
    alignof(Struct) == sizeof(std::int32_t)&&
#include <iecfront/ast/nodes.def>
    true;
static_assert(nodes_are_words);

} // namespace detail

/// All nodes of a unit, each once, as they lie in memory, which is no order to rely on: some come
/// before their children, others behind them. For what is asked of each node by itself this is
/// faster than `walk`, which has to find out what is below a node to go on. A view: valid as long
/// as the unit.
///
/// Nodes lie behind each other, in words of 4 bytes. Between them are rows of children, and words
/// that are not used. A row lies behind its children, so that each distance in it is negative,
/// which the first word of a node, the number of a token, never is: this tells where the next node
/// is.
class StoredNodes {
public:
    /// Goes from node to node.
    class iterator {
    public:
        using value_type = Node;
        using difference_type = std::ptrdiff_t;
        using pointer = const Node*;
        using reference = const Node&;
        using iterator_category = std::forward_iterator_tag;

        iterator() = default;

        [[nodiscard]] const Node& operator*() const noexcept {
            return *reinterpret_cast<const Node*>(at_);
        }
        [[nodiscard]] const Node* operator->() const noexcept { return &**this; }
        iterator& operator++() noexcept {
            detail::fetch_ahead(at_);
            at_ += detail::node_sizes[static_cast<std::size_t>((**this).kind)];
            pass_words_between();
            return *this;
        }
        iterator operator++(int) noexcept {
            const iterator before = *this;
            ++*this;
            return before;
        }
        [[nodiscard]] friend bool operator==(iterator a, iterator b) noexcept {
            return a.at_ == b.at_;
        }

    private:
        friend class StoredNodes;
        iterator(const std::byte* at, const std::byte* end) noexcept : at_(at), end_(end) {
            pass_words_between();
        }
        void pass_words_between() noexcept {
            while (at_ != end_ && word_at(at_) < 0)
                at_ += sizeof(std::int32_t);
        }
        [[nodiscard]] static std::int32_t word_at(const std::byte* place) noexcept {
            std::int32_t word;
            std::memcpy(&word, place, sizeof word);
            return word;
        }

        const std::byte* at_ = nullptr;
        const std::byte* end_ = nullptr;
    };

    /// Of what there are no nodes.
    StoredNodes() = default;
    /// Those in `memory`, where a parser has made them.
    explicit StoredNodes(std::span<const std::byte> memory) noexcept : memory_(memory) {}

    [[nodiscard]] iterator begin() const noexcept { return {memory_.data(), limit()}; }
    [[nodiscard]] iterator end() const noexcept { return {limit(), limit()}; }

    /// What a word that is not used consists of.
    static constexpr std::byte unused{0xFF};

private:
    [[nodiscard]] const std::byte* limit() const noexcept {
        return memory_.data() + memory_.size();
    }

    std::span<const std::byte> memory_;
};

} // namespace iecfront::ast

/// Its iterators do not need it.
template<>
inline constexpr bool std::ranges::enable_borrowed_range<iecfront::ast::StoredNodes> = true;
