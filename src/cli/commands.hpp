#pragma once

#include "cli/options.hpp"

#include <span>
#include <string_view>

namespace iecfront::cli {

/// The exit status of the program.
enum class Status {
    nothing_found = 0,
    violations = 1,
    unusable = 2,   ///< usage, or an input that cannot be read, or an output that cannot be written
    incomplete = 3, ///< nothing found, but something in this input was not examined
};

/// A command of the program, as in `iecfront check`.
struct Command {
    std::string_view name;
    std::string_view operands; ///< as in `FILE-or-FOLDER...`
    std::string_view summary;  ///< one line
    std::string_view details;  ///< the rest of its help
    std::span<const OptionRow> options;
    Status (*run)(const Options& options);
};

/// All commands, in the order of the help.
[[nodiscard]] std::span<const Command> commands() noexcept;

[[nodiscard]] Status run_check(const Options& options);
[[nodiscard]] Status run_tokens(const Options& options);
[[nodiscard]] Status run_ast(const Options& options);
[[nodiscard]] Status run_format(const Options& options);
[[nodiscard]] Status run_explain(const Options& options);
[[nodiscard]] Status run_compliance(const Options& options);

} // namespace iecfront::cli
