#include "lexer/keywords.hpp"

#include <algorithm>

namespace iecfront {

// The table is indexed by TokenKind: keywords come first in tokens.def.
static_assert(static_cast<std::size_t>(TokenKind::kw_eno) + 1 == keywords::spellings.size());
static_assert(keywords::spellings.size() < keywords::empty_slot);

static_assert(std::ranges::all_of(keywords::spellings, [](std::string_view word) {
    return word.size() >= keywords::shortest && word.size() <= keywords::longest;
}));

// Words of letters and underscores only: `key` folds nothing else right.
static_assert(std::ranges::all_of(keywords::spellings, [](std::string_view word) {
    return std::ranges::all_of(word, [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; });
}));

} // namespace iecfront
