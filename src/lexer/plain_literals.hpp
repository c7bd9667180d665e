#pragma once

#include <iecfront/lexer/token.hpp>

#include <cstddef>
#include <string_view>

namespace iecfront {

/// So many digits fit 64 bits and the range of every real type: nothing can be wrong with them.
inline constexpr std::size_t safe_digits = 18;

/// True for a literal of `kind` in one of the usual forms, of which no scanner would report
/// anything; told without them. False says nothing. `text` begins as such a literal does.
[[nodiscard]] bool is_plain_literal(TokenKind kind, std::string_view text) noexcept;

} // namespace iecfront
