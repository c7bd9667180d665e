#include "lexer/keywords.hpp"
#include "lexer/lexer.hpp"
#include "lexer/literal_scanners.hpp"
#include "lexer/lookahead.hpp"
#include "lexer/plain_literals.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace iecfront {

namespace {

// By its opening quote.
[[nodiscard]] TokenKind string_kind(const char* begin) noexcept {
    return *begin == '"' ? TokenKind::double_byte_string : TokenKind::single_byte_string;
}

} // namespace

const char* Lexer::string(const char* begin) {
    const char* const end = extents_.string_end(begin);
    const TokenKind kind = string_kind(begin);
    if (const char* const whole_end = end_behind_inner_quote(end)) {
        const TextRange inner = range(end - 1, end);
        Diagnostic& diagnostic = report(DiagnosticId::quote_in_string, inner);
        diagnostic.arguments.emplace_back(std::string{'$', *begin});
        add_replacement(diagnostic, inner, std::string{'$', *begin});
        emit_any(kind, begin, whole_end, true);
        return whole_end;
    }
    if (is_plain_literal(kind, view(begin, end))) {
        emit_any(kind, begin, end);
        return end;
    }
    if (std::find(begin + 1, end, *begin) == end)
        if (const char* const other_end = unclosed_string(begin, end))
            return other_end;
    return literal(kind, begin, end);
}

namespace {

// The quote in the line from `begin` to `end` that closes a string of the line before; null when
// there is none: what stands before it is no code, and what stands behind it ends the operand.
[[nodiscard]] const char* quote_on_next_line(const char* begin, const char* end,
                                             char quote) noexcept {
    const char* const close = std::find(begin, end, quote);
    const std::string_view before(begin, static_cast<std::size_t>(close - begin));
    const bool closes = close != end && std::count(close, end, quote) % 2 == 1 &&
                        before.find_first_of(";=$") == before.npos && ends_operand_at(close + 1);
    return closes ? close : nullptr;
}

} // namespace

// A quote that nothing closes in its line, which ends at `end`: one too many in `x := y';`, or
// that of a string which the next line closes, or one with code behind its probable end. Null when
// it is none of these.
const char* Lexer::unclosed_string(const char* begin, const char* end) {
    note_open_end(begin, std::min(end + 1, end_)); // what follows may be of other units
    if (is_stray_quote(begin)) {
        Diagnostic& diagnostic =
            report(DiagnosticId::unexpected_character, range(begin, begin + 1));
        diagnostic.arguments.emplace_back(static_cast<char32_t>(*begin));
        add_replacement(diagnostic, range(begin, begin + 1));
        emit(TokenKind::unknown, begin, begin + 1, true);
        return begin + 1;
    }
    const char* const code = begin + 1 + literals::length_before_code(view(begin + 1, end));
    if (code != end)
        return literal(string_kind(begin), begin, code);
    const char* const next = end + (*end == '\r' && end[1] == '\n' ? 2 : 1);
    if (!is_line_end(*end) || view(begin, end).find(';') != std::string_view::npos)
        return nullptr;
    const char* const next_end = std::find_if(next, end_, is_line_end);
    result_.open_ends.back().looked_to = offset(next_end) + 1;
    const char* const close = quote_on_next_line(next, next_end, *begin);
    if (close == nullptr || static_cast<std::size_t>(close - begin) >= Token::maximum_length)
        return nullptr;
    Diagnostic& diagnostic = report(DiagnosticId::unterminated_string, range(begin, begin + 1));
    diagnostic.arguments.emplace_back(std::string{'`', *begin, '`'});
    add_replacement(diagnostic, range(end, Extents::blanks_end(next)), "$N");
    emit(string_kind(begin), begin, close + 1, true);
    return close + 1;
}

// Directly behind an operand, and before what can follow one.
bool Lexer::is_stray_quote(const char* begin) const {
    return has_tokens() && last_token().end() == offset(begin) &&
           !is_keyword(last_token().kind()) && ends_operand(last_token(), begin) &&
           ends_operand_at(begin + 1);
}

// The end of `'it's'`, when a word that is no keyword adjoins the string that ends at `end`, and
// the next quote on the line begins no other string; else null.
const char* Lexer::end_behind_inner_quote(const char* end) {
    constexpr std::ptrdiff_t furthest = 1000; // bounds the time that a line full of quotes takes
    const char quote = end[-1];
    if (!is_quote(quote) || !is_word_start(*end) ||
        keyword_kind(view(end, extents_.word_end(end))) != TokenKind::identifier)
        return nullptr;
    const char* const whole_end = extents_.string_end(end - 1);
    const char* p = whole_end; // up to where the line is looked at
    bool whole = whole_end[-1] == quote;
    for (; whole && p != end_ && !is_line_end(*p); ++p) {
        whole = p - end <= furthest;
        if (whole && *p == quote) {
            p = extents_.string_end(p) - 1;
            whole = *p == quote;
        }
    }
    note_open_end(end, p); // the rest of the line may be of other units
    return whole ? whole_end : nullptr;
}

} // namespace iecfront
