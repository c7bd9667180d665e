#pragma once

#include "grammar/ebnf.hpp"
#include "grammar/known_differences.hpp"
#include "grammar/recogniser.hpp"
#include "grammar/words.hpp"

#include <string>

namespace iecfront::test {

/// docs/grammar.md, and what is read from it.
struct FormalSyntax {
    std::string document;
    Grammar grammar;
    Words words;
    LexicalRecogniser lexical;
    KnownDifferences differences;

    FormalSyntax();
    FormalSyntax(const FormalSyntax&) = delete;
    FormalSyntax& operator=(const FormalSyntax&) = delete;

    /// True when the strict part derives `text`.
    [[nodiscard]] bool derives(std::string_view text) const {
        return test::derives(grammar, lexical, text);
    }
};

/// The same for all tests.
[[nodiscard]] const FormalSyntax& formal_syntax();

} // namespace iecfront::test
