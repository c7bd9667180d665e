#include "lexer/keywords.hpp"

#include <algorithm>

namespace iecfront {

// The table is indexed by TokenKind: keywords come first in tokens.def.
static_assert(static_cast<std::size_t>(TokenKind::kw_eno) + 1 == keywords::spellings.size());
static_assert(keywords::spellings.size() <= 0xFF); // so many a slot can tell apart

// Words of letters and underscores only: the lexer takes no others for keywords.
static_assert(std::ranges::all_of(keywords::spellings, [](std::string_view word) {
    return std::ranges::all_of(word, [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; });
}));

bool keywords::ends_alike(std::string_view word, std::uint8_t index) noexcept {
    return names_equal(word.substr(head_size), spellings[index].substr(head_size));
}

// In text that is no word, what is folded alike need not be the same: DEL differs from `_` in the
// bit that tells small letters from capitals.
TokenKind keyword_kind(std::string_view word) noexcept {
    const TokenKind kind = keyword_kind(word, keywords::head_of(word));
    const bool same = kind == TokenKind::identifier ||
                      names_equal(word, keywords::spellings[static_cast<std::size_t>(kind)]);
    return same ? kind : TokenKind::identifier;
}

} // namespace iecfront
