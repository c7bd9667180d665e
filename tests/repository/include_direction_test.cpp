#include "support/repository_files.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <string>
#include <string_view>

namespace iecfront::test {
namespace {

// A file includes files of its own stage and of those before it.
constexpr std::array<std::string_view, 10> stages = {
    "source", "diagnostics", "lexer",  "ast",     "parser",
    "sema",   "compliance",  "format", "builder", "cli"};

constexpr std::size_t no_stage = stages.size();

[[nodiscard]] std::size_t stage_number(std::string_view name) {
    const auto* found = std::find(stages.begin(), stages.end(), name);
    return static_cast<std::size_t>(found - stages.begin());
}

// `lexer/token.hpp` of `include/iecfront/lexer/token.hpp`, `src/lexer/token.hpp` and
// `iecfront/lexer/token.hpp`.
[[nodiscard]] std::string_view below_root(std::string_view path) {
    for (const std::string_view root : {"include/", "src/", "iecfront/"})
        if (path.starts_with(root))
            path.remove_prefix(root.size());
    return path;
}

[[nodiscard]] std::string_view first_folder(std::string_view path) {
    return path.substr(0, std::min(path.find('/'), path.size()));
}

// What a line includes, without its quotes; empty when it is no include line.
[[nodiscard]] std::string_view included(std::string_view line) {
    constexpr std::string_view directive = "#include ";
    if (!line.starts_with(directive) || line.size() < directive.size() + 2)
        return {};
    line.remove_prefix(directive.size() + 1);
    return line.substr(0, line.find_first_of("\">"));
}

[[nodiscard]] bool is_own(std::string_view line) {
    return line.starts_with("#include \"") || line.starts_with("#include <iecfront/");
}

void check_file(const RepositoryFile& file) {
    const std::size_t stage = stage_number(first_folder(below_root(file.path)));
    for (const std::string_view line : lines_of(file.text)) {
        if (!is_own(line))
            continue;
        const std::string_view target = below_root(included(line));
        const std::size_t target_stage = stage_number(first_folder(target));
        if (target_stage == no_stage) {
            EXPECT_EQ(target, "export.hpp") << file.path << ": " << line;
            continue;
        }
        EXPECT_LE(target_stage, stage) << file.path << " belongs to a stage before: " << line;
    }
}

TEST(IncludeDirection, RunsOnlyDownTheListOfStages) {
    const auto files = repository_files({"include", "src"}, {".hpp", ".cpp", ".def"});
    ASSERT_FALSE(files.empty());
    for (const RepositoryFile& file : files) {
        if (file.path == "include/iecfront/export.hpp" ||
            file.path == "include/iecfront/iecfront.hpp")
            continue; // below and above all stages
        EXPECT_NE(stage_number(first_folder(below_root(file.path))), no_stage)
            << file.path << " belongs to no stage";
        check_file(file);
    }
}

TEST(IncludeDirection, PublicHeadersIncludeNoInternalOnes) {
    for (const RepositoryFile& file : repository_files({"include"}, {".hpp"}))
        for (const std::string_view line : lines_of(file.text))
            EXPECT_FALSE(line.starts_with("#include \"")) << file.path << ": " << line;
}

TEST(IncludeDirection, IecfrontHeaderOffersEveryStageHeader) {
    std::string all;
    for (const RepositoryFile& file : repository_files({"include"}, {"iecfront.hpp"}))
        all += file.text;
    for (const RepositoryFile& file : repository_files({"include"}, {".hpp"})) {
        const std::string_view stage = first_folder(below_root(file.path));
        if (stage_number(stage) == no_stage)
            continue;
        EXPECT_NE(all.find("#include <iecfront/" + std::string(stage) + "/"), std::string::npos)
            << "iecfront.hpp includes nothing of " << stage;
    }
}

} // namespace
} // namespace iecfront::test
