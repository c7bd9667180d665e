#include "support/sarif_faults.hpp"

#include <algorithm>
#include <set>
#include <string_view>

namespace iecfront::test {
namespace {

using Kind = JsonValue::Kind;

class SarifReader {
public:
    [[nodiscard]] std::vector<std::string> read(const JsonValue& log) {
        expect(log["$schema"].kind == Kind::string, "$schema is no string");
        expect(log["version"].text == "2.1.0", "version is not 2.1.0");
        expect(log["runs"].items.size() == 1, "there is not one run");
        for (const JsonValue& run : log["runs"].items)
            read_run(run);
        return std::move(faults_);
    }

private:
    void expect(bool condition, const std::string& fault) {
        if (!condition)
            faults_.push_back(fault);
    }

    void read_run(const JsonValue& run) {
        const JsonValue& driver = run["tool"]["driver"];
        expect(!driver["name"].text.empty(), "the tool has no name");
        for (const JsonValue& rule : driver["rules"].items)
            read_rule(rule);
        expect(run["columnKind"].text == "unicodeCodePoints", "columnKind");
        for (const JsonMember& base : run["originalUriBaseIds"].members)
            bases_.insert(base.name);
        for (const JsonValue& invocation : run["invocations"].items)
            read_invocation(invocation);
        expect(run["results"].kind == Kind::array, "results is no array");
        for (const JsonValue& result : run["results"].items)
            read_result(result);
    }

    void read_rule(const JsonValue& rule) {
        const std::string& id = rule["id"].text;
        expect(!id.empty() && rules_.insert(id).second, "rule id `" + id + "`");
        expect(!rule["name"].text.empty(), id + " has no name");
        read_message(rule["shortDescription"], id + ": shortDescription");
        if (rule["help"].kind != Kind::null)
            read_message(rule["help"], id + ": help");
        read_level(rule["defaultConfiguration"]["level"], id);
    }

    void read_invocation(const JsonValue& invocation) {
        expect(invocation["executionSuccessful"].kind == Kind::boolean, "executionSuccessful");
        for (const JsonValue& one : invocation["toolExecutionNotifications"].items) {
            read_level(one["level"], "notification");
            read_message(one["message"], "notification");
        }
    }

    void read_result(const JsonValue& result) {
        const std::string& id = result["ruleId"].text;
        expect(rules_.contains(id), "`" + id + "` is none of the rules");
        read_level(result["level"], id);
        read_message(result["message"], id + ": message");
        expect(result["locations"].items.size() == 1, id + " has not one location");
        for (const JsonValue& location : result["locations"].items)
            read_location(location, id);
        for (const JsonValue& location : result["relatedLocations"].items) {
            read_location(location, id + ": relatedLocations");
            read_message(location["message"], id + ": relatedLocations");
        }
        for (const JsonValue& fix : result["fixes"].items)
            read_fix(fix, id);
    }

    void read_level(const JsonValue& level, const std::string& where) {
        static constexpr std::string_view levels[] = {"none", "note", "warning", "error"};
        expect(std::find(std::begin(levels), std::end(levels), level.text) != std::end(levels),
               where + ": level `" + level.text + "`");
    }

    void read_message(const JsonValue& message, const std::string& where) {
        expect(message["text"].kind == Kind::string && !message["text"].text.empty(),
               where + " has no text");
    }

    void read_location(const JsonValue& location, const std::string& where) {
        const JsonValue& physical = location["physicalLocation"];
        read_artifact(physical["artifactLocation"], where);
        read_region(physical["region"], where);
    }

    void read_artifact(const JsonValue& artifact, const std::string& where) {
        static constexpr std::string_view plain =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/:%";
        const std::string& uri = artifact["uri"].text;
        expect(!uri.empty() && uri.find_first_not_of(plain) == uri.npos, where + ": URI " + uri);
        const bool absolute = uri.starts_with("file:///");
        const bool known = bases_.contains(artifact["uriBaseId"].text);
        expect(absolute != known, where + ": base of " + uri);
    }

    void read_region(const JsonValue& region, const std::string& where) {
        const auto number = [&](std::string_view name) {
            const JsonValue& value = region[name];
            return value.kind == Kind::number ? std::stoul(value.text) : 0;
        };
        const auto line = number("startLine");
        const auto column = number("startColumn");
        expect(line > 0 && column > 0, where + ": the region begins nowhere");
        expect(number("endLine") > line ||
                   (number("endLine") == line && number("endColumn") >= column),
               where + ": the region ends before it begins");
    }

    void read_fix(const JsonValue& fix, const std::string& where) {
        read_message(fix["description"], where + ": fix");
        expect(!fix["artifactChanges"].items.empty(), where + ": a fix without changes");
        for (const JsonValue& change : fix["artifactChanges"].items) {
            read_artifact(change["artifactLocation"], where + ": fix");
            expect(!change["replacements"].items.empty(), where + ": a change without any");
            for (const JsonValue& replacement : change["replacements"].items)
                read_region(replacement["deletedRegion"], where + ": fix");
        }
    }

    std::set<std::string> rules_;
    std::set<std::string> bases_;
    std::vector<std::string> faults_;
};

} // namespace

std::vector<std::string> sarif_faults(const JsonValue& log) {
    return SarifReader().read(log);
}

} // namespace iecfront::test
