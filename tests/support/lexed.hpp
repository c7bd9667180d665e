#pragma once

#include "lexer/lexer.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>

#include <string>
#include <string_view>
#include <vector>

// What the tests of the lexer share. Each of these reads `text`, checks the invariants of what
// comes of it (`tiling_fault`), and shows one side of it as words.
namespace iecfront::test {

// `identifier(a) assign(:=) real!(1.)`: `!` marks a malformed one; end_of_unit is left out.
std::string tokens(std::string_view text, Encoding encoding = Encoding::utf8);

// The kinds alone: `identifier assign real`.
std::string kinds(std::string_view text, Encoding encoding = Encoding::utf8);

// The tokens that are first on their line, by their text.
std::string line_starts(std::string_view text);

// `comment(0..5) pragma(6..9)`.
std::string trivia(std::string_view text);

// `1310@3..4`, in order; extensions and pragmas included.
std::string faults(std::string_view text, Encoding encoding = Encoding::utf8);

// `text` after the first fix-it of every diagnostic.
std::string fixed(std::string_view text);

} // namespace iecfront::test
