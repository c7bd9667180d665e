#pragma once

#include <iecfront/ast/arena.hpp>
#include <iecfront/ast/node.hpp>
#include <iecfront/ast/stored_nodes.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/export.hpp>
#include <iecfront/lexer/token.hpp>
#include <iecfront/source/encoding.hpp>
#include <iecfront/source/line_table.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront {

/// A self-contained piece of a file: one library element declaration (B.0) with the white space,
/// comments and pragmas before it, and the comments and pragmas behind it on the line of its end;
/// the last unit of a file also holds all that follows. Immutable, but for what `lines()` and
/// `nodes()` find out. Everything in it counts from its own start, so that it stays as it is when
/// the text before it changes, and can be shared by the trees of several versions of a file, and by
/// threads.
class IECFRONT_API Unit {
public:
    /// What a unit is made of. The parser fills it in.
    struct Parts {
        std::shared_ptr<const std::string> buffer; ///< owns `text`
        std::string_view text;                     ///< the unit's part of the file
        Encoding encoding = Encoding::utf8;        ///< of `text`
        Arena arena;                               ///< owns tokens, trivia and, behind them, nodes
        std::span<const Token> tokens;             ///< what `Unit::tokens` gives
        std::span<const Trivia> trivia;            ///< what `Unit::trivia` gives
        const ast::LibraryUnit* root = nullptr;    ///< not null in a unit, the first of its nodes
        std::vector<Diagnostic> diagnostics;       ///< ordered by position
        bool depends_on_rest = false;              ///< what `Unit::depends_on_rest` gives
    };
    /// `parse` makes units; there is no need to make one by hand.
    explicit Unit(Parts parts);
    Unit(const Unit&) = delete;
    Unit& operator=(const Unit&) = delete;
    ~Unit();

    /// All bytes of the unit. Views into it, as all of the unit, live as long as the unit does.
    [[nodiscard]] std::string_view text() const noexcept { return parts_.text; }
    /// That of the file.
    [[nodiscard]] Encoding encoding() const noexcept { return parts_.encoding; }
    /// The shared bytes that `text()` is a view into.
    [[nodiscard]] const std::shared_ptr<const std::string>& buffer() const noexcept {
        return parts_.buffer;
    }

    /// In source order; without white space, comments and pragmas.
    [[nodiscard]] std::span<const Token> tokens() const noexcept { return parts_.tokens; }
    /// Comments and pragmas, in source order.
    [[nodiscard]] std::span<const Trivia> trivia() const noexcept { return parts_.trivia; }
    /// The syntax tree of the unit. It is there whatever the text.
    [[nodiscard]] const ast::LibraryUnit& root() const noexcept { return *parts_.root; }
    /// All nodes of the tree, the root among them, in no order to rely on: see `ast::walk` for
    /// source order. A unit with diagnostics is walked through when somebody asks for the first
    /// time, whatever the thread, as nodes may have been made in it that nobody needs; other
    /// threads that ask wait for this one.
    [[nodiscard]] ast::StoredNodes nodes() const;
    /// What was found in this unit, ordered by position; ranges count from the start of the unit.
    [[nodiscard]] std::span<const Diagnostic> diagnostics() const noexcept {
        return parts_.diagnostics;
    }
    /// True when text behind the unit could change it: a comment or pragma in it is never closed,
    /// or a string that may go on stands in its last lines.
    [[nodiscard]] bool depends_on_rest() const noexcept { return parts_.depends_on_rest; }

    /// Number of line ends in the unit's text.
    [[nodiscard]] std::uint32_t line_end_count() const noexcept { return line_end_count_; }
    /// Where the lines of the unit's text begin. Made when it is asked for the first time, whatever
    /// the thread; lives as long as the unit does.
    [[nodiscard]] const LineTable& lines() const noexcept;

    /// The bytes from the first to the last token of `node`, with the trivia between them; for a
    /// node without tokens the empty range behind the token before it, and for an empty statement
    /// that before its `;`. Counts from the start of the unit; `node` belongs to it.
    [[nodiscard]] TextRange range(const ast::Node& node) const noexcept;

    /// The bytes in `range`, which counts from the start of the unit and lies inside it.
    [[nodiscard]] std::string_view text(TextRange range) const noexcept {
        return parts_.text.substr(range.begin, range.size());
    }
    /// The spelling of one of the unit's tokens.
    [[nodiscard]] std::string_view text(Token token) const noexcept { return text(token.range()); }
    /// The bytes in `range(node)`: a name as it is spelt, an expression with its comments.
    [[nodiscard]] std::string_view text(const ast::Node& node) const noexcept {
        return text(range(node));
    }

    /// Bytes of memory that the unit takes beside its text; more as soon as somebody asks for
    /// `lines()`, as positions, dumps and the formatter do. Units of a large text lie in blocks
    /// that they share, and which are released with the last one in them.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

private:
    /// Whether what is stored was compared with the tree.
    enum class NodeState : std::uint8_t { unknown, looked_at, known };
    void look_at_nodes() const;

    mutable Parts parts_; // what the tree does not need of the nodes is overwritten
    std::uint32_t line_end_count_;
    mutable std::atomic<NodeState> node_state_ = NodeState::unknown;
    mutable std::atomic<const LineTable*> lines_ = nullptr; // owned
};

/// True when both have the same text, tokens, trivia, nodes and diagnostics.
[[nodiscard]] IECFRONT_API bool operator==(const Unit& a, const Unit& b);

} // namespace iecfront
