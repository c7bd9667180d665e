// The command `iecfront`.
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/near_names.hpp"
#include "cli/output.hpp"
#include "cli/platform.hpp"

#include <exception>
#include <new>
#include <string>
#include <vector>

namespace iecfront::cli {
namespace {

[[nodiscard]] const Command* find_command(std::string_view name) {
    for (const Command& command : commands())
        if (command.name == name)
            return &command;
    return nullptr;
}

[[nodiscard]] UsageError unknown_command(const std::string& name) {
    std::vector<std::string> names;
    for (const Command& command : commands())
        names.emplace_back(command.name);
    return UsageError("unknown command `" + on_one_line(name) + "`" + did_you_mean(name, names));
}

[[nodiscard]] Status run_command(const Command& command, std::span<const std::string> arguments) {
    const Options options = parse_options(command.options, arguments);
    if (options.help) {
        print(help(command));
        return Status::nothing_found;
    }
    return command.run(options);
}

[[nodiscard]] Status run(const std::vector<std::string>& arguments, const Command*& command) {
    if (arguments.empty())
        throw UsageError("no command given");
    const std::string& first = arguments.front();
    if (first == "--help" || first == "-h" || first == "--version") {
        print(first == "--version" ? "iecfront " IECFRONT_VERSION "\n" : help());
        return Status::nothing_found;
    }
    command = find_command(first);
    if (command == nullptr)
        throw unknown_command(first);
    return run_command(*command, std::span(arguments).subspan(1));
}

// Everything that can go wrong ends here as one line and a status.
[[nodiscard]] Status run_guarded(const std::vector<std::string>& arguments) {
    const Command* command = nullptr;
    try {
        const Status status = run(arguments, command);
        flush_output();
        return status;
    } catch (const UsageError& error) {
        complain(error.what());
        const std::string name = command == nullptr ? "" : " " + std::string(command->name);
        std::fputs(("try `iecfront" + name + " --help`\n").c_str(), stderr);
    } catch (const OutputClosed&) {
        // nobody is there to be told
    } catch (const std::bad_alloc&) {
        complain("out of memory");
    } catch (const std::exception& error) {
        complain(error.what());
    }
    return Status::unusable;
}

} // namespace
} // namespace iecfront::cli

int main(int argc, char** argv) {
    iecfront::cli::prepare_standard_streams();
    return static_cast<int>(
        iecfront::cli::run_guarded(std::vector<std::string>(argv + (argc > 0), argv + argc)));
}
