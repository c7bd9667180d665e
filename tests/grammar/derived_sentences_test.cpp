#include "grammar/formal_syntax.hpp"
#include "grammar/reading.hpp"
#include "grammar/sentences.hpp"
#include "support/tree_faults.hpp"

#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <gtest/gtest.h>

// What the formal syntax derives is accepted. Each seed gives other sentences; the counts are such
// that all ways through the grammar are gone, in little time.

namespace iecfront::test {
namespace {

constexpr std::uint32_t seed = 2;
constexpr std::size_t sentence_count = 5000;

/// The codes that no known difference explains, in words; empty when there are none.
[[nodiscard]] std::string unexplained(const SyntaxTree& tree) {
    std::string codes;
    for (const std::string& code : reported_codes(tree))
        if (formal_syntax().differences.find(code) == nullptr)
            codes += code + " ";
    return codes;
}

[[nodiscard]] bool is_reported(const std::string& text) {
    return !unexplained(parse(SourceText(text))).empty();
}

void expect_accepted(const Sentence& sentence) {
    const SyntaxTree tree = parse(SourceText(sentence.text));
    EXPECT_EQ(tree_fault(tree, sentence.text), "") << sentence.text;
    if (const std::string codes = unexplained(tree); !codes.empty())
        ADD_FAILURE() << codes << "is reported in:\n"
                      << shrunk(sentence.text, [](const std::string& text) {
                             return is_reported(text) && formal_syntax().derives(text);
                         });
    EXPECT_EQ(body_languages(tree), sentence.bodies) << sentence.text;
}

TEST(DerivedSentences, AreAcceptedAndTakeEachWayOfTheGrammar) {
    const FormalSyntax& syntax = formal_syntax();
    SentenceDeriver deriver(syntax.grammar, syntax.words, seed);
    for (std::size_t i = 0; i < sentence_count; ++i) {
        const Sentence sentence = deriver.derive(10 + i % 100);
        EXPECT_TRUE(syntax.derives(sentence.text)) << sentence.text;
        expect_accepted(sentence);
    }
    for (const std::string& way : deriver.missed())
        ADD_FAILURE() << "no sentence takes " << way;
}

} // namespace
} // namespace iecfront::test
