#pragma once

#include <iecfront/ast/unit.hpp>

#include <cstdint>
#include <vector>

// Where the tokens of a unit stand in the agreed layout. What a construct looks like is said by
// the functions of layout.cpp, one for each kind of node; everything behind them works on pieces
// (pieces.hpp) and knows nothing of nodes.
namespace iecfront::layout {

/// What is aligned with the lines above and below.
enum class Cell : std::uint8_t { none, location, colon, value };

/// How one token stands.
struct TokenLayout {
    std::int32_t level = 0;     ///< the column of a line that begins with it
    bool space = true;          ///< a blank before it, when it does not begin a line
    bool begins_line = false;   ///< always
    bool stays_on_line = false; ///< never begins a line, whatever is said otherwise
    bool blank_before = false;  ///< an empty line above it
    bool may_break = false;     ///< a long line can be broken before it, and the user may
    std::uint8_t rank = 0;      ///< of such a break among those between the same brackets: 0 first
    bool in_instructions = false; ///< begins a line exactly where it does in the source
    std::int8_t stop = -1;        ///< behind its level, at least; -1 for none
    bool word = false;            ///< spelt as `KeywordCase` says
    bool closes = false;          ///< a closing word, or one between two parts, such as ELSE
    bool row = false;             ///< begins what is aligned with its like above and below
    Cell cell = Cell::none;
};

/// One for each token of `unit`. `indent_width` is what `FormatOptions` has.
[[nodiscard]] std::vector<TokenLayout> lay_out(const Unit& unit, std::uint32_t indent_width);

} // namespace iecfront::layout
