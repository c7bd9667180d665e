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
    KeywordCase keyword_case = KeywordCase::upper;
    std::uint32_t indent_width = 4; ///< columns a level
    /// Columns that a line has room for. What has no place to be broken at goes beyond it, and
    /// comments are never broken.
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
