#pragma once

#include "format/pieces.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/format/formatter.hpp>

#include <string>
#include <string_view>

namespace iecfront::layout {

/// The line end of the first line of `tree`; LF when there is none.
[[nodiscard]] std::string_view line_end_of(const SyntaxTree& tree);

/// Appends `unit` in the agreed layout to `out`, without a line end behind it.
void write_unit(std::string& out, const Unit& unit, std::string_view line_end,
                const FormatOptions& options, TextRule* rule);

/// True when `written` has the tokens of `unit` and no more faults.
[[nodiscard]] bool reads_as(const Unit& unit, std::string_view written,
                            const ParseOptions& options);

} // namespace iecfront::layout
