#include "grammar/recogniser.hpp"
#include "grammar/sentences.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace iecfront::test {
namespace {

/// The sentences of a grammar, each once, as far as `count` derivations find them.
[[nodiscard]] std::set<std::string> sentences(const std::string& productions, int count = 200) {
    const std::string document = "### Part\n```ebnf\n" + productions + "\n```\n";
    const Grammar grammar = read_grammar(document);
    const Words words(grammar, document);
    const LexicalRecogniser lexical(grammar, words);
    SentenceDeriver deriver(grammar, words, 1);
    std::set<std::string> result;
    for (int i = 0; i < count; ++i) {
        const std::string text = deriver.derive(4).text;
        EXPECT_TRUE(derives(grammar, lexical, text)) << text;
        std::string tokens = upper_case(text.substr(0, text.find("(*")));
        std::erase_if(tokens, [](char c) { return !is_word_character(c); });
        if (text.find_first_of("({") == std::string::npos) // without comments and pragmas
            result.insert(tokens);
    }
    EXPECT_EQ(deriver.missed(), std::vector<std::string>{});
    return result;
}

TEST(SentenceDeriver, TakesAllWays) {
    EXPECT_EQ(sentences("a = \"A\" ( b | \"D\" ) ;\nb = \"B\" | \"C\" ;"),
              (std::set<std::string>{"AB", "AC", "AD"}));
    EXPECT_EQ(sentences("a = \"A\" [ \"B\" ] ;"), (std::set<std::string>{"A", "AB"}));
    const std::set<std::string> row = sentences("a = \"A\" { \"B\" } ;");
    EXPECT_TRUE(row.contains("A") && row.contains("AB") && row.contains("ABB"));
}

TEST(SentenceDeriver, ComesToAnEnd) {
    for (const std::string& text : sentences("a = \"A\" | \"B\" a \"C\" a | \"D\" a ;"))
        EXPECT_LT(text.size(), 20U) << text;
}

TEST(SentenceDeriver, SaysWhichWaysItMissed) {
    const Grammar grammar = read_grammar("```ebnf\na = \"A\" [ \"B\" ] | \"C\" ;\n```\n");
    SentenceDeriver deriver(grammar, Words(grammar, ""), 1);
    EXPECT_EQ(deriver.missed().size(), 4U);
}

TEST(SentenceDeriver, DerivesTheSameFromTheSameSeed) {
    const Grammar grammar = read_grammar("```ebnf\na = { \"A\" | \"B\" | \"C\" } ;\n```\n");
    const Words words(grammar, "");
    SentenceDeriver one(grammar, words, 5);
    SentenceDeriver same(grammar, words, 5);
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(one.derive(10).text, same.derive(10).text);
}

} // namespace
} // namespace iecfront::test
