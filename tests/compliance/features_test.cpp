#include "support/case_coverage.hpp"

#include <iecfront/compliance/features.hpp>
#include <iecfront/lexer/standard_names.hpp>

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace iecfront::test {
namespace {

[[nodiscard]] std::string tag_of(const Feature& feature) {
    return "table-" + std::string(feature.table) + "." + std::string(feature.number);
}

TEST(Features, AreNumberedOnce) {
    std::set<std::string> seen;
    for (const Feature& feature : features())
        EXPECT_TRUE(seen.insert(tag_of(feature)).second) << tag_of(feature);
}

TEST(Features, StandInTheirTables) {
    std::size_t count = 0;
    for (const FeatureTable& table : feature_tables()) {
        EXPECT_FALSE(features_of(table).empty()) << table.number;
        for (const Feature& feature : features_of(table))
            EXPECT_EQ(&table_of(feature), &table);
        count += features_of(table).size();
    }
    EXPECT_EQ(count, features().size());
}

// Lists of 1.5.1 and of the standard that are no feature tables.
TEST(Features, NoneIsOfATableWithoutFeatures) {
    const std::set<std::string_view> without = {"9",  "11", "13", "16a", "16b", "32",
                                                "38", "47", "48", "51",  "51a"};
    for (const FeatureTable& table : feature_tables())
        EXPECT_FALSE(without.contains(table.number)) << table.number;
}

TEST(Features, AreFoundByTableAndNumber) {
    const Feature* const found = find_feature("4.2");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->table, "4");
    EXPECT_EQ(found->number, "2");
    EXPECT_EQ(find_feature("3A.1"), find_feature("3a.1"));
    EXPECT_NE(find_feature("3a.1"), nullptr);
    for (const std::string_view unknown : {"", ".", "4", "4.", ".2", "4.99", "99.1", "4.2.1"})
        EXPECT_EQ(find_feature(unknown), nullptr) << unknown;
}

TEST(Features, WhatIsSupportedHasAnAcceptingCase) {
    for (const Feature& feature : features()) {
        if (status_of(feature.treatment) == FeatureStatus::supported) {
            EXPECT_TRUE(has_case(tag_of(feature), false)) << tag_of(feature);
        }
    }
}

// What of a chart or an instruction is a mistake depends on the feature: each has a case of its
// own. All rows of these tables can be got wrong in their form.
TEST(Features, ThoseOfChartsAndInstructionsHaveARejectingCase) {
    const std::set<std::string_view> tables = {"40", "41",  "42", "43", "45",
                                               "46", "51b", "52", "53", "54"};
    for (const Feature& feature : features()) {
        if (tables.contains(feature.table) &&
            status_of(feature.treatment) != FeatureStatus::not_supported) {
            EXPECT_TRUE(has_case(tag_of(feature), false))
                << "no accepting case: " << tag_of(feature);
            EXPECT_TRUE(has_case(tag_of(feature), true))
                << "no rejecting case: " << tag_of(feature);
        }
    }
}

// `ABS: absolute value` is the description of a feature that the name is known for.
TEST(Features, StandardNamesAreKnown) {
    for (const Feature& feature : features()) {
        const std::string_view name = feature.description.substr(0, feature.description.find(':'));
        const bool is_name = name.find_first_of(" *`") == std::string_view::npos;
        if (feature.treatment == FeatureTreatment::name_known && is_name) {
            EXPECT_NE(standard_name(name), StandardName::none) << name;
        }
    }
}

TEST(Features, GroupsHaveTitles) {
    EXPECT_EQ(feature_groups().size(), 4U);
    for (const FeatureGroup group : feature_groups())
        EXPECT_FALSE(title_of(group).empty());
}

} // namespace
} // namespace iecfront::test
