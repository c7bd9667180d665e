#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/export.hpp>
#include <iecfront/source/line_table.hpp>
#include <iecfront/source/source_text.hpp>

#include <string>
#include <string_view>

namespace iecfront {

/// Appends `text` to `out` as a JSON string with its quotes. Bytes that are not UTF-8 become
/// U+FFFD, so that the result is always well-formed.
IECFRONT_API void append_json_string(std::string& out, std::string_view text);

/// The same for text in another encoding: its characters are converted to UTF-8.
IECFRONT_API void append_json_string(std::string& out, std::string_view text, Encoding encoding);

/// Appends `diagnostic`, whose ranges count from the start of `source`, to `out` as one JSON object
/// with the members `file, line, column, endLine, endColumn` (1-based, columns in code points),
/// `offset, endOffset` (bytes, 0-based), `code, name, severity, class, clause, message`,
/// `annexE` (row, only for an error of Annex E), `labels[]` (position and `message`) and `fixes[]`
/// (`description` and `edits[]` with `offset, endOffset, text`). Nothing is appended, and false
/// returned, when `severity` is `allow`.
IECFRONT_API bool render_json(std::string& out, const Diagnostic& diagnostic, Severity severity,
                              const SourceText& source, const LineTable& lines);

} // namespace iecfront
