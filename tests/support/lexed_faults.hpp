#pragma once

#include "lexer/lexer.hpp"

#include <string>
#include <string_view>

namespace iecfront::test {

/// What breaks the invariants of lexed text: tokens and trivia are ordered, do not overlap, leave
/// only white space between them, and end in one end_of_unit; ranges of diagnostics lie in the text
/// and are ordered. Empty when all is well.
[[nodiscard]] std::string tiling_fault(std::string_view text, const LexedText& lexed,
                                       Encoding encoding);

} // namespace iecfront::test
