#pragma once

#include <iecfront/export.hpp>
#include <iecfront/source/text_range.hpp>

#include <cstdint>
#include <string_view>

namespace iecfront {

/// What a token is: a keyword, a delimiter, or one of the kinds with varying text. See
/// `tokens.def`.
enum class TokenKind : std::uint8_t {
#define IECFRONT_KEYWORD(enumerator, spelling) enumerator,
#define IECFRONT_DELIMITER(enumerator, spelling) enumerator,
#define IECFRONT_TOKEN(enumerator, description) enumerator,
#include <iecfront/lexer/tokens.def>
};

/// Number of token kinds.
inline constexpr std::size_t token_kind_count = static_cast<std::size_t>(TokenKind::unknown) + 1;

/// True for the keywords of Annex C, but not for names of standard functions (`standard_name`).
[[nodiscard]] constexpr bool is_keyword(TokenKind kind) noexcept {
    return kind <= TokenKind::kw_eno;
}
/// True for BOOL, INT, TIME, STRING and their like (2.3.1): keywords as well.
[[nodiscard]] constexpr bool is_elementary_type_name(TokenKind kind) noexcept {
    return kind <= TokenKind::kw_wstring;
}
/// True for ANY, ANY_NUM and their like (2.3.2): keywords as well.
[[nodiscard]] constexpr bool is_generic_type_name(TokenKind kind) noexcept {
    return kind >= TokenKind::kw_any && kind <= TokenKind::kw_any_date;
}
/// True for delimiters and operators of signs, also those of other languages (`==`).
[[nodiscard]] constexpr bool is_delimiter(TokenKind kind) noexcept {
    return kind >= TokenKind::assign && kind <= TokenKind::caret;
}

/// The standard's spelling of a keyword or delimiter (`END_IF`, `:=`), or a description of another
/// kind ("an integer").
[[nodiscard]] IECFRONT_API std::string_view spelling(TokenKind kind) noexcept;

/// The enumerator's name: `kw_end_if`, `assign`, `integer`. Used in dumps.
[[nodiscard]] IECFRONT_API std::string_view to_string(TokenKind kind) noexcept;

/// One lexical element as it stands in the source: 8 bytes. White space is the gap between tokens;
/// comments and pragmas are trivia. A literal is one token, well-formed or not.
class Token {
public:
    /// No token is longer, in bytes; what is longer is cut and reported (`text-too-long`).
    static constexpr std::uint32_t maximum_length = (1U << 22) - 1;

    /// A token of no bytes at the start: a placeholder.
    constexpr Token() = default;
    /// `offset` and `length` are bytes; `length <= maximum_length`.
    constexpr Token(TokenKind kind, std::uint32_t offset, std::uint32_t length,
                    bool first_on_line = false, bool malformed = false) noexcept
        : offset_(offset),
          rest_(length | (first_on_line ? first_on_line_bit : 0U) |
                (malformed ? malformed_bit : 0U) |
                (static_cast<std::uint32_t>(kind) << kind_shift)) {}

    /// What it is. For a sign of another language that is taken for an operator, that operator's.
    [[nodiscard]] constexpr TokenKind kind() const noexcept {
        return static_cast<TokenKind>(rest_ >> kind_shift);
    }
    /// Offset of the first byte, counted in bytes from the start of the unit.
    [[nodiscard]] constexpr std::uint32_t offset() const noexcept { return offset_; }
    /// In bytes.
    [[nodiscard]] constexpr std::uint32_t length() const noexcept { return rest_ & maximum_length; }
    /// One past the last byte, and the bytes between, counted as `offset()` is.
    [[nodiscard]] constexpr std::uint32_t end() const noexcept { return offset_ + length(); }
    [[nodiscard]] constexpr TextRange range() const noexcept { return {offset(), end()}; }
    /// True when no other token precedes it on its line. Comments do not count; a line end inside a
    /// comment does not begin a line (A.1.1).
    [[nodiscard]] constexpr bool first_on_line() const noexcept {
        return (rest_ & first_on_line_bit) != 0;
    }
    /// True when the lexer has reported a fault in the token.
    [[nodiscard]] constexpr bool malformed() const noexcept { return (rest_ & malformed_bit) != 0; }
    /// The same token, `distance` bytes nearer to the start.
    [[nodiscard]] constexpr Token moved_back(std::uint32_t distance) const noexcept {
        Token token = *this;
        token.offset_ -= distance;
        return token;
    }

    friend constexpr bool operator==(Token, Token) noexcept = default;

private:
    static constexpr std::uint32_t first_on_line_bit = 1U << 22;
    static constexpr std::uint32_t malformed_bit = 1U << 23;
    static constexpr std::uint32_t kind_shift = 24;

    std::uint32_t offset_ = 0;
    std::uint32_t rest_ = 0; // length 22 bits, two flags, kind 8 bits
};

static_assert(sizeof(Token) == 8);

/// What may stand wherever white space may (2.1.5, 2.1.6).
enum class TriviaKind : std::uint8_t {
    comment,      ///< `(* ... *)`
    pragma,       ///< `{ ... }`
    line_comment, ///< `// ...` up to the line end; an extension
    c_comment,    ///< `/* ... */`; an extension
};

/// `comment`, `pragma`, `line_comment` or `c_comment`.
[[nodiscard]] IECFRONT_API std::string_view to_string(TriviaKind kind) noexcept;

/// A comment or pragma with its delimiters. The range counts from the start of the unit.
struct Trivia {
    TextRange range;
    TriviaKind kind{};

    friend constexpr bool operator==(Trivia, Trivia) noexcept = default;
};

} // namespace iecfront
