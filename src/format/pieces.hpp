#pragma once

#include "format/layout.hpp"

#include <iecfront/ast/unit.hpp>

#include <cstdint>
#include <string_view>
#include <vector>

// A unit as a row of pieces: its tokens, comments and pragmas, each with what stands before it.
namespace iecfront::layout {

/// Between code and a comment behind it.
inline constexpr std::uint32_t blanks_before_comment = 2;

/// What can stand before a piece.
enum class Break : std::uint8_t {
    none,    ///< never a line end
    allowed, ///< a line end where the line is too long
    kept,    ///< a line end that the user made, inside a statement or declaration
    line,    ///< the line end that separates statements, declarations and their like
};

/// A token, comment or pragma and its place. The first group of members is known from the tree, the
/// second one is found out by `break_lines` and `align`.
struct Piece {
    std::string_view text;
    std::string_view gap; ///< white space before it in the source, back to the piece before
    /// In columns. Of a piece of several lines that of the last one, without the white space before
    /// it until `break_lines` has found a place for it.
    std::uint32_t width = 0;
    std::string_view line_before;   ///< in the source, of a piece of several lines
    std::uint32_t first_column = 0; ///< behind that, in the source
    bool tab_before = false;        ///< a tab stands in `line_before`
    bool blanks_before = false;     ///< nothing but white space does
    std::int32_t level = 0;         ///< the column of a line that begins with it
    std::uint32_t brackets = 0;     ///< that are open before it, in what is one line without breaks
    std::uint32_t source_column = no_column; ///< of a comment behind something
    std::uint8_t rank = 0;                   ///< see `TokenLayout`
    TokenKind kind = TokenKind::end_of_unit; ///< end_of_unit for a comment or pragma
    Break line_break = Break::none;
    bool several_lines = false; ///< a comment or pragma with line ends
    bool space = false;         ///< a blank before it
    bool blank_line = false;    ///< an empty line above it
    bool verbatim = false;      ///< written as it was read, with the gap before it
    bool word = false;          ///< spelt as `KeywordCase` says
    bool pragma = false;        ///< stands where it stands, and is not aligned
    bool behind = false;        ///< a comment, or pragma, at the end of a line
    bool row = false;           ///< see `TokenLayout`
    std::int8_t stop = -1;      ///< see `TokenLayout`
    Cell cell = Cell::none;

    bool begins_line = false; ///< a line end stands before it
    std::uint32_t spaces = 0; ///< blanks before it, in its line
    std::uint32_t column = 0; ///< where it begins

    static constexpr std::uint32_t no_column = 0xFFFF'FFFF;

    [[nodiscard]] bool is_comment() const noexcept { return kind == TokenKind::end_of_unit; }
};

[[nodiscard]] constexpr bool opens_bracket(TokenKind kind) noexcept {
    return kind == TokenKind::left_parenthesis || kind == TokenKind::left_bracket;
}
[[nodiscard]] constexpr bool closes_bracket(TokenKind kind) noexcept {
    return kind == TokenKind::right_parenthesis || kind == TokenKind::right_bracket;
}

/// What becomes of the white space that a further line of a comment begins with: so many blanks,
/// and then what is left of it.
struct MovedIndent {
    std::uint32_t blanks = 0;
    std::string_view rest;

    [[nodiscard]] std::uint32_t width() const noexcept {
        return blanks + static_cast<std::uint32_t>(rest.size());
    }
};

/// The further lines of a comment move with its first one, which comes to stand in `column`, as far
/// as there is white space before them. `line` is one of them, without its line end. What the first
/// one moves beyond the column `furthest` does not count: there can be many further ones.
[[nodiscard]] MovedIndent moved_indent(const Piece& comment, std::string_view line,
                                       std::uint32_t column, std::uint32_t furthest) noexcept;

/// What stands behind the last line end of `text`.
[[nodiscard]] std::string_view last_line(std::string_view text) noexcept;

/// The white space that `line` begins with.
[[nodiscard]] std::string_view indent_of(std::string_view line) noexcept;

/// How many characters the last line of `text` has.
[[nodiscard]] std::uint32_t width_of_last_line(std::string_view text, Encoding encoding) noexcept;

/// What becomes of the text of tokens, comments and pragmas. A comment that becomes empty is left
/// out; one that `stays`, in a line that could not be read, has to be written.
class TextRule {
public:
    virtual ~TextRule() = default;
    /// The text to write for `text`, which stands at `range` of the unit; either `text` itself, or
    /// something that is kept elsewhere until the unit is written.
    virtual std::string_view token(Token token, std::string_view text) = 0;
    virtual std::string_view trivia(Trivia trivia, std::string_view text, bool stays) = 0;
};

/// The bytes of the byte order mark that `unit` begins with.
[[nodiscard]] std::uint32_t leading_mark_size(const Unit& unit) noexcept;

/// Tokens, comments and pragmas of `unit`, in order. `rule` may be null: all is written as it is.
[[nodiscard]] std::vector<Piece> pieces_of(const Unit& unit, std::uint32_t indent_width,
                                           TextRule* rule);

} // namespace iecfront::layout
