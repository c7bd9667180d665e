#pragma once

#include <iecfront/source/line_table.hpp>
#include <iecfront/source/source_text.hpp>
#include <iecfront/source/text_range.hpp>

#include <algorithm>

namespace iecfront {

/// `range` cut to what `source` holds.
[[nodiscard]] inline TextRange range_within(TextRange range, const SourceText& source) noexcept {
    const auto size = static_cast<std::uint32_t>(source.bytes().size());
    const std::uint32_t begin = std::min(range.begin, size);
    return {begin, std::clamp(range.end, begin, size)};
}

/// Line and column of `offset` as people count them: in characters. For a piece of a file they are
/// those in the file.
[[nodiscard]] inline Position position_of(std::uint32_t offset, const SourceText& source,
                                          const LineTable& lines) noexcept {
    const std::uint32_t line = lines.line_of(offset);
    const LineTable::KnownColumn known = lines.known_column(offset);
    const std::uint32_t column =
        known.column - 1 +
        column_of(source.bytes(), known.offset, offset, source.encoding(), ColumnUnit::code_points);
    return {line + source.origin().line, line == 0 ? column + source.origin().column - 1 : column};
}

} // namespace iecfront
