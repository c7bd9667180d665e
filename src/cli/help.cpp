#include "cli/help.hpp"

#include <algorithm>

namespace iecfront::cli {
namespace {

// What stands before the explanations takes so many columns.
constexpr std::size_t first_column = 24;

[[nodiscard]] std::string row(std::string_view name, std::string_view explanation) {
    std::string out = "  " + std::string(name);
    out.append(std::max(first_column, out.size() + 2) - out.size(), ' ');
    return out + std::string(explanation) + "\n";
}

} // namespace

std::string help() {
    std::string out = "usage: iecfront COMMAND [OPTION...] ...\n\n"
                      "Reads source texts of IEC 61131-3:2003.\n\ncommands:\n";
    for (const Command& command : commands())
        out += row(command.name, command.summary);
    out += "\noptions:\n";
    out += row("--help", "print this, or with a command what it does");
    out += row("--version", "print the version");
    return out;
}

std::string help(const Command& command) {
    std::string out = "usage: iecfront " + std::string(command.name) + " [OPTION...]";
    out += command.operands.empty() ? "" : " " + std::string(command.operands);
    out += "\n\n" + std::string(command.details) + "\noptions:\n";
    for (const OptionRow& option : command.options)
        out +=
            row(option.value.empty() ? std::string(option.name)
                                     : std::string(option.name) + " " + std::string(option.value),
                option.help);
    out += row("--help", "print this");
    if (!command.operands.empty())
        out += row("--", "take what follows for names, even if it begins with `-` or `@`");
    return out;
}

} // namespace iecfront::cli
