#pragma once

#include <iecfront/lexer/token.hpp>

#include <string_view>

namespace iecfront {

/// True for a literal of `kind` in one of the usual forms, of which no scanner would report
/// anything; told without them. False says nothing. `text` begins as such a literal does.
[[nodiscard]] bool is_plain_literal(TokenKind kind, std::string_view text) noexcept;

} // namespace iecfront
