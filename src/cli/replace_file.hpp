#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace iecfront::cli {

/// Puts a file with these bytes in the place of the file at `path`, which keeps its permissions; a
/// symbolic link goes on leading to it. Nobody ever sees half of it. Gives the reason when that
/// fails, and the file is then as it was; empty when all is well.
[[nodiscard]] std::string replace_file(const std::filesystem::path& path, std::string_view bytes);

} // namespace iecfront::cli
