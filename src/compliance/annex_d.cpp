#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/lexer/token.hpp>
#include <iecfront/source/source_text.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace iecfront {
namespace {

// The words of the columns `listing` and `diagnostic`.
constexpr bool checked = true;
constexpr bool unverified = false;
constexpr std::nullopt_t none = std::nullopt;

constexpr std::array rows = {
#define IECFRONT_ANNEX_D(subclause, kind, listing, diagnostic, number, parameter, value)           \
    AnnexDParameter{subclause, ParameterKind::kind, listing, diagnostic, number, parameter, value},
#include <iecfront/compliance/annex_d.def>
};

} // namespace

std::span<const AnnexDParameter> annex_d() noexcept {
    return rows;
}

const AnnexDParameter* find_parameter(DiagnosticId diagnostic) noexcept {
    const auto* const found = std::ranges::find_if(rows, [&](const AnnexDParameter& row) {
        return row.diagnostic == diagnostic && row.subclause == diagnostic_info(diagnostic).clause;
    });
    return found == rows.end() ? nullptr : &*found;
}

std::string value_of(const AnnexDParameter& parameter) {
    constexpr std::string_view placeholder = "{0}";
    std::string text(parameter.value);
    if (const std::size_t at = text.find(placeholder); at != std::string::npos)
        text.replace(at, placeholder.size(), std::to_string(parameter.number));
    return text;
}

std::string_view to_string(ParameterKind kind) noexcept {
    switch (kind) {
    case ParameterKind::limit: return "limit";
    case ParameterKind::choice: return "choice";
    case ParameterKind::run_time: return "run time";
    case ParameterKind::not_applicable: break;
    }
    return "not applicable";
}

} // namespace iecfront
