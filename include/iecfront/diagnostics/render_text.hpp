#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/export.hpp>
#include <iecfront/source/line_table.hpp>
#include <iecfront/source/source_text.hpp>

#include <span>
#include <string>

namespace iecfront {

/// How diagnostics look as text.
struct TextStyle {
    bool colour = false; ///< ANSI escape sequences
    bool snippet = true; ///< the source line with carets, labels and the first fix below it
};

/// Appends `diagnostic`, whose ranges count from the start of `source`, to `out`: one clickable
/// line `file:line:column: severity CODE: message` (1-based, columns in code points), then the
/// source line with carets. The output is UTF-8. Nothing is
/// appended when `severity` is `allow`. `lines` is the table of `source`.
IECFRONT_API void render_text(std::string& out, const Diagnostic& diagnostic, Severity severity,
                              const SourceText& source, const LineTable& lines,
                              const TextStyle& style = {});

/// All of `diagnostics`, one below the other, each with the severity that `policy` gives it.
[[nodiscard]] IECFRONT_API std::string render_text(std::span<const Diagnostic> diagnostics,
                                                   const SourceText& source,
                                                   const SeverityPolicy& policy = {},
                                                   const TextStyle& style = {});

} // namespace iecfront
