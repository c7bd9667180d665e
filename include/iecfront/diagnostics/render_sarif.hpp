#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/export.hpp>
#include <iecfront/source/line_table.hpp>
#include <iecfront/source/source_text.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace iecfront {

/// A diagnostic of the catalogue as a rule of a SARIF log.
struct SarifRule {
    DiagnosticId id{};
    std::string help; ///< Markdown in UTF-8; may be empty
};

/// What a SARIF log says beside its results. All text is UTF-8.
struct SarifRun {
    std::string tool_name;                 ///< of the program that writes the log
    std::string tool_version;              ///< as in semantic versioning: `0.1.0`
    std::vector<SarifRule> rules;          ///< at least those that results have
    Determination determination{};         ///< of all texts together
    std::vector<std::string> problems;     ///< why inputs could not be read; such a run failed
    std::vector<std::string> not_examined; ///< what was left out, or is never examined
};

/// Appends `diagnostic`, whose ranges count from the start of `source`, to `out` as one `result`
/// object of SARIF 2.1.0, with its labels as related locations, and its fixes. Columns are in code
/// points, from 1. The name of `source` is taken for a path: an absolute one becomes a `file:` URI,
/// any other is relative to `%SRCROOT%`. Nothing is appended, and false returned, when `severity`
/// is `allow`.
IECFRONT_API bool render_sarif(std::string& out, const Diagnostic& diagnostic, Severity severity,
                               const SourceText& source, const LineTable& lines);

/// A SARIF 2.1.0 log up to its results, which follow with commas between, and then
/// `end_sarif_log()`.
[[nodiscard]] IECFRONT_API std::string begin_sarif_log(const SarifRun& run);

/// What stands behind the results.
[[nodiscard]] IECFRONT_API std::string_view end_sarif_log() noexcept;

} // namespace iecfront
