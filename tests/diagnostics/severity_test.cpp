#include <iecfront/diagnostics/severity.hpp>

#include <gtest/gtest.h>

using namespace iecfront;

namespace {

constexpr DiagnosticId violation = DiagnosticId::missing_semicolon;
constexpr DiagnosticId annex_e = DiagnosticId::nested_comment;
constexpr DiagnosticId extension = DiagnosticId::line_comment;
constexpr DiagnosticId dependent = DiagnosticId::pragma;
constexpr DiagnosticId limit = DiagnosticId::nesting_too_deep;

TEST(SeverityPolicy, BeginsWithTheCatalogue) {
    const SeverityPolicy policy;
    for (const DiagnosticInfo& row : diagnostic_catalogue())
        EXPECT_EQ(policy.severity(row.id), row.default_severity);
    EXPECT_EQ(policy.severity(dependent), Severity::allow);
}

TEST(SeverityPolicy, OneDiagnosticWinsOverItsClass) {
    SeverityPolicy policy;
    policy.set(extension, Severity::warning);
    policy.set(DiagnosticClass::extension, Severity::allow);
    EXPECT_EQ(policy.severity(extension), Severity::warning);
    EXPECT_EQ(policy.severity(DiagnosticId::c_comment), Severity::allow);
    EXPECT_EQ(policy.severity(violation), Severity::error);
}

TEST(SeverityPolicy, IsSetByWhatAUserTypes) {
    SeverityPolicy policy;
    EXPECT_TRUE(policy.set("iec5001", Severity::allow));
    EXPECT_EQ(policy.severity(DiagnosticId::line_comment), Severity::allow);
    EXPECT_TRUE(policy.set("Missing-Semicolon", Severity::warning));
    EXPECT_EQ(policy.severity(violation), Severity::warning);
    EXPECT_TRUE(policy.set("IMPLEMENTATION-DEPENDENT", Severity::warning));
    EXPECT_EQ(policy.severity(dependent), Severity::warning);
    EXPECT_FALSE(policy.set("everything", Severity::allow));
    EXPECT_FALSE(policy.set("", Severity::allow));
}

TEST(SeverityPolicy, StrictLetsNothingPassThat152Forbids) {
    const SeverityPolicy policy = SeverityPolicy::strict();
    for (const DiagnosticInfo& row : diagnostic_catalogue()) {
        const bool is_limit = row.category == DiagnosticClass::limit;
        EXPECT_EQ(policy.severity(row.id), is_limit ? Severity::warning : Severity::error);
    }
}

Determination determine_one(DiagnosticId id, const SeverityPolicy& policy = {}) {
    Diagnostic diagnostic;
    diagnostic.id = id;
    return determine({&diagnostic, 1}, policy);
}

// While rules of meaning are not examined, no text is determined to have no violations.
constexpr Determination nothing_found = Determination::incomplete;

TEST(Determination, AnErrorIsAViolation) {
    EXPECT_EQ(determine_one(violation), Determination::violations);
    EXPECT_EQ(determine_one(extension), Determination::violations);
}

TEST(Determination, AViolationIsOneAlsoAsAWarning) {
    SeverityPolicy policy;
    policy.set(DiagnosticClass::violation, Severity::warning);
    policy.set(DiagnosticClass::error, Severity::warning);
    EXPECT_EQ(determine_one(violation, policy), Determination::violations);
    EXPECT_EQ(determine_one(annex_e, policy), Determination::violations);
}

TEST(Determination, WhatIsRefusedIsAViolation) {
    EXPECT_EQ(determine_one(dependent, SeverityPolicy::strict()), Determination::violations);
}

TEST(Determination, AWarningOfWhatIsPermittedIsNone) {
    SeverityPolicy policy;
    policy.set(dependent, Severity::warning);
    policy.set(extension, Severity::warning);
    EXPECT_EQ(determine_one(extension, policy), nothing_found);
    EXPECT_EQ(determine_one(dependent, policy), nothing_found);
    EXPECT_EQ(determine_one(dependent), nothing_found);
}

TEST(Determination, AnAllowedViolationLeavesItOpen) {
    SeverityPolicy policy;
    policy.set(violation, Severity::allow);
    EXPECT_EQ(determine_one(violation, policy), Determination::incomplete);
}

TEST(Determination, ALimitIsNeverAViolation) {
    SeverityPolicy policy;
    policy.set(limit, Severity::error);
    EXPECT_EQ(determine_one(limit, policy), Determination::incomplete);
}

TEST(Determination, WhatIsNeverExaminedLeavesItOpen) {
    EXPECT_FALSE(never_examined().empty());
    EXPECT_EQ(determine({}, {}), nothing_found);
}

} // namespace
