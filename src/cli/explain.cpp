#include "cli/commands.hpp"
#include "cli/explain_pages.hpp"
#include "cli/near_names.hpp"
#include "cli/output.hpp"
#include "cli/platform.hpp"

#include <iecfront/compliance/extensions.hpp>
#include <iecfront/compliance/features.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>

#include <string>
#include <vector>

namespace iecfront::cli {
namespace {

// What the page of an extension leaves to the registry.
[[nodiscard]] std::string extension_facts(const Extension& extension) {
    const std::string name(diagnostic_info(extension.diagnostic).name);
    return "\n## Extension\n\nOf " + std::string(to_string(extension.language)) + ", since " +
           std::string(extension.since) + ": " + std::string(extension.description) +
           ".\n`iecfront check --allow " + name + "` takes it, `--warn " + name +
           "` reports its use as a warning.\n";
}

void explain(const DiagnosticInfo& row) {
    print(explain_page(code_string(row.id)));
    if (const Extension* extension = find_extension(row.id))
        print(extension_facts(*extension));
}

void explain(const Feature& feature) {
    const FeatureTable& table = table_of(feature);
    const std::string number(table.number);
    const std::string reason(reason_of(feature.treatment));
    std::string out = "# Table " + number + ", feature " + std::string(feature.number) + ": " +
                      std::string(feature.description) + "\n\nTable " + number + ": " +
                      std::string(table.title) + ". Clause: " + std::string(table.clause) +
                      ". Group: " + std::string(title_of(table.group)) +
                      ".\n\nStatus: " + std::string(to_string(status_of(feature.treatment))) +
                      (reason.empty() ? "" : ": " + reason) + ".\n";
    if (!feature.numbering_checked)
        out += "\nThe number was not compared with the text of the standard.\n";
    print(out);
}

[[nodiscard]] bool is_known(const std::string& what) {
    return find_diagnostic(what) != nullptr || find_feature(what) != nullptr;
}

void explain(const std::string& what) {
    if (const DiagnosticInfo* row = find_diagnostic(what))
        explain(*row);
    else
        explain(*find_feature(what));
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
    return "there is no diagnostic, extension or feature `" + on_one_line(what) + "`" +
           (hint.empty() ? "; `iecfront explain --list` lists all diagnostics" : hint);
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
        throw UsageError("name a code or a feature, as in `iecfront explain IEC2001`");
    Status status = Status::nothing_found;
    bool first = true;
    for (const std::string& what : options.operands) {
        if (!is_known(what)) {
            complain(unknown(what));
            status = Status::unusable;
            continue;
        }
        print(first ? "" : "\n");
        explain(what);
        first = false;
    }
    return status;
}

} // namespace iecfront::cli
