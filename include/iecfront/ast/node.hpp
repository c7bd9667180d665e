#pragma once

#include <iecfront/ast/relative_pointer.hpp>
#include <iecfront/export.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>

/// The syntax tree: typed nodes, one struct a kind, grouped as Annex B groups the productions.
///
/// Nodes are immutable values in the arena of a `Unit`: they live as long as it does, are never
/// copied, and are free of virtual functions. A `Child` is null only where the grammar says
/// optional and the part is not there; in the place of something mandatory that is missing stands
/// an `Error...` node or an `Identifier` that is `missing`.
namespace iecfront::ast {

/// What a node is. See `nodes.def`.
enum class NodeKind : std::uint8_t {
#define IECFRONT_NODE(enumerator, Struct, Category, production) enumerator,
#include <iecfront/ast/nodes.def>
};

/// Number of node kinds.
inline constexpr std::size_t node_kind_count =
    static_cast<std::size_t>(NodeKind::il_error_operation) + 1;

/// `assignment_statement` and so on.
[[nodiscard]] IECFRONT_API std::string_view to_string(NodeKind kind) noexcept;

/// The production(s) of Annex B that nodes of this kind stand for, `-` for error nodes and
/// extensions.
[[nodiscard]] IECFRONT_API std::string_view production(NodeKind kind) noexcept;

/// The header of every node: its kind, and its tokens as a half-open stretch of `Unit::tokens()`.
/// A node without tokens (a missing name, an empty list) has `first_token == end_token`: it stands
/// directly before token `first_token`.
struct Node {
    std::uint32_t first_token = 0; ///< index in `Unit::tokens()`
    std::uint32_t end_token = 0;   ///< one past the last token
    NodeKind kind;
    bool missing = false; ///< nothing in the source stands for this mandatory node

    Node(const Node&) = delete;
    Node& operator=(const Node&) = delete;

protected:
    constexpr explicit Node(NodeKind node_kind) noexcept : kind(node_kind) {}
};

/// A member of a node struct, by name. `Node::members()` of each struct gives them all, in source
/// order; walking, dumping and comparing derive from it.
template<class Struct, class Member>
struct MemberDescription {
    std::string_view name;
    Member Struct::*pointer;
};
template<class Struct, class Member>
MemberDescription(std::string_view, Member Struct::*) -> MemberDescription<Struct, Member>;

/// Something with a value (B.3.1): constants, variables, operations; and the aggregates of initial
/// values (B.1.3.3).
struct Expression : Node {
protected:
    using Node::Node;
};
/// A literal (B.1.2); its value: `literals.hpp`.
struct Constant : Expression {
    std::uint32_t literal_token = 0; ///< the literal itself, behind its sign
    /// True when a sign stands before the literal as a token of its own, as in `-5`.
    [[nodiscard]] bool has_sign() const noexcept { return first_token != literal_token; }

    static constexpr auto members() {
        return std::tuple{MemberDescription{"literal_token", &Constant::literal_token}};
    }

protected:
    using Expression::Expression;
};
/// What follows the `:` of a declaration: a type name or a type written out (B.1.3).
struct TypeSpecification : Node {
protected:
    using Node::Node;
};
/// A statement (B.3.2), without its `;`.
struct Statement : Node {
protected:
    using Node::Node;
};
/// The body of a program organization unit or of an action (B.1.5, B.1.6).
struct Body : Node {
protected:
    using Node::Node;
};
/// What a file consists of (B.0).
struct LibraryElement : Node {
protected:
    using Node::Node;
};
/// What stands in the operator field of an IL instruction, with its operands (B.2.1).
struct IlOperation : Node {
protected:
    using Node::Node;
};

/// One child of a node: used like a `const T*`, but `auto` would try to copy it; say
/// `const auto* x = y.child.get()`.
template<class T>
using Child = RelativePointer<T>;

/// Child nodes in source order. Never null inside; lives in its node, and cannot be copied.
template<class T>
class List {
public:
    /// Goes through pointers to children, for `for (const T* child : list)`. The algorithms of
    /// `std::ranges` see random access, those before them input only.
    class iterator {
    public:
        using value_type = const T*;
        using difference_type = std::ptrdiff_t;
        using iterator_category = std::input_iterator_tag;
        using iterator_concept = std::random_access_iterator_tag;

        constexpr iterator() = default;
        constexpr explicit iterator(const Child<T>* child) noexcept : child_(child) {}

        [[nodiscard]] const T* operator*() const noexcept { return child_->get(); }
        [[nodiscard]] const T* operator[](difference_type n) const noexcept {
            return child_[n].get();
        }
        constexpr iterator& operator+=(difference_type n) noexcept {
            child_ += n;
            return *this;
        }
        constexpr iterator& operator-=(difference_type n) noexcept { return *this += -n; }
        constexpr iterator& operator++() noexcept { return *this += 1; }
        constexpr iterator& operator--() noexcept { return *this -= 1; }
        constexpr iterator operator++(int) noexcept { return iterator(child_++); }
        constexpr iterator operator--(int) noexcept { return iterator(child_--); }
        [[nodiscard]] friend constexpr iterator operator+(iterator i, difference_type n) noexcept {
            return i += n;
        }
        [[nodiscard]] friend constexpr iterator operator+(difference_type n, iterator i) noexcept {
            return i += n;
        }
        [[nodiscard]] friend constexpr iterator operator-(iterator i, difference_type n) noexcept {
            return i -= n;
        }
        [[nodiscard]] friend constexpr difference_type operator-(iterator a, iterator b) noexcept {
            return a.child_ - b.child_;
        }
        [[nodiscard]] friend constexpr auto operator<=>(iterator, iterator) noexcept = default;

    private:
        const Child<T>* child_ = nullptr;
    };

    List() = default;
    List(const List&) = delete;
    List& operator=(const List&) = delete;
    /// Holds `children`, which lie in the same block as the list.
    List& operator=(std::span<const Child<T>> children) noexcept {
        children_ = children.data();
        size_ = static_cast<std::uint32_t>(children.size());
        return *this;
    }

    [[nodiscard]] iterator begin() const noexcept { return iterator(children_.get()); }
    [[nodiscard]] iterator end() const noexcept { return iterator(children_.get() + size_); }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    /// The same as they lie in memory.
    [[nodiscard]] std::span<const Child<T>> children() const noexcept {
        return {children_.get(), size_};
    }
    /// The child at `index < size()`.
    [[nodiscard]] const T* operator[](std::size_t index) const noexcept {
        return children_.get()[index].get();
    }
    /// The first and the last child, of a list that is not empty.
    [[nodiscard]] const T* front() const noexcept { return (*this)[0]; }
    [[nodiscard]] const T* back() const noexcept { return (*this)[size_ - 1]; }

private:
    RelativePointer<Child<T>> children_;
    std::uint32_t size_ = 0;
};

/// A name (B.1.1). When it `is missing`, no token stands for it. Spelling: `Unit::text(node)`.
struct Identifier : Node {
    static constexpr NodeKind node_kind = NodeKind::identifier;
    Identifier() noexcept : Node(node_kind) {}
    std::uint32_t hash = 0; ///< of the case-folded spelling, see `hash_name`; 0 when missing

    static constexpr auto members() {
        return std::tuple{MemberDescription{"hash", &Identifier::hash}};
    }
};

/// Tokens that fit nowhere; the diagnostics say why.
struct SkippedText : Node {
    static constexpr NodeKind node_kind = NodeKind::skipped_text;
    SkippedText() noexcept : Node(node_kind) {}

    static constexpr auto members() { return std::tuple{}; }
};

/// The root of a unit: at most one library element declaration, and what else stands there. For a
/// text that is read as a fragment, what the fragment consists of.
struct LibraryUnit : Node {
    static constexpr NodeKind node_kind = NodeKind::library_unit;
    LibraryUnit() noexcept : Node(node_kind) {}
    /// A `LibraryElement`, with `SkippedText` before or after it where something is wrong. Of a
    /// fragment a `Body`, an `Expression`, or any number of `VariableDeclarations`.
    List<Node> elements;

    static constexpr auto members() {
        return std::tuple{MemberDescription{"elements", &LibraryUnit::elements}};
    }
};

} // namespace iecfront::ast
