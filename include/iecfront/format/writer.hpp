#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/export.hpp>
#include <iecfront/format/formatter.hpp>
#include <iecfront/source/text_range.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace iecfront {

/// What becomes of comments when a tree is written.
enum class CommentHandling : std::uint8_t {
    keep,         ///< all, with whatever characters they hold
    keep_iso_646, ///< those that ISO 646 has all characters of; the others are left out
    leave_out,    ///< none is written
};

/// What can be set about writing.
struct WriteOptions {
    CommentHandling comments = CommentHandling::keep; ///< pragmas are kept whatever it says
    FormatOptions layout;                             ///< what the text looks like
};

/// A tree as standard text.
struct WrittenText {
    std::string text;
    /// Places in the text of the tree, in order, with characters that ISO 646 lacks and that could
    /// not be written otherwise: in names, pragmas and comments, in a string that has no value.
    /// They stand in `text` as they were, in the encoding of the tree; but comments that are left
    /// out because of them do not. When there are none, `text` is in ISO 646.
    std::vector<TextRange> beyond_iso_646;
};

/// Writes `tree` as standard text (1.5.1 j): its tokens in the agreed layout, and in ISO 646.
/// Characters beyond it become `$hh` and `$hhhh` in strings, by their value, and comments in the
/// form of other languages become `(* *)`. The tree of the result equals `tree`. What the standard
/// has no form for stands as it was: other extensions, which the findings of the tree name, and
/// what could not be read of a tree with faults.
[[nodiscard]] IECFRONT_API WrittenText write(const SyntaxTree& tree,
                                             const WriteOptions& options = {});

} // namespace iecfront
