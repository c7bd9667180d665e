#include "lexer/lexer.hpp"
#include "lexer/lookahead.hpp"
#include "lexer/meant_number.hpp"
#include "lexer/plain_literals.hpp"

#include <iecfront/lexer/literals.hpp>
#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace iecfront {

const char* Lexer::long_number(const char* begin) {
    const char* const digits_end = Extents::digits_end(begin);
    if (*digits_end == '#')
        return prefixed(begin, digits_end);
    const bool behind_dot = has_tokens() && last_token().kind() == TokenKind::dot &&
                            last_token().end() == offset(begin);
    if (*digits_end == '.' && !behind_dot)
        return number_with_point(begin, digits_end);
    if (is_exponent_letter(*digits_end) && !behind_dot)
        return number_with_exponent(begin, digits_end);
    const char* const word_end = extents_.word_end(digits_end);
    return word_end == digits_end ? literal(TokenKind::integer, begin, digits_end)
                                  : digit_first_word(begin, word_end);
}

namespace {

// Digits that are no number of their own: `1. 5`, but not `1. 2.5`.
[[nodiscard]] bool is_fraction(const char* p) noexcept {
    const char* const end = Extents::digits_end(p);
    return is_digit(*p) && *end != '#' && (*end != '.' || end[1] == '.');
}

} // namespace

const char* Lexer::number_with_point(const char* begin, const char* point) {
    if (point[1] == '.' || is_lone_dot(Extents::blanks_end(point + 1))) // `1..3` and `1. .3`
        return literal(TokenKind::integer, begin, point);
    const char* end = point + 1;
    if (Extents::point_begins_fraction(point))
        end = extents_.real_end(point);
    // `1. 5`, `1.0 E3` and `1.0E 3`: the rest of the number behind blanks.
    const char* const rest = Extents::gap_end(end);
    if (rest != end) {
        const auto whole = [&](const char* real_end) {
            return spaced_literal(TokenKind::real, begin, real_end, gaps_of({range(end, rest)}));
        };
        if (end == point + 1 && is_fraction(rest))
            return whole(extents_.real_end(rest - 1));
        if (const char* const exponent = Extents::exponent_end(rest);
            exponent != nullptr && end != point + 1 && !is_word_part(*exponent))
            return whole(exponent);
        if (end != point + 1 && is_exponent_letter(end[-1]) && begins_number(rest))
            return whole(Extents::digits_end(is_sign(*rest) ? rest + 1 : rest));
    }
    if (lacks_duration_prefix(begin, end))
        return duration_without_prefix(begin, end);
    return literal(TokenKind::real, begin, end);
}

const char* Lexer::number_with_exponent(const char* begin, const char* letter) {
    const char* const exponent = Extents::exponent_end(letter);
    const char* const word_end = extents_.word_end(letter);
    if (exponent == nullptr)
        return word_end == letter + 1 ? literal(TokenKind::real, begin, word_end)
                                      : digit_first_word(begin, word_end);
    if (is_sign(letter[1]))
        return literal(TokenKind::real, begin, extents_.word_end(exponent));
    return exponent == word_end ? literal(TokenKind::real, begin, exponent)
                                : digit_first_word(begin, word_end);
}

// `5s`, `1h_30m`, `1.5s`: a duration but for its prefix. What a colon follows is declared or
// assigned to, and so meant as a name.
bool Lexer::lacks_duration_prefix(const char* begin, const char* end) const {
    if (view(begin, end).size() > longest_tried || is_digit(end[-1]) ||
        *Extents::blanks_end(end) == ':')
        return false;
    const std::string with_prefix = "T#" + std::string(begin, end);
    return check_literal(TokenKind::duration, with_prefix, encoding_).empty();
}

const char* Lexer::duration_without_prefix(const char* begin, const char* end) {
    if (has_tokens() && last_token().kind() == TokenKind::duration) {
        const char* const before_end = begin_ + last_token().end();
        if (before_end != begin && Extents::gap_end(before_end) == begin) { // `T#1m 5s`
            Gaps gaps = take_back_gaps(last_token());
            gaps.push_back({range(before_end, begin), {}});
            return spaced_literal(TokenKind::duration, begin_ + take_back().offset(), end,
                                  std::move(gaps));
        }
    }
    Diagnostic& diagnostic = report(DiagnosticId::duration_without_prefix, range(begin, end));
    add_replacement(diagnostic, range(begin, begin), "T#");
    emit_any(TokenKind::duration, begin, end, true);
    return end;
}

// `0x1F`: a based integer in the way of another language. Null when it is none.
const char* Lexer::c_style_integer(const char* begin, const char* end) {
    struct Base {
        char letter;
        const char* prefix;
        std::uint64_t base;
    };
    static constexpr std::array bases = {Base{'X', "16#", 16}, Base{'O', "8#", 8},
                                         Base{'B', "2#", 2}};
    const auto* const found = std::ranges::find(bases, fold(begin[1]), &Base::letter);
    if (*begin != '0' || found == bases.end() || view(begin, end).size() > safe_digits)
        return nullptr;
    const std::string meant = found->prefix + std::string(begin + 2, end);
    if (!check_literal(TokenKind::based_integer, meant, encoding_).empty())
        return nullptr;
    const TextRange where = range(begin, begin + 2);
    Diagnostic& diagnostic = report(DiagnosticId::c_style_base, where);
    diagnostic.arguments.emplace_back(std::string(begin, begin + 2));
    diagnostic.arguments.emplace_back(found->base);
    add_replacement(diagnostic, where, found->prefix);
    emit_any(TokenKind::based_integer, begin, end, true);
    return end;
}

// `0FFh` and `16FF`, which are to be 16#FF. Null when it is none of these, or is declared or
// assigned to, and so meant as a name.
const char* Lexer::hexadecimal_of_other_language(const char* begin, const char* end) {
    if (view(begin, end).size() > longest_tried || *Extents::gap_end(end) == ':')
        return nullptr;
    const std::string meant = meant_hexadecimal(view(begin, end));
    if (meant.empty())
        return nullptr;
    const TextRange where = range(begin, end);
    Diagnostic& diagnostic = report(DiagnosticId::number_of_other_language, where);
    diagnostic.arguments.emplace_back(std::uint64_t{16});
    diagnostic.arguments.emplace_back(meant);
    add_replacement(diagnostic, where, meant);
    emit_any(TokenKind::based_integer, begin, end, true);
    return end;
}

// `3MOD 2` and `FOR i := 1TO 3 DO`: a number without a fault, and a keyword that adjoins it. Null
// when these are not what the text is made of.
const char* Lexer::number_before_keyword(TokenKind kind, const char* begin, const char* end) {
    const std::size_t size = size_before_keyword(view(begin, end));
    const char* const number_end = begin + size;
    if (size == 0 || !is_word_part(number_end[-1]) ||
        !check_literal(kind, view(begin, number_end), encoding_).empty())
        return nullptr;
    Diagnostic& diagnostic =
        report(DiagnosticId::missing_white_space, range(number_end, number_end));
    diagnostic.arguments.emplace_back(std::string(begin, number_end));
    diagnostic.arguments.emplace_back(std::string(number_end, end));
    add_replacement(diagnostic, range(number_end, number_end), " ");
    emit_any(kind, begin, number_end);
    return number_end;
}

// `2nd_pump`: meant as a name, unless it is a value that lacks its prefix.
const char* Lexer::digit_first_word(const char* begin, const char* end) {
    if (*end == '#')
        return prefixed(begin, end);
    if (lacks_duration_prefix(begin, end))
        return duration_without_prefix(begin, end);
    if (const char* const value_end = c_style_integer(begin, end))
        return value_end;
    if (const char* const value_end = hexadecimal_of_other_language(begin, end))
        return value_end;
    if (const char* const value_end = with_pound_sign(begin, end))
        return value_end;
    if (const char* const number_end = number_before_keyword(TokenKind::integer, begin, end))
        return number_end;
    if (check_foreign_letters(begin, end)) {
        const char* const digits = std::find_if_not(begin, end, is_digit);
        report(DiagnosticId::identifier_begins_with_digit, range(begin, digits));
    }
    emit_any(TokenKind::identifier, begin, end, true);
    return end;
}

} // namespace iecfront
