#include "docs/documents.hpp"

#include <gtest/gtest.h>
#include <regex>

namespace iecfront::test {
namespace {

[[nodiscard]] std::string without_code(std::string_view document) {
    std::string text;
    bool inside = false;
    for (const std::string_view line : lines_of(document)) {
        if (line.starts_with("```"))
            inside = !inside;
        else if (!inside)
            text += std::string(line) + "\n";
    }
    return text;
}

TEST(Documents, LinksLeadToFilesOfTheRepository) {
    const std::regex link(R"(\]\(([^)#\s]+)[^)\s]*\))");
    for (const RepositoryFile& file : documents()) {
        const std::string text = without_code(file.text);
        for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
            const std::string target = (*it)[1];
            if (target.find("://") != std::string::npos)
                continue;
            const auto path = std::filesystem::path(IECFRONT_SOURCE_DIR) /
                              std::filesystem::path(file.path).parent_path() / target;
            EXPECT_TRUE(std::filesystem::exists(path)) << file.path << " links to " << target;
        }
    }
}

TEST(Documents, AreAsciiAndNameNoMachine) {
    // A path from the root of a file system, in words, quotes or parentheses of any kind.
    const std::regex absolute_path(R"((^|[\s"'`(=])(/\w[\w.+-]*/|[A-Za-z]:\\))");
    for (const RepositoryFile& file : documents()) {
        const bool ascii = std::all_of(file.text.begin(), file.text.end(),
                                       [](char c) { return static_cast<unsigned char>(c) < 0x80; });
        EXPECT_TRUE(ascii) << file.path;
        std::smatch found;
        EXPECT_FALSE(std::regex_search(file.text, found, absolute_path))
            << file.path << ": " << found.str();
    }
}

TEST(Readme, ShowsTheQuickStartExample) {
    for (const CodeBlock& block : code_blocks(repository_text("README.md"))) {
        if (block.language == "cpp") {
            EXPECT_EQ(block.text, repository_text("examples/quick_start.cpp"));
        }
    }
}

// What `.ci/run` looks for and runs: `readme_command 'pattern'`.
[[nodiscard]] std::vector<std::regex> patterns_of_ci_run() {
    const std::string script = repository_text(".ci/run");
    const std::regex use("readme_command '([^']*)'");
    std::vector<std::regex> patterns;
    for (std::sregex_iterator it(script.begin(), script.end(), use), end; it != end; ++it)
        patterns.emplace_back((*it)[1].str(), std::regex::extended);
    return patterns;
}

TEST(Readme, HoldsEachCommandOfTheIntegrationRunOnce) {
    const std::string readme = repository_text("README.md");
    const std::vector<std::regex> patterns = patterns_of_ci_run();
    EXPECT_EQ(patterns.size(), 2U);
    std::size_t found = 0;
    for (const std::string_view line : lines_of(readme))
        for (const std::regex& pattern : patterns)
            found += std::regex_search(std::string(line), pattern) ? 1U : 0U;
    EXPECT_EQ(found, patterns.size());
}

// What stands in a document was compiled: its lines stand one below the other, at any depth, in an
// example or in embedding_test.cpp.
[[nodiscard]] std::string without_indentation(std::string_view code) {
    std::string text = "\n";
    for (std::string_view line : lines_of(code)) {
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        if (!line.empty())
            text += std::string(line) + "\n";
    }
    return text;
}

TEST(Documents, ShowCodeThatIsCompiled) {
    std::string compiled = without_indentation(repository_text("tests/docs/embedding_test.cpp"));
    for (const RepositoryFile& file : repository_files({"examples"}, {".cpp", ".hpp"}))
        compiled += without_indentation(file.text);
    for (const std::string page : {"docs/embedding.md", "README.md"})
        for (const CodeBlock& block : code_blocks(repository_text(page)))
            if (block.language == "cpp") {
                EXPECT_NE(compiled.find(without_indentation(block.text)), std::string::npos)
                    << page << ":\n"
                    << block.text;
            }
}

// Names at the top of a namespace stand in paragraphs; each paragraph begins with its explanation.
TEST(PublicHeaders, ExplainTheirNames) {
    const std::regex needs_none(
        R"((///|//|#|\}| |namespace|private:|protected:|static_assert).*|struct \w+;|)");
    for (const RepositoryFile& file : repository_files({"include"}, {".hpp"})) {
        bool begins = true;
        for (const std::string_view line : lines_of(file.text)) {
            if (begins) {
                EXPECT_TRUE(std::regex_match(std::string(line), needs_none))
                    << file.path << ": no /// before " << line;
            }
            begins = line.empty();
        }
    }
}

} // namespace
} // namespace iecfront::test
