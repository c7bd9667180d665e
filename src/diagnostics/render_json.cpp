#include "diagnostics/json_writer.hpp"
#include "diagnostics/place.hpp"
#include "source/utf8.hpp"

#include <iecfront/diagnostics/render_json.hpp>

#include <cstdint>

namespace iecfront {
namespace {

void append_escape(std::string& out, char32_t code_point) {
    out += "\\u";
    for (unsigned shift = 16; shift > 0;) {
        shift -= 4;
        out += "0123456789abcdef"[(code_point >> shift) & 0xFU];
    }
}

void append_json_character(std::string& out, char32_t code_point) {
    switch (code_point) {
    case U'"': out += "\\\""; return;
    case U'\\': out += "\\\\"; return;
    case U'\b': out += "\\b"; return;
    case U'\f': out += "\\f"; return;
    case U'\n': out += "\\n"; return;
    case U'\r': out += "\\r"; return;
    case U'\t': out += "\\t"; return;
    default: break;
    }
    // U+2028 and U+2029 end a line in JavaScript, where JSON is often pasted.
    if (code_point < 0x20 || code_point == 0x7F || code_point == 0x2028 || code_point == 0x2029)
        append_escape(out, code_point);
    else
        append_utf8(out, code_point);
}

class DiagnosticWriter {
public:
    DiagnosticWriter(std::string& out, const SourceText& source, const LineTable& lines)
        : out_(out), source_(source), lines_(lines) {}

    void write(const Diagnostic& diagnostic, Severity severity) {
        const DiagnosticInfo& row = diagnostic_info(diagnostic.id);
        JsonObject object(out_);
        object.member("file", source_.name());
        write_place(object, diagnostic.range);
        object.member("code", code_string(diagnostic.id));
        object.member("name", row.name);
        object.member("severity", to_string(severity));
        object.member("class", to_string(row.category));
        object.member("clause", row.clause);
        object.member("message", message(diagnostic, source_.encoding()));
        if (row.annex_e_row != 0)
            object.member("annexE", std::uint32_t{row.annex_e_row});
        object.name("labels");
        append_array(out_, diagnostic.labels, [&](const auto& label) { write_label(label); });
        object.name("fixes");
        append_array(out_, diagnostic.fixes, [&](const auto& fix) { write_fix(fix); });
        object.close();
    }

private:
    void write_place(JsonObject& object, TextRange range) {
        const TextRange within = range_within(range, source_);
        const Position begin = position_of(within.begin, source_, lines_);
        const Position end = within.empty() ? begin : position_of(within.end, source_, lines_);
        object.member("line", begin.line);
        object.member("column", begin.column);
        object.member("endLine", end.line);
        object.member("endColumn", end.column);
        object.member("offset", source_.origin().offset + within.begin);
        object.member("endOffset", source_.origin().offset + within.end);
    }

    void write_label(const DiagnosticLabel& label) {
        JsonObject object(out_);
        write_place(object, label.range);
        object.member("message", message(label, source_.encoding()));
        object.close();
    }

    void write_fix(const DiagnosticFix& fix) {
        JsonObject object(out_);
        object.member("description", description(fix, source_.bytes(), source_.encoding()));
        object.name("edits");
        append_array(out_, fix.edits, [&](const auto& edit) { write_edit(edit); });
        object.close();
    }

    void write_edit(const TextEdit& edit) {
        const TextRange within = range_within(edit.range, source_);
        JsonObject object(out_);
        object.member("offset", source_.origin().offset + within.begin);
        object.member("endOffset", source_.origin().offset + within.end);
        object.name("text");
        append_json_string(out_, edit.replacement, source_.encoding());
        object.close();
    }

    std::string& out_;
    const SourceText& source_;
    const LineTable& lines_;
};

} // namespace

void append_json_string(std::string& out, std::string_view text) {
    append_json_string(out, text, Encoding::utf8);
}

void append_json_string(std::string& out, std::string_view text, Encoding encoding) {
    out += '"';
    for (std::size_t at = 0; at < text.size();) {
        const DecodedCharacter character = decode_character(text, at, encoding);
        append_json_character(out, character.valid ? character.code_point : U'\uFFFD');
        at += character.size;
    }
    out += '"';
}

bool render_json(std::string& out, const Diagnostic& diagnostic, Severity severity,
                 const SourceText& source, const LineTable& lines) {
    if (severity == Severity::allow)
        return false;
    DiagnosticWriter(out, source, lines).write(diagnostic, severity);
    return true;
}

} // namespace iecfront
