#include <iecfront/compliance/dialects.hpp>
#include <iecfront/compliance/extensions.hpp>

#include <gtest/gtest.h>

namespace iecfront::test {
namespace {

// 1.5.1 e)
TEST(Dialects, TheDefaultIsTheStandard) {
    ASSERT_FALSE(dialects().empty());
    EXPECT_EQ(dialects()[0].name, "iec2");
    EXPECT_TRUE(dialects()[0].extensions.empty());
}

TEST(Dialects, AreFoundByTheirNames) {
    for (const Dialect& dialect : dialects())
        EXPECT_EQ(find_dialect(dialect.name), &dialect);
    EXPECT_EQ(find_dialect("IEC2-Tools"), &dialects()[1]);
    EXPECT_EQ(find_dialect("iec3"), nullptr);
}

TEST(Dialects, AreSetsOfExtensions) {
    for (const Dialect& dialect : dialects()) {
        for (const DialectExtension& one : dialect.extensions) {
            const DiagnosticInfo& row = diagnostic_info(one.diagnostic);
            EXPECT_EQ(row.category, DiagnosticClass::extension) << row.name;
            EXPECT_NE(find_extension(one.diagnostic), nullptr) << row.name;
        }
    }
}

// 1.5.1 f)
TEST(Dialects, SetWhatIsTheirsAlone) {
    const Dialect& dialect = dialects()[1];
    SeverityPolicy policy;
    policy.set(DiagnosticId::pointer_type, Severity::warning);
    set_dialect(policy, dialect);
    EXPECT_EQ(policy.severity(DiagnosticId::line_comment), Severity::allow);
    EXPECT_EQ(policy.severity(DiagnosticId::third_edition_literal), Severity::warning);
    EXPECT_EQ(policy.severity(DiagnosticId::foreign_construct), Severity::error);
    EXPECT_EQ(policy.severity(DiagnosticId::pointer_type), Severity::warning);
}

} // namespace
} // namespace iecfront::test
