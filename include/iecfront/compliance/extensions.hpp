#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/export.hpp>

#include <cstdint>
#include <span>
#include <string_view>

namespace iecfront {

/// What an extension extends.
enum class ExtensionLanguage : std::uint8_t {
    common, ///< the elements that all languages share
    il,     ///< Instruction List
    st,     ///< Structured Text
    sfc,    ///< Sequential Function Chart
};

/// Something that is understood though the standard does not have it (`extensions.def`). Its name,
/// and what is done about its use by default, are those of its diagnostic.
struct Extension {
    DiagnosticId diagnostic;
    ExtensionLanguage language;
    std::string_view since; ///< the first version that has it
    std::string_view description;
};

/// All extensions, in the order of the codes.
[[nodiscard]] IECFRONT_API std::span<const Extension> extensions() noexcept;

/// The extension whose use this diagnostic reports; null when there is none.
[[nodiscard]] IECFRONT_API const Extension* find_extension(DiagnosticId diagnostic) noexcept;

/// `common elements`, `IL`, `ST` or `SFC`.
[[nodiscard]] IECFRONT_API std::string_view to_string(ExtensionLanguage language) noexcept;

} // namespace iecfront
