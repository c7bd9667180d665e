#include "support/json.hpp"
#include "support/sarif_faults.hpp"

#include <iecfront/diagnostics/render_sarif.hpp>

#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace iecfront;

namespace {

using Faults = std::vector<std::string>;

Diagnostic missing_closer() {
    Diagnostic diagnostic;
    diagnostic.id = DiagnosticId::missing_closing_word;
    diagnostic.range = {9, 9};
    diagnostic.arguments = {"END_IF", "IF"};
    diagnostic.labels = {{{0, 2}, LabelId::opened_here, "IF"}};
    diagnostic.fixes = {{{{{3, 4}, {}}, {{9, 9}, "\nEND_IF;"}}}};
    return diagnostic;
}

std::string result_of(const Diagnostic& diagnostic, const SourceText& source) {
    std::string out;
    EXPECT_TRUE(render_sarif(out, diagnostic, Severity::error, source, LineTable(source.bytes())));
    return out;
}

SarifRun run_with(std::vector<SarifRule> rules) {
    return {"checker", "1.2.3", std::move(rules), Determination::violations, {}, {}};
}

test::JsonValue log_of(const SarifRun& run, const std::string& results) {
    const std::string text = begin_sarif_log(run) + results + std::string(end_sarif_log());
    return test::read_json(text).value_or(test::JsonValue{});
}

std::string uri_of(const std::string& name) {
    const SourceText source("IF a", name);
    Diagnostic diagnostic;
    const auto result = test::read_json(result_of(diagnostic, source));
    return (*result)["locations"][0]["physicalLocation"]["artifactLocation"]["uri"].text;
}

// As in text: a URI has to be there.
TEST(RenderSarif, NamesATextWithoutAName) {
    EXPECT_EQ(uri_of(""), "%3Ctext%3E");
}

TEST(RenderSarif, GivesAResultWithAllThatADiagnosticHas) {
    const SourceText source("IF a\nx:=1", "src/a b.st");
    const std::string artifact = R"({"uri":"src/a%20b.st","uriBaseId":"%SRCROOT%"})";
    const std::string expected =
        R"({"ruleId":"IEC2002","level":"error",)"
        R"("message":{"text":"`END_IF` is missing: it closes `IF`"},)"
        R"("locations":[{"physicalLocation":{"artifactLocation":)" +
        artifact +
        R"(,"region":{"startLine":2,"startColumn":5,"endLine":2,"endColumn":5}}}],)"
        R"("relatedLocations":[{"physicalLocation":{"artifactLocation":)" +
        artifact +
        R"(,"region":{"startLine":1,"startColumn":1,"endLine":1,"endColumn":3}},)"
        R"("message":{"text":"`IF` begins here"}}],)"
        R"("fixes":[{"description":{"text":"remove `a` and insert `END_IF;`"},)"
        R"("artifactChanges":[{"artifactLocation":)" +
        artifact +
        R"(,"replacements":[{"deletedRegion":)"
        R"({"startLine":1,"startColumn":4,"endLine":1,"endColumn":5}},)"
        R"({"deletedRegion":{"startLine":2,"startColumn":5,"endLine":2,"endColumn":5},)"
        R"("insertedContent":{"text":"\nEND_IF;"}}]}]}]})";
    EXPECT_EQ(result_of(missing_closer(), source), expected);
}

TEST(RenderSarif, LeavesOutWhatIsAllowed) {
    const SourceText source("IF a\nx:=1");
    std::string out = "before";
    EXPECT_FALSE(
        render_sarif(out, missing_closer(), Severity::allow, source, LineTable(source.bytes())));
    EXPECT_EQ(out, "before");
}

TEST(RenderSarif, CountsColumnsInCodePoints) {
    const SourceText source("'\xF0\x9F\x98\x80' IF", "a.st");
    Diagnostic diagnostic;
    diagnostic.range = {7, 9};
    const auto result = test::read_json(result_of(diagnostic, source));
    EXPECT_EQ((*result)["locations"][0]["physicalLocation"]["region"]["startColumn"].text, "5");
}

// An absolute URI is resolved against nothing (3.4.4 of the format).
TEST(RenderSarif, GivesABaseToRelativePathsOnly) {
    const auto base_of = [](const std::string& name) {
        const auto result = test::read_json(result_of({}, SourceText("IF a", name)));
        return (*result)["locations"][0]["physicalLocation"]["artifactLocation"]["uriBaseId"].text;
    };
    EXPECT_EQ(base_of("plant/b.st"), "%SRCROOT%");
    EXPECT_EQ(base_of("/plant/b.st"), "");
}

TEST(RenderSarif, MakesUrisOfPaths) {
    EXPECT_EQ(uri_of("a/b.st"), "a/b.st");
    EXPECT_EQ(uri_of("a\\b.st"), "a/b.st");
    EXPECT_EQ(uri_of("/plant 1/b.st"), "file:///plant%201/b.st");
    EXPECT_EQ(uri_of("C:\\plant\\b.st"), "file:///C:/plant/b.st");
    EXPECT_EQ(uri_of("\xC3\x84#?.st"), "%C3%84%23%3F.st");
    EXPECT_EQ(uri_of("\xFF.st"), "%FF.st");
    EXPECT_EQ(uri_of("<stdin>"), "%3Cstdin%3E");
}

TEST(SarifLog, IsByTheRulesOfTheSchema) {
    const SourceText source("IF a\nx:=1", "a.st");
    SarifRun run = run_with({{DiagnosticId::missing_closing_word, "# help"}});
    run.not_examined = {"meaning"};
    const test::JsonValue log = log_of(run, result_of(missing_closer(), source));
    EXPECT_EQ(test::sarif_faults(log), Faults{});
    const test::JsonValue& one = log["runs"][0];
    EXPECT_EQ(one["tool"]["driver"]["name"].text, "checker");
    EXPECT_EQ(one["tool"]["driver"]["semanticVersion"].text, "1.2.3");
    EXPECT_EQ(one["tool"]["driver"]["rules"][0]["help"]["markdown"].text, "# help");
    EXPECT_EQ(one["tool"]["driver"]["rules"][0]["properties"]["clause"].text, "Annex B");
    EXPECT_EQ(one["properties"]["determination"].text, "violations");
    EXPECT_EQ(one["invocations"][0]["executionSuccessful"].text, "true");
    EXPECT_EQ(one["invocations"][0]["toolExecutionNotifications"][0]["level"].text, "note");
}

TEST(SarifLog, SaysWhatCouldNotBeRead) {
    SarifRun run = run_with({});
    run.problems = {"a.st: no such file"};
    const test::JsonValue log = log_of(run, "");
    EXPECT_EQ(test::sarif_faults(log), Faults{});
    const test::JsonValue& invocation = log["runs"][0]["invocations"][0];
    EXPECT_EQ(invocation["executionSuccessful"].text, "false");
    EXPECT_EQ(invocation["toolExecutionNotifications"][0]["level"].text, "error");
    EXPECT_EQ(invocation["toolExecutionNotifications"][0]["message"]["text"].text,
              "a.st: no such file");
}

// The check itself tells what is wrong.
TEST(SarifLog, IsCheckedForRulesThatAreMissing) {
    const SourceText source("IF a\nx:=1", "a.st");
    EXPECT_EQ(test::sarif_faults(log_of(run_with({}), result_of(missing_closer(), source))),
              Faults{"`IEC2002` is none of the rules"});
}

} // namespace
