#include "support/case_outcome.hpp"

#include "support/layout.hpp"
#include "support/line_diff.hpp"
#include "support/repository_files.hpp"

#include <iecfront/ast/dump.hpp>
#include <iecfront/diagnostics/render_text.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/source/line_table.hpp>
#include <iecfront/source/text_range.hpp>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace iecfront::test {
namespace {

[[nodiscard]] SeverityPolicy policy_of(const Case& one) {
    SeverityPolicy policy;
    for (const std::string& what : one.report)
        (void)policy.set(what, Severity::warning);
    return policy;
}

[[nodiscard]] std::vector<Diagnostic> reported(std::vector<Diagnostic> all,
                                               const SeverityPolicy& policy) {
    std::erase_if(all, [&](const Diagnostic& diagnostic) {
        return policy.severity(diagnostic.id) == Severity::allow;
    });
    return all;
}

/// A fault of spelling or of syntax: what a fix has to mend.
[[nodiscard]] bool is_fault(const Diagnostic& diagnostic, const SeverityPolicy& policy) {
    return diagnostic_info(diagnostic.id).code < 3000 &&
           policy.severity(diagnostic.id) == Severity::error;
}

// ---- diagnostics
// ---------------------------------------------------------------------------------

/// Writes diagnostics as case files have them.
class Writer {
public:
    Writer(const SourceText& source, const SeverityPolicy& policy)
        : source_(source), policy_(policy), lines_(source.bytes()) {}

    [[nodiscard]] std::string write(const std::vector<Diagnostic>& diagnostics) {
        for (const Diagnostic& diagnostic : diagnostics)
            write(diagnostic);
        return trimmed(out_);
    }

private:
    void write(const Diagnostic& diagnostic) {
        const DiagnosticInfo& info = diagnostic_info(diagnostic.id);
        out_ += place(diagnostic.range) + ' ';
        out_ += to_string(policy_.severity(diagnostic.id));
        out_ += ' ' + code_string(diagnostic.id) + ' ';
        out_ += info.name;
        out_ += ": " + message(diagnostic, source_.encoding()) + '\n';
        write_snippet(diagnostic.range);
        for (const DiagnosticLabel& label : diagnostic.labels) {
            out_ += "    note " + place(label.range) + ": ";
            out_ += message(label, source_.encoding()) + '\n';
            write_snippet(label.range);
        }
        for (const DiagnosticFix& fix : diagnostic.fixes)
            out_ += "    fix: " + description(fix, source_.bytes(), source_.encoding()) + '\n';
    }

    [[nodiscard]] std::string place(TextRange range) const {
        return position(range.begin) + '-' + position(range.end);
    }

    [[nodiscard]] std::string position(std::uint32_t offset) const {
        const std::uint32_t line = lines_.line_of(offset);
        const std::uint32_t column = column_of(source_.bytes(), lines_.line_start(line), offset,
                                               source_.encoding(), ColumnUnit::code_points);
        return std::to_string(line + 1) + ':' + std::to_string(column);
    }

    // The source line and its carets, as the text renderer draws them behind its `12 | `.
    void write_snippet(TextRange range) {
        std::string rendered;
        render_text(rendered, {DiagnosticId::missing_semicolon, range, {}, {}, {}}, Severity::error,
                    source_, lines_);
        const auto rendered_lines = lines_of(rendered);
        for (std::size_t i = 1; i < rendered_lines.size(); ++i) {
            const std::string_view line = rendered_lines[i];
            const std::size_t bar = line.find('|');
            out_ += "    ";
            out_ += line.substr(std::min(bar + 2, line.size()));
            out_ += '\n';
        }
    }

    const SourceText& source_;
    const SeverityPolicy& policy_;
    LineTable lines_;
    std::string out_;
};

// ---- fixes
// ---------------------------------------------------------------------------------------

/// A text and the edits that were chosen for it.
class Mender {
public:
    void add(const DiagnosticFix& fix) {
        const bool clash = std::any_of(fix.edits.begin(), fix.edits.end(),
                                       [&](const TextEdit& edit) { return clashes(edit.range); });
        overlap_ = overlap_ || clash;
        if (!clash)
            edits_.insert(edits_.end(), fix.edits.begin(), fix.edits.end());
    }

    [[nodiscard]] std::string apply(std::string_view text) {
        std::stable_sort(edits_.begin(), edits_.end(), [](const TextEdit& a, const TextEdit& b) {
            return std::pair(a.range.begin, a.range.end) < std::pair(b.range.begin, b.range.end);
        });
        return apply_edits(text, edits_);
    }

    [[nodiscard]] bool overlap() const { return overlap_; }

private:
    // Edits that only touch do not clash: two insertions at one place stand in order.
    [[nodiscard]] bool clashes(TextRange range) const {
        return std::any_of(edits_.begin(), edits_.end(), [&](const TextEdit& other) {
            return range.begin < other.range.end && other.range.begin < range.end;
        });
    }

    std::vector<TextEdit> edits_;
    bool overlap_ = false;
};

/// The faults of syntax in `text`, read as `source` is.
[[nodiscard]] std::string faults_in(std::string text, const SourceText& source,
                                    const ParseOptions& options, const SeverityPolicy& policy) {
    const SourceText changed(std::move(text), source.name(), source.encoding());
    std::vector<Diagnostic> left = parse(changed, options).diagnostics();
    std::erase_if(left, [&](const Diagnostic& one) { return !is_fault(one, policy); });
    return Writer(changed, policy).write(left);
}

void mend(CaseOutcome& outcome, const std::vector<Diagnostic>& found, const SourceText& source,
          const ParseOptions& options, const SeverityPolicy& policy) {
    Mender mender;
    bool all_have_fixes = true;
    for (const Diagnostic& diagnostic : found) {
        if (!diagnostic.fixes.empty())
            mender.add(diagnostic.fixes.front());
        else if (is_fault(diagnostic, policy))
            all_have_fixes = false;
    }
    outcome.fixed = mender.apply(source.bytes());
    outcome.fixes_overlap = mender.overlap();
    outcome.fixable = all_have_fixes && std::any_of(found.begin(), found.end(), [&](const auto& d) {
                          return is_fault(d, policy);
                      });
    if (outcome.fixable)
        outcome.left_in_fixed = faults_in(outcome.fixed, source, options, policy);
}

[[nodiscard]] std::string tree_text(const SyntaxTree& tree) {
    std::string text;
    for (const SyntaxTree::Slot& slot : tree.slots())
        text += laid_out(s_expression(*slot.unit, slot.unit->root())) + '\n';
    return text;
}

} // namespace

SourceText source_text_of(const Case& one) {
    const auto encoding = encoding_from_string(one.encoding.empty() ? "utf-8" : one.encoding);
    return SourceText(one.source(), one.title, encoding.value_or(Encoding::utf8));
}

ParseOptions options_of(const Case& one) {
    ParseOptions options;
    const auto set = [](std::uint32_t& limit, const std::string& value) {
        if (!value.empty())
            limit = static_cast<std::uint32_t>(std::stoul(value));
    };
    set(options.maximum_nesting, one.maximum_nesting);
    set(options.maximum_identifier_length, one.maximum_identifier_length);
    set(options.maximum_diagnostics, one.maximum_diagnostics);
    set(options.maximum_source_size, one.maximum_source_size);
    set(options.maximum_unit_memory, one.maximum_unit_memory);
    return options;
}

ParseOptions options_of_changed(const Case& one) {
    ParseOptions options = options_of(one);
    options.maximum_source_size = ParseOptions().maximum_source_size;
    options.maximum_unit_memory = ParseOptions().maximum_unit_memory;
    return options;
}

CaseOutcome run_case(const Case& one) {
    const SourceText source = source_text_of(one);
    const ParseOptions options = options_of(one);
    const SeverityPolicy policy = policy_of(one);
    const SyntaxTree tree = parse(source, options);
    const std::vector<Diagnostic> found = reported(tree.diagnostics(), policy);

    CaseOutcome outcome;
    outcome.diagnostics = Writer(source, policy).write(found);
    outcome.tree = tree_text(tree);
    for (const Diagnostic& diagnostic : found) {
        outcome.reported.insert(diagnostic.id);
        if (policy.severity(diagnostic.id) == Severity::error)
            outcome.rejected = true;
    }
    mend(outcome, found, source, options, policy);
    outcome.fixed = one.written(outcome.fixed);
    return outcome;
}

} // namespace iecfront::test
