#include "grammar/formal_syntax.hpp"
#include "grammar/recogniser.hpp"

#include <gtest/gtest.h>

namespace iecfront::test {
namespace {

/// A grammar with lexical productions for names and integers, and what its first production says
/// of texts.
class SmallLanguage {
public:
    explicit SmallLanguage(const std::string& productions)
        : document_("### Part\n```ebnf\n" + productions + "\n```\n### Words (lexical)\n```ebnf\n" +
                    "identifier = letter { letter | digit } ;\n" +
                    "letter = \"A\" | \"B\" | \"X\" ;\ndigit = \"0\" | \"1\" ;\n" +
                    "signed_integer = [ \"-\" ] integer ;\ninteger = digit { digit } ;\n" +
                    "named = identifier \"#\" identifier ;\n" +
                    "text = \"'\" { \"$L\" | <any> } \"'\" ;\n```\n"),
          grammar_(read_grammar(document_)),
          words_(grammar_, document_),
          lexical_(grammar_, words_) {
        EXPECT_EQ(grammar_.faults, std::vector<std::string>{});
    }

    [[nodiscard]] bool derives(std::string_view text) const {
        return test::derives(grammar_, lexical_, text);
    }

private:
    std::string document_;
    Grammar grammar_;
    Words words_;
    LexicalRecogniser lexical_;
};

TEST(Recogniser, TellsTextsOfALanguageFromOthers) {
    const SmallLanguage sums("start = term { \"+\" term } ;\n"
                             "term = identifier | \"(\" start \")\" ;");
    for (const char* text : {"a", "a + b", "(a)", "a+(b+x)+a", "((a) + b)"})
        EXPECT_TRUE(sums.derives(text)) << text;
    for (const char* text : {"", "+", "a +", "a b", "(a", "a)", "()", "a + + b", "a * b", "c"})
        EXPECT_FALSE(sums.derives(text)) << text;
}

TEST(Recogniser, TriesAllWaysThroughOptionsAndAlternatives) {
    const SmallLanguage language("start = [ \"A\" ] { \"A\" } ( \"A\" | \"A\" \"B\" ) ;");
    for (const char* text : {"A", "A B", "A A", "A A A A B"})
        EXPECT_TRUE(language.derives(text)) << text;
    for (const char* text : {"", "B", "B A", "A B A", "A B B"})
        EXPECT_FALSE(language.derives(text)) << text;
}

TEST(Recogniser, EndsInARepetitionOfNothing) {
    const SmallLanguage language("start = { [ \"A\" ] { \"B\" } NIL } ;");
    EXPECT_TRUE(language.derives(""));
    EXPECT_TRUE(language.derives("A B B A"));
    EXPECT_FALSE(language.derives("A X"));
}

TEST(Recogniser, GivesNothingForLeftRecursion) {
    const SmallLanguage language("start = start \"A\" | \"A\" ;");
    EXPECT_FALSE(language.derives("A"));
}

TEST(Recogniser, TakesTerminalsInAnyCaseAndNoKeywordForAName) {
    const SmallLanguage language("start = \"AB\" identifier ;");
    EXPECT_TRUE(language.derives("ab x"));
    EXPECT_TRUE(language.derives("Ab abx"));
    EXPECT_FALSE(language.derives("AB ab"));
    EXPECT_FALSE(language.derives("ABX"));
}

TEST(Recogniser, SeparatesTokensByWholeCommentsAndPragmas) {
    const SmallLanguage language("start = \"A\" \"B\" ;");
    for (const char* text : {"A(**)B", "A (* x *) {y} B (* \n *)"})
        EXPECT_TRUE(language.derives(text)) << text;
    for (const char* text : {"A B // x", "A /* x */ B", "A B (* x", "A (* (* x *) *) B", "A B { x"})
        EXPECT_FALSE(language.derives(text)) << text;
}

TEST(Recogniser, LooksIntoTokens) {
    const SmallLanguage language("start = { signed_integer | named | text } ;");
    for (const char* text : {"10", "-10", "a#b1", "A#X -0", "'$L'", "'a $L'"})
        EXPECT_TRUE(language.derives(text)) << text;
    // A sign adjoins its number, and between quotes case counts.
    for (const char* text : {"12", "- 10", "--1", "+1", "a#", "c#a", "'$l'", "'$'", "''a"})
        EXPECT_FALSE(language.derives(text)) << text;
}

TEST(Recogniser, TakesTAndDBeforeANumberSignForNoName) {
    const FormalSyntax& syntax = formal_syntax();
    EXPECT_TRUE(syntax.derives("PROGRAM p x := TT#a; END_PROGRAM"));
    EXPECT_TRUE(syntax.derives("PROGRAM p t := d; END_PROGRAM"));
    EXPECT_FALSE(syntax.derives("PROGRAM p x := T#a; END_PROGRAM"));
    EXPECT_FALSE(syntax.derives("PROGRAM p x := d#a; END_PROGRAM"));
}

TEST(Recogniser, CountsLineEndsInInstructionListOnly) {
    const std::string list = "### Part\n```ebnf\nstart = \"X\" { item } \"X\" ;\n```\n"
                             "### B.2.1 List\n```ebnf\nitem = \"A\" [ \"B\" ] EOL { EOL } ;\n```\n";
    const Grammar grammar = read_grammar(list);
    const Words words(grammar, list);
    const LexicalRecogniser lexical(grammar, words);
    for (const char* text : {"X X", "X\nX", "X A\nX", "X A B\n\nX", "X A B\nA\n(* c *)\nX\n"})
        EXPECT_TRUE(derives(grammar, lexical, text)) << text;
    for (const char* text : {"X A X", "X A\nB\nX", "X A A\nX", "X\nA\nX"})
        EXPECT_FALSE(derives(grammar, lexical, text)) << text;
}

// By hand, so that not everything rests on what the program itself takes.
TEST(Recogniser, KnowsTheLanguage) {
    const FormalSyntax& syntax = formal_syntax();
    for (const char* text :
         {"", "PROGRAM p\nEND_PROGRAM", "TYPE T : INT(1..-5) := +3; END_TYPE",
          "FUNCTION f : INT VAR_INPUT a, b : BOOL; END_VAR f := a - -5; END_FUNCTION",
          "PROGRAM p VAR x AT %IX1.2 : ARRAY [0..5] OF T; END_VAR x[1].y := NOT (z); END_PROGRAM",
          "PROGRAM p\nLD a\nAND( b\nOR c\n)\nl1: ST d\nEND_PROGRAM"})
        EXPECT_TRUE(syntax.derives(text)) << text;
    for (const char* text :
         {"PROGRAM p END_PROGRAM", "TYPE T : INT(1..- 5); END_TYPE", "TYPE T : INT END_TYPE",
          "FUNCTION f VAR_INPUT a : BOOL; END_VAR ; END_FUNCTION", "PROGRAM p x = 1; END_PROGRAM",
          "PROGRAM p IF x THEN END_IF; END_PROGRAM", "PROGRAM p LD a END_PROGRAM",
          "PROGRAM p\nLD a\n, b\nEND_PROGRAM", "PROGRAM IF ; END_PROGRAM"})
        EXPECT_FALSE(syntax.derives(text)) << text;
}

} // namespace
} // namespace iecfront::test
