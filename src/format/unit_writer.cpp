#include "format/unit_writer.hpp"

#include "format/broken_lines.hpp"
#include "format/columns.hpp"
#include "format/line_end.hpp"
#include "format/lines.hpp"

#include <iecfront/ast/nodes.hpp>
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

void append_piece(std::string& out, const Piece& piece, KeywordCase keyword_case) {
    if (piece.word && !piece.verbatim)
        append_word(out, piece.text, keyword_case);
    else
        out += piece.text;
}

// A comment or pragma of several lines; the first one begins in `column`, and `furthest` is what
// `moved_indent` calls so.
void append_lines(std::string& out, const Piece& piece, std::uint32_t column,
                  std::uint32_t furthest, std::string_view line_end) {
    std::string_view rest = piece.text;
    for (bool first = true; !rest.empty(); first = false) {
        const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
        std::string_view line = rest.substr(0, end);
        if (!first) {
            const MovedIndent indent = moved_indent(piece, line, column, furthest);
            out.append(indent.blanks, ' ');
            out += indent.rest;
            line.remove_prefix(indent_of(line).size());
        }
        out += line;
        rest.remove_prefix(end);
        if (rest.empty())
            break;
        out += line_end;
        rest.remove_prefix(line_end_at(rest, 0).size());
    }
}

// Extensions by which nothing is read in another way, wherever lines end.
[[nodiscard]] bool is_harmless(const Diagnostic& diagnostic) {
    return diagnostic.id == DiagnosticId::line_comment ||
           diagnostic.id == DiagnosticId::c_comment ||
           diagnostic_info(diagnostic.id).category == DiagnosticClass::implementation_dependent;
}

// Nothing of the unit was read.
[[nodiscard]] bool is_refusal(const Diagnostic& diagnostic) {
    return diagnostic.id == DiagnosticId::source_too_large ||
           diagnostic.id == DiagnosticId::unit_too_large;
}

[[nodiscard]] bool same_tokens(const Unit& one, const Unit& other) {
    return std::ranges::equal(one.tokens(), other.tokens(), {}, &Token::kind, &Token::kind);
}

// The same tokens, no more findings, and the same nodes when there are no lines to keep.
[[nodiscard]] bool reads_as(const Unit& unit, const SyntaxTree& tree) {
    if (tree.slots().size() != 1)
        return false;
    const Unit& other = *tree.slots().front().unit;
    return same_tokens(unit, other) && other.diagnostics().size() <= unit.diagnostics().size() &&
           (!broken_lines(unit).empty() || ast::equal(unit.root(), other.root()));
}

[[nodiscard]] FormatOptions bounded(FormatOptions options) {
    options.indent_width = std::min(options.indent_width, FormatOptions::widest_indent);
    options.line_length = std::min(options.line_length, FormatOptions::longest_line);
    return options;
}

} // namespace

UnitWriter::UnitWriter(const SyntaxTree& tree, const FormatOptions& options)
    : tree_(tree), options_(bounded(options)), line_end_(line_end_of(tree)) {
    out_.reserve(tree.size() + tree.size() / 8);
}

bool UnitWriter::append(const Unit& unit, TextRule* rule) {
    const std::size_t begin = out_.size();
    if (std::ranges::any_of(unit.diagnostics(), is_refusal)) {
        out_ += unit.text();
        complete_ = true;
        return false;
    }
    lay_out(out_, unit, rule);
    complete_ = out_.size() <= begin + leading_mark_size(unit);
    if (std::ranges::all_of(unit.diagnostics(), is_harmless))
        return true;
    doubtful_ = true;
    if (is_read_alike(unit, std::string_view(out_).substr(begin), rule == nullptr))
        return true;
    out_.replace(begin, std::string::npos, unit.text());
    complete_ = true;
    return false;
}

std::optional<std::string> UnitWriter::finish() && {
    if (!complete_)
        out_ += line_end_;
    if (doubtful_ && !all_is_read_alike(out_))
        return std::nullopt;
    return std::move(out_);
}

// Where a unit begins and ends is guessed as well when something is wrong.
bool UnitWriter::all_is_read_alike(const std::string& text) const {
    const SyntaxTree tree = parse(SourceText(text, {}, tree_.encoding()), tree_.options());
    const auto same = [](const SyntaxTree::Slot& one, const SyntaxTree::Slot& other) {
        return same_tokens(*one.unit, *other.unit);
    };
    return std::ranges::equal(tree.slots(), tree_.slots(), same) &&
           tree.diagnostics().size() <= tree_.diagnostics().size();
}

void UnitWriter::lay_out(std::string& out, const Unit& unit, TextRule* rule) const {
    std::vector<Piece> pieces = pieces_of(unit, options_.indent_width, rule);
    break_lines(pieces, options_.indent_width, options_.line_length);
    align(pieces, options_.line_length);
    bool first_in_file = out.empty();
    if (rule == nullptr) // a byte order mark is nothing to write in ISO 646
        out += unit.text().substr(0, leading_mark_size(unit));
    const std::size_t begin = out.size();
    for (const Piece& piece : pieces) {
        if (piece.begins_line && !first_in_file)
            out += line_end_;
        if (piece.blank_line && !first_in_file)
            out += line_end_;
        first_in_file = false;
        if (piece.verbatim)
            out += last_line(piece.gap);
        else
            out.append(piece.spaces, ' ');
        if (piece.several_lines && !piece.verbatim) {
            const std::string_view line = last_line(std::string_view(out).substr(begin));
            const std::uint32_t column = width_of_last_line(line, unit.encoding());
            append_lines(out, piece, column, options_.line_length, line_end_);
        } else {
            append_piece(out, piece, options_.keyword_case);
        }
    }
}

// What is formatted has to be formatted already, besides.
bool UnitWriter::is_read_alike(const Unit& unit, std::string_view written, bool formatted) const {
    const SyntaxTree tree =
        parse(SourceText(std::string(written), {}, unit.encoding()), tree_.options());
    if (!reads_as(unit, tree))
        return false;
    if (!formatted)
        return true;
    const std::string_view before = written.starts_with(line_end_) ? "-" : "";
    std::string twice(before);
    lay_out(twice, *tree.slots().front().unit, nullptr);
    return std::string_view(twice).substr(before.size()) == written;
}

} // namespace iecfront::layout
