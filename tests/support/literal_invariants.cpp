#include "support/literal_invariants.hpp"

#include <iecfront/lexer/literals.hpp>

#include <algorithm>

namespace iecfront::test {
namespace {

[[nodiscard]] bool takes_value(const Diagnostic& fault) {
    const DiagnosticClass category = diagnostic_info(fault.id).category;
    return category == DiagnosticClass::violation && fault.id != DiagnosticId::integer_too_large &&
           fault.id != DiagnosticId::real_out_of_range;
}

[[nodiscard]] bool is_inside(TextRange range, std::string_view text) {
    return range.begin <= range.end && range.end <= text.size();
}

[[nodiscard]] bool is_inside(const std::vector<TextEdit>& edits, std::string_view text) {
    return std::ranges::all_of(edits,
                               [&](const TextEdit& edit) { return is_inside(edit.range, text); });
}

[[nodiscard]] std::string place_fault(const Diagnostic& fault, std::string_view text) {
    if (!is_inside(fault.range, text))
        return "a fault is not in the literal";
    for (const DiagnosticLabel& label : fault.labels)
        if (!is_inside(label.range, text))
            return "a label is not in the literal";
    for (const DiagnosticFix& fix : fault.fixes)
        if (!is_inside(fix.edits, text))
            return "a fix is not in the literal";
    return {};
}

} // namespace

std::vector<TextEdit> first_fixes(const std::vector<Diagnostic>& faults) {
    std::vector<TextEdit> edits;
    for (const Diagnostic& fault : faults)
        if (!fault.fixes.empty())
            edits.insert(edits.end(), fault.fixes.front().edits.begin(),
                         fault.fixes.front().edits.end());
    std::stable_sort(edits.begin(), edits.end(), [](const TextEdit& a, const TextEdit& b) {
        return a.range.begin < b.range.begin;
    });
    return edits;
}

bool has_value(TokenKind kind, std::string_view text, Encoding encoding) {
    switch (kind) {
    case TokenKind::single_byte_string:
    case TokenKind::double_byte_string: return string_value(text, encoding).has_value();
    case TokenKind::duration: return duration_value(text).has_value();
    case TokenKind::date: return date_value(text).has_value();
    case TokenKind::time_of_day: return time_of_day_value(text).has_value();
    case TokenKind::date_and_time: return date_and_time_value(text).has_value();
    case TokenKind::direct_variable:
    case TokenKind::incomplete_location: return direct_variable_value(text).has_value();
    case TokenKind::typed_literal:
        if (string_value(text, encoding) || duration_value(text) || date_value(text) ||
            time_of_day_value(text) || date_and_time_value(text))
            return true;
        [[fallthrough]];
    default: return integer_value(text).has_value() || real_value(text).has_value();
    }
}

std::string literal_fault(TokenKind kind, std::string_view text, Encoding encoding) {
    const std::vector<Diagnostic> faults = check_literal(kind, text, encoding);
    for (const Diagnostic& fault : faults) {
        if (std::string what = place_fault(fault, text); !what.empty())
            return what;
        if (message(fault, encoding).empty())
            return "a fault has no message";
    }
    if (!std::ranges::is_sorted(faults, {}, [](const Diagnostic& one) { return one.range.begin; }))
        return "the faults are not in order";
    const std::vector<TextEdit> edits = first_fixes(faults);
    for (std::size_t i = 1; i < edits.size(); ++i)
        if (edits[i - 1].range.end > edits[i].range.begin)
            return "fixes overlap";
    if (std::ranges::any_of(faults, takes_value) && has_value(kind, text, encoding))
        return "a violation has a value";
    return {};
}

} // namespace iecfront::test
