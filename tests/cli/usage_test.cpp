#include "cli/command.hpp"

#include <array>

namespace iecfront::test {
namespace {

using Usage = CommandTest;

TEST_F(Usage, EachCommandThatReadsTextTakesItsLimits) {
    const std::string text = "PROGRAM   p\n;   END_PROGRAM\n";
    write("p.st", text);
    for (const std::string option : {"--max-source-size", "--max-unit-memory"}) {
        EXPECT_EQ(run({"format", option, "20", "p.st"}).out, text) << option;
        EXPECT_NE(run({"format", option, "1000", "p.st"}).out, text) << option;
        for (const std::string command : {"tokens", "ast"}) {
            const auto finds_program = [&](const std::string& limit) {
                const std::string out = run({command, option, limit, "p.st"}).out;
                return out.find("kw_program \"") != std::string::npos ||
                       out.find("program_declaration") != std::string::npos;
            };
            EXPECT_FALSE(finds_program("20")) << command << option;
            EXPECT_TRUE(finds_program("1000")) << command << option;
        }
    }
}

constexpr std::array<std::string_view, 4> all_commands = {"check", "tokens", "ast", "explain"};

struct WrongUsage {
    std::vector<std::string> arguments;
    std::string_view message;
    std::string_view help;
};

TEST_F(Usage, AMistakeIsOneLineAndWhereToFindHelp) {
    const std::vector<WrongUsage> rows = {
        {{}, "no command given", "iecfront --help"},
        {{"chekc"}, "unknown command `chekc`; did you mean `check`?", "iecfront --help"},
        {{"--verson"}, "unknown command `--verson`", "iecfront --help"},
        {{"check"},
         "name files or folders to read, or `-` for standard input",
         "iecfront check --help"},
        {{"check", ""}, "one of the names is empty", "iecfront check --help"},
        {{"check", "-", "-"}, "standard input can be read once only", "iecfront check --help"},
        {{"check", "--strct", "x"},
         "unknown option `--strct`; did you mean `--strict`?",
         "iecfront check --help"},
        {{"check", "-q", "x"}, "unknown option `-q`", "iecfront check --help"},
        {{"check", "--strict=1", "x"}, "`--strict` takes no value", "iecfront check --help"},
        {{"check", "x", "--jobs"}, "`--jobs` needs a value: `--jobs N`", "iecfront check --help"},
        {{"check", "--jobs=0", "x"},
         "`0` is no value for `--jobs`: a number from 1 to 1024",
         "iecfront check --help"},
        {{"check", "--jobs", "4x", "x"},
         "`4x` is no value for `--jobs`: a number from 1 to 1024",
         "iecfront check --help"},
        {{"check", "--max-nesting", "-1", "x"},
         "`-1` is no value for `--max-nesting`: a number from 1 to 1000",
         "iecfront check --help"},
        {{"check", "--format", "xml", "x"},
         "`xml` is no value for `--format`: text, json or sarif",
         "iecfront check --help"},
        {{"check", "--color", "yes", "x"},
         "`yes` is no value for `--color`: auto, always or never",
         "iecfront check --help"},
        {{"check", "--encoding", "ebcdic", "x"},
         "`ebcdic` is no value for `--encoding`: utf-8, iso-8859-1 or windows-1252",
         "iecfront check --help"},
        {{"check", "--warn", "missing-semicolom", "x"},
         "`missing-semicolom` is no code, name or class of diagnostics; did you mean "
         "`missing-semicolon`?",
         "iecfront check --help"},
        {{"check", "--deny", "extensoin", "x"},
         "`extensoin` is no code, name or class of diagnostics; did you mean `extension`?",
         "iecfront check --help"},
        {{"check", "--allow", "everything", "x"},
         "`everything` is no code, name or class of diagnostics",
         "iecfront check --help"},
        {{"tokens", "--strict", "x"}, "unknown option `--strict`", "iecfront tokens --help"},
        {{"ast", "--format=text", "x"},
         "`text` is no value for `--format`: tree or json",
         "iecfront ast --help"},
        {{"explain"},
         "name a code or a feature, as in `iecfront explain IEC2001`",
         "iecfront explain --help"},
    };
    for (const WrongUsage& row : rows) {
        const Outcome outcome = run(row.arguments);
        EXPECT_EQ(outcome.status, 2) << row.message;
        EXPECT_EQ(outcome.out, "") << row.message;
        EXPECT_EQ(outcome.err, "iecfront: " + std::string(row.message) + "\ntry `" +
                                   std::string(row.help) + "`\n");
    }
}

TEST_F(Usage, HelpIsForTheProgramAndForEachCommand) {
    const Outcome general = run({"--help"});
    EXPECT_EQ(general.status, 0);
    EXPECT_EQ(general.err, "");
    for (const std::string_view command : all_commands) {
        EXPECT_NE(general.out.find("\n  " + std::string(command) + " "), std::string::npos);
        const Outcome outcome = run({std::string(command), "--help"});
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(outcome.err, "");
        EXPECT_TRUE(outcome.out.starts_with("usage: iecfront " + std::string(command) + " "));
        EXPECT_NE(outcome.out.find("\n  --help "), std::string::npos);
    }
}

TEST_F(Usage, HelpFitsATerminal) {
    for (const std::string_view command : all_commands) {
        std::string_view rest;
        const Outcome outcome = run({std::string(command), "--help"});
        for (rest = outcome.out; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1))
            EXPECT_LE(rest.find('\n'), 100U) << rest.substr(0, rest.find('\n'));
    }
}

TEST_F(Usage, VersionIsTheProjectsOwn) {
    const Outcome outcome = run({"--version"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "iecfront " IECFRONT_VERSION "\n");
}

} // namespace
} // namespace iecfront::test
