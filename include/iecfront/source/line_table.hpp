#pragma once

#include <iecfront/export.hpp>
#include <iecfront/source/encoding.hpp>
#include <iecfront/source/text_range.hpp>

#include <cstdint>
#include <string_view>
#include <vector>

namespace iecfront {

/// What a column counts.
enum class ColumnUnit : std::uint8_t {
    bytes,       ///< of the text as it is encoded
    code_points, ///< characters of ISO/IEC 10646; a broken byte counts as one
    utf16_units, ///< as the Language Server Protocol counts; a broken byte counts as one
};

/// A place in a text. Both numbers are 1-based; a tab is one column.
struct Position {
    std::uint32_t line = 1;
    std::uint32_t column = 1; ///< in what `ColumnUnit` says where the position is made

    friend constexpr auto operator<=>(const Position&, const Position&) noexcept = default;
};

/// Number of line ends in `text`: LF, CR LF and CR each are one (A.1.1).
[[nodiscard]] IECFRONT_API std::uint32_t count_line_ends(std::string_view text) noexcept;

/// Where the lines of a text begin. LF, CR LF and CR each end a line (A.1.1). The table refers to
/// offsets only and does not keep the text.
class IECFRONT_API LineTable {
public:
    /// Of an empty text: one line.
    LineTable() = default;
    /// Of `text`, which is looked through twice.
    explicit LineTable(std::string_view text);
    /// The same, with columns of long lines noted here and there, so that to ask for many places of
    /// a giant line takes no longer than of short ones.
    LineTable(std::string_view text, Encoding encoding);

    /// Number of line ends in the text: 0 for a text of a single line.
    [[nodiscard]] std::uint32_t line_end_count() const noexcept {
        return static_cast<std::uint32_t>(starts_.size());
    }
    /// 0-based line that holds the byte at `offset`; an offset at the end of text belongs to the
    /// last line.
    [[nodiscard]] std::uint32_t line_of(std::uint32_t offset) const noexcept;
    /// Offset of the first byte of 0-based `line`; `line <= line_end_count()`.
    [[nodiscard]] std::uint32_t line_start(std::uint32_t line) const noexcept;
    /// Offset of the line end, or of the end of `text`; `text` is what the table was made of.
    [[nodiscard]] std::uint32_t line_end(std::string_view text, std::uint32_t line) const noexcept;

    /// A place in a line whose column is known.
    struct KnownColumn {
        std::uint32_t offset = 0; ///< where a character begins
        std::uint32_t column = 1; ///< 1-based, in code points
    };
    /// The last one noted at or before `offset` in its line: the start of the line, or a place
    /// further on.
    [[nodiscard]] KnownColumn known_column(std::uint32_t offset) const noexcept;

private:
    std::vector<std::uint32_t> starts_;      // of every line but the first
    std::vector<KnownColumn> known_columns_; // by offset, in long lines only
};

/// 1-based column of `offset` in the line that begins at `line_start`, both counted in `text`. An
/// offset inside a character has that character's column. A byte order mark at the start of `text`
/// takes no column, except in bytes: editors do not show it.
[[nodiscard]] IECFRONT_API std::uint32_t column_of(std::string_view text, std::uint32_t line_start,
                                                   std::uint32_t offset, Encoding encoding,
                                                   ColumnUnit unit) noexcept;

/// The inverse: the offset of 1-based `column` in that line. A column behind the end of the line
/// gives the offset of its line end, or of the end of text.
[[nodiscard]] IECFRONT_API std::uint32_t offset_of_column(std::string_view text,
                                                          std::uint32_t line_start,
                                                          std::uint32_t column, Encoding encoding,
                                                          ColumnUnit unit) noexcept;

} // namespace iecfront
