#include "support/case_coverage.hpp"

#include <iecfront/compliance/extensions.hpp>
#include <iecfront/diagnostics/severity.hpp>

#include <gtest/gtest.h>
#include <string>

namespace iecfront::test {
namespace {

TEST(Extensions, EachHasACaseThatReportsIt) {
    for (const Extension& extension : extensions())
        EXPECT_TRUE(is_reported(extension.diagnostic))
            << diagnostic_info(extension.diagnostic).name;
}

TEST(Extensions, EachIsSetByItsName) {
    for (const Extension& extension : extensions()) {
        SeverityPolicy policy;
        const DiagnosticInfo& row = diagnostic_info(extension.diagnostic);
        EXPECT_EQ(policy.severity(extension.diagnostic), row.default_severity);
        for (const Severity severity : {Severity::allow, Severity::warning, Severity::error}) {
            EXPECT_TRUE(policy.set(diagnostic_info(extension.diagnostic).name, severity));
            EXPECT_EQ(policy.severity(extension.diagnostic), severity);
        }
    }
}

TEST(Extensions, AreFoundByTheirDiagnostic) {
    for (const Extension& extension : extensions())
        EXPECT_EQ(find_extension(extension.diagnostic), &extension);
    EXPECT_EQ(find_extension(DiagnosticId::missing_semicolon), nullptr);
}

} // namespace
} // namespace iecfront::test
