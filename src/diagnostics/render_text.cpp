#include "diagnostics/place.hpp"
#include "diagnostics/visible.hpp"
#include "source/utf8.hpp"

#include <iecfront/diagnostics/render_text.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace iecfront {
namespace {

// A longer line is cut to a window of so many columns, so that the carets stay in sight.
constexpr std::size_t window_width = 100;
// A line is shown from its start when the range begins within so many columns of it.
constexpr std::size_t longest_lead = 80;
// Otherwise so many columns are shown before the range.
constexpr std::size_t usual_lead = 40;
// A tab is as wide as so many columns wherever it stands: a window need not know what is before it.
constexpr std::size_t tab_width = 4;

constexpr std::string_view gap = "...";

/// One line as it is shown, and what stands under it.
struct Snippet {
    std::string text;   // UTF-8
    std::string carets; // spaces and `^`, one for each column of the text
};

/// Builds the snippet for what a range marks in its first line.
class SnippetBuilder {
public:
    SnippetBuilder(const SourceText& source, const LineTable& lines, TextRange range)
        : text_(source.bytes()), encoding_(source.encoding()), range_(range) {
        const std::uint32_t line = lines.line_of(range.begin);
        line_begin_ = lines.line_start(line);
        if (line == 0)
            line_begin_ += byte_order_mark_size(text_, encoding_);
        line_end_ = lines.line_end(text_, line);
        range_.begin = std::clamp(range_.begin, line_begin_, std::max(line_begin_, line_end_));
        range_.end = std::clamp(range_.end, range_.begin, std::max(range_.begin, line_end_));
    }

    [[nodiscard]] Snippet build() {
        std::size_t at = window_begin();
        if (at > line_begin_)
            append_gap();
        const std::size_t limit = columns_ + window_width;
        while (at < line_end_ && columns_ < limit)
            at += append_character(at);
        if (!marked_)
            snippet_.carets += '^'; // something is missing at the end of the line
        if (at < line_end_)
            append_gap();
        snippet_.carets.erase(snippet_.carets.find_last_of('^') + 1);
        return std::move(snippet_);
    }

private:
    // Where the part that is shown begins. Counts backwards from the range and never from the start
    // of the line, which may be the whole of a large file.
    [[nodiscard]] std::size_t window_begin() const noexcept {
        if (back_from_range(longest_lead) == line_begin_)
            return line_begin_;
        return back_from_range(usual_lead);
    }

    [[nodiscard]] std::size_t back_from_range(std::size_t columns) const noexcept {
        std::size_t at = range_.begin;
        while (at > line_begin_) {
            const std::size_t before = previous(at);
            const std::size_t width = text_[before] == '\t' ? tab_width : 1;
            if (width > columns)
                break;
            columns -= width;
            at = before;
        }
        return at;
    }

    // Where the character that ends at `at` begins.
    [[nodiscard]] std::size_t previous(std::size_t at) const noexcept {
        for (std::size_t size = 2; size <= 4 && size <= at - line_begin_; ++size)
            if (decode_character(text_, at - size, encoding_).size == size)
                return at - size;
        return at - 1;
    }

    void append_gap() {
        snippet_.text += gap;
        snippet_.carets.append(gap.size(), ' ');
        columns_ += gap.size();
    }

    // Appends the character at `at` and gives its size in bytes.
    std::size_t append_character(std::size_t at) {
        const DecodedCharacter character = decode_character(text_, at, encoding_);
        const std::size_t width = text_[at] == '\t' ? tab_width : 1;
        if (text_[at] == '\t')
            snippet_.text.append(tab_width, ' ');
        else
            append_utf8(snippet_.text, character.valid ? shown(character.code_point) : U'\uFFFD');
        append_carets(at, at + character.size, width);
        columns_ += width;
        return character.size;
    }

    void append_carets(std::size_t begin, std::size_t end, std::size_t width) {
        const bool inside = begin < range_.end && range_.begin < end;
        const bool at_point = range_.empty() && begin <= range_.begin && range_.begin < end;
        marked_ = marked_ || inside || at_point;
        const std::size_t carets = inside ? width : at_point ? 1U : 0U;
        snippet_.carets.append(carets, '^');
        snippet_.carets.append(width - carets, ' ');
    }

    // A character of one column in the place of one that cannot be seen: for control characters
    // those that Unicode has as their pictures.
    [[nodiscard]] static char32_t shown(char32_t code_point) noexcept {
        if (code_point < 0x20)
            return 0x2400 + code_point;
        if (code_point == 0x7F)
            return 0x2421;
        return is_visible(code_point) ? code_point : U'\uFFFD';
    }

    std::string_view text_;
    Encoding encoding_;
    TextRange range_; // cut to its first line
    std::uint32_t line_begin_ = 0;
    std::uint32_t line_end_ = 0;
    std::size_t columns_ = 0;
    bool marked_ = false;
    Snippet snippet_;
};

// ANSI escape sequences.
constexpr std::string_view bold = "\x1B[1m";
constexpr std::string_view red = "\x1B[1;31m";
constexpr std::string_view green = "\x1B[1;32m";
constexpr std::string_view blue = "\x1B[34m";
constexpr std::string_view magenta = "\x1B[1;35m";
constexpr std::string_view cyan = "\x1B[1;36m";
constexpr std::string_view plain = "\x1B[0m";

/// Writes one diagnostic.
class TextWriter {
public:
    TextWriter(std::string& out, const SourceText& source, const LineTable& lines,
               const TextStyle& style)
        : out_(out), source_(source), lines_(lines), style_(style) {}

    void write(const Diagnostic& diagnostic, Severity severity) {
        gutter_width_ = gutter_width(diagnostic);
        write_place(diagnostic.range);
        coloured(severity == Severity::error ? red : magenta, to_string(severity));
        out_ += ' ';
        coloured(bold, code_string(diagnostic.id));
        out_ += ": ";
        out_ += message(diagnostic, source_.encoding());
        out_ += '\n';
        if (!style_.snippet)
            return;
        write_snippet(diagnostic.range);
        for (const DiagnosticLabel& label : diagnostic.labels)
            write_label(label);
        if (!diagnostic.fixes.empty())
            write_help(description(diagnostic.fixes.front(), source_.bytes(), source_.encoding()));
        const DiagnosticInfo& row = diagnostic_info(diagnostic.id);
        // The one error of Annex E that can be taken for an extension.
        const bool extension =
            row.category == DiagnosticClass::extension || row.id == DiagnosticId::nested_comment;
        if (extension && severity == Severity::error)
            write_help("`--allow " + std::string(row.name) + "` takes this extension");
    }

private:
    void write_label(const DiagnosticLabel& label) {
        write_place(label.range);
        coloured(cyan, "note");
        out_ += ": ";
        out_ += message(label, source_.encoding());
        out_ += '\n';
        write_snippet(label.range);
    }

    void write_help(std::string_view words) {
        coloured(cyan, "help");
        out_ += ": ";
        out_ += words;
        out_ += '\n';
    }

    // `file:line:column: `
    void write_place(TextRange range) {
        const Position position = position_of(range_within(range, source_).begin, source_, lines_);
        std::string place;
        append_file_name(place);
        place += ':' + std::to_string(position.line) + ':' + std::to_string(position.column) + ':';
        coloured(bold, place);
        out_ += ' ';
    }

    // A file is opened by its exact bytes, so only what would disturb a terminal is changed.
    void append_file_name(std::string& place) const {
        if (source_.name().empty())
            place += "<text>";
        for (const char c : source_.name()) {
            const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
            place += control ? '?' : c;
        }
    }

    void write_snippet(TextRange range) {
        if (source_.bytes().empty())
            return;
        const TextRange within = range_within(range, source_);
        const Snippet snippet = SnippetBuilder(source_, lines_, within).build();
        write_gutter(std::to_string(lines_.line_of(within.begin) + source_.origin().line));
        if (!snippet.text.empty())
            out_ += ' ' + snippet.text;
        out_ += '\n';
        write_gutter("");
        out_ += ' ';
        coloured(green, snippet.carets);
        out_ += '\n';
    }

    void write_gutter(std::string_view number) {
        std::string gutter(gutter_width_ - number.size(), ' ');
        gutter += number;
        gutter += " |";
        coloured(blue, gutter);
    }

    // As wide as the largest line number shown, and two spaces before it.
    [[nodiscard]] std::size_t gutter_width(const Diagnostic& diagnostic) const {
        std::uint32_t last = lines_.line_of(range_within(diagnostic.range, source_).begin);
        for (const DiagnosticLabel& label : diagnostic.labels)
            last = std::max(last, lines_.line_of(range_within(label.range, source_).begin));
        return 2 + std::to_string(std::uint64_t{last} + source_.origin().line).size();
    }

    void coloured(std::string_view colour, std::string_view text) {
        if (style_.colour)
            out_ += colour;
        out_ += text;
        if (style_.colour)
            out_ += plain;
    }

    std::string& out_;
    const SourceText& source_;
    const LineTable& lines_;
    const TextStyle& style_;
    std::size_t gutter_width_ = 0;
};

} // namespace

void render_text(std::string& out, const Diagnostic& diagnostic, Severity severity,
                 const SourceText& source, const LineTable& lines, const TextStyle& style) {
    if (severity != Severity::allow)
        TextWriter(out, source, lines, style).write(diagnostic, severity);
}

std::string render_text(std::span<const Diagnostic> diagnostics, const SourceText& source,
                        const SeverityPolicy& policy, const TextStyle& style) {
    std::string out;
    const LineTable lines(source.bytes(), source.encoding());
    for (const Diagnostic& diagnostic : diagnostics)
        render_text(out, diagnostic, policy.severity(diagnostic.id), source, lines, style);
    return out;
}

} // namespace iecfront
