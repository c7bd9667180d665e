#include "benchmark/bench_options.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace iecfront::bench {
namespace {

constexpr std::array<std::string_view, 9> step_names = {
    "lex", "lex_cut", "parse", "walk", "nodes", "format", "memory", "edit", "check"};

template<class Number>
[[nodiscard]] Number number(std::string_view text, std::string& error) {
    Number value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || end != text.data() + text.size() || value == 0)
        error = "`" + std::string(text) + "` is not a number from 1 on";
    return value;
}

[[nodiscard]] std::string step(std::string_view name, std::string& error) {
    if (std::ranges::find(step_names, name) == step_names.end())
        error = "there is no step `" + std::string(name) + "`";
    return std::string(name);
}

void set(Options& options, std::string_view name, std::string_view value, std::string& error) {
    if (name == "--size")
        options.megabytes.push_back(number<std::size_t>(value, error));
    else if (name == "--runs")
        options.runs = number<std::size_t>(value, error);
    else if (name == "--seed")
        options.seed = number<std::uint64_t>(value, error);
    else if (name == "--only")
        options.steps.push_back(step(value, error));
    else if (name == "--command")
        options.command = value;
    else
        error = "there is no option `" + std::string(name) + "`";
}

} // namespace

bool Options::wants(std::string_view step) const {
    return steps.empty() || std::ranges::find(steps, step) != steps.end();
}

std::string_view usage() noexcept {
    return "usage: iecfront_bench [OPTION...] [FILE...]\n"
           "  --size N        a generated text of N MB; can be repeated (1 and 10)\n"
           "  --seed N        of the generator (1)\n"
           "  --runs N        of each step (5)\n"
           "  --only STEP     lex, lex_cut, parse, walk, nodes, format, memory, edit or check;\n"
           "                  can be repeated (all)\n"
           "  --command PATH  the program iecfront that `check` runs (the one built along)\n"
           "  --json          for programs\n"
           "With files, these are measured and no text is generated.\n";
}

Options read_options(int count, char** arguments, std::string& error) {
    Options options;
#ifdef IECFRONT_COMMAND
    options.command = IECFRONT_COMMAND;
#endif
    options.self = arguments[0];
    for (int i = 1; i < count && error.empty(); ++i) {
        const std::string_view name = arguments[i];
        if (!name.starts_with("--"))
            options.files.emplace_back(name);
        else if (name == "--json")
            options.json = true;
        else if (name == "--help")
            options.help = true;
        else if (name == "--nothing")
            options.nothing = true;
        else if (i + 1 == count)
            error = "`" + std::string(name) + "` needs a value";
        else
            set(options, name, arguments[++i], error);
    }
    if (options.megabytes.empty())
        options.megabytes = {1, 10};
    return options;
}

} // namespace iecfront::bench
