#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// A case, what it is about and what is reported in it.
struct CoveredCase {
    std::string place; ///< `path:line`
    std::set<std::string> tags;
    std::set<DiagnosticId> reported;
    bool rejected = false; ///< something was reported as an error
};

/// All cases, run once.
[[nodiscard]] const std::vector<CoveredCase>& covered_cases();

/// True when a case with this tag is rejected, or is not.
[[nodiscard]] bool has_case(const std::string& tag, bool rejected);

/// True when some case reports `id`.
[[nodiscard]] bool is_reported(DiagnosticId id);

/// True when a case with this tag reports `id`, or does not.
[[nodiscard]] bool has_reporting_case(const std::string& tag, DiagnosticId id);
[[nodiscard]] bool has_silent_case(const std::string& tag, DiagnosticId id);

/// What tests a diagnostic that no case can produce; empty when a case can.
[[nodiscard]] std::string_view tested_elsewhere(DiagnosticId id);

} // namespace iecfront::test
