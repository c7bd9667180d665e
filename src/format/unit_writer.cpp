#include "format/unit_writer.hpp"

#include "format/columns.hpp"
#include "format/lines.hpp"

#include <iecfront/lexer/name.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <cstddef>

namespace iecfront::layout {
namespace {

[[nodiscard]] char in_lower_case(char c) noexcept {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

void append_word(std::string& out, std::string_view word, KeywordCase keyword_case) {
    switch (keyword_case) {
    case KeywordCase::upper: std::ranges::transform(word, std::back_inserter(out), fold); break;
    case KeywordCase::lower:
        std::ranges::transform(word, std::back_inserter(out), in_lower_case);
        break;
    case KeywordCase::keep: out += word; break;
    }
}

// The gap of a piece that stays as it is, without the line ends before it.
[[nodiscard]] std::string_view last_line(std::string_view gap) noexcept {
    const std::size_t line_end = gap.find_last_of("\r\n");
    return line_end == std::string_view::npos ? gap : gap.substr(line_end + 1);
}

void append(std::string& out, const Piece& piece, KeywordCase keyword_case) {
    if (piece.verbatim)
        out += last_line(piece.gap);
    else
        out.append(piece.spaces, ' ');
    if (piece.word && !piece.verbatim)
        append_word(out, piece.text, keyword_case);
    else
        out += piece.text;
}

} // namespace

std::string_view line_end_of(const SyntaxTree& tree) {
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        const std::string_view text = slot.unit->text();
        const std::size_t found = text.find_first_of("\r\n");
        if (found == std::string_view::npos)
            continue;
        if (text[found] == '\n')
            return "\n";
        return found + 1 < text.size() && text[found + 1] == '\n' ? "\r\n" : "\r";
    }
    return "\n";
}

void write_unit(std::string& out, const Unit& unit, std::string_view line_end,
                const FormatOptions& options, TextRule* rule) {
    std::vector<Piece> pieces = pieces_of(unit, options.indent_width, rule);
    break_lines(pieces, options.indent_width, options.line_length);
    align(pieces, options.line_length);
    bool first_in_file = out.empty();
    if (rule == nullptr) // a byte order mark is nothing to write in ISO 646
        out += unit.text().substr(0, leading_mark_size(unit));
    for (const Piece& piece : pieces) {
        if (piece.begins_line && !first_in_file)
            out += line_end;
        if (piece.blank_line && !first_in_file)
            out += line_end;
        first_in_file = false;
        append(out, piece, options.keyword_case);
    }
}

bool reads_as(const Unit& unit, std::string_view written, const ParseOptions& options) {
    const SyntaxTree tree = parse(SourceText(std::string(written), {}, unit.encoding()), options);
    std::size_t token = 0;
    std::size_t findings = 0;
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        findings += slot.unit->diagnostics().size();
        for (const Token other : slot.unit->tokens())
            if (token == unit.tokens().size() || unit.tokens()[token++].kind() != other.kind())
                return false;
    }
    return token == unit.tokens().size() && findings <= unit.diagnostics().size();
}

} // namespace iecfront::layout
