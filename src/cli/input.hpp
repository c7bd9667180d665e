#pragma once

#include <iecfront/source/source_text.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace iecfront::cli {

/// Something to read, as found behind the arguments.
struct Input {
    std::filesystem::path path;
    std::string name;    ///< what diagnostics call it
    std::string problem; ///< why it cannot be read, when that is known already
    bool standard_input = false;
};

/// What was read.
struct ReadText {
    SourceText source;
    /// There is more of it than a text can have. `source` is then empty: it is not read at all.
    bool too_large = false;
    std::string problem; ///< why nothing could be read; empty when it could
};

/// The files that arguments stand for: a file is itself, `-` is standard input, and a folder is
/// every source in it and below it, ordered by name. Symbolic links to folders are not followed,
/// except when named. Throws `UsageError` when there is nothing to read.
[[nodiscard]] std::vector<Input> find_inputs(std::span<const std::string> arguments);

/// Reads all of it. Never throws.
[[nodiscard]] ReadText read_input(const Input& input, Encoding encoding) noexcept;

} // namespace iecfront::cli
