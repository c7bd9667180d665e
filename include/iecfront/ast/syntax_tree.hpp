#pragma once

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/unit.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/export.hpp>
#include <iecfront/source/line_table.hpp>
#include <iecfront/source/source_text.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront {

/// What a text is read as. Programs also live in pieces: in XML, in databases, in panes of editors.
enum class FragmentKind : std::uint8_t {
    library,               ///< a file: any number of library element declarations (B.0)
    body,                  ///< function_block_body, in any language (B.1.5.2)
    statement_list,        ///< B.3.2
    expression,            ///< B.3.1
    variable_declarations, ///< any number of blocks, those of every place (B.1.4.3, B.1.7)
};

/// What can be set about parsing.
struct ParseOptions {
    /// All but a library is one unit, whose `root().elements` are the body, expression or blocks.
    FragmentKind read_as = FragmentKind::library;
    /// How deep parentheses, statements and initial values can nest. What is nested deeper is kept
    /// but not examined, and reported (`nesting-too-deep`; Annex D, 3.3.1 and 3.3.2). Bounds the
    /// stack that parsing needs: about 1 kB a level in a Release build.
    std::uint32_t maximum_nesting = 256;
    /// How many bytes an identifier can have. The first longer one of a unit is reported
    /// (`identifier-too-long`; Annex D, 2.1.2); all of them are significant.
    std::uint32_t maximum_identifier_length = 4096;
    /// How many findings `SyntaxTree::diagnostics` gives for a file, the last of which says so
    /// (`too-many-diagnostics`; Annex D, 1.5.1).
    std::uint32_t maximum_diagnostics = 100'000;
    /// How many bytes a text can have. A larger one is kept but not examined, and reported
    /// (`source-too-large`; Annex D, 2.5.3). Bounds the time that parsing needs, and the
    /// memory: some 4 bytes for each byte of source, and up to some 450 where each is a fault.
    std::uint32_t maximum_source_size = 1U << 28U;

    /// How many bytes the tokens, comments, nodes and findings of a unit can take; a finding counts
    /// as `memory_of_finding`. A larger unit is kept but not examined, and reported
    /// (`unit-too-large`; Annex D, 2.5.1). Bounds what a unit takes, whatever stands in the text;
    /// while it is read, it can be twice as much, and what the lexer finds wrong besides.
    std::uint32_t maximum_unit_memory = 1U << 31U;
    /// What most findings take, with their arguments and fixes, in bytes.
    static constexpr std::uint32_t memory_of_finding = 256;

    friend bool operator==(const ParseOptions&, const ParseOptions&) = default;
};

/// A file as a row of units. A value that is cheap to copy: copies share the units. Immutable, and
/// so free to be used by several threads.
class IECFRONT_API SyntaxTree {
public:
    /// Where a unit stands in the file.
    struct Slot {
        std::uint32_t offset = 0;         ///< of the unit's first byte, from the start of the file
        std::uint32_t first_line = 0;     ///< 0-based line that holds that byte
        std::shared_ptr<const Unit> unit; ///< never null

        /// What `Unit::range` gives, counted from the start of the file.
        [[nodiscard]] TextRange range(const ast::Node& node) const noexcept {
            return unit->range(node).shifted(offset);
        }
    };

    /// Puts units in a row; `parse` and `edited` do that. There is at least one unit, and all have
    /// `encoding`. `name` is what diagnostics call the file, `origin` where the text begins in it.
    SyntaxTree(std::string name, Encoding encoding, std::vector<std::shared_ptr<const Unit>> units,
               const ParseOptions& options, const Origin& origin = {});

    /// The units in file order, at least one. They tile the file byte for byte.
    [[nodiscard]] std::span<const Slot> slots() const noexcept { return *slots_; }

    /// What diagnostics call the file: the name of the `SourceText`.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    /// That of the `SourceText`.
    [[nodiscard]] Encoding encoding() const noexcept { return encoding_; }
    /// That of the `SourceText`: an edit of a piece does not move its beginning.
    [[nodiscard]] const Origin& origin() const noexcept { return origin_; }
    /// Bytes in the file.
    [[nodiscard]] std::uint32_t size() const noexcept { return size_; }
    /// The text in this version of the file. Shared with the text that was parsed; put together
    /// anew at each call for a tree that was edited.
    [[nodiscard]] SourceText source() const;
    /// What the text was read with; `edited` reads with the same.
    [[nodiscard]] const ParseOptions& options() const noexcept { return options_; }

    /// The slot whose unit holds the byte at `offset` of the file; at the end of text and beyond it
    /// the last one.
    [[nodiscard]] const Slot& slot_at(std::uint32_t offset) const noexcept;

    /// Line and column of an offset in the file, `offset <= size()`.
    [[nodiscard]] Position position(std::uint32_t offset,
                                    ColumnUnit unit = ColumnUnit::code_points) const noexcept;
    /// The inverse. A line behind the last one gives the end of text, a column behind the end of
    /// its line the end of that line.
    [[nodiscard]] std::uint32_t offset(Position position,
                                       ColumnUnit unit = ColumnUnit::code_points) const noexcept;

    /// Where `offset`, counted from the start of the text as everywhere, lies in the file that the
    /// text is a piece of (`SourceText::at`). Of a whole file it is the same place.
    [[nodiscard]] HostPlace host_place(std::uint32_t offset,
                                       ColumnUnit unit = ColumnUnit::code_points) const noexcept;

    /// All findings in source order; ranges count from the start of the file.
    [[nodiscard]] std::vector<Diagnostic> diagnostics() const;

    /// The way from the root of a unit to the innermost node that holds the byte at `offset`. Empty
    /// `nodes` never: the root is always there.
    struct Path {
        const Slot* slot;                    ///< of the tree; not null
        std::vector<const ast::Node*> nodes; ///< outermost first

        /// The innermost node on the way that is a `T`, which may be a category; null for none.
        template<class T>
        [[nodiscard]] const T* find() const noexcept {
            for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
                if (const T* found = ast::as<T>(*node))
                    return found;
            return nullptr;
        }
    };
    /// `offset` counts from the start of the file. Beyond `size()` the way is the root of the last
    /// unit alone. It leads into the units of this tree: hold the tree, or the unit, to keep it.
    [[nodiscard]] Path node_at(std::uint32_t offset) const;

    /// A token of the tree.
    struct TokenPlace {
        const Slot* slot;    ///< of the tree; not null
        std::uint32_t index; ///< in `slot->unit->tokens()`

        /// Its offset counts from the start of the unit.
        [[nodiscard]] Token token() const noexcept { return slot->unit->tokens()[index]; }
        /// Counted from the start of the file.
        [[nodiscard]] TextRange range() const noexcept {
            return token().range().shifted(slot->offset);
        }
    };
    /// The token that holds the byte at `offset`; nothing between tokens, in comments, and from
    /// `size()` on.
    [[nodiscard]] std::optional<TokenPlace> token_at(std::uint32_t offset) const noexcept;
    /// The last token that begins before `offset`: what an editor completes, or completes behind.
    /// Nothing before the first one.
    [[nodiscard]] std::optional<TokenPlace> token_before(std::uint32_t offset) const noexcept;

    /// The tree of the text in which `replacement` stands in the place of the bytes in `range`,
    /// which counts from the start of the file; a range that goes beyond its end is cut off there,
    /// and one that ends before it begins is taken the other way round.
    /// Only units that the edit can touch are read again, the others are shared. Always equal to
    /// parsing the new text.
    [[nodiscard]] SyntaxTree edited(TextRange range, std::string_view replacement) const;

private:
    // The same file with other slots, made by an edit.
    SyntaxTree(const SyntaxTree& before, std::vector<Slot> slots, std::size_t first_open);

    std::string name_;
    Encoding encoding_;
    std::uint32_t size_ = 0;
    std::shared_ptr<const std::vector<Slot>> slots_;
    std::size_t first_open_ = 0; // slot whose unit depends on the rest; one past the last for none
    ParseOptions options_;
    Origin origin_;
};

/// True when both have the same text and equal units.
[[nodiscard]] IECFRONT_API bool operator==(const SyntaxTree& a, const SyntaxTree& b);

} // namespace iecfront
