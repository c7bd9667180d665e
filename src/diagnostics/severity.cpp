#include "source/ascii.hpp"

#include <iecfront/diagnostics/severity.hpp>

namespace iecfront {
namespace {

constexpr std::array all_classes = {
    DiagnosticClass::violation, DiagnosticClass::error, DiagnosticClass::extension,
    DiagnosticClass::implementation_dependent, DiagnosticClass::limit};

// The syntax is examined by the parser, characters and literals by the lexer; these are left.
constexpr std::array<std::string_view, 4> unexamined = {
    "rules of meaning: types, variables and their values (clauses 2.3 and 2.4)",
    "rules of meaning: functions, function blocks, programs and charts (clauses 2.5 and 2.6)",
    "rules of meaning: configurations, resources and tasks (clause 2.7)",
    "rules of meaning: instructions, expressions and statements (clauses 3.2 and 3.3)",
};

// What the standard forbids stays forbidden when it is reported as a warning; what it lets a system
// have, and the user refuses, is forbidden by the user. A limit says nothing of the text.
[[nodiscard]] bool is_violation(const DiagnosticInfo& row, Severity severity) noexcept {
    switch (row.category) {
    case DiagnosticClass::violation:
    case DiagnosticClass::error: return severity != Severity::allow;
    case DiagnosticClass::extension:
    case DiagnosticClass::implementation_dependent: return severity == Severity::error;
    case DiagnosticClass::limit: break;
    }
    return false;
}

[[nodiscard]] bool leaves_open(const DiagnosticInfo& row, Severity severity) noexcept {
    switch (row.category) {
    case DiagnosticClass::limit: return true;
    case DiagnosticClass::violation:
    case DiagnosticClass::error: return severity == Severity::allow;
    case DiagnosticClass::extension:
    case DiagnosticClass::implementation_dependent: break;
    }
    return false;
}

} // namespace

Severity SeverityPolicy::severity(DiagnosticId id) const noexcept {
    if (const auto own = by_id_.find(id); own != by_id_.end())
        return own->second;
    const DiagnosticInfo& row = diagnostic_info(id);
    return by_class_[static_cast<std::size_t>(row.category)].value_or(row.default_severity);
}

void SeverityPolicy::set(DiagnosticId id, Severity severity) {
    by_id_[id] = severity;
}

void SeverityPolicy::set(DiagnosticClass category, Severity severity) {
    by_class_[static_cast<std::size_t>(category)] = severity;
}

bool SeverityPolicy::set(std::string_view what, Severity severity) {
    if (const DiagnosticInfo* row = find_diagnostic(what)) {
        set(row->id, severity);
        return true;
    }
    for (const DiagnosticClass category : all_classes) {
        if (equal_in_any_case(to_string(category), what)) {
            set(category, severity);
            return true;
        }
    }
    return false;
}

SeverityPolicy SeverityPolicy::strict() {
    SeverityPolicy policy;
    policy.set(DiagnosticClass::extension, Severity::error);
    policy.set(DiagnosticClass::implementation_dependent, Severity::error);
    return policy;
}

std::string_view to_string(Determination determination) noexcept {
    switch (determination) {
    case Determination::no_violations: return "no-violations";
    case Determination::violations: return "violations";
    case Determination::incomplete: break;
    }
    return "incomplete";
}

std::span<const std::string_view> never_examined() noexcept {
    return unexamined;
}

Determination determine(std::span<const Diagnostic> diagnostics,
                        const SeverityPolicy& policy) noexcept {
    bool open = !never_examined().empty();
    for (const Diagnostic& diagnostic : diagnostics) {
        const DiagnosticInfo& row = diagnostic_info(diagnostic.id);
        const Severity severity = policy.severity(diagnostic.id);
        if (is_violation(row, severity))
            return Determination::violations;
        open = open || leaves_open(row, severity);
    }
    return open ? Determination::incomplete : Determination::no_violations;
}

} // namespace iecfront
