#include <iecfront/compliance/dialects.hpp>
#include <iecfront/lexer/name.hpp>

#include <algorithm>

namespace iecfront {
namespace {

struct DialectRow {
    std::string_view name;
    std::string_view description;
};

constexpr DialectRow rows[] = {
#define IECFRONT_DIALECT(name, description) {#name, description},
#include <iecfront/compliance/dialects.def>
};

struct ExtensionRow {
    std::string_view dialect;
    DialectExtension extension;
};

constexpr ExtensionRow extension_rows[] = {
#define IECFRONT_DIALECT_EXTENSION(name, extension, treatment)                                     \
    {#name, {DiagnosticId::extension, Severity::treatment}},
#include <iecfront/compliance/dialects.def>
};

[[nodiscard]] std::vector<Dialect> all_dialects() {
    std::vector<Dialect> dialects;
    for (const DialectRow& row : rows) {
        Dialect& dialect =
            dialects.emplace_back(Dialect{std::string(row.name), row.description, {}});
        std::ranges::replace(dialect.name, '_', '-');
        for (const ExtensionRow& extension : extension_rows)
            if (extension.dialect == row.name)
                dialect.extensions.push_back(extension.extension);
    }
    return dialects;
}

} // namespace

std::span<const Dialect> dialects() {
    static const std::vector<Dialect> all = all_dialects();
    return all;
}

const Dialect* find_dialect(std::string_view name) {
    const std::span<const Dialect> all = dialects();
    const auto found = std::ranges::find_if(
        all, [name](const Dialect& dialect) { return names_equal(dialect.name, name); });
    return found == all.end() ? nullptr : &*found;
}

void set_dialect(SeverityPolicy& policy, const Dialect& dialect) {
    for (const DialectExtension& extension : dialect.extensions)
        policy.set(extension.diagnostic, extension.treatment);
}

} // namespace iecfront
