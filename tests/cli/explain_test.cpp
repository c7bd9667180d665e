#include "cli/command.hpp"
#include "support/repository_files.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>

namespace iecfront::test {
namespace {

using ExplainCommand = CommandTest;

TEST_F(ExplainCommand, PrintsThePageOfACode) {
    const auto pages = repository_files({"docs"}, {".md"});
    std::size_t count = 0;
    for (const RepositoryFile& page : pages) {
        constexpr std::string_view folder = "docs/diagnostics/IEC";
        if (!page.path.starts_with(folder))
            continue;
        const std::string code = "IEC" + page.path.substr(folder.size(), 4);
        const Outcome outcome = run({"explain", code});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_TRUE(outcome.out.starts_with(page.text)) << outcome.out;
        ++count;
    }
    EXPECT_GT(count, 0U);
}

TEST_F(ExplainCommand, TakesNamesAndCodesInAnyCase) {
    const Outcome code = run({"explain", "IEC2006"});
    EXPECT_EQ(code.status, 0);
    EXPECT_EQ(run({"explain", "iec2006"}).out, code.out);
    EXPECT_EQ(run({"explain", "Missing-Semicolon"}).out, code.out);
    EXPECT_EQ(run({"explain", "IEC2006", "missing-semicolon"}).out, code.out + "\n" + code.out);
}

TEST_F(ExplainCommand, KnowsEveryDiagnostic) {
    std::vector<std::string> arguments = {"explain"};
    for (const DiagnosticInfo& row : diagnostic_catalogue())
        arguments.emplace_back(row.name);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (const DiagnosticInfo& row : diagnostic_catalogue())
        EXPECT_NE(outcome.out.find("# " + code_string(row.id)), std::string::npos) << row.name;
}

TEST_F(ExplainCommand, TellsHowToTakeAnExtension) {
    const Outcome outcome = run({"explain", "line-comment"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.out.starts_with("# IEC5001 line-comment\n"));
    EXPECT_NE(outcome.out.find("since 0.1.0: comments that begin with `//`"), std::string::npos);
    EXPECT_NE(outcome.out.find("--allow line-comment"), std::string::npos);
    EXPECT_EQ(run({"explain", "IEC2006"}).out.find("## Extension"), std::string::npos);
}

TEST_F(ExplainCommand, TellsOfAFeature) {
    EXPECT_EQ(run({"explain", "4.2"}).out,
              "# Table 4, feature 2: real literals\n\n"
              "Table 4: numeric literals. Clause: 2.2.1. Group: Common elements.\n\n"
              "Status: supported.\n");
    const Outcome function = run({"explain", "23.1"});
    EXPECT_EQ(function.status, 0);
    EXPECT_NE(function.out.find("Status: front-end part only: "), std::string::npos);
    EXPECT_NE(function.out.find("not compared with the text"), std::string::npos);
    EXPECT_EQ(run({"explain", "4.99"}).status, 2);
}

TEST_F(ExplainCommand, SaysWhatItDoesNotKnowAndGoesOn) {
    const Outcome outcome = run({"explain", "missing-semicolom", "zzz", "IEC2006"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(
        outcome.err,
        "iecfront: there is no diagnostic, extension or feature `missing-semicolom`; did you mean "
        "`missing-semicolon`?\n"
        "iecfront: there is no diagnostic, extension or feature `zzz`; "
        "`iecfront explain --list` lists all diagnostics\n");
    EXPECT_TRUE(outcome.out.starts_with("# IEC2006")) << outcome.out;
}

TEST_F(ExplainCommand, ListsAllCodes) {
    const Outcome outcome = run({"explain", "--list"});
    EXPECT_EQ(outcome.status, 0);
    std::string expected;
    for (const DiagnosticInfo& row : diagnostic_catalogue())
        expected += code_string(row.id) + " " + std::string(row.name) + ": " +
                    std::string(row.message) + "\n";
    EXPECT_EQ(outcome.out, expected);
}

} // namespace
} // namespace iecfront::test
