#pragma once

#include <iecfront/ast/syntax_tree.hpp>

#include <set>
#include <string>
#include <string_view>
#include <vector>

// What the parser makes of a text, as far as it is compared with the formal syntax.
namespace iecfront::test {

/// The codes of what is reported as not being in the language: violations, errors and extensions,
/// but neither limits nor the use of implementation-dependent features.
[[nodiscard]] std::set<std::string> reported_codes(const SyntaxTree& tree);

/// The languages of the bodies in source order, as the productions that derive them are called:
/// `statement_list`, `instruction_list`, `sequential_function_chart`.
[[nodiscard]] std::vector<std::string> body_languages(const SyntaxTree& tree);

/// The tokens of a text as they stand there, and what stands between them: before each, and at the
/// end. Put together, they give the text.
struct Pieces {
    std::vector<std::string> gaps; // one more than tokens
    std::vector<std::string> tokens;

    explicit Pieces(std::string_view text);
    [[nodiscard]] std::string text() const;
    void erase(std::size_t begin, std::size_t end);
};

/// `text` without all the tokens that can go while `is_bad` stays true of it.
template<class IsBad>
[[nodiscard]] std::string shrunk(std::string_view text, IsBad is_bad) {
    Pieces pieces(text);
    for (std::size_t size = pieces.tokens.size(); size > 0; size -= size / 4 + 1)
        for (std::size_t at = 0; at + size <= pieces.tokens.size();) {
            Pieces fewer = pieces;
            fewer.erase(at, at + size);
            if (is_bad(fewer.text()))
                pieces = fewer;
            else
                ++at;
        }
    return pieces.text();
}

} // namespace iecfront::test
