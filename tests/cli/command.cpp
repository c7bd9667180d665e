#include "cli/command.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

#ifndef _WIN32
#include <sys/wait.h>
#endif

namespace iecfront::test {
namespace {

namespace fs = std::filesystem;

// Beside the folder of a test, so that they are not found in it.
constexpr std::string_view input_suffix = ".in";
constexpr std::string_view output_suffix = ".out";
constexpr std::string_view error_suffix = ".err";

[[nodiscard]] std::string shell_word(std::string_view text) {
    std::string out = "'";
    for (const char c : text)
        out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}

[[nodiscard]] fs::path beside(fs::path folder, std::string_view suffix) {
    folder += suffix;
    return folder;
}

[[nodiscard]] std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

[[nodiscard]] int exit_status(int result) {
#ifdef _WIN32
    return result;
#else
    return WIFEXITED(result) ? WEXITSTATUS(result) : -1;
#endif
}

} // namespace

void CommandTest::SetUp() {
    std::random_device random;
    const std::string name = "iecfront-" + std::to_string(random()) + std::to_string(random());
    folder_ = fs::temp_directory_path() / name;
    fs::create_directories(folder_);
}

void CommandTest::TearDown() {
    fs::remove_all(folder_);
    for (const std::string_view suffix : {input_suffix, output_suffix, error_suffix})
        fs::remove(beside(folder_, suffix));
}

void CommandTest::write(const std::string& name, std::string_view text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
}

Outcome CommandTest::run(const std::vector<std::string>& arguments, std::string_view input,
                         const std::string& redirections) const {
    const fs::path input_path = beside(folder_, input_suffix);
    std::ofstream(input_path, std::ios::binary) << input;
    std::string line = "\"$IECFRONT\"";
    for (const std::string& argument : arguments)
        line += " " + shell_word(argument);
    return run_shell(line + " < " + shell_word(input_path.string()) + " " + redirections);
}

Outcome CommandTest::run_shell(const std::string& text) const {
    const fs::path out = beside(folder_, output_suffix);
    const fs::path err = beside(folder_, error_suffix);
    const std::string line =
        "cd " + shell_word(folder_.string()) + " && IECFRONT=" + shell_word(IECFRONT_COMMAND) +
        " && { " + text + "\n} > " + shell_word(out.string()) + " 2> " + shell_word(err.string());
    const int result = std::system(line.c_str());
    return {exit_status(result), content(out), content(err)};
}

JsonValue CommandTest::run_json(const std::vector<std::string>& arguments) const {
    const Outcome outcome = run(arguments);
    const std::optional<JsonValue> value = read_json(outcome.out);
    EXPECT_TRUE(value.has_value()) << outcome.out;
    return value.value_or(JsonValue());
}

} // namespace iecfront::test
