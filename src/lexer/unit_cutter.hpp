#pragma once

#include <iecfront/lexer/token.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace iecfront {

/// A unit as a stretch of a token row: one library element declaration and the trivia before it.
struct UnitCut {
    std::uint32_t end_token; // one past its last token
    std::uint32_t opener;    // the word that opens the declaration; end_token when there is none
};

/// Cuts the tokens of a file (the last one is end_of_unit) into units, by a table of which word
/// closes which and which openers may stand inside which. At least one cut is given; the last one
/// ends before end_of_unit. A unit begins where the one before it ends, at the end of its last
/// token; the last unit takes the rest of the text.
[[nodiscard]] std::vector<UnitCut> cut_units(std::span<const Token> tokens);

} // namespace iecfront
