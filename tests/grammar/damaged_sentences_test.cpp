#include "grammar/damage.hpp"
#include "grammar/formal_syntax.hpp"
#include "grammar/reading.hpp"
#include "grammar/sentences.hpp"

#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <gtest/gtest.h>

// What is reported is not of the language, and what is not of the language is reported.

namespace iecfront::test {
namespace {

constexpr std::uint32_t seed = 2;
constexpr std::size_t sentence_count = 2500;
constexpr std::size_t damages_each = 4;

[[nodiscard]] bool explained(const std::set<std::string>& codes) {
    return std::all_of(codes.begin(), codes.end(), [](const std::string& code) {
        return formal_syntax().differences.find(code) != nullptr;
    });
}

/// Where the parser and the formal syntax differ, and no known difference says so; empty when they
/// agree.
[[nodiscard]] std::string disagreement(const std::string& text) {
    const SyntaxTree tree = parse(SourceText(text));
    const std::set<std::string> codes = reported_codes(tree);
    if (!formal_syntax().derives(text))
        return codes.empty() ? "not reported, and not of the language" : "";
    return explained(codes) ? "" : "reported, and of the language: " + *codes.begin();
}

void expect_agreement(const std::string& text) {
    if (const std::string what = disagreement(text); !what.empty())
        ADD_FAILURE() << what << ":\n"
                      << shrunk(text, [&](const std::string& fewer) {
                             return disagreement(fewer) == what;
                         });
}

TEST(DamagedSentences, AreReportedExactlyWhenTheGrammarDoesNotDeriveThem) {
    const FormalSyntax& syntax = formal_syntax();
    SentenceDeriver deriver(syntax.grammar, syntax.words, seed);
    Damager damager(syntax.grammar, seed);
    std::size_t still_derived = 0;
    for (std::size_t i = 0; i < sentence_count; ++i) {
        const Sentence sentence = deriver.derive(10 + i % 80);
        for (std::size_t damage = 0; damage < damages_each; ++damage) {
            const std::string text = damager.damaged(sentence.text);
            still_derived += syntax.derives(text) ? 1U : 0U;
            expect_agreement(text);
        }
    }
    // Both verdicts have to be common, or the comparison says nothing.
    EXPECT_GT(still_derived, sentence_count * damages_each / 10);
    EXPECT_LT(still_derived, sentence_count * damages_each / 2);
}

} // namespace
} // namespace iecfront::test
