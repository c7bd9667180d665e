#include "diagnostics/json_writer.hpp"
#include "diagnostics/place.hpp"

#include <iecfront/diagnostics/render_sarif.hpp>

#include <cstdint>

namespace iecfront {
namespace {

constexpr std::string_view base_of_paths = "%SRCROOT%";
constexpr std::string_view schema =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

[[nodiscard]] std::string_view level(Severity severity) noexcept {
    switch (severity) {
    case Severity::allow: return "none";
    case Severity::warning: return "warning";
    case Severity::error: break;
    }
    return "error";
}

/// True for a character that a path may have in a URI as it is (RFC 3986).
[[nodiscard]] bool is_plain(char c) noexcept {
    constexpr std::string_view marks = "-._~/";
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           marks.find(c) != marks.npos;
}

/// A path as a URI: `file:` when it begins at a root, else relative.
[[nodiscard]] std::string uri_of(std::string_view path) {
    const bool drive = path.size() > 2 && path[1] == ':' && (path[2] == '\\' || path[2] == '/');
    std::string uri = drive ? "file:///" : path.starts_with('/') ? "file://" : "";
    for (const char c : path) {
        constexpr std::string_view digits = "0123456789ABCDEF";
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\\')
            uri += '/';
        else if (is_plain(c) || (drive && c == ':'))
            uri += c;
        else
            uri += {'%', digits[byte >> 4U], digits[byte & 0xFU]};
    }
    return uri;
}

/// `{"text":...}`, of which SARIF's messages are made.
void append_text(std::string& out, std::string_view text) {
    JsonObject object(out);
    object.member("text", text);
    object.close();
}

class ResultWriter {
public:
    ResultWriter(std::string& out, const SourceText& source, const LineTable& lines)
        : out_(out),
          source_(source),
          lines_(lines),
          uri_(uri_of(source.name().empty() ? "<text>" : source.name())) {}

    void write(const Diagnostic& diagnostic, Severity severity) {
        JsonObject object(out_);
        object.member("ruleId", code_string(diagnostic.id));
        object.member("level", level(severity));
        object.name("message");
        append_text(out_, message(diagnostic, source_.encoding()));
        object.name("locations");
        out_ += '[';
        write_location(diagnostic.range, {});
        out_ += ']';
        if (!diagnostic.labels.empty()) {
            object.name("relatedLocations");
            append_array(out_, diagnostic.labels, [&](const DiagnosticLabel& label) {
                write_location(label.range, message(label, source_.encoding()));
            });
        }
        if (!diagnostic.fixes.empty()) {
            object.name("fixes");
            append_array(out_, diagnostic.fixes, [&](const auto& fix) { write_fix(fix); });
        }
        object.close();
    }

private:
    void write_location(TextRange range, const std::string& words) {
        JsonObject object(out_);
        object.name("physicalLocation");
        JsonObject physical(out_);
        physical.name("artifactLocation");
        write_artifact();
        physical.name("region");
        write_region(range);
        physical.close();
        if (!words.empty()) {
            object.name("message");
            append_text(out_, words);
        }
        object.close();
    }

    void write_artifact() {
        JsonObject object(out_);
        object.member("uri", uri_);
        if (!uri_.starts_with("file:"))
            object.member("uriBaseId", base_of_paths);
        object.close();
    }

    void write_region(TextRange range) {
        const TextRange within = range_within(range, source_);
        const Position begin = position_of(within.begin, source_, lines_);
        const Position end = within.empty() ? begin : position_of(within.end, source_, lines_);
        JsonObject object(out_);
        object.member("startLine", begin.line);
        object.member("startColumn", begin.column);
        object.member("endLine", end.line);
        object.member("endColumn", end.column);
        object.close();
    }

    void write_fix(const DiagnosticFix& fix) {
        JsonObject object(out_);
        object.name("description");
        append_text(out_, description(fix, source_.bytes(), source_.encoding()));
        object.name("artifactChanges");
        out_ += '[';
        JsonObject change(out_);
        change.name("artifactLocation");
        write_artifact();
        change.name("replacements");
        append_array(out_, fix.edits, [&](const TextEdit& edit) { write_replacement(edit); });
        change.close();
        out_ += ']';
        object.close();
    }

    void write_replacement(const TextEdit& edit) {
        JsonObject object(out_);
        object.name("deletedRegion");
        write_region(edit.range);
        if (!edit.replacement.empty()) {
            object.name("insertedContent");
            JsonObject content(out_);
            content.name("text");
            append_json_string(out_, edit.replacement, source_.encoding());
            content.close();
        }
        object.close();
    }

    std::string& out_;
    const SourceText& source_;
    const LineTable& lines_;
    std::string uri_;
};

void append_rule(std::string& out, const SarifRule& rule) {
    const DiagnosticInfo& info = diagnostic_info(rule.id);
    JsonObject object(out);
    object.member("id", code_string(rule.id));
    object.member("name", info.name);
    object.name("shortDescription");
    append_text(out, info.message);
    if (!rule.help.empty()) {
        object.name("help");
        JsonObject help(out);
        help.member("text", rule.help);
        help.member("markdown", rule.help);
        help.close();
    }
    object.name("defaultConfiguration");
    JsonObject configuration(out);
    configuration.member("level", level(info.default_severity));
    configuration.close();
    object.name("properties");
    JsonObject properties(out);
    properties.member("class", to_string(info.category));
    properties.member("clause", info.clause);
    properties.close();
    object.close();
}

void append_tool(std::string& out, const SarifRun& run) {
    JsonObject tool(out);
    tool.name("driver");
    JsonObject driver(out);
    driver.member("name", run.tool_name);
    driver.member("semanticVersion", run.tool_version);
    driver.name("rules");
    append_array(out, run.rules, [&](const SarifRule& rule) { append_rule(out, rule); });
    driver.close();
    tool.close();
}

void append_notification(std::string& out, std::string_view level_of_line, std::string_view line) {
    JsonObject notification(out);
    notification.member("level", level_of_line);
    notification.name("message");
    append_text(out, line);
    notification.close();
}

void append_invocation(std::string& out, const SarifRun& run) {
    JsonObject invocation(out);
    invocation.name("executionSuccessful");
    out += run.problems.empty() ? "true" : "false";
    invocation.name("toolExecutionNotifications");
    out += '[';
    for (const std::string& line : run.problems) {
        out += out.back() == '[' ? "" : ",";
        append_notification(out, "error", line);
    }
    for (const std::string& line : run.not_examined) {
        out += out.back() == '[' ? "" : ",";
        append_notification(out, "note", line);
    }
    out += ']';
    invocation.close();
}

} // namespace

bool render_sarif(std::string& out, const Diagnostic& diagnostic, Severity severity,
                  const SourceText& source, const LineTable& lines) {
    if (severity == Severity::allow)
        return false;
    ResultWriter(out, source, lines).write(diagnostic, severity);
    return true;
}

std::string begin_sarif_log(const SarifRun& run) {
    std::string out;
    JsonObject log(out);
    log.member("$schema", schema);
    log.member("version", "2.1.0");
    log.name("runs");
    out += "[";
    JsonObject object(out);
    object.name("tool");
    append_tool(out, run);
    object.name("invocations");
    out += '[';
    append_invocation(out, run);
    out += ']';
    object.member("columnKind", "unicodeCodePoints");
    object.name("originalUriBaseIds");
    JsonObject bases(out);
    bases.name(base_of_paths);
    JsonObject base(out);
    base.name("description");
    append_text(out, "the folder in which the program ran");
    base.close();
    bases.close();
    object.name("properties");
    JsonObject properties(out);
    properties.member("determination", to_string(run.determination));
    properties.close();
    object.name("results");
    out += "[";
    return out;
}

std::string_view end_sarif_log() noexcept {
    return "]}]}";
}

} // namespace iecfront
