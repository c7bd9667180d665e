#pragma once

#include <iecfront/export.hpp>

#include <cstdint>
#include <span>
#include <string_view>

namespace iecfront {

/// How far a feature of the standard's feature tables goes. None of them speaks of rules of meaning
/// that `never_examined()` lists.
enum class FeatureStatus : std::uint8_t {
    supported,      ///< what uses it is read, and every departure from its form is reported
    front_end_part, ///< something is left to later stages or to a run time
    not_supported,
};

/// What is done about features (`features.def`); each treatment has one status and one reason.
enum class FeatureTreatment : std::uint8_t {
#define IECFRONT_FEATURE_TREATMENT(enumerator, status, reason) enumerator,
#include <iecfront/compliance/features.def>
};

/// The compliance tables of 1.5.1 that a textual language has features for.
enum class FeatureGroup : std::uint8_t {
#define IECFRONT_FEATURE_GROUP(enumerator, title, note) enumerator,
#include <iecfront/compliance/features.def>
};

/// A row of a feature table.
struct Feature {
    std::string_view table;  ///< number of its table: `3a` is Table 3 a)
    std::string_view number; ///< as in the table, such as `2` or `10d`
    FeatureTreatment treatment;
    bool numbering_checked;       ///< the number was compared with the text of the standard
    std::string_view description; ///< in our words
};

/// A feature table.
struct FeatureTable {
    std::string_view number;
    FeatureGroup group;
    std::string_view clause;
    std::string_view title; ///< in our words
};

/// All rows, table by table.
[[nodiscard]] IECFRONT_API std::span<const Feature> features() noexcept;

/// All feature tables, in the order of the standard.
[[nodiscard]] IECFRONT_API std::span<const FeatureTable> feature_tables() noexcept;

/// The rows of one table.
[[nodiscard]] IECFRONT_API std::span<const Feature> features_of(const FeatureTable& table) noexcept;

/// The table of a row.
[[nodiscard]] IECFRONT_API const FeatureTable& table_of(const Feature& feature) noexcept;

/// Finds feature 2 of Table 4 by `4.2`, in any case; null when there is none.
[[nodiscard]] IECFRONT_API const Feature* find_feature(std::string_view table_and_number) noexcept;

/// What follows for the features of this treatment.
[[nodiscard]] IECFRONT_API FeatureStatus status_of(FeatureTreatment treatment) noexcept;

/// Why they are not `supported`, in words; empty when they are.
[[nodiscard]] IECFRONT_API std::string_view reason_of(FeatureTreatment treatment) noexcept;

/// All groups, in the order of the statement.
[[nodiscard]] IECFRONT_API std::span<const FeatureGroup> feature_groups() noexcept;

/// The title that 1.5.1 gives to a compliance table.
[[nodiscard]] IECFRONT_API std::string_view title_of(FeatureGroup group) noexcept;

/// What the statement says beside the features of the group; may be empty.
[[nodiscard]] IECFRONT_API std::string_view note_of(FeatureGroup group) noexcept;

/// `supported`, `front-end part only` or `not supported`.
[[nodiscard]] IECFRONT_API std::string_view to_string(FeatureStatus status) noexcept;

} // namespace iecfront
