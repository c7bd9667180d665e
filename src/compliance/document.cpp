#include "compliance/document.hpp"

#include <algorithm>

namespace iecfront {
namespace {

constexpr std::size_t line_width = 100;
// What is longer goes on in the next line of its cell.
constexpr std::size_t cell_width = 44;
constexpr std::string_view between_columns = "  ";

// `text` in lines of at most `width` characters, unless a word alone is longer.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
    std::vector<std::string> lines(1);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width)
            lines.emplace_back();
        lines.back() += lines.back().empty() ? "" : " ";
        lines.back() += word;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

void append_wrapped(std::string& out, std::string_view text, std::string_view first_mark) {
    std::string_view mark = first_mark;
    const std::string indentation(first_mark.size(), ' ');
    for (const std::string& line : wrapped(text, line_width - first_mark.size())) {
        out.append(mark).append(line) += '\n';
        mark = indentation;
    }
}

/// Writes what both forms have in common.
struct Writer {
    std::string& out;

    void operator()(const Paragraph& paragraph) const { append_wrapped(out, paragraph.text, ""); }
    void operator()(const BulletList& list) const {
        for (const std::string& item : list.items)
            append_wrapped(out, item, "- ");
    }
};

// ---- plain text ------------------------------------------------------------------------------

using Row = std::vector<std::string>;

[[nodiscard]] std::vector<std::size_t> widths_of(const Table& table) {
    std::vector<std::size_t> widths(table.columns.size());
    for (std::size_t column = 0; column < widths.size(); ++column) {
        widths[column] = table.columns[column].size();
        for (const Row& row : table.rows)
            widths[column] = std::max(widths[column], std::min(row[column].size(), cell_width));
    }
    return widths;
}

void append_padded(std::string& out, const std::vector<std::string>& cells,
                   const std::vector<std::size_t>& widths) {
    std::string line;
    for (std::size_t column = 0; column < cells.size(); ++column) {
        line += column == 0 ? std::string_view() : between_columns;
        line += cells[column];
        line.append(widths[column] - std::min(widths[column], cells[column].size()), ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
}

void append_row(std::string& out, const Row& row, const std::vector<std::size_t>& widths) {
    std::vector<std::vector<std::string>> cells;
    std::size_t height = 0;
    for (std::size_t column = 0; column < row.size(); ++column) {
        cells.push_back(wrapped(row[column], widths[column]));
        height = std::max(height, cells.back().size());
    }
    for (std::size_t line = 0; line < height; ++line) {
        Row parts;
        for (const std::vector<std::string>& cell : cells)
            parts.push_back(line < cell.size() ? cell[line] : std::string());
        append_padded(out, parts, widths);
    }
}

struct TextWriter : Writer {
    using Writer::operator();

    void operator()(const Heading& heading) const {
        constexpr std::string_view marks = "=-.";
        const char mark = marks[std::min(heading.level, marks.size()) - 1];
        out += heading.text + '\n' + std::string(heading.text.size(), mark) + '\n';
    }

    void operator()(const Table& table) const {
        const std::vector<std::size_t> widths = widths_of(table);
        append_padded(out, table.columns, widths);
        Row rules;
        for (const std::size_t width : widths)
            rules.emplace_back(width, '-');
        append_padded(out, rules, widths);
        for (const Row& row : table.rows)
            append_row(out, row, widths);
    }
};

// ---- Markdown --------------------------------------------------------------------------------

struct MarkdownWriter : Writer {
    using Writer::operator();

    void operator()(const Heading& heading) const {
        out += std::string(heading.level, '#') + ' ' + heading.text + '\n';
    }

    void operator()(const Table& table) const {
        append_cells(table.columns);
        out += '|';
        for (std::size_t column = 0; column < table.columns.size(); ++column)
            out += " --- |";
        out += '\n';
        for (const Row& row : table.rows)
            append_cells(row);
    }

    void append_cells(const Row& row) const {
        out += '|';
        for (const std::string& cell : row)
            out += cell.empty() ? std::string(" |") : ' ' + cell + " |";
        out += '\n';
    }
};

template<class BlockWriter>
[[nodiscard]] std::string written(const Document& document) {
    std::string out;
    for (const auto& block : document) {
        out += out.empty() ? "" : "\n";
        std::visit(BlockWriter{{out}}, block);
    }
    return out;
}

} // namespace

std::string plain_text(const Document& document) {
    return written<TextWriter>(document);
}

std::string markdown(const Document& document) {
    return written<MarkdownWriter>(document);
}

} // namespace iecfront
