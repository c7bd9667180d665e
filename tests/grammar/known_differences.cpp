#include "grammar/known_differences.hpp"

#include "grammar/markdown.hpp"

#include <algorithm>
#include <sstream>

namespace iecfront::test {
namespace {

/// `\n` in a source stands for a line end.
[[nodiscard]] std::string unescaped(std::string_view code) {
    std::string source(code);
    for (std::size_t at = source.find("\\n"); at != std::string::npos; at = source.find("\\n", at))
        source.replace(at, 2, "\n");
    return source;
}

[[nodiscard]] std::set<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::set<std::string> words;
    for (std::string word; in >> word;)
        words.insert(word);
    return words;
}

} // namespace

KnownDifferences::KnownDifferences(std::string_view document) {
    for (const auto& row : table_rows(document, "Known differences"))
        if (row.size() == 5)
            reported.push_back(
                {row[0], unescaped(code_in(row[1])), words_of(row[2]), row[3], row[4]});
}

const KnownDifference* KnownDifferences::find(std::string_view code) const {
    const auto found =
        std::find_if(reported.begin(), reported.end(), [&](const KnownDifference& one) {
            return one.codes.contains(std::string(code));
        });
    return found == reported.end() ? nullptr : &*found;
}

} // namespace iecfront::test
