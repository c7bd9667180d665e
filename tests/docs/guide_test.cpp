#include "docs/documents.hpp"

#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace iecfront::test {
namespace {

constexpr std::string_view prompt = "$ ";
const std::string guide_path = "docs/guide.md";

// What a line that a reader types prints, at the top of the repository.
[[nodiscard]] std::string output_of(std::string line) {
    const std::string shell = "cd '" + std::string(IECFRONT_SOURCE_DIR) +
                              "' && iecfront() { '" IECFRONT_COMMAND "' \"$@\"; } && { " +
                              std::move(line) + "; } 2>&1";
    std::string output;
    std::FILE* pipe = popen(shell.c_str(), "r");
    if (pipe == nullptr)
        return "cannot be run\n";
    for (int c = std::getc(pipe); c != EOF; c = std::getc(pipe))
        output += static_cast<char>(c);
    pclose(pipe);
    return output;
}

// The guide, with the blocks that begin with a prompt made anew.
[[nodiscard]] std::string made_anew(std::string_view guide) {
    std::string result;
    bool console = false;
    for (const std::string_view line : lines_of(guide)) {
        if (line.starts_with("```"))
            console = line == "```console";
        if (console && line.starts_with(prompt))
            result += std::string(line) + "\n" + output_of(std::string(line.substr(2)));
        else if (!console || line.starts_with("```"))
            result += std::string(line) + "\n";
    }
    return result;
}

TEST(Guide, ShowsWhatTheCommandPrints) {
    const std::string guide = repository_text(guide_path);
    const std::string anew = made_anew(guide);
    const char* update = std::getenv("UPDATE_EXPECT");
    if (update != nullptr && std::string_view(update) == "1") {
        std::ofstream(std::filesystem::path(IECFRONT_SOURCE_DIR) / guide_path, std::ios::binary)
            << anew;
        return;
    }
    EXPECT_EQ(guide, anew) << "UPDATE_EXPECT=1 writes the file anew";
}

// The first words of the lines that begin with two blanks and `begin`.
[[nodiscard]] std::vector<std::string> listed(const std::string& help, std::string_view begin) {
    std::vector<std::string> words;
    for (const std::string_view line : lines_of(help))
        if (line.starts_with("  " + std::string(begin)) && line[2] != ' ')
            words.emplace_back(line.substr(2, line.find(' ', 2) - 2));
    return words;
}

// What the guide says of all commands, and of this one.
[[nodiscard]] std::string part_about(const std::string& guide, const std::string& command) {
    const std::size_t begin = guide.find("\n## " + command + ": ");
    if (begin == std::string::npos)
        return "";
    const std::size_t end = guide.find("\n## ", begin + 1);
    return guide.substr(0, guide.find("\n## check: ")) + guide.substr(begin, end - begin);
}

TEST(Guide, NamesEachOptionOfEachCommand) {
    const std::string guide = repository_text(guide_path);
    const std::string help = output_of("iecfront --help");
    const std::vector<std::string> commands = listed(help.substr(0, help.find("options:")), "");
    EXPECT_GE(commands.size(), 6U);
    for (const std::string& command : commands) {
        const std::string part = part_about(guide, command);
        EXPECT_NE(part, "") << command;
        for (const std::string& option : listed(output_of("iecfront " + command + " --help"), "--"))
            EXPECT_TRUE(part.find(option + " ") != part.npos ||
                        part.find(option + "`") != part.npos)
                << command << ' ' << option;
    }
}

} // namespace
} // namespace iecfront::test
