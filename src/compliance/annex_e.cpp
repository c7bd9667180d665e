#include <iecfront/compliance/annex_e.hpp>

#include <array>
#include <cstddef>

namespace iecfront {
namespace {

constexpr std::array rows = {
#define IECFRONT_ANNEX_E(row, subclause, treatment, condition, reason)                             \
    AnnexEError{row, subclause, ErrorTreatment::treatment, condition, reason},
#include <iecfront/compliance/annex_e.def>
};

constexpr bool rows_are_counted() {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].row != i + 1)
            return false;
    return true;
}
static_assert(rows_are_counted(), "a row of Annex E is missing, or stands in the wrong place");

constexpr bool what_is_not_reported_says_why() {
    for (const AnnexEError& error : rows)
        if ((error.treatment == ErrorTreatment::not_reported) == error.reason.empty())
            return false;
    return true;
}
static_assert(what_is_not_reported_says_why());

} // namespace

std::span<const AnnexEError> annex_e() noexcept {
    return rows;
}

std::vector<DiagnosticId> diagnostics_of(const AnnexEError& error) {
    std::vector<DiagnosticId> result;
    for (const DiagnosticInfo& row : diagnostic_catalogue())
        if (row.annex_e_row == error.row)
            result.push_back(row.id);
    return result;
}

std::string_view to_string(ErrorTreatment treatment) noexcept {
    switch (treatment) {
    case ErrorTreatment::not_yet_examined: return "not yet examined";
    case ErrorTreatment::not_reported: return "not reported";
    case ErrorTreatment::possibility_reported: return "possibility reported";
    case ErrorTreatment::reported: break;
    }
    return "reported";
}

} // namespace iecfront
