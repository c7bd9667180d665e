#include "support/case_coverage.hpp"

#include <iecfront/compliance/annex_e.hpp>
#include <iecfront/diagnostics/severity.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace iecfront::test {
namespace {

[[nodiscard]] bool is_treated(const AnnexEError& error) {
    return error.treatment == ErrorTreatment::possibility_reported ||
           error.treatment == ErrorTreatment::reported;
}

TEST(AnnexE, IsComplete) {
    EXPECT_EQ(annex_e().size(), 38U);
}

TEST(AnnexE, WhatIsTreatedHasADiagnosticAndNothingElseHas) {
    for (const AnnexEError& error : annex_e())
        EXPECT_EQ(is_treated(error), !diagnostics_of(error).empty()) << int{error.row};
}

TEST(AnnexE, WhatIsTreatedHasAReportingAndASilentCase) {
    for (const AnnexEError& error : annex_e()) {
        const std::string tag = "Annex-E." + std::to_string(error.row);
        for (const DiagnosticId id : diagnostics_of(error)) {
            EXPECT_TRUE(has_reporting_case(tag, id)) << tag;
            EXPECT_TRUE(has_silent_case(tag, id)) << tag;
        }
        EXPECT_TRUE(!is_treated(error) || has_case(tag, false)) << "none without a fault: " << tag;
    }
}

// A text that was not examined for all of them must not be said to have no violations.
TEST(AnnexE, WhatIsNotYetExaminedMakesDeterminationsIncomplete) {
    const bool open = std::ranges::any_of(annex_e(), [](const AnnexEError& error) {
        return error.treatment == ErrorTreatment::not_yet_examined;
    });
    if (open) {
        EXPECT_EQ(determine({}, {}), Determination::incomplete);
    }
}

} // namespace
} // namespace iecfront::test
