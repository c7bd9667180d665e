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
    /// Where the comments and pragmas begin, in order, whose end depended on everything up to the
    /// end of the text, as that of a comment does that nothing closes; and the ends of strings that
    /// a word adjoins. An edit behind such a place can change what stands before the edit.
    std::vector<std::uint32_t> open_ended;
};

/// Reads `text`, which a zero byte must follow. Never fails: tokens, trivia and the white space
/// between them give back every byte.
/// `at_file_start` is false for a text that goes on in the middle of a line: no byte order mark can
/// stand there, and its first token is not the first on its line.
[[nodiscard]] LexedText lex(std::string_view text, Encoding encoding, bool at_file_start = true);

} // namespace iecfront
