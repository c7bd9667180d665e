#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/export.hpp>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace iecfront {

/// What is done about an error condition of Annex E. The ways are those of 1.5.1 d).
enum class ErrorTreatment : std::uint8_t {
    not_yet_examined,     ///< none of the ways, until a later version examines it
    not_reported,         ///< way 1: the documents say that it is not reported
    possibility_reported, ///< way 2: it is reported that the error can occur
    reported,             ///< way 3
};

/// An error condition (`annex_e.def`).
struct AnnexEError {
    std::uint8_t row; ///< counted from 1
    std::string_view subclause;
    ErrorTreatment treatment;
    std::string_view condition;
    std::string_view reason; ///< why it is not reported
};

/// All error conditions, in the order of the annex: row 1 is the first.
[[nodiscard]] IECFRONT_API std::span<const AnnexEError> annex_e() noexcept;

/// The diagnostics that treat it.
[[nodiscard]] IECFRONT_API std::vector<DiagnosticId> diagnostics_of(const AnnexEError& error);

/// `not yet examined`, `not reported`, `possibility reported` or `reported`.
[[nodiscard]] IECFRONT_API std::string_view to_string(ErrorTreatment treatment) noexcept;

} // namespace iecfront
