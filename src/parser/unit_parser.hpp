#pragma once

#include "lexer/lexer.hpp"
#include "lexer/unit_cutter.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/ast/unit.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront {

/// A stretch of text that was lexed and cut, to be parsed unit by unit.
struct LexedUnits {
    std::shared_ptr<const std::string> buffer; // all of it is the stretch
    Encoding encoding = Encoding::utf8;
    LexedText lexed;
    std::vector<UnitCut> cuts;

    [[nodiscard]] std::uint32_t size() const noexcept {
        return static_cast<std::uint32_t>(buffer->size());
    }
    /// Offset where the unit ends that `cuts[index]` ends.
    [[nodiscard]] std::uint32_t unit_end(std::size_t index) const noexcept;
    /// End of the token before `end_token` with the comments and pragmas that begin on its line,
    /// unless `end_token` stands there as well: then they are taken to speak of that.
    [[nodiscard]] std::uint32_t end_on_line(std::uint32_t end_token) const noexcept;
};

/// Lexes and cuts; a fragment is one unit. `at_file_start` says whether the stretch begins a file:
/// a byte order mark can stand there, and its first token is the first on its line.
[[nodiscard]] LexedUnits lex_units(std::shared_ptr<const std::string> buffer, Encoding encoding,
                                   bool at_file_start, FragmentKind read_as);

/// True when a diagnostic of the lexer at `range` concerns what stands before `end`, where a unit
/// ends. An empty range marks the place behind a token where something is missing.
[[nodiscard]] bool belongs_before(TextRange range, std::uint32_t end) noexcept;

/// Parses all units of the stretch, in order.
[[nodiscard]] std::vector<std::shared_ptr<const Unit>> parse_units(const LexedUnits& source,
                                                                   const ParseOptions& options);

} // namespace iecfront
