#pragma once

#include "lexer/characters.hpp"

#include <iecfront/lexer/token.hpp>
#include <iecfront/source/encoding.hpp>

#include <string_view>

namespace iecfront {

// Where words and literals end. Whether they are well-formed is not asked here: the extent of a
// malformed literal covers what evidently belongs to it, so that it is one token (2.2).
//
// Every function takes a place in the text and gives the place behind what begins there. All rely
// on the zero byte behind the text.
class Extents {
public:
    Extents(std::string_view text, Encoding encoding) noexcept
        : begin_(text.data()), size_(text.size()), encoding_(encoding) {}

    // Of a character that is not ASCII: its size when it passes for a part of a word, else 0.
    // Broken bytes do: they were letters in another encoding, most likely.
    [[nodiscard]] std::uint32_t foreign_letter_size(const char* p) const noexcept;
    [[nodiscard]] DecodedCharacter decode(const char* p) const noexcept;

    // Letters, digits and underscores, and foreign letters among them.
    [[nodiscard]] const char* word_end(const char* p) const noexcept;
    // The digits and underscores only.
    [[nodiscard]] static const char* digits_end(const char* p) noexcept;
    [[nodiscard]] static const char* blanks_end(const char* p) noexcept;
    // Behind blanks, and comments and pragmas that begin and end on this line.
    [[nodiscard]] static const char* gap_end(const char* p) noexcept;

    // `p` is at the `E`. The end of the exponent with its digits; null when this is none.
    [[nodiscard]] static const char* exponent_end(const char* p) noexcept;
    // `point` is the one in `1.5E3`, or in `.5`.
    [[nodiscard]] const char* real_end(const char* point) const noexcept;
    // True when the point behind some digits makes a real literal of them, and is neither the first
    // one of `..` nor an access to a member.
    [[nodiscard]] static bool point_begins_fraction(const char* point) noexcept;

    // True at a point that nothing which can begin with one follows: it belongs to the literal.
    [[nodiscard]] static bool ends_with_point(const char* p) noexcept;

    // `body` is behind the `#`.
    [[nodiscard]] const char* literal_end(TokenKind kind, const char* body) const noexcept;
    // `quote` is the opening one. Ends behind the closing one, or before the line end.
    [[nodiscard]] const char* string_end(const char* quote) const noexcept;
    // `p` is behind the `%`.
    [[nodiscard]] const char* location_end(const char* p) const noexcept;
    // `p` is behind the letters of a location, at the digits.
    [[nodiscard]] const char* address_end(const char* p) const noexcept;

private:
    [[nodiscard]] const char* number_end(const char* p) const noexcept;
    [[nodiscard]] const char* duration_end(const char* p) const noexcept;
    [[nodiscard]] const char* date_end(TokenKind kind, const char* p) const noexcept;

    const char* begin_;
    std::size_t size_;
    Encoding encoding_;
};

} // namespace iecfront
