#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/lexer/token.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// What is wrong with the faults and the value of `text` as a literal of this kind, in words; empty
/// when nothing is: faults are ordered and lie inside, fix-its do not overlap, and no value comes
/// of a violation, except for one that its `overflow` tells of.
[[nodiscard]] std::string literal_fault(TokenKind kind, std::string_view text, Encoding encoding);

/// Whether the value function of the kind gives one.
[[nodiscard]] bool has_value(TokenKind kind, std::string_view text, Encoding encoding);

/// The first fix of each diagnostic, all together, by position.
[[nodiscard]] std::vector<TextEdit> first_fixes(const std::vector<Diagnostic>& faults);

} // namespace iecfront::test
