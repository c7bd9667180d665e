#pragma once

#include "cli/commands.hpp"

#include <string>

namespace iecfront::cli {

/// What `iecfront --help` prints.
[[nodiscard]] std::string help();

/// What `iecfront check --help` prints.
[[nodiscard]] std::string help(const Command& command);

} // namespace iecfront::cli
