#include "source/ascii.hpp"

#include <iecfront/compliance/features.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace iecfront {
namespace {

// The words of the column `numbering`.
constexpr bool checked = true;
constexpr bool unverified = false;

// As many as a fold expression over them may not have.
constexpr auto rows = std::to_array<Feature>({
#define IECFRONT_FEATURE(table, number, treatment, numbering, description)                         \
    Feature{table, number, FeatureTreatment::treatment, numbering, description},
#include <iecfront/compliance/features.def>
});

constexpr std::array tables = {
#define IECFRONT_FEATURE_TABLE(number, group, clause, title)                                       \
    FeatureTable{number, FeatureGroup::group, clause, title},
#include <iecfront/compliance/features.def>
};

struct Treatment {
    FeatureStatus status;
    std::string_view reason;
};

constexpr std::array treatments = {
#define IECFRONT_FEATURE_TREATMENT(enumerator, status, reason)                                     \
    Treatment{FeatureStatus::status, reason},
#include <iecfront/compliance/features.def>
};

struct Group {
    FeatureGroup group;
    std::string_view title;
    std::string_view note;
};

constexpr std::array groups = {
#define IECFRONT_FEATURE_GROUP(enumerator, title, note)                                            \
    Group{FeatureGroup::enumerator, title, note},
#include <iecfront/compliance/features.def>
};

constexpr auto group_names = [] {
    std::array<FeatureGroup, groups.size()> names{};
    std::ranges::transform(groups, names.begin(), &Group::group);
    return names;
}();

// Tables and rows come in one order, so that the rows of a table stand together.
constexpr bool rows_follow_their_tables() {
    std::size_t row = 0;
    for (const FeatureTable& table : tables) {
        const std::size_t first = row;
        while (row < rows.size() && rows[row].table == table.number)
            ++row;
        if (row == first)
            return false;
    }
    return row == rows.size();
}
static_assert(rows_follow_their_tables(), "a feature does not stand below its table");

constexpr bool unsupported_features_say_why() {
    for (const Treatment& treatment : treatments)
        if ((treatment.status == FeatureStatus::supported) != treatment.reason.empty())
            return false;
    return true;
}
static_assert(unsupported_features_say_why());

[[nodiscard]] const Treatment& row_of(FeatureTreatment treatment) noexcept {
    return treatments[static_cast<std::size_t>(treatment)];
}

[[nodiscard]] const Group& row_of(FeatureGroup group) noexcept {
    return groups[static_cast<std::size_t>(group)];
}

} // namespace

std::span<const Feature> features() noexcept {
    return rows;
}

std::span<const FeatureTable> feature_tables() noexcept {
    return tables;
}

std::span<const Feature> features_of(const FeatureTable& table) noexcept {
    const auto is_of_table = [&](const Feature& row) { return row.table == table.number; };
    const auto* const first = std::ranges::find_if(rows, is_of_table);
    return {first, std::find_if_not(first, rows.end(), is_of_table)};
}

const FeatureTable& table_of(const Feature& feature) noexcept {
    return *std::ranges::find(tables, feature.table, &FeatureTable::number);
}

const Feature* find_feature(std::string_view table_and_number) noexcept {
    const std::size_t point = table_and_number.find('.');
    if (point == std::string_view::npos)
        return nullptr;
    const auto* const found = std::ranges::find_if(rows, [&](const Feature& row) {
        return equal_in_any_case(row.table, table_and_number.substr(0, point)) &&
               equal_in_any_case(row.number, table_and_number.substr(point + 1));
    });
    return found == rows.end() ? nullptr : found;
}

FeatureStatus status_of(FeatureTreatment treatment) noexcept {
    return row_of(treatment).status;
}

std::string_view reason_of(FeatureTreatment treatment) noexcept {
    return row_of(treatment).reason;
}

std::span<const FeatureGroup> feature_groups() noexcept {
    return group_names;
}

std::string_view title_of(FeatureGroup group) noexcept {
    return row_of(group).title;
}

std::string_view note_of(FeatureGroup group) noexcept {
    return row_of(group).note;
}

std::string_view to_string(FeatureStatus status) noexcept {
    switch (status) {
    case FeatureStatus::supported: return "supported";
    case FeatureStatus::front_end_part: return "front-end part only";
    case FeatureStatus::not_supported: break;
    }
    return "not supported";
}

} // namespace iecfront
