#include "cli/commands.hpp"
#include "cli/explain_pages.hpp"
#include "cli/near_names.hpp"
#include "cli/output.hpp"
#include "cli/platform.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>

#include <string>
#include <vector>

namespace iecfront::cli {
namespace {

// What the catalogue knows, for a diagnostic without a page.
[[nodiscard]] std::string short_page(const DiagnosticInfo& row) {
    return "# " + code_string(row.id) + ": " + std::string(row.name) + "\n\n" +
           std::string(row.message) + "\n\nClause " + std::string(row.clause) + "; " +
           std::string(to_string(row.category)) + ", reported as " +
           std::string(to_string(row.default_severity)) + " by default.\n";
}

void explain(const DiagnosticInfo& row) {
    const std::string_view page = explain_page(code_string(row.id));
    print(page.empty() ? short_page(row) : page);
}

void print_list() {
    for (const DiagnosticInfo& row : diagnostic_catalogue())
        print(code_string(row.id) + " " + std::string(row.name) + ": " + std::string(row.message) +
              "\n");
}

[[nodiscard]] std::string unknown(const std::string& what) {
    std::vector<std::string> names;
    for (const DiagnosticInfo& row : diagnostic_catalogue()) {
        names.push_back(code_string(row.id));
        names.emplace_back(row.name);
    }
    const std::string hint = did_you_mean(what, names);
    return "there is no diagnostic `" + on_one_line(what) + "`" +
           (hint.empty() ? "; `iecfront explain --list` lists all" : hint);
}

} // namespace

std::string_view explain_page(std::string_view code) noexcept {
    for (const ExplainPage& page : explain_pages())
        if (page.code == code)
            return page.text;
    return {};
}

Status run_explain(const Options& options) {
    if (options.list)
        print_list();
    else if (options.operands.empty())
        throw UsageError("name a code, as in `iecfront explain IEC2001`");
    Status status = Status::nothing_found;
    bool first = true;
    for (const std::string& what : options.operands) {
        const DiagnosticInfo* row = find_diagnostic(what);
        if (row == nullptr) {
            complain(unknown(what));
            status = Status::unusable;
            continue;
        }
        print(first ? "" : "\n");
        explain(*row);
        first = false;
    }
    return status;
}

} // namespace iecfront::cli
