#pragma once

#include <iecfront/iecfront.hpp>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

// The library opens no files: reading them is left to the program around it. When `path` cannot be
// read, says so and gives nothing.
inline std::optional<iecfront::SourceText> read_source(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
        return std::nullopt;
    }
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    return iecfront::SourceText(std::move(bytes), path);
}
