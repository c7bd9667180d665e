#pragma once

#include "cli/commands.hpp"
#include "cli/input.hpp"

#include <functional>
#include <span>
#include <string>

namespace iecfront::cli {

/// Why there is no text; empty when there is.
[[nodiscard]] std::string problem_of(const ReadText& text);

/// Reads the inputs one after another and gives the text of each to `use`. What cannot be read is
/// complained of, and the rest is read all the same.
[[nodiscard]] Status read_each(std::span<const Input> inputs, const Options& options,
                               const std::function<void(const SourceText&, const Input&)>& use);

} // namespace iecfront::cli
