#pragma once

#include "format/pieces.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/format/formatter.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace iecfront::layout {

/// Writes the units of a tree one behind another. The tree and the options outlive it.
class UnitWriter {
public:
    UnitWriter(const SyntaxTree& tree, const FormatOptions& options);

    /// Appends `unit` in the agreed layout, without a line end behind it, and with the texts that
    /// `rule` gives; it may be null. What cannot be read is guessed by its layout as well: when
    /// the unit would be read in another way, it is appended as it was. Gives false then.
    bool append(const Unit& unit, TextRule* rule);

    /// All that was appended, with a line end behind the last line. Nothing when the tree as a
    /// whole would be read in another way.
    [[nodiscard]] std::optional<std::string> finish() &&;

private:
    void lay_out(std::string& out, const Unit& unit, TextRule* rule) const;
    [[nodiscard]] bool is_read_alike(const Unit& unit, std::string_view written,
                                     bool formatted) const;
    [[nodiscard]] bool all_is_read_alike(const std::string& text) const;

    const SyntaxTree& tree_;
    FormatOptions options_;
    std::string_view line_end_;
    std::string out_;
    bool complete_ = true;  // no line end belongs behind the last unit
    bool doubtful_ = false; // a unit could be read in another way
};

} // namespace iecfront::layout
