#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/export.hpp>

#include <cstdint>
#include <string>

namespace iecfront {

/// How keywords are spelt, and with them the operators of Instruction List and the other words that
/// the syntax gives a meaning (`PRIORITY`, the qualifiers of actions).
enum class KeywordCase : std::uint8_t {
    upper, ///< `END_IF`
    lower, ///< `end_if`
    keep,  ///< as they were read
};

/// What can be set about the layout.
struct FormatOptions {
    static constexpr std::uint32_t widest_indent = 16;    ///< largest `indent_width`
    static constexpr std::uint32_t longest_line = 10'000; ///< largest `line_length`

    KeywordCase keyword_case = KeywordCase::upper;
    /// Columns a level; above `widest_indent` it counts as that.
    std::uint32_t indent_width = 4;
    /// Columns that a line has room for; above `longest_line` it counts as that. What has no place
    /// to be broken at goes beyond it, and comments are never broken. Nothing is moved to the right
    /// beyond it, neither the beginning of a line nor what is aligned with the lines around: so
    /// each byte of the text gives hardly more than so many.
    std::uint32_t line_length = 100;
};

/// The text of `tree` in the agreed layout: the same tokens, comments and pragmas in the same
/// order, but for the case of keywords. The further lines of a comment move along with its first
/// one. Formatting what it gives changes nothing. The bytes stay in the encoding of the tree, and
/// line ends are those of the first line, also in comments and pragmas.
///
/// Lines on which a violation of the syntax is reported stay as they are, and so does a whole unit
/// in which a layout around them would be read in another way.
[[nodiscard]] IECFRONT_API std::string format(const SyntaxTree& tree,
                                              const FormatOptions& options = {});

} // namespace iecfront
