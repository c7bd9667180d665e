#include "support/case_coverage.hpp"

#include "support/case_file.hpp"
#include "support/case_outcome.hpp"

#include <algorithm>

namespace iecfront::test {

const std::vector<CoveredCase>& covered_cases() {
    static const std::vector<CoveredCase> all = [] {
        std::vector<CoveredCase> result;
        for (const CaseFile& file : all_case_files()) {
            for (const Case& one : file.cases) {
                CaseOutcome outcome = run_case(one);
                result.push_back({file.path + ":" + std::to_string(one.line),
                                  {one.tags.begin(), one.tags.end()},
                                  std::move(outcome.reported),
                                  outcome.rejected});
            }
        }
        return result;
    }();
    return all;
}

bool has_case(const std::string& tag, bool rejected) {
    return std::ranges::any_of(covered_cases(), [&](const CoveredCase& one) {
        return one.rejected == rejected && one.tags.contains(tag);
    });
}

bool is_reported(DiagnosticId id) {
    return std::ranges::any_of(covered_cases(),
                               [id](const CoveredCase& one) { return one.reported.contains(id); });
}

bool has_reporting_case(const std::string& tag, DiagnosticId id) {
    return std::ranges::any_of(covered_cases(), [&](const CoveredCase& one) {
        return one.tags.contains(tag) && one.reported.contains(id);
    });
}

bool has_silent_case(const std::string& tag, DiagnosticId id) {
    return std::ranges::any_of(covered_cases(), [&](const CoveredCase& one) {
        return one.tags.contains(tag) && !one.reported.contains(id);
    });
}

std::string_view tested_elsewhere(DiagnosticId id) {
    switch (id) {
    case DiagnosticId::text_too_long: return "needs 4 MiB: tests/lexer/lexer_test.cpp";
    default: return {};
    }
}

} // namespace iecfront::test
