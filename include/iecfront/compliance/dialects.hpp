#pragma once

#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/export.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront {

/// How a dialect treats the use of one extension.
struct DialectExtension {
    DiagnosticId diagnostic;
    Severity treatment;
};

/// A named set of extensions with their treatments (1.5.1 e and f, `dialects.def`).
struct Dialect {
    std::string name; ///< `iec2-tools`
    std::string_view description;
    std::vector<DialectExtension> extensions; ///< those that it does not leave to their defaults
};

/// All dialects. The first one, `iec2`, is the default, and has no extension.
[[nodiscard]] IECFRONT_API std::span<const Dialect> dialects();

/// The dialect of this name, in any case; null when there is none.
[[nodiscard]] IECFRONT_API const Dialect* find_dialect(std::string_view name);

/// Sets the extensions of `dialect` in `policy`. What `policy` says of others stays.
IECFRONT_API void set_dialect(SeverityPolicy& policy, const Dialect& dialect);

} // namespace iecfront
