#pragma once

#include "support/json.hpp"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// What a run of the command gave.
struct Outcome {
    int status = 0;
    std::string out;
    std::string err;
};

/// A test that runs the built command in a folder of its own.
class CommandTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    /// Writes a file in the folder, and the folders above it.
    void write(const std::string& name, std::string_view text) const;

    /// Runs `iecfront` with these arguments. `redirections` is shell text behind the command, where
    /// a test wants another standard output.
    [[nodiscard]] Outcome run(const std::vector<std::string>& arguments,
                              std::string_view input = {},
                              const std::string& redirections = {}) const;

    /// Runs shell text in the folder, in which `$IECFRONT` is the command.
    [[nodiscard]] Outcome run_shell(const std::string& text) const;

    /// Runs the command and reads its output as one JSON value; fails the test when it is none.
    [[nodiscard]] JsonValue run_json(const std::vector<std::string>& arguments) const;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
};

/// A program without a fault.
inline constexpr std::string_view good_program = "PROGRAM good\n"
                                                 "VAR x : INT; END_VAR\n"
                                                 "x := 1;\n"
                                                 "END_PROGRAM\n";

/// A program with a `;` missing behind column 7 of line 3.
inline constexpr std::string_view bad_program = "PROGRAM bad\n"
                                                "VAR x : INT; END_VAR\n"
                                                "x := 1\n"
                                                "x := 2;\n"
                                                "END_PROGRAM\n";

/// A program with a use of an extension, `//`, in line 3.
inline constexpr std::string_view extended_program = "PROGRAM extended\n"
                                                     "VAR x : INT; END_VAR\n"
                                                     "x := 1; // one\n"
                                                     "END_PROGRAM\n";

/// A program with parentheses nested nine deep.
inline constexpr std::string_view deep_program = "PROGRAM deep\n"
                                                 "VAR x : INT; END_VAR\n"
                                                 "x := (((((((((1)))))))));\n"
                                                 "END_PROGRAM\n";

} // namespace iecfront::test
