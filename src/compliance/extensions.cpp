#include <iecfront/compliance/extensions.hpp>

#include <algorithm>
#include <array>

namespace iecfront {
namespace {

constexpr std::array rows = {
#define IECFRONT_EXTENSION(diagnostic, language, since, description)                               \
    Extension{DiagnosticId::diagnostic, ExtensionLanguage::language, since, description},
#include <iecfront/compliance/extensions.def>
};
static_assert(std::ranges::is_sorted(rows, {}, &Extension::diagnostic));

} // namespace

std::span<const Extension> extensions() noexcept {
    return rows;
}

const Extension* find_extension(DiagnosticId diagnostic) noexcept {
    const auto* const found = std::ranges::find(rows, diagnostic, &Extension::diagnostic);
    return found == rows.end() ? nullptr : found;
}

std::string_view to_string(ExtensionLanguage language) noexcept {
    switch (language) {
    case ExtensionLanguage::common: return "common elements";
    case ExtensionLanguage::il: return "IL";
    case ExtensionLanguage::st: return "ST";
    case ExtensionLanguage::sfc: break;
    }
    return "SFC";
}

} // namespace iecfront
