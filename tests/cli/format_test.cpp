#include "cli/command.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace iecfront::test {
namespace {

constexpr std::string_view formatted_program = "PROGRAM good\n"
                                               "    VAR\n"
                                               "        x : INT;\n"
                                               "    END_VAR\n"
                                               "    x := 1;\n"
                                               "END_PROGRAM\n";

class FormatCommand : public CommandTest {
protected:
    [[nodiscard]] std::string text_of(const std::string& name) const {
        std::ifstream file(folder() / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(folder()), {}));
    }
};

TEST_F(FormatCommand, PrintsTheFormattedText) {
    write("p.st", good_program);
    const Outcome outcome = run({"format", "p.st"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, formatted_program);
    EXPECT_EQ(text_of("p.st"), good_program);
    EXPECT_EQ(run({"format", "-"}, good_program).out, formatted_program);
    EXPECT_EQ(run({"format", "p.st", "p.st"}).out,
              std::string(formatted_program) + std::string(formatted_program));
}

TEST_F(FormatCommand, ChecksWhetherSomethingWouldChange) {
    write("a.st", good_program);
    write("b.st", formatted_program);
    const Outcome outcome = run({"format", "--check", "."});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, "./a.st\n");
    EXPECT_EQ(text_of("a.st"), good_program);
    EXPECT_EQ(run({"format", "--check", "b.st"}).status, 0);
    EXPECT_EQ(run({"format", "--check", "b.st"}).out, "");
    EXPECT_EQ(run({"format", "--check", "-"}, good_program).status, 1);
}

TEST_F(FormatCommand, RewritesWhatChanges) {
    write("a.st", good_program);
    write("b.st", formatted_program);
    const auto time = std::filesystem::last_write_time(folder() / "b.st");
    const std::size_t before = files();
    const Outcome outcome = run({"format", "--write", "a.st", "b.st"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "a.st\n");
    EXPECT_EQ(text_of("a.st"), formatted_program);
    EXPECT_EQ(std::filesystem::last_write_time(folder() / "b.st"), time);
    EXPECT_EQ(files(), before);
    EXPECT_EQ(run({"format", "--write", "."}).out, "");
}

TEST_F(FormatCommand, KeepsPermissions) {
    namespace fs = std::filesystem;
    write("a.st", good_program);
    fs::permissions(folder() / "a.st", fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(run({"format", "--write", "a.st"}).status, 0);
    EXPECT_EQ(text_of("a.st"), formatted_program);
    EXPECT_EQ(fs::status(folder() / "a.st").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(FormatCommand, KeepsSymbolicLinks) {
    namespace fs = std::filesystem;
    write("a.st", good_program);
    fs::create_symlink("a.st", folder() / "link.st");
    EXPECT_EQ(run({"format", "--write", "link.st"}).status, 0);
    EXPECT_TRUE(fs::is_symlink(folder() / "link.st"));
    EXPECT_EQ(text_of("a.st"), formatted_program);
}

TEST_F(FormatCommand, DoesNotTouchFilesBeside) {
    write("a.st", good_program);
    write("a.st.new0", "mine");
    EXPECT_EQ(run({"format", "--write", "a.st"}).status, 0);
    EXPECT_EQ(text_of("a.st"), formatted_program);
    EXPECT_EQ(text_of("a.st.new0"), "mine");
}

TEST_F(FormatCommand, TakesOptions) {
    write("p.st", "PROGRAM p\nx := aaaaaaaa + bbbbbbbb;\nEND_PROGRAM\n");
    EXPECT_EQ(
        run({"format", "--keyword-case", "lower", "--indent=2", "--line-length", "20", "p.st"}).out,
        "program p\n  x := aaaaaaaa\n       + bbbbbbbb;\nend_program\n");
    write("latin.st", "PROGRAM p\nx := '\xC4';\nEND_PROGRAM\n");
    EXPECT_EQ(run({"format", "--encoding=latin-1", "latin.st"}).out,
              "PROGRAM p\n    x := '\xC4';\nEND_PROGRAM\n");
}

TEST_F(FormatCommand, KeepsTheBytesOfWhatIsBroken) {
    write("p.st", "PROGRAM p\n x:=1;\n  y  :=  2 3;\nEND_PROGRAM\n");
    EXPECT_EQ(run({"format", "p.st"}).out, "PROGRAM p\n    x := 1;\n  y  :=  2 3;\nEND_PROGRAM\n");
    EXPECT_EQ(run({"format", "-"}, "x  := \xFF").out, "x  := \xFF\n");
}

TEST_F(FormatCommand, ComplainsInOneLineAndGoesOn) {
    write("a.st", formatted_program);
    const Outcome outcome = run({"format", "missing.st", "a.st"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "iecfront: missing.st: No such file or directory\n");
    EXPECT_EQ(outcome.out, formatted_program);
    write("b.st", good_program);
    EXPECT_EQ(run({"format", "--check", "missing.st", "b.st"}).status, 2);
}

TEST_F(FormatCommand, DoesTheSameForAnyNumberOfJobs) {
    std::vector<std::string> arguments = {"format", "--jobs", "1"};
    for (int i = 0; i < 60; ++i) {
        const std::string name = "file" + std::to_string(i) + ".st";
        if (i % 7 != 3)
            write(name, i % 3 == 0 ? good_program : formatted_program);
        arguments.push_back(name);
    }
    for (const char* what : {"", "--check", "--write"}) {
        if (*what != '\0')
            arguments.insert(arguments.begin() + 1, what);
        std::vector<Outcome> outcomes;
        for (const char* jobs : {"1", "2", "16", "1024"}) {
            for (int i = 0; i < 60; i += 3)
                if (i % 7 != 3)
                    write("file" + std::to_string(i) + ".st", good_program);
            *(std::ranges::find(arguments, "--jobs") + 1) = jobs;
            outcomes.push_back(run(arguments));
            EXPECT_EQ(outcomes.back().status, 2);
            EXPECT_EQ(outcomes.back().out, outcomes.front().out) << what << jobs;
            EXPECT_EQ(outcomes.back().err, outcomes.front().err) << what << jobs;
        }
        EXPECT_NE(outcomes.front().out, "");
        if (*what != '\0')
            arguments.erase(arguments.begin() + 1);
    }
}

TEST_F(FormatCommand, RewritesAFileThatIsNamedTwiceOnce) {
    write("a.st", good_program);
    EXPECT_EQ(run({"format", "--write", "--jobs", "4", "a.st", "./a.st", "."}).out, "a.st\n");
    EXPECT_EQ(text_of("a.st"), formatted_program);
}

TEST_F(FormatCommand, RefusesWhatMakesNoSense) {
    write("a.st", good_program);
    const auto message = [&](const std::vector<std::string>& arguments) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2);
        return outcome.err.substr(0, outcome.err.find('\n'));
    };
    EXPECT_EQ(message({"format", "--check", "--write", "a.st"}),
              "iecfront: `--check` and `--write` cannot stand together");
    EXPECT_EQ(message({"format", "--write", "-"}), "iecfront: standard input cannot be rewritten");
    EXPECT_EQ(message({"format", "--keyword-case", "Upper", "a.st"}),
              "iecfront: `Upper` is no value for `--keyword-case`: upper, lower or keep");
    EXPECT_EQ(message({"format", "--indent", "17", "a.st"}),
              "iecfront: `17` is no value for `--indent`: a number from 0 to 16");
    EXPECT_EQ(text_of("a.st"), good_program);
}

} // namespace
} // namespace iecfront::test
