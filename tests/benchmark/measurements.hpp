#pragma once

#include "benchmark/bench_options.hpp"
#include "benchmark/figures.hpp"

#include <string>

namespace iecfront::bench {

/// What `options` ask for, of one text.
[[nodiscard]] Table measure(const Options& options, const std::string& name, std::string text);

/// The same of the command, which checks files of `text` and a tiny one. Nothing where it cannot be
/// run.
[[nodiscard]] std::vector<Row> measure_command(const Options& options, const std::string& text);

} // namespace iecfront::bench
