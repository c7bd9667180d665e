#include "compliance/requirements.hpp"

#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/compliance/annex_e.hpp>
#include <iecfront/compliance/dialects.hpp>
#include <iecfront/compliance/extensions.hpp>
#include <iecfront/compliance/features.hpp>
#include <iecfront/compliance/statement.hpp>
#include <iecfront/diagnostics/severity.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace iecfront::test {
namespace {

[[nodiscard]] bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

// What the registries hold stands in the statement, a row each.
TEST(Statement, HoldsEveryRegistry) {
    const std::string page = compliance_statement(StatementFormat::markdown, "gate 7");
    EXPECT_TRUE(contains(page, "\ngate 7 complies in part with the requirements of "));
    for (const FeatureGroup group : feature_groups())
        EXPECT_TRUE(contains(page, "\n### " + std::string(title_of(group)) + "\n"));
    for (const Feature& feature : features())
        EXPECT_TRUE(contains(page, " | " + std::string(feature.description) + " | "))
            << feature.description;
    for (const AnnexDParameter& one : annex_d())
        EXPECT_TRUE(contains(page, value_of(one))) << one.parameter;
    for (const AnnexEError& error : annex_e())
        EXPECT_TRUE(contains(page, "\n| E" + std::to_string(error.row) + " | "));
    for (const Extension& one : extensions())
        EXPECT_TRUE(contains(page, "\n| " + std::string(diagnostic_info(one.diagnostic).name)));
    for (const Dialect& one : dialects())
        EXPECT_TRUE(contains(page, "\n| " + one.name + " | "));
    for (const std::string_view what : never_examined())
        EXPECT_TRUE(contains(page, what)) << what;
}

[[nodiscard]] bool is_met(char letter) {
    return std::ranges::find(requirements, letter, &Requirement::letter)->met;
}

// 1.5.1 c), d) and g) are met as soon as nothing is left open, and not before.
TEST(Statement, SaysInPartAsLongAsSomethingIsOpen) {
    EXPECT_EQ(is_met('c'), never_examined().empty());
    EXPECT_EQ(is_met('d'), std::ranges::none_of(annex_e(), [](const AnnexEError& error) {
                  return error.treatment == ErrorTreatment::not_yet_examined;
              }));
    EXPECT_EQ(is_met('g'), std::ranges::none_of(annex_d(), [](const AnnexDParameter& one) {
                  return one.kind == ParameterKind::choice && !one.diagnostic;
              }));
}

// A bar in a cell of Markdown would begin the next one.
TEST(Statement, RowsHaveAsManyCellsAsTheirTable) {
    const std::string page = compliance_statement(StatementFormat::markdown, "gate 7");
    std::ptrdiff_t bars = 0;
    for (std::size_t begin = 0; begin < page.size(); begin = page.find('\n', begin) + 1) {
        const std::string line = page.substr(begin, page.find('\n', begin) - begin);
        const std::ptrdiff_t count = std::ranges::count(line, '|');
        EXPECT_TRUE(bars == 0 || count == 0 || count == bars) << line;
        bars = count;
    }
}

TEST(Statement, FormsAgree) {
    const std::string text = compliance_statement(StatementFormat::text, "gate 7");
    EXPECT_TRUE(text.starts_with("Compliance with IEC 61131-3:2003\n====="));
    EXPECT_TRUE(text.ends_with("\n"));
    const std::string json = compliance_statement(StatementFormat::json, "gate \"7\"");
    EXPECT_TRUE(json.starts_with("{\"product\":\"gate \\\"7\\\"\",\"standard\":"));
    EXPECT_TRUE(json.ends_with("]}\n"));
}

} // namespace
} // namespace iecfront::test
