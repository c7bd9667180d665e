#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/export.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace iecfront {

/// What an implementation-dependent parameter is to a front end.
enum class ParameterKind : std::uint8_t {
    limit,          ///< how much there can be of something
    choice,         ///< what something means
    run_time,       ///< a matter of execution: passed on
    not_applicable, ///< a matter of the graphical languages
};

/// A parameter of Annex D (`annex_d.def`).
struct AnnexDParameter {
    std::string_view subclause;
    ParameterKind kind;
    bool listing_checked; ///< that Annex D lists it was compared with the text of the standard
    /// Reported when the limit is passed, or the parameter relied on.
    std::optional<DiagnosticId> diagnostic;
    std::uint64_t number; ///< the constant of the code that is its value; 0 when there is none
    std::string_view parameter;
    std::string_view value; ///< `{0}` stands for `number`; see `value_of`
};

/// All parameters, in the order of the clauses.
[[nodiscard]] IECFRONT_API std::span<const AnnexDParameter> annex_d() noexcept;

/// The parameter that a diagnostic is about: the first of its clause. Null for one that is about
/// none.
[[nodiscard]] IECFRONT_API const AnnexDParameter* find_parameter(DiagnosticId diagnostic) noexcept;

/// The value, or the treatment, in words.
[[nodiscard]] IECFRONT_API std::string value_of(const AnnexDParameter& parameter);

/// `limit`, `choice`, `run time` or `not applicable`.
[[nodiscard]] IECFRONT_API std::string_view to_string(ParameterKind kind) noexcept;

} // namespace iecfront
