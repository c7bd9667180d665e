#include "cli/check_file.hpp"

#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/diagnostics/render_sarif.hpp>
#include <iecfront/parser/parse.hpp>
#include <iecfront/source/line_table.hpp>

#include <algorithm>
#include <exception>
#include <vector>

namespace iecfront::cli {
namespace {

[[nodiscard]] std::vector<Diagnostic> examine(const ReadText& text, const Options& options) {
    if (!text.too_large)
        return parse(text.source, options.parse).diagnostics();
    // What parsing would say, without the memory to hold such a text.
    Diagnostic diagnostic;
    diagnostic.id = DiagnosticId::source_too_large;
    diagnostic.arguments = {std::to_string(SourceText::maximum_size)};
    return {diagnostic};
}

// No violations, then incomplete, then violations: what is worse counts for the whole.
[[nodiscard]] int rank(Determination determination) noexcept {
    switch (determination) {
    case Determination::no_violations: return 0;
    case Determination::incomplete: return 1;
    case Determination::violations: break;
    }
    return 2;
}

[[nodiscard]] Findings count(const std::vector<Diagnostic>& diagnostics,
                             const SeverityPolicy& policy) {
    Findings findings;
    findings.files = 1;
    findings.determination = determine(diagnostics, policy);
    for (const Diagnostic& diagnostic : diagnostics) {
        const Severity severity = policy.severity(diagnostic.id);
        findings.errors += severity == Severity::error ? 1U : 0U;
        findings.warnings += severity == Severity::warning ? 1U : 0U;
        if (severity != Severity::allow)
            findings.reported.insert(diagnostic.id);
        if (diagnostic_info(diagnostic.id).category == DiagnosticClass::limit)
            findings.limits.insert(diagnostic.id);
    }
    return findings;
}

/// Objects of JSON or SARIF with commas between.
[[nodiscard]] std::string as_objects(const std::vector<Diagnostic>& diagnostics,
                                     const SourceText& source, const CheckSettings& settings) {
    const auto render = settings.options.format == Format::sarif ? render_sarif : render_json;
    const LineTable lines(source.bytes(), source.encoding());
    std::string out;
    for (const Diagnostic& diagnostic : diagnostics) {
        const std::size_t before = out.size();
        out += out.empty() ? "" : ",\n";
        if (!render(out, diagnostic, settings.policy.severity(diagnostic.id), source, lines))
            out.resize(before);
    }
    return out;
}

[[nodiscard]] std::string as_text(const std::vector<Diagnostic>& diagnostics,
                                  const SourceText& source, const CheckSettings& settings) {
    const LineTable lines(source.bytes(), source.encoding());
    const std::size_t most = settings.options.maximum_findings;
    std::size_t shown = 0;
    std::size_t hidden = 0;
    std::string out;
    for (const Diagnostic& diagnostic : diagnostics) {
        const Severity severity = settings.policy.severity(diagnostic.id);
        if (severity == Severity::allow)
            continue;
        if (most != 0 && shown == most) {
            ++hidden;
            continue;
        }
        render_text(out, diagnostic, severity, source, lines, settings.style);
        ++shown;
    }
    if (hidden > 0)
        out += source.name() + ": " + counted(hidden, "more finding") +
               " not shown; --max-findings 0 shows all\n";
    return out;
}

} // namespace

void Findings::add(const Findings& other) {
    files += other.files;
    errors += other.errors;
    warnings += other.warnings;
    limits.insert(other.limits.begin(), other.limits.end());
    reported.insert(other.reported.begin(), other.reported.end());
    if (rank(other.determination) > rank(determination))
        determination = other.determination;
}

FileReport check_file(const Input& input, const CheckSettings& settings) noexcept {
    FileReport report;
    try {
        const ReadText text = read_input(input, settings.options.encoding);
        report.problem = text.problem;
        if (!report.problem.empty())
            return report;
        const std::vector<Diagnostic> diagnostics = examine(text, settings.options);
        report.findings = count(diagnostics, settings.policy);
        if (diagnostics.empty())
            return report;
        report.text = settings.options.format == Format::text
                          ? as_text(diagnostics, text.source, settings)
                          : as_objects(diagnostics, text.source, settings);
    } catch (const std::exception& exception) {
        report.problem = exception.what();
    }
    return report;
}

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace iecfront::cli
