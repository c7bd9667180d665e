#include "compliance/statement_json.hpp"

#include "compliance/requirements.hpp"

#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/compliance/annex_e.hpp>
#include <iecfront/compliance/dialects.hpp>
#include <iecfront/compliance/extensions.hpp>
#include <iecfront/compliance/features.hpp>
#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/diagnostics/severity.hpp>

#include <cstdint>
#include <utility>

namespace iecfront {
namespace {

/// Writes JSON in the order of the calls. A name goes before each member of an object; an element
/// of an array has none, and a line of its own.
class JsonWriter {
public:
    void begin(char bracket, std::string_view name = {}) {
        separate(name);
        out_ += bracket;
        first_ = true;
    }
    void end(char bracket) {
        out_ += bracket;
        first_ = false;
    }
    void text(std::string_view name, std::string_view value) {
        separate(name);
        append_json_string(out_, value);
    }
    void number(std::string_view name, std::uint64_t value) {
        separate(name);
        out_ += std::to_string(value);
    }
    void truth(std::string_view name, bool value) {
        separate(name);
        out_ += value ? "true" : "false";
    }

    [[nodiscard]] std::string take() && { return std::move(out_) + "\n"; }

private:
    void separate(std::string_view name) {
        if (!first_)
            out_ += name.empty() ? ",\n" : ", ";
        first_ = false;
        if (name.empty())
            return;
        append_json_string(out_, name);
        out_ += ": ";
    }

    std::string out_;
    bool first_ = true;
};

void write_code(JsonWriter& json, std::string_view member, DiagnosticId id) {
    json.text(member, code_string(id));
}

void write_requirements(JsonWriter& json) {
    json.begin('[', "requirements");
    for (const Requirement& one : requirements) {
        json.begin('{');
        json.text("item", std::string_view(&one.letter, 1));
        json.text("demands", one.demand);
        json.text("met", one.met ? "yes" : "in part");
        json.text("how", one.how);
        json.end('}');
    }
    json.end(']');
}

void write_features(JsonWriter& json) {
    json.begin('[', "features");
    for (const Feature& feature : features()) {
        const FeatureTable& table = table_of(feature);
        json.begin('{');
        json.text("table", feature.table);
        json.text("feature", feature.number);
        json.truth("numberingChecked", feature.numbering_checked);
        json.text("description", feature.description);
        json.text("status", to_string(status_of(feature.treatment)));
        json.text("reason", reason_of(feature.treatment));
        json.text("tableTitle", table.title);
        json.text("clause", table.clause);
        json.text("group", title_of(table.group));
        json.end('}');
    }
    json.end(']');
}

void write_never_examined(JsonWriter& json) {
    json.begin('[', "neverExamined");
    for (const std::string_view what : never_examined())
        json.text({}, what);
    json.end(']');
}

void write_annex_d(JsonWriter& json) {
    json.begin('[', "annexD");
    for (const AnnexDParameter& one : annex_d()) {
        json.begin('{');
        json.text("subclause", one.subclause);
        json.truth("listingChecked", one.listing_checked);
        json.text("parameter", one.parameter);
        json.text("kind", to_string(one.kind));
        json.text("value", value_of(one));
        if (one.number != 0)
            json.number("number", one.number);
        if (one.diagnostic)
            write_code(json, "reportedBy", *one.diagnostic);
        json.end('}');
    }
    json.end(']');
}

void write_annex_e(JsonWriter& json) {
    json.begin('[', "annexE");
    for (const AnnexEError& error : annex_e()) {
        json.begin('{');
        json.number("row", error.row);
        json.text("subclause", error.subclause);
        json.text("condition", error.condition);
        json.text("treatment", to_string(error.treatment));
        json.text("reason", error.reason);
        json.begin('[', "reportedBy");
        for (const DiagnosticId id : diagnostics_of(error))
            write_code(json, {}, id);
        json.end(']');
        json.end('}');
    }
    json.end(']');
}

void write_extensions(JsonWriter& json) {
    json.begin('[', "extensions");
    for (const Extension& one : extensions()) {
        const DiagnosticInfo& info = diagnostic_info(one.diagnostic);
        json.begin('{');
        json.text("name", info.name);
        write_code(json, "code", one.diagnostic);
        json.text("extends", to_string(one.language));
        json.text("since", one.since);
        json.text("byDefault", to_string(info.default_severity));
        json.text("description", one.description);
        json.end('}');
    }
    json.end(']');
}

void write_dialects(JsonWriter& json) {
    json.begin('[', "dialects");
    for (const Dialect& dialect : dialects()) {
        json.begin('{');
        json.text("name", dialect.name);
        json.text("description", dialect.description);
        json.begin('[', "extensions");
        for (const DialectExtension& one : dialect.extensions) {
            json.begin('{');
            json.text("name", diagnostic_info(one.diagnostic).name);
            json.text("treatment", to_string(one.treatment));
            json.end('}');
        }
        json.end(']');
        json.end('}');
    }
    json.end(']');
}

} // namespace

std::string json_statement(std::string_view product) {
    JsonWriter json;
    json.begin('{');
    json.text("product", product);
    json.text("standard", "IEC 61131-3:2003");
    write_requirements(json);
    write_features(json);
    write_never_examined(json);
    write_annex_d(json);
    write_annex_e(json);
    write_extensions(json);
    write_dialects(json);
    json.end('}');
    return std::move(json).take();
}

} // namespace iecfront
