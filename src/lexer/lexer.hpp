#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/lexer/token.hpp>
#include <iecfront/source/encoding.hpp>

#include <string_view>
#include <vector>

namespace iecfront {

/// What the lexer makes of a text. All positions count from the start of that text.
struct LexedText {
    std::vector<Token> tokens; // ends in one end_of_unit token of length 0 at the end of the text
    std::vector<Trivia> trivia;
    std::vector<Diagnostic> diagnostics; // ordered by position
    /// The first offset whose treatment depended on everything up to the end of the text (a comment
    /// that nothing closes); the text's size when there is none. An edit behind it can change what
    /// stands before the edit.
    std::uint32_t depends_on_rest_from = 0;
};

/// Reads `text`, which a zero byte must follow. Never fails: tokens, trivia and the white space
/// between them give back every byte.
/// `at_file_start` is false for a text that goes on in the middle of a line: no byte order mark can
/// stand there, and its first token is not the first on its line.
[[nodiscard]] LexedText lex(std::string_view text, Encoding encoding, bool at_file_start = true);

} // namespace iecfront
