#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/source/encoding.hpp>

#include <optional>
#include <string_view>

namespace iecfront {

/// Finds the first byte of `text` that is no part of a character, wherever it stands: in a name, a
/// string, a comment. Where one is, there are more, and for one reason; so the parser asks this
/// once a unit, and the lexer says nothing of broken bytes.
[[nodiscard]] std::optional<Diagnostic> check_encoding(std::string_view text, Encoding encoding);

} // namespace iecfront
