#include "grammar/formal_syntax.hpp"

#include <iecfront/lexer/standard_names.hpp>
#include <iecfront/lexer/token.hpp>

#include <gtest/gtest.h>

namespace iecfront::test {
namespace {

TEST(Words, AreTerminalsOfProductionsThatAreNotLexical) {
    const std::string document = "### One\n```ebnf\na = \"IF\" b standard_function_name \":=\" ;\n"
                                 "standard_function_name = \"SIN\" ;\n```\n"
                                 "### Two (lexical)\n```ebnf\nb = \"E\" \"MS\" ;\n```\n"
                                 "```ebnf-unreachable\nc = \"ANY\" ;\n```\n";
    const Words words(read_grammar(document), document);
    EXPECT_EQ(words.keywords, (std::set<std::string>{"ANY", "FALSE", "IF", "TRUE"}));
    EXPECT_TRUE(words.is_keyword("if"));
    EXPECT_FALSE(words.is_keyword("SIN"));
    EXPECT_TRUE(words.is_reserved("sin"));
    EXPECT_FALSE(words.is_reserved("MS"));
}

TEST(Words, AreNoKeywordsWhenTheTableSaysSo) {
    const std::string document = "### One\n```ebnf\na = \"IF\" \"SINGLE\" ;\n```\n"
                                 "## Words that are terminals but not keywords\n"
                                 "| words | where |\n| --- | --- |\n| `S SINGLE` | here |\n";
    const Words words(read_grammar(document), document);
    EXPECT_FALSE(words.is_keyword("SINGLE"));
    EXPECT_TRUE(words.is_keyword("IF"));
}

// The rule for keywords in the page gives those of the lexer, no more and no fewer.
TEST(Words, OfThePageAreTheKeywordsOfTheLexer) {
    std::set<std::string> of_lexer;
    for (std::size_t i = 0; i < token_kind_count; ++i)
        if (is_keyword(static_cast<TokenKind>(i)))
            of_lexer.emplace(spelling(static_cast<TokenKind>(i)));
    EXPECT_EQ(formal_syntax().words.keywords, of_lexer);
}

TEST(Words, OfStandardElementsAreKnownToTheLexer) {
    for (const std::string& name : formal_syntax().words.standard_names) {
        if (!formal_syntax().words.is_keyword(name)) {
            EXPECT_NE(standard_name(name), StandardName::none) << name;
        }
    }
}

} // namespace
} // namespace iecfront::test
