#include "compliance/statement_json.hpp"

#include "compliance/requirements.hpp"
#include "diagnostics/json_writer.hpp"

#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/compliance/annex_e.hpp>
#include <iecfront/compliance/dialects.hpp>
#include <iecfront/compliance/extensions.hpp>
#include <iecfront/compliance/features.hpp>
#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/diagnostics/severity.hpp>

#include <string>

namespace iecfront {
namespace {

/// The member `name` of the statement: a row a line.
template<class Items, class Write>
void write_rows(JsonObject& statement, std::string& out, std::string_view name, const Items& items,
                Write write) {
    statement.name(name);
    const auto write_row = [&](const auto& item) {
        JsonObject row(out);
        write(row, item);
        row.close();
    };
    append_array(out, items, write_row, ",\n");
}

void write_requirement(JsonObject& row, const Requirement& one) {
    row.member("item", std::string_view(&one.letter, 1));
    row.member("demands", one.demand);
    row.member("met", one.met ? "yes" : "in part");
    row.member("how", one.how);
}

void write_feature(JsonObject& row, const Feature& feature) {
    const FeatureTable& table = table_of(feature);
    row.member("table", feature.table);
    row.member("feature", feature.number);
    row.truth("numberingChecked", feature.numbering_checked);
    row.member("description", feature.description);
    row.member("status", to_string(status_of(feature.treatment)));
    row.member("reason", reason_of(feature.treatment));
    row.member("tableTitle", table.title);
    row.member("clause", table.clause);
    row.member("group", title_of(table.group));
}

void write_parameter(JsonObject& row, const AnnexDParameter& one) {
    row.member("subclause", one.subclause);
    row.truth("listingChecked", one.listing_checked);
    row.member("parameter", one.parameter);
    row.member("kind", to_string(one.kind));
    row.member("value", value_of(one));
    if (one.number != 0)
        row.member("number", one.number);
    if (one.diagnostic)
        row.member("reportedBy", code_string(*one.diagnostic));
}

void write_error(JsonObject& row, std::string& out, const AnnexEError& error) {
    row.member("row", error.row);
    row.member("subclause", error.subclause);
    row.member("condition", error.condition);
    row.member("treatment", to_string(error.treatment));
    row.member("reason", error.reason);
    row.name("reportedBy");
    append_array(out, diagnostics_of(error),
                 [&](DiagnosticId id) { append_json_string(out, code_string(id)); });
}

void write_extension(JsonObject& row, const Extension& one) {
    const DiagnosticInfo& info = diagnostic_info(one.diagnostic);
    row.member("name", info.name);
    row.member("code", code_string(one.diagnostic));
    row.member("extends", to_string(one.language));
    row.member("since", one.since);
    row.member("byDefault", to_string(info.default_severity));
    row.member("description", one.description);
}

void write_dialect(JsonObject& row, std::string& out, const Dialect& dialect) {
    row.member("name", dialect.name);
    row.member("description", dialect.description);
    write_rows(row, out, "extensions", dialect.extensions,
               [](JsonObject& object, const DialectExtension& one) {
                   object.member("name", diagnostic_info(one.diagnostic).name);
                   object.member("treatment", to_string(one.treatment));
               });
}

} // namespace

std::string json_statement(std::string_view product) {
    std::string out;
    JsonObject statement(out);
    statement.member("product", product);
    statement.member("standard", "IEC 61131-3:2003");
    write_rows(statement, out, "requirements", requirements, write_requirement);
    write_rows(statement, out, "features", features(), write_feature);
    statement.name("neverExamined");
    append_array(
        out, never_examined(), [&](std::string_view what) { append_json_string(out, what); },
        ",\n");
    write_rows(statement, out, "annexD", annex_d(), write_parameter);
    write_rows(statement, out, "annexE", annex_e(),
               [&](JsonObject& row, const AnnexEError& one) { write_error(row, out, one); });
    write_rows(statement, out, "extensions", extensions(), write_extension);
    write_rows(statement, out, "dialects", dialects(),
               [&](JsonObject& row, const Dialect& one) { write_dialect(row, out, one); });
    statement.close();
    return out + "\n";
}

} // namespace iecfront
