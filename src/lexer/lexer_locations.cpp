#include "lexer/lexer.hpp"
#include "lexer/lookahead.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <string_view>

namespace iecfront {

// `%X3` behind the point of `x.%X3`. Null when it is none.
const char* Lexer::part_selector(const char* begin) {
    constexpr std::string_view sizes = "XBWDL";
    if (!has_tokens() || last_token().kind() != TokenKind::dot ||
        sizes.find(fold(begin[1])) == std::string_view::npos || !is_digit(begin[2]))
        return nullptr;
    const char* const end = std::find_if_not(begin + 2, end_, is_digit);
    emit_any(TokenKind::part_selector, begin, end);
    return end;
}

const char* Lexer::location(const char* begin) {
    if (const char* const behind = operator_of_other_language(begin))
        return behind;
    if (const char* const part_end = part_selector(begin))
        return part_end;
    const char* const end = extents_.location_end(begin + 1);
    const char* const rest = Extents::gap_end(end);
    const TextRange gap = range(end, rest);
    const std::string_view letters = view(begin + 1, end);
    const TokenKind kind = letters.find('*') != std::string_view::npos
                               ? TokenKind::incomplete_location
                               : TokenKind::direct_variable;
    if (rest == end)
        return literal(kind, begin, end);
    if (letters.empty() && is_location(rest)) {
        const char* const rest_end = extents_.location_end(rest);
        return spaced_literal(rest_end[-1] == '*' ? TokenKind::incomplete_location : kind, begin,
                              rest_end, gaps_of({gap}));
    }
    // `%IX 1.0`: only behind what is a complete prefix, for digits to follow.
    if (!letters.empty() && letters.size() <= 2 && is_digit(*rest) &&
        std::ranges::all_of(letters, is_word_start))
        return spaced_literal(kind, begin, extents_.address_end(rest), gaps_of({gap}));
    return literal(kind, begin, end);
}

} // namespace iecfront
