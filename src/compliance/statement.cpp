#include "compliance/document.hpp"
#include "compliance/requirements.hpp"
#include "compliance/statement_json.hpp"

#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/compliance/annex_e.hpp>
#include <iecfront/compliance/dialects.hpp>
#include <iecfront/compliance/extensions.hpp>
#include <iecfront/compliance/features.hpp>
#include <iecfront/compliance/statement.hpp>
#include <iecfront/diagnostics/severity.hpp>

#include <algorithm>

namespace iecfront {
namespace {

// Behind what was not compared with the text of the standard.
constexpr std::string_view unverified_mark = " ~";

[[nodiscard]] std::string marked(std::string_view text, bool checked) {
    return std::string(text) + std::string(checked ? "" : unverified_mark);
}

// `IEC2006 missing-semicolon`
[[nodiscard]] std::string code_and_name(DiagnosticId id) {
    return code_string(id) + ' ' + std::string(diagnostic_info(id).name);
}

// ---- features --------------------------------------------------------------------------------

// The treatments that need a reason, in the order in which the tables use them: notes 1, 2 ...
[[nodiscard]] std::vector<FeatureTreatment> noted_treatments() {
    std::vector<FeatureTreatment> result;
    for (const Feature& feature : features())
        if (!reason_of(feature.treatment).empty() &&
            std::ranges::find(result, feature.treatment) == result.end())
            result.push_back(feature.treatment);
    return result;
}

[[nodiscard]] std::string status_cell(FeatureTreatment treatment,
                                      const std::vector<FeatureTreatment>& noted) {
    std::string cell(to_string(status_of(treatment)));
    if (const auto note = std::ranges::find(noted, treatment); note != noted.end())
        cell += " (" + std::to_string(note - noted.begin() + 1) + ")";
    return cell;
}

void append_statuses(Document& document, const std::vector<FeatureTreatment>& noted) {
    BulletList statuses;
    statuses.items.push_back(std::string(to_string(FeatureStatus::supported)) +
                             ": every form that Annex B gives it is read, and every other form is "
                             "reported, but for the known differences in `docs/grammar.md`");
    for (const FeatureTreatment treatment : noted)
        statuses.items.push_back(status_cell(treatment, noted) + ": " +
                                 std::string(reason_of(treatment)));
    document.push_back(Paragraph{"The status of a feature says:"});
    document.push_back(std::move(statuses));
    document.push_back(Paragraph{"No status speaks of meaning. This version never examines:"});
    BulletList unexamined;
    for (const std::string_view what : never_examined())
        unexamined.items.emplace_back(what);
    document.push_back(std::move(unexamined));
    document.push_back(
        Paragraph{"A number with `~` behind it was not compared with the text of the "
                  "standard."});
}

[[nodiscard]] Table table_of(FeatureGroup group, const std::vector<FeatureTreatment>& noted) {
    Table table{{"Table No.", "Feature No.", "Features description", "Status"}, {}};
    for (const FeatureTable& features_table : feature_tables()) {
        if (features_table.group != group)
            continue;
        const std::string number(features_table.number);
        table.rows.push_back({number, "",
                              "Table " + number + ", " + std::string(features_table.title) + " (" +
                                  std::string(features_table.clause) + ")",
                              ""});
        for (const Feature& feature : features_of(features_table))
            table.rows.push_back({number, marked(feature.number, feature.numbering_checked),
                                  std::string(feature.description),
                                  status_cell(feature.treatment, noted)});
    }
    return table;
}

void append_features(Document& document) {
    const std::vector<FeatureTreatment> noted = noted_treatments();
    document.push_back(Heading{2, "Language features"});
    append_statuses(document, noted);
    for (const FeatureGroup group : feature_groups()) {
        document.push_back(Heading{3, std::string(title_of(group))});
        if (!note_of(group).empty())
            document.push_back(Paragraph{std::string(note_of(group))});
        if (Table table = table_of(group, noted); !table.rows.empty())
            document.push_back(std::move(table));
    }
}

// ---- the other sections ----------------------------------------------------------------------

void append_opening(Document& document, std::string_view product) {
    document.push_back(Heading{1, "Compliance with IEC 61131-3:2003"});
    document.push_back(Paragraph{
        std::string(product) +
        " complies in part with the requirements of IEC 61131-3:2003, for the language features "
        "listed below, as far as their status says."});
    document.push_back(Paragraph{
        "It is a front end: it reads source texts in the textual languages, and executes nothing. "
        "A programmable controller system that is built on it can found its own statement on this "
        "one."});
}

void append_requirements(Document& document) {
    document.push_back(Heading{2, "Requirements"});
    document.push_back(Paragraph{"How the requirements of 1.5.1 on a system are met:"});
    Table table{{"Item", "Demands", "Met", "How"}, {}};
    for (const Requirement& one : requirements)
        table.rows.push_back({std::string(1, one.letter) + ")", std::string(one.demand),
                              one.met ? "yes" : "in part", std::string(one.how)});
    document.push_back(std::move(table));
}

void append_annex_d(Document& document) {
    document.push_back(Heading{2, "Implementation-dependent parameters"});
    document.push_back(Paragraph{
        "The values of the parameters of Annex D. Where a diagnostic is named, passing the limit "
        "or relying on the parameter is reported; a limit that is passed makes the determination "
        "incomplete. What relies on a parameter, `iecfront check --warn implementation-dependent` "
        "reports as a warning and `--strict` as an error. Where no limit of its own is given, the "
        "size of programs (2.5.3) is one. A subclause with `~` behind it was not compared with the "
        "text of the standard."});
    Table table{{"Subclause", "Parameter", "Kind", "Value", "Reported by"}, {}};
    for (const AnnexDParameter& one : annex_d())
        table.rows.push_back({marked(one.subclause, one.listing_checked),
                              std::string(one.parameter), std::string(to_string(one.kind)),
                              value_of(one), one.diagnostic ? code_and_name(*one.diagnostic) : ""});
    document.push_back(std::move(table));
}

[[nodiscard]] std::string reports_of(const AnnexEError& error) {
    std::string result;
    for (const DiagnosticId id : diagnostics_of(error))
        result += (result.empty() ? "" : ", ") + code_and_name(id);
    return result;
}

// The error conditions with this treatment, each with `how` in a column of its own if there is one.
void append_errors(Document& document, ErrorTreatment treatment, const char* column,
                   std::string (*how)(const AnnexEError&)) {
    Table table{{"No.", "Subclause", "Error condition"}, {}};
    if (how != nullptr)
        table.columns.emplace_back(column);
    for (const AnnexEError& error : annex_e()) {
        if (error.treatment != treatment)
            continue;
        table.rows.push_back({"E" + std::to_string(error.row), std::string(error.subclause),
                              std::string(error.condition)});
        if (how != nullptr)
            table.rows.back().push_back(how(error));
    }
    if (table.rows.empty())
        document.push_back(Paragraph{"None."});
    else
        document.push_back(std::move(table));
}

void append_annex_e(Document& document) {
    document.push_back(Heading{2, "Error conditions"});
    document.push_back(Paragraph{"The errors of Annex E, counted in its order, by the ways of "
                                 "1.5.1 d). Way 4, a report during execution, is none of a front "
                                 "end."});
    document.push_back(Heading{3, "Errors reported (way 3)"});
    append_errors(document, ErrorTreatment::reported, "Reported by", reports_of);
    document.push_back(Heading{3, "Errors whose possibility is reported (way 2)"});
    append_errors(document, ErrorTreatment::possibility_reported, "Reported by", reports_of);
    document.push_back(Heading{3, "Errors not reported (way 1)"});
    append_errors(document, ErrorTreatment::not_reported, "Why",
                  [](const AnnexEError& error) { return std::string(error.reason); });
    document.push_back(Heading{3, "Errors not yet examined"});
    document.push_back(
        Paragraph{"These are treated in none of the ways, and nothing is claimed for "
                  "them. As long as there are any, each determination is incomplete "
                  "at best."});
    append_errors(document, ErrorTreatment::not_yet_examined, nullptr, nullptr);
}

void append_extensions(Document& document) {
    document.push_back(Heading{2, "Extensions"});
    document.push_back(Paragraph{
        "What is understood though the standard does not have it. `iecfront check --allow NAME` "
        "takes an extension, `--warn NAME` reports its use as a warning, and `--deny NAME` as an "
        "error; `extension` stands for all of them. `SeverityPolicy::set` does the same in the "
        "library. `iecfront explain NAME` shows an example."});
    Table table{{"Name", "Code", "Extends", "Since", "By default", "Description"}, {}};
    for (const Extension& one : extensions()) {
        const DiagnosticInfo& info = diagnostic_info(one.diagnostic);
        table.rows.push_back({std::string(info.name), code_string(one.diagnostic),
                              std::string(to_string(one.language)), std::string(one.since),
                              std::string(to_string(info.default_severity)),
                              std::string(one.description)});
    }
    document.push_back(std::move(table));
}

// Everything that a dialect does not leave as it is.
[[nodiscard]] std::string names_of(const Dialect& dialect, Severity treatment) {
    std::string names;
    for (const DialectExtension& one : dialect.extensions)
        if (one.treatment == treatment)
            names +=
                (names.empty() ? "" : ", ") + std::string(diagnostic_info(one.diagnostic).name);
    return names.empty() ? "none" : names;
}

void append_dialects(Document& document) {
    document.push_back(Heading{2, "Dialects"});
    document.push_back(
        Paragraph{"Named sets of extensions, with their treatments. `iecfront check --dialect "
                  "NAME` takes one, "
                  "`set_dialect` in the library. What a dialect does not name keeps its default."});
    Table table{{"Name", "Description", "Takes", "Warns of"}, {}};
    for (const Dialect& one : dialects())
        table.rows.push_back({one.name, std::string(one.description),
                              names_of(one, Severity::allow), names_of(one, Severity::warning)});
    document.push_back(std::move(table));
}

[[nodiscard]] Document statement_document(std::string_view product) {
    Document document;
    append_opening(document, product);
    append_requirements(document);
    append_features(document);
    append_annex_d(document);
    append_annex_e(document);
    append_extensions(document);
    append_dialects(document);
    return document;
}

} // namespace

std::string compliance_statement(StatementFormat format, std::string_view product) {
    switch (format) {
    case StatementFormat::json: return json_statement(product);
    case StatementFormat::markdown: return markdown(statement_document(product));
    case StatementFormat::text: break;
    }
    return plain_text(statement_document(product));
}

} // namespace iecfront
