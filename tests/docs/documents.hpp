#pragma once

#include "support/repository_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// The text of a file, by its path from the top of the repository.
[[nodiscard]] inline std::string repository_text(const std::string& path) {
    std::ifstream in(std::filesystem::path(IECFRONT_SOURCE_DIR) / path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// README.md and all pages of docs/.
[[nodiscard]] inline std::vector<RepositoryFile> documents() {
    std::vector<RepositoryFile> files = repository_files({"docs"}, {".md"});
    files.push_back({"README.md", repository_text("README.md")});
    return files;
}

/// A block of code between lines of three backticks.
struct CodeBlock {
    std::string language; ///< what stands behind the backticks
    std::string text;
};

[[nodiscard]] inline std::vector<CodeBlock> code_blocks(std::string_view document) {
    std::vector<CodeBlock> blocks;
    bool inside = false;
    for (const std::string_view line : lines_of(document)) {
        const bool fence = line.starts_with("```");
        if (fence && !inside)
            blocks.push_back({std::string(line.substr(3)), {}});
        else if (inside && !fence)
            blocks.back().text += std::string(line) + "\n";
        inside = fence != inside;
    }
    return blocks;
}

} // namespace iecfront::test
