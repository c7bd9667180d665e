#include "cli/command.hpp"
#include "support/sarif_faults.hpp"

#include <iecfront/diagnostics/severity.hpp>

#include <algorithm>

namespace iecfront::test {
namespace {

using CheckCommand = CommandTest;

[[nodiscard]] std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

[[nodiscard]] bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

// ---- determination and status
// --------------------------------------------------------------------

TEST_F(CheckCommand, SaysThatNothingWasFoundAndWhatIsNeverExamined) {
    write("good.st", good_program);
    const Outcome outcome = run({"check", "good.st"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    std::string expected = "1 file: no violations found, but the examination is incomplete\n";
    for (const std::string_view line : never_examined())
        expected += "  never examined by this version: " + std::string(line) + "\n";
    if (never_examined().empty())
        expected = "1 file: no violations\n";
    EXPECT_EQ(outcome.out, expected);
}

TEST_F(CheckCommand, PrintsAClickableLineTheSourceAndTheRemedy) {
    write("bad.st", bad_program);
    const Outcome outcome = run({"check", "bad.st"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "bad.st:3:7: error IEC2006: `;` is missing\n"
                           "  3 | x := 1\n"
                           "    |       ^\n"
                           "help: insert `;`\n"
                           "1 file, 1 error: violations were found\n");
}

TEST_F(CheckCommand, WarningsOfExtensionsLeaveTheStatus) {
    write("extended.st", extended_program);
    const Outcome outcome = run({"check", "--warn", "extension", "extended.st"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.out.starts_with("extended.st:3:9: warning IEC5001: ")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "\n1 file, 1 warning: no violations found, but"));
}

TEST_F(CheckCommand, ADialectTakesItsExtensions) {
    write("extended.st", extended_program);
    EXPECT_EQ(run({"check", "extended.st"}).status, 1);
    EXPECT_EQ(run({"check", "--dialect", "iec2", "extended.st"}).status, 1);
    EXPECT_EQ(run({"check", "--dialect", "iec2-tools", "extended.st"}).status, 0);
    EXPECT_EQ(
        run({"check", "--dialect=iec2-tools", "--deny", "line-comment", "extended.st"}).status, 1);
    EXPECT_EQ(run({"check", "--strict", "--dialect=iec2-tools", "extended.st"}).status, 1);
    const Outcome unknown = run({"check", "--dialect", "iec2-tool", "extended.st"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_TRUE(contains(unknown.err, "did you mean `iec2-tools`")) << unknown.err;
}

TEST_F(CheckCommand, AViolationStaysOneAsAWarning) {
    write("bad.st", bad_program);
    const Outcome outcome = run({"check", "--warn", "missing-semicolon", "bad.st"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.out.starts_with("bad.st:3:7: warning IEC2006: ")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "\n1 file, 1 warning: violations were found\n"));
}

TEST_F(CheckCommand, SeveritiesCanBeSet) {
    write("extended.st", extended_program);
    const auto status = [&](std::vector<std::string> options) {
        options.insert(options.begin(), "check");
        options.push_back("extended.st");
        return run(options).status;
    };
    EXPECT_EQ(status({"--warn", "extension"}), 0);
    EXPECT_EQ(status({"--deny", "extension"}), 1);
    EXPECT_EQ(status({"--deny=IEC5001"}), 1);
    EXPECT_EQ(status({"--deny", "iec5001"}), 1);
    EXPECT_EQ(status({"--deny", "line-comment", "--warn", "line-comment"}), 0);
    EXPECT_EQ(status({"--warn", "line-comment", "--deny", "line-comment"}), 1);
    EXPECT_EQ(status({"--warn", "line-comment", "--strict"}), 0);
    EXPECT_EQ(status({"--allow", "extension", "--strict"}), 1);
    EXPECT_EQ(status({"--strict", "--allow", "extension"}), 0);
    EXPECT_EQ(status({"--strict", "--warn", "line-comment"}), 0);
    EXPECT_EQ(status({"--deny", "line-comment", "--allow", "extension"}), 1);
    EXPECT_FALSE(contains(run({"check", "--allow", "extension", "extended.st"}).out, "IEC5001"));
}

TEST_F(CheckCommand, StrictLetsNoRelianceOnTheImplementationPass) {
    write("pragma.st", "{ any }\n" + std::string(good_program));
    EXPECT_EQ(run({"check", "pragma.st"}).status, 0);
    const Outcome outcome = run({"check", "--strict", "pragma.st"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.out.starts_with("pragma.st:1:1: error IEC6001: ")) << outcome.out;
    EXPECT_EQ(run({"check", "--allow", "pragma", "--strict", "pragma.st"}).status, 0);
}

TEST_F(CheckCommand, AnAllowedViolationIsNotReportedButLeavesTheExaminationIncomplete) {
    write("bad.st", bad_program);
    const Outcome outcome = run({"check", "--allow", "missing-semicolon", "bad.st"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.out.starts_with("1 file: no violations found, but the examination is "
                                        "incomplete\n"))
        << outcome.out;
}

TEST_F(CheckCommand, ALimitGivesAStatusOfItsOwn) {
    write("deep.st", deep_program);
    EXPECT_EQ(run({"check", "deep.st"}).status, 0);
    const Outcome outcome = run({"check", "--max-nesting", "5", "deep.st"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_TRUE(contains(outcome.out, "deep.st:3:")) << outcome.out;
    EXPECT_TRUE(contains(
        outcome.out,
        "\n  not examined: IEC9002 nesting-too-deep (Annex D, 3.3.1: length of expressions)\n"))
        << outcome.out;
}

TEST_F(CheckCommand, EachLimitCanBeSet) {
    struct Limit {
        std::string_view option;
        std::string_view enough;
        std::string_view too_little;
        std::string_view code;
    };
    constexpr Limit limits[] = {
        {"--max-nesting", "20", "5", "IEC9002"},
        {"--max-identifier-length", "4", "3", "IEC9009"},
        {"--max-source-size", "1000", "20", "IEC9001"},
        {"--max-unit-memory", "100000", "300", "IEC9011"},
        {"--max-diagnostics", "2", "1", "IEC9010"},
    };
    write("deep.st", deep_program);
    write("twice.st", std::string(bad_program) + std::string(bad_program));
    for (const Limit& limit : limits) {
        const auto said = [&](std::string_view value) {
            const Outcome outcome = run(
                {"check", std::string(limit.option), std::string(value), "deep.st", "twice.st"});
            EXPECT_NE(outcome.status, 2) << outcome.err;
            return contains(outcome.out, limit.code);
        };
        EXPECT_TRUE(said(limit.too_little)) << limit.option;
        EXPECT_FALSE(said(limit.enough)) << limit.option;
    }
}

TEST_F(CheckCommand, ALimitThatIsNotReportedIsStillSaid) {
    write("deep.st", deep_program);
    const Outcome outcome = run({"check", "--max-nesting", "5", "--allow", "limit", "deep.st"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_TRUE(contains(
        outcome.out,
        "\n  not examined: IEC9002 nesting-too-deep (Annex D, 3.3.1: length of expressions)\n"))
        << outcome.out;
}

TEST_F(CheckCommand, ALimitIsNoViolationAlsoAsAnError) {
    write("deep.st", deep_program);
    const Outcome outcome = run({"check", "--max-nesting", "5", "--deny", "limit", "deep.st"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_TRUE(contains(outcome.out, ": error IEC9002: ")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, ": no violations found, but the examination is incomplete"));
}

TEST_F(CheckCommand, ViolationsCountMoreThanLimits) {
    write("deep.st", deep_program);
    write("bad.st", bad_program);
    EXPECT_EQ(run({"check", "--max-nesting", "5", "deep.st", "bad.st"}).status, 1);
}

// ---- JSON
// ----------------------------------------------------------------------------------------

TEST_F(CheckCommand, JsonIsOneObject) {
    write("good.st", good_program);
    const JsonValue json = run_json({"check", "--format", "json", "good.st"});
    EXPECT_EQ(json.names(), "determination notExamined files diagnostics");
    EXPECT_EQ(json["determination"].text,
              never_examined().empty() ? "no-violations" : "incomplete");
    EXPECT_EQ(json["notExamined"].items.size(), never_examined().size());
    EXPECT_EQ(json["files"].text, "1");
    EXPECT_EQ(json["diagnostics"].kind, JsonValue::Kind::array);
    EXPECT_TRUE(json["diagnostics"].items.empty());
}

TEST_F(CheckCommand, JsonHoldsTheDiagnosticsOfAllFilesInOrder) {
    write("a.st", bad_program);
    write("b.st", good_program);
    write("c.st", extended_program);
    const JsonValue json =
        run_json({"check", "--format=json", "--warn=extension", "c.st", "b.st", "a.st"});
    EXPECT_EQ(json["determination"].text, "violations");
    EXPECT_EQ(json["files"].text, "3");
    ASSERT_EQ(json["diagnostics"].items.size(), 2U);
    const JsonValue& first = json["diagnostics"][0];
    EXPECT_EQ(first["file"].text, "c.st");
    EXPECT_EQ(first["severity"].text, "warning");
    const JsonValue& second = json["diagnostics"][1];
    EXPECT_EQ(second.names(),
              "file line column endLine endColumn offset endOffset code name severity class "
              "clause message labels fixes");
    EXPECT_EQ(second["file"].text, "a.st");
    EXPECT_EQ(second["line"].text, "3");
    EXPECT_EQ(second["column"].text, "7");
    EXPECT_EQ(second["offset"].text, "39");
    EXPECT_EQ(second["fixes"][0]["edits"][0]["text"].text, ";");
}

TEST_F(CheckCommand, JsonSaysWhatWasLeftOut) {
    write("deep.st", deep_program);
    const Outcome outcome =
        run({"check", "--format=json", "--max-nesting=5", "missing.st", "deep.st"});
    EXPECT_EQ(outcome.status, 2);
    const std::optional<JsonValue> json = read_json(outcome.out);
    ASSERT_TRUE(json.has_value()) << outcome.out;
    EXPECT_EQ((*json)["files"].text, "1");
    EXPECT_EQ((*json)["notExamined"][0].text, "missing.st: No such file or directory");
    EXPECT_EQ((*json)["notExamined"][1].text,
              "IEC9002 nesting-too-deep (Annex D, 3.3.1: length of expressions)");
}

TEST_F(CheckCommand, SarifHoldsTheFindingsOfAllFilesAndTheirRules) {
    write("a.st", bad_program);
    write("b.st", good_program);
    write("c.st", extended_program);
    const JsonValue log =
        run_json({"check", "--format=sarif", "--warn=extension", "c.st", "b.st", "a.st"});
    EXPECT_EQ(sarif_faults(log), std::vector<std::string>{});
    const JsonValue& one = log["runs"][0];
    EXPECT_EQ(one["properties"]["determination"].text, "violations");
    ASSERT_EQ(one["results"].items.size(), 2U);
    EXPECT_EQ(one["results"][0]["level"].text, "warning");
    EXPECT_EQ(one["results"][1]["ruleId"].text, "IEC2006");
    ASSERT_EQ(one["tool"]["driver"]["rules"].items.size(), 2U);
    const JsonValue& rule = one["tool"]["driver"]["rules"][0];
    EXPECT_EQ(rule["id"].text, "IEC2006");
    EXPECT_TRUE(rule["help"]["markdown"].text.starts_with("# IEC2006 missing-semicolon\n"));
    EXPECT_EQ(one["invocations"][0]["toolExecutionNotifications"].items.size(),
              never_examined().size());
}

TEST_F(CheckCommand, SarifSaysWhatCouldNotBeRead) {
    write("deep.st", deep_program);
    const Outcome outcome =
        run({"check", "--format=sarif", "--max-nesting=5", "missing.st", "deep.st"});
    EXPECT_EQ(outcome.status, 2);
    const std::optional<JsonValue> log = read_json(outcome.out);
    ASSERT_TRUE(log.has_value()) << outcome.out;
    EXPECT_EQ(sarif_faults(*log), std::vector<std::string>{});
    const JsonValue& invocation = (*log)["runs"][0]["invocations"][0];
    EXPECT_EQ(invocation["executionSuccessful"].text, "false");
    const JsonValue& notes = invocation["toolExecutionNotifications"];
    EXPECT_EQ(notes[0]["message"]["text"].text, "missing.st: No such file or directory");
    EXPECT_EQ(notes[1]["message"]["text"].text,
              "IEC9002 nesting-too-deep (Annex D, 3.3.1: length of expressions)");
}

TEST_F(CheckCommand, JsonAndSarifAreWellFormedForAnyBytes) {
    std::string bytes;
    for (int i = 0; i < 4096; ++i)
        bytes += static_cast<char>((i * 167 + i / 256) & 0xFF);
    write("x\xFF\"\n.st", bytes);
    for (const char* encoding : {"utf-8", "iso-8859-1", "windows-1252"}) {
        static_cast<void>(run_json({"check", "--format=json", "--encoding", encoding, "."}));
        const JsonValue log = run_json({"check", "--format=sarif", "--encoding", encoding, "."});
        EXPECT_EQ(sarif_faults(log), std::vector<std::string>{});
    }
}

// ---- inputs
// --------------------------------------------------------------------------------------

TEST_F(CheckCommand, WhatCannotBeReadIsOneLineAndTheRestIsRead) {
    write("good.st", good_program);
    write("bad.st", bad_program);
    const Outcome outcome = run({"check", "one.st", "bad.st", "two.st", "good.st"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "iecfront: one.st: No such file or directory\n"
                           "iecfront: two.st: No such file or directory\n");
    EXPECT_TRUE(contains(outcome.out, "bad.st:3:7: error")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "\n2 files, 1 error: violations were found\n"
                                      "  not examined: one.st: No such file or directory\n"
                                      "  not examined: two.st: No such file or directory\n"))
        << outcome.out;
}

TEST_F(CheckCommand, NothingReadIsNothingExamined) {
    const Outcome outcome = run({"check", "missing.st"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "0 files: nothing was examined\n"
                           "  not examined: missing.st: No such file or directory\n");
}

TEST_F(CheckCommand, FoldersAreReadToTheirDepthInOrder) {
    write("d/z.ST", bad_program);
    write("d/sub/b.Pou", bad_program);
    write("d/sub/deeper/c.iec", bad_program);
    write("d/a.sfc", bad_program);
    write("d/e.il", bad_program);
    write("d/readme.txt", bad_program);
    write("d/st", bad_program);
    std::filesystem::create_directory_symlink("..", folder() / "d/sub/loop");
    std::filesystem::create_directory(folder() / "d/folder.st");
    const JsonValue json = run_json({"check", "--format=json", "d"});
    std::string files;
    for (const JsonValue& diagnostic : json["diagnostics"].items)
        files += diagnostic["file"].text + " ";
    EXPECT_EQ(files, "d/a.sfc d/e.il d/sub/b.Pou d/sub/deeper/c.iec d/z.ST ");
}

TEST_F(CheckCommand, AFolderWithoutSourcesIsSaid) {
    std::filesystem::create_directory(folder() / "d");
    const Outcome outcome = run({"check", "d"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "iecfront: d: no *.st, *.il, *.sfc, *.iec or *.pou in this folder\n");
}

TEST_F(CheckCommand, ADanglingLinkIsSaid) {
    std::filesystem::create_symlink("nowhere.st", folder() / "link.st");
    const Outcome outcome = run({"check", "."});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "iecfront: ./link.st: No such file or directory\n");
}

TEST_F(CheckCommand, StandardInputIsReadWhenNamed) {
    const Outcome outcome = run({"check", "-"}, bad_program);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(first_line(outcome.out), "<stdin>:3:7: error IEC2006: `;` is missing");
}

TEST_F(CheckCommand, AResponseFileHoldsArguments) {
    write("with space.st", bad_program);
    write("list", "\xEF\xBB\xBF--allow=missing-semicolon\r\n\n@more\r\n");
    write("more", "with space.st");
    const Outcome outcome = run({"check", "@list"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("1 file:")) << outcome.out;
}

TEST_F(CheckCommand, AResponseFileThatCannotBeUsedIsSaid) {
    write("circle", "@circle\n");
    const Outcome circle = run({"check", "@circle"});
    EXPECT_EQ(circle.status, 2);
    EXPECT_EQ(first_line(circle.err), "iecfront: response file circle includes itself");
    const Outcome missing = run({"check", "@missing"});
    EXPECT_EQ(missing.status, 2);
    EXPECT_EQ(first_line(missing.err),
              "iecfront: response file missing: No such file or directory");
}

TEST_F(CheckCommand, TwoDashesEndTheOptions) {
    write("--strict", bad_program);
    write("@list", bad_program);
    const Outcome outcome = run({"check", "--", "--strict", "@list"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(contains(outcome.out, "2 files, 2 errors")) << outcome.out << outcome.err;
}

TEST_F(CheckCommand, OptionsMayFollowFiles) {
    write("extended.st", extended_program);
    EXPECT_EQ(run({"check", "extended.st", "--warn", "extension"}).status, 0);
}

TEST_F(CheckCommand, TheOutputIsTheSameForAnyNumberOfJobs) {
    std::vector<std::string> arguments = {"check", "--jobs", "1"};
    for (int i = 0; i < 60; ++i) {
        const std::string name = "file" + std::to_string(i) + ".st";
        if (i % 7 != 3)
            write(name, i % 3 == 0 ? bad_program : extended_program);
        arguments.push_back(name);
    }
    const Outcome one = run(arguments);
    EXPECT_EQ(one.status, 2);
    for (const char* jobs : {"2", "3", "16", "1024"}) {
        arguments[2] = jobs;
        const Outcome several = run(arguments);
        EXPECT_EQ(several.status, one.status);
        EXPECT_EQ(several.out, one.out);
        EXPECT_EQ(several.err, one.err);
    }
}

// ---- texts
// ---------------------------------------------------------------------------------------

TEST_F(CheckCommand, AnEmptyFileHasNothingWrong) {
    write("empty.st", "");
    const Outcome outcome = run({"check", "empty.st"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.out.starts_with("1 file:")) << outcome.out;
}

TEST_F(CheckCommand, LineEndsAndByteOrderMarkMoveNothing) {
    write("crlf.st", "PROGRAM p\r\nVAR x : INT; END_VAR\r\nx := 1\r\nx := 2;\r\nEND_PROGRAM\r\n");
    write("cr.st", "PROGRAM p\rVAR x : INT; END_VAR\rx := 1\rx := 2;\rEND_PROGRAM\r");
    write("bom.st", "\xEF\xBB\xBF" + std::string(bad_program));
    for (const char* name : {"crlf.st", "cr.st", "bom.st"})
        EXPECT_EQ(first_line(run({"check", name}).out),
                  name + std::string(":3:7: error IEC2006: `;` is missing"));
}

TEST_F(CheckCommand, EncodingsAreAsTold) {
    write("latin.st", "PROGRAM p\nVAR s : STRING; END_VAR\ns := '\xC4\xCB';\nEND_PROGRAM\n");
    EXPECT_EQ(run({"check", "latin.st"}).status, 1);
    EXPECT_EQ(run({"check", "--encoding", "iso-8859-1", "latin.st"}).status, 0);
    EXPECT_EQ(run({"check", "--encoding", "CP1252", "latin.st"}).status, 0);
}

TEST_F(CheckCommand, BytesOfAnotherKindGiveAnAnswer) {
    write("zero.st", std::string(100000, '\0'));
    const Outcome zero = run({"check", "zero.st"});
    EXPECT_EQ(zero.status, 1);
    EXPECT_LT(zero.out.size(), 10000U) << "a run of the same fault is one report";

    std::string noise;
    for (unsigned i = 0, x = 1; i < 100000; ++i, x = x * 1664525U + 1013904223U)
        noise += static_cast<char>(x >> 24U);
    write("noise.st", noise);
    const Outcome outcome = run({"check", "noise.st"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(contains(outcome.out, " not shown; --max-findings 0 shows all\n"));
}

TEST_F(CheckCommand, Utf16IsNamedAndNotRead) {
    write("mark.st", std::string("\xFF\xFEP\0R\0", 6));
    write("big.st", std::string("\0P\0R\0O", 6));
    const Outcome outcome = run({"check", "mark.st", "big.st"});
    EXPECT_EQ(outcome.status, 2);
    const std::string problem =
        ": this is UTF-16, which cannot be read; save it as UTF-8, ISO 8859-1 or Windows-1252\n";
    EXPECT_EQ(outcome.err, "iecfront: mark.st" + problem + "iecfront: big.st" + problem);
}

TEST_F(CheckCommand, TooManyFindingsAreCountedButNotShown) {
    write("bad.st", "PROGRAM p\nx := 1\ny := 2\nz := 3\nEND_PROGRAM\n");
    const auto shown = [&](const char* most) {
        const std::string out = run({"check", "--max-findings", most, "bad.st"}).out;
        EXPECT_TRUE(contains(out, "1 file, 3 errors: violations were found\n")) << out;
        std::size_t count = 0;
        for (std::size_t at = out.find(": error "); at != out.npos;
             at = out.find(": error ", at + 1))
            ++count;
        return count;
    };
    EXPECT_EQ(shown("1"), 1U);
    EXPECT_EQ(shown("2"), 2U);
    EXPECT_EQ(shown("3"), 3U);
    EXPECT_EQ(shown("0"), 3U);
    EXPECT_TRUE(contains(run({"check", "--max-findings=1", "bad.st"}).out,
                         "bad.st: 2 more findings not shown; --max-findings 0 shows all\n"));
}

TEST_F(CheckCommand, ATextBeyondTheLimitIsNotRead) {
    write("large.st", "");
    std::filesystem::resize_file(folder() / "large.st", std::uintmax_t{1} << 32U); // sparse
    const Outcome outcome = run({"check", "large.st"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_TRUE(outcome.out.starts_with("large.st:1:1: warning IEC9001: ")) << outcome.out;
}

// ---- output
// --------------------------------------------------------------------------------------

TEST_F(CheckCommand, ColourIsForTerminals) {
    write("bad.st", bad_program);
    EXPECT_FALSE(contains(run({"check", "bad.st"}).out, "\x1B["));
    EXPECT_FALSE(contains(run({"check", "--color", "never", "bad.st"}).out, "\x1B["));
    EXPECT_TRUE(contains(run({"check", "--color=always", "bad.st"}).out, "\x1B["));
    EXPECT_FALSE(contains(run({"check", "--color=always", "--format=json", "bad.st"}).out, "\x1B"));
}

} // namespace
} // namespace iecfront::test
