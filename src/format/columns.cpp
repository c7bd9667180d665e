#include "format/columns.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace iecfront::layout {
namespace {

constexpr std::size_t cell_count = 4;

[[nodiscard]] constexpr std::size_t index_of(Cell cell) noexcept {
    return static_cast<std::size_t>(cell);
}

/// The pieces of a line.
using Line = std::span<Piece>;

[[nodiscard]] std::vector<Line> lines_of(std::span<Piece> pieces) {
    std::vector<Line> lines;
    for (std::size_t begin = 0; begin < pieces.size();) {
        std::size_t end = begin + 1;
        while (end < pieces.size() && !pieces[end].begins_line)
            ++end;
        lines.push_back(pieces.subspan(begin, end - begin));
        begin = end;
    }
    return lines;
}

[[nodiscard]] const Piece* comment_behind(Line line) noexcept {
    for (const Piece& piece : line)
        if (piece.behind)
            return piece.pragma ? nullptr : &piece;
    return nullptr;
}

// Behind the code of a line.
[[nodiscard]] std::uint32_t end_of_code(Line line) noexcept {
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < line.size() && !line[i].behind; ++i)
        end = line[i].width + (line[i].several_lines ? 0 : line[i].column);
    return end;
}

void shift(Line line, Piece& first, std::uint32_t columns) {
    first.spaces += columns;
    for (Piece* piece = &first; piece != line.data() + line.size(); ++piece)
        piece->column += columns;
}

// ---- rows --------------------------------------------------------------------------------------

/// A line that holds one whole declaration or argument, or a case label and its statement.
struct Row {
    Line line;
    std::array<Piece*, cell_count> cells{};         ///< by `Cell`; null for one that is not there
    std::array<std::uint32_t, cell_count> widths{}; ///< from the cell before to this one
};

[[nodiscard]] Row row_of(Line line) {
    Row row{line};
    const Piece* before = &line.front();
    Cell last = Cell::none;
    for (Piece& piece : line) {
        if (piece.cell <= last || piece.brackets != line.front().brackets)
            continue;
        last = piece.cell;
        row.cells[index_of(last)] = &piece;
        row.widths[index_of(last)] = piece.column - before->column;
        before = &piece;
    }
    return row;
}

// One row, which the line behind it does not continue.
[[nodiscard]] bool is_row(Line line, const Piece* next) noexcept {
    const Piece& first = line.front();
    if (!first.row || std::ranges::any_of(line, &Piece::several_lines))
        return false;
    const bool alone = std::none_of(line.begin() + 1, line.end(), [&](const Piece& piece) {
        return piece.row && piece.brackets == first.brackets;
    });
    return alone && (next == nullptr || next->line_break == Break::line || next->row ||
                     next->is_comment() || closes_bracket(next->kind));
}

// A row of declarations begins anywhere, one of arguments behind the parenthesis.
[[nodiscard]] bool begins_section(Line line, const Piece* before) noexcept {
    return line.front().line_break == Break::line ||
           (before != nullptr && opens_bracket(before->kind));
}

[[nodiscard]] bool continues_section(const Row& section, Line line) noexcept {
    const Piece& above = section.line.front();
    const Piece& first = line.front();
    return !first.blank_line && first.column == above.column && first.brackets == above.brackets;
}

using Columns = std::array<std::uint32_t, cell_count>;

// Where each of the cells of `row` would stand, counted from the beginning of the line, if those
// before it stood in `columns`; 0 for one that is not there.
[[nodiscard]] Columns columns_behind(const Row& row, const Columns& columns) {
    Columns result{};
    std::uint32_t before = 0;
    for (std::size_t i = 0; i < cell_count; ++i) {
        if (row.cells[i] == nullptr)
            continue;
        result[i] = before + row.widths[i];
        before = std::max(columns[i], result[i]);
    }
    return result;
}

// One cell after the other, as each moves those behind it.
[[nodiscard]] Columns columns_of(std::span<const Row> rows) {
    Columns columns{};
    for (std::size_t i = 0; i < cell_count; ++i)
        for (const Row& row : rows)
            columns[i] = std::max(columns[i], columns_behind(row, columns)[i]);
    return columns;
}

void align_row(const Row& row, const Columns& columns, std::uint32_t line_length) {
    const Columns own = columns_behind(row, columns);
    std::uint32_t end = end_of_code(row.line);
    for (std::size_t i = 0; i < cell_count; ++i)
        end += row.cells[i] != nullptr ? columns[i] - own[i] : 0;
    if (end > line_length || std::ranges::any_of(row.line, &Piece::verbatim))
        return;
    for (std::size_t i = 0; i < cell_count; ++i)
        if (row.cells[i] != nullptr)
            shift(row.line, *row.cells[i], columns[i] - own[i]);
}

void align_rows(std::span<const Row> rows, std::uint32_t line_length) {
    const Columns columns = columns_of(rows);
    for (const Row& row : rows)
        align_row(row, columns, line_length);
}

void align_all_rows(std::span<const Line> lines, std::uint32_t line_length) {
    std::vector<Row> section;
    const auto end_section = [&] {
        align_rows(section, line_length);
        section.clear();
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool last = i + 1 == lines.size();
        if (lines[i].front().is_comment() && !lines[i].front().blank_line)
            continue; // stands above a row
        if (!is_row(lines[i], last ? nullptr : &lines[i + 1].front())) {
            end_section();
            continue;
        }
        if (!section.empty() && !continues_section(section.back(), lines[i]))
            end_section();
        const Piece* before = i == 0 ? nullptr : &lines[i - 1].back();
        if (!section.empty() || begins_section(lines[i], before))
            section.push_back(row_of(lines[i]));
    }
    end_section();
}

// ---- comments behind ---------------------------------------------------------------------------

// Where the comments behind all of these lines stand: where the user has put them all, if there is
// room, and else behind the longest line that is not too long.
[[nodiscard]] std::uint32_t column_of_comments(std::span<const Line> lines,
                                               std::uint32_t line_length) {
    std::uint32_t end = 0;
    std::uint32_t end_of_short = 0;
    for (const Line line : lines) {
        const std::uint32_t here = end_of_code(line);
        end = std::max(end, here);
        if (here <= line_length)
            end_of_short = std::max(end_of_short, here);
    }
    const std::uint32_t column = comment_behind(lines.front())->source_column;
    const bool same = std::ranges::all_of(
        lines, [&](Line line) { return comment_behind(line)->source_column == column; });
    return same && column != Piece::no_column && column > end
               ? column
               : end_of_short + blanks_before_comment;
}

void align_comments(std::span<const Line> lines, std::uint32_t line_length) {
    if (lines.empty())
        return;
    const std::uint32_t column = column_of_comments(lines, line_length);
    for (const Line line : lines) {
        Piece& comment = line[static_cast<std::size_t>(comment_behind(line) - line.data())];
        const std::uint32_t end = end_of_code(line);
        comment.spaces = column > end ? column - end : blanks_before_comment;
    }
}

void align_all_comments(std::span<const Line> lines, std::uint32_t line_length) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= lines.size(); ++i) {
        const Piece* comment = i < lines.size() ? comment_behind(lines[i]) : nullptr;
        if (comment != nullptr && !comment->verbatim && !lines[i].front().blank_line)
            continue;
        align_comments(lines.subspan(begin, i - begin), line_length);
        begin = comment != nullptr && !comment->verbatim ? i : i + 1;
    }
}

} // namespace

void align(std::span<Piece> pieces, std::uint32_t line_length) {
    const std::vector<Line> lines = lines_of(pieces);
    align_all_rows(lines, line_length);
    align_all_comments(lines, line_length);
}

} // namespace iecfront::layout
