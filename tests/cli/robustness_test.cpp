#include "cli/command.hpp"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sstream>
#include <sys/ioctl.h>
#include <unistd.h>

// Whatever happens around the command: a message in one line, a status, and nothing lost.

namespace iecfront::test {
namespace {

namespace fs = std::filesystem;

using Robustness = CommandTest;

[[nodiscard]] bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

// ---- inputs ------------------------------------------------------------------------------------

TEST_F(Robustness, WhatCannotBeOpenedIsSaid) {
    write("good.st", good_program);
    fs::create_symlink("circle.st", folder() / "circle.st");
    const Outcome outcome = run({"check", "circle.st", "good.st/x.st", std::string(300, 'n')});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "iecfront: circle.st: Too many levels of symbolic links\n"
                           "iecfront: good.st/x.st: Not a directory\n"
                           "iecfront: " +
                               std::string(300, 'n') + ": File name too long\n");
}

TEST_F(Robustness, WhatMayNotBeReadIsSaid) {
    const bool reads_everything = geteuid() == 0;
    write("d/locked.st", good_program);
    write("e/in.st", good_program);
    fs::permissions(folder() / "d/locked.st", fs::perms::none);
    fs::permissions(folder() / "e", fs::perms::none);
    const Outcome outcome = run({"check", "d", "e"});
    fs::permissions(folder() / "e", fs::perms::owner_all);
    EXPECT_EQ(outcome.status, reads_everything ? 0 : 2);
    EXPECT_EQ(outcome.err, reads_everything ? ""
                                            : "iecfront: d/locked.st: Permission denied\n"
                                              "iecfront: e: Permission denied\n");
}

// Reading stops with an error in the middle of this file, whoever reads.
TEST_F(Robustness, AnErrorWhileReadingIsSaid) {
    write("good.st", good_program);
    const Outcome outcome = run({"check", "/proc/self/mem", "good.st"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "iecfront: /proc/self/mem: Input/output error\n");
    EXPECT_TRUE(contains(outcome.out, "1 file: no violations found")) << outcome.out;
}

// The first file is a pipe, which is opened when all files have been found.
TEST_F(Robustness, AFileThatVanishesIsSaid) {
    write("d/b.st", good_program);
    const Outcome outcome = run_shell("mkfifo d/a.st\n"
                                      "\"$IECFRONT\" check --jobs 1 d &\n"
                                      "exec 3> d/a.st\n"
                                      "rm d/b.st\n"
                                      "exec 3>&-\n"
                                      "wait $!");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "iecfront: d/b.st: No such file or directory\n");
    EXPECT_TRUE(contains(outcome.out, "1 file: no violations found")) << outcome.out;
}

TEST_F(Robustness, FoldersThatHoldThemselvesEnd) {
    write("d/e/a.st", bad_program);
    fs::create_directory_symlink("..", folder() / "d/e/up");
    fs::create_directory_symlink(".", folder() / "d/e/here");
    fs::create_directory_symlink("here", folder() / "d/e/there");
    for (const char* command : {"check", "format", "tokens", "ast"}) {
        const Outcome outcome = run({command, "d"});
        EXPECT_EQ(outcome.err, "") << command;
        EXPECT_LE(outcome.status, 1) << command;
    }
    // Named, a link is followed: once.
    EXPECT_EQ(run({"check", "d/e/up"}).status, 1);
}

TEST_F(Robustness, TenThousandFilesAreRead) {
    constexpr int count = 10'000;
    for (int i = 0; i < count; ++i)
        write("d/" + std::to_string(i / 1000) + "/" + std::to_string(i) + ".st",
              i == 4321 ? bad_program : good_program);
    for (const char* jobs : {"1", "4"}) {
        const Outcome outcome = run({"check", "--jobs", jobs, "d"});
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(outcome.err, "");
        EXPECT_TRUE(contains(outcome.out, "\n10000 files, 1 error: violations were found\n"))
            << outcome.out;
    }
}

// No line of what is printed can be taken for another one's.
TEST_F(Robustness, NamesMayHoldAnyBytes) {
    const std::vector<std::string> names = {"with space.st", "line\nend.st", "broken\xC3.st",
                                            "quote'\".st",   "-dash.st",     "esc\x1B[2J.st"};
    for (const std::string& name : names)
        write("d/" + name, bad_program);
    const Outcome text = run({"check", "d"});
    EXPECT_EQ(text.status, 1);
    EXPECT_EQ(text.err, "");
    EXPECT_EQ(text.out.find('\x1B'), std::string::npos);
    EXPECT_TRUE(contains(text.out, "\n6 files, 6 errors: violations were found\n")) << text.out;
    EXPECT_TRUE(contains(text.out, "line?end.st:3:7: error")) << text.out;
    EXPECT_EQ(run_json({"check", "--format=json", "d"})["files"].text, "6");

    const Outcome names_only = run({"format", "--check", "d"});
    EXPECT_EQ(std::ranges::count(names_only.out, '\n'), 6) << names_only.out;
    EXPECT_EQ(run({"format", "--write", "d"}).err, "");
    for (const std::string& name : names)
        EXPECT_TRUE(fs::exists(folder() / "d" / name)) << name;
    const auto left = std::distance(fs::directory_iterator(folder() / "d"), {});
    EXPECT_EQ(static_cast<std::size_t>(left), names.size());
}

// ---- outputs -----------------------------------------------------------------------------------

TEST_F(Robustness, AFullDeviceIsSaidByEachCommand) {
    write("bad.st", bad_program);
    const std::vector<std::vector<std::string>> commands = {
        {"check", "bad.st"},    {"check", "--format=json", "bad.st"},
        {"tokens", "bad.st"},   {"ast", "bad.st"},
        {"format", "bad.st"},   {"format", "--check", "bad.st"},
        {"explain", "IEC2006"}, {"compliance"},
        {"check", "--help"},    {"--version"}};
    for (const std::vector<std::string>& command : commands) {
        const Outcome full = run(command, {}, "> /dev/full");
        EXPECT_EQ(full.status, 2) << command.front();
        EXPECT_EQ(full.err, "iecfront: standard output: No space left on device\n")
            << command.front();
    }
}

// Nobody is told what he does not want to read: `| head` is no mistake.
TEST_F(Robustness, AClosedPipeEndsTheCommandInSilence) {
    std::string many;
    for (int i = 0; i < 20'000; ++i)
        many += bad_program;
    write("many.st", many);
    for (const std::string command :
         {"check --max-findings 0", "check --format=sarif", "tokens", "ast", "format"}) {
        const Outcome closed = run_shell("{ \"$IECFRONT\" " + command +
                                         " many.st; echo $? > status; } | head -c 1 > part; "
                                         "cat status");
        EXPECT_EQ(closed.out, "2\n") << command;
        EXPECT_EQ(closed.err, "") << command;
    }
}

TEST_F(Robustness, ClosedStandardStreamsAreSurvived) {
    write("bad.st", bad_program);
    EXPECT_EQ(run({"check", "bad.st"}, {}, ">&-").status, 2);
    EXPECT_EQ(run({"check", "bad.st", "none.st"}, {}, "2>&-").status, 2);
    EXPECT_EQ(run({"check", "-"}, {}, "<&-").status, 2);
}

// A terminal is asked for the progress line alone: everything else is of any width.
TEST_F(Robustness, ProgressFitsANarrowTerminal) {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_TRUE(terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0);
    constexpr std::size_t columns = 20;
    const winsize narrow{4, columns, 0, 0};
    ASSERT_EQ(ioctl(terminal, TIOCSWINSZ, &narrow), 0);
    write("d/b.st", good_program);
    write("d/c.st", good_program);
    // The first file comes late, so that progress is shown.
    const Outcome outcome = run_shell("mkfifo d/a.st\n"
                                      "{ sleep 1; cat d/b.st; } > d/a.st &\n"
                                      "\"$IECFRONT\" check --jobs 1 d 2> " +
                                      std::string(ptsname(terminal)));
    EXPECT_EQ(outcome.status, 0);
    std::string shown(1000, '\0');
    const auto size = read(terminal, shown.data(), shown.size());
    shown.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    close(terminal);
    EXPECT_TRUE(shown.starts_with("\r1/3 files")) << shown;
    EXPECT_TRUE(shown.ends_with("\r\x1B[K")) << "the line is cleared";
    std::istringstream lines(shown);
    for (std::string line; std::getline(lines, line, '\r');)
        EXPECT_LT(line.size(), columns) << line; // it must not wrap, for it is overwritten
    EXPECT_LT(std::string("999999/999999 files").size(), columns);
}

// ---- interruption ------------------------------------------------------------------------------

TEST_F(Robustness, AnInterruptionEndsTheCommandInSilence) {
    const Outcome outcome = run_shell(
        "mkfifo never.st; timeout --preserve-status -s INT 0.3 \"$IECFRONT\" check never.st");
    EXPECT_EQ(outcome.status, 128 + 2);
    EXPECT_EQ(outcome.out + outcome.err, "");
}

// Each file is the old one or the new one, and nothing else is left.
TEST_F(Robustness, AnInterruptedRewriteLeavesWholeFiles) {
    std::string old;
    for (int i = 0; i < 300; ++i)
        old += bad_program;
    constexpr int count = 300;
    for (int i = 0; i < count; ++i)
        write("d/" + std::to_string(i) + ".st", old);
    write("one.st", old);
    EXPECT_EQ(run({"format", "--write", "one.st"}).status, 0);
    const std::string sizes = "for f in d/*; do cmp -s $f one.st || cmp -s $f old || echo $f; done";
    write("old", old);
    const Outcome outcome =
        run_shell("timeout --preserve-status -s INT 0.1 \"$IECFRONT\" format --write d > names\n" +
                  sizes + "; ls d | wc -l");
    EXPECT_EQ(outcome.out, std::to_string(count) + "\n");
    EXPECT_EQ(outcome.err, "");
}

// The signal comes while the new file is written: as soon as that is there, if it still is when the
// shell has seen it. What runs beside a shell would ignore SIGINT and SIGQUIT by default.
TEST_F(Robustness, ASignalLeavesNothingBesideAFile) {
    std::string text;
    for (int i = 0; i < 40'000; ++i)
        text += good_program;
    write("text", text);
    for (const std::string signal : {"INT", "TERM", "HUP", "QUIT"}) {
        const Outcome outcome = run_shell(
            "ulimit -c 0; rm -f x.st*\n"
            "for attempt in 1 2 3 4 5 6 7 8 9 10; do cp text x.st\n"
            "env --default-signal \"$IECFRONT\" format --write x.st > names & command=$!\n"
            "until [ -e x.st.new0 ] || ! kill -0 $command; do :; done\n"
            "kill -" +
            signal +
            " $command; wait $command; status=$?; ls x.st*\n"
            "[ $status -le 128 ] || break; done 2> messages");
        EXPECT_EQ(outcome.out.find("new"), std::string::npos) << signal << ": " << outcome.out;
    }
}

// ---- what is no file of its own ----------------------------------------------------------------

TEST_F(Robustness, APipeIsNotReplacedByAFile) {
    write("x.st", bad_program);
    const Outcome outcome = run_shell(
        "mkfifo pipe.st; cat x.st > pipe.st & \"$IECFRONT\" format --write pipe.st; echo $?; "
        "test -p pipe.st && echo pipe");
    EXPECT_EQ(outcome.out, "2\npipe\n");
    EXPECT_NE(outcome.err.find("not a file that can be replaced"), std::string::npos)
        << outcome.err;
}

TEST_F(Robustness, ARewrittenFileKeepsItsOwner) {
    write("x.st", bad_program);
    // Only who may give a file away can tell.
    const Outcome outcome =
        run_shell("chown 12345:12346 x.st 2> chown.txt; stat -c %u:%g x.st > before\n"
                  "\"$IECFRONT\" format --write x.st; stat -c %u:%g x.st | cmp - before; echo $?");
    EXPECT_EQ(outcome.out, "x.st\n0\n");
}

// ---- response files ----------------------------------------------------------------------------

TEST_F(Robustness, ResponseFilesThatNameEachOtherOftenAreRefused) {
    for (int i = 0; i < 10; ++i) {
        std::string lines;
        for (int j = 0; j < 10; ++j)
            lines += "@level" + std::to_string(i + 1) + "\n";
        write("level" + std::to_string(i), lines);
    }
    write("level10", "");
    const Outcome outcome = run({"check", "@level0"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("more than 10000 response files"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace iecfront::test
