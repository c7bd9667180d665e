#include "grammar/ebnf.hpp"
#include "grammar/formal_syntax.hpp"

#include <gtest/gtest.h>
#include <set>

namespace iecfront::test {
namespace {

using Kind = Expression::Kind;

[[nodiscard]] Grammar grammar_of(const std::string& block) {
    return read_grammar("### Part\n```ebnf\n" + block + "\n```\n");
}

/// An expression in prefix form: `seq(a "b" opt(c))`.
[[nodiscard]] std::string in_words(const Expression& expression) {
    static constexpr std::string_view names[] = {"NIL", "",    "",    "EOL", "",
                                                 "seq", "alt", "opt", "rep"};
    std::string text(names[static_cast<std::size_t>(expression.kind)]);
    if (expression.kind == Kind::terminal)
        return "\"" + expression.text + "\"";
    if (expression.kind == Kind::described)
        return "<" + expression.text + ">";
    if (expression.kind == Kind::name)
        return expression.text;
    for (const Expression& part : expression.parts)
        text += (&part == &expression.parts.front() ? "(" : " ") + in_words(part);
    return text + (expression.parts.empty() ? "" : ")");
}

[[nodiscard]] std::string body_of(const std::string& expression) {
    const Grammar grammar = grammar_of("start = " + expression + " ;\na = NIL ;\nb = NIL ;");
    EXPECT_EQ(grammar.faults, std::vector<std::string>{}) << expression;
    return in_words(grammar.productions.front().body);
}

TEST(EbnfReader, ReadsEachPartOfAProduction) {
    EXPECT_EQ(body_of("a"), "a");
    EXPECT_EQ(body_of("\"IF\" ';' '\"' \"'\""), R"(seq("IF" ";" """ "'"))");
    EXPECT_EQ(body_of("<any one> EOL NIL"), "seq(<any one> EOL NIL)");
    EXPECT_EQ(body_of("[ a ] { b }"), "seq(opt(a) rep(b))");
    EXPECT_EQ(body_of("[ a\n | b ]"), "opt(alt(a b))");
}

TEST(EbnfReader, BindsARowTighterThanTheBar) {
    EXPECT_EQ(body_of("a b | b | a a"), "alt(seq(a b) b seq(a a))");
    EXPECT_EQ(body_of("a ( b | a ) b"), "seq(a alt(b a) b)");
    EXPECT_EQ(body_of("( a | b ) | a"), "alt(alt(a b) a)");
}

TEST(EbnfReader, ReadsOnlyTheMarkedBlocks) {
    const Grammar grammar = read_grammar("## One (lexical)\n```ebnf\na = \"x\" ;\n```\n"
                                         "```ebnf-extension\nb = ;;\n```\nc = \"y\" ;\n"
                                         "### B.2.1 Two\n```ebnf\nd =\n  a   [ a ]\n;\n```\n");
    EXPECT_EQ(grammar.faults, std::vector<std::string>{});
    ASSERT_EQ(grammar.productions.size(), 2U);
    EXPECT_TRUE(grammar.productions[0].lexical());
    EXPECT_FALSE(grammar.productions[0].by_line());
    EXPECT_FALSE(grammar.productions[1].lexical());
    EXPECT_TRUE(grammar.productions[1].by_line());
    EXPECT_EQ(grammar.productions[1].text, "d = a [ a ] ;");
}

TEST(EbnfReader, NumbersExpressionsAndFindsProductions) {
    const Grammar grammar = grammar_of("a = b \"x\" ;\nb = \"y\" ;");
    EXPECT_EQ(grammar.expression_count, 4U); // the row and its two parts, and `"y"`
    EXPECT_EQ(grammar.productions[0].body.parts[0].production, 1U);
    ASSERT_NE(grammar.find("b"), nullptr);
    EXPECT_EQ(grammar.find("b")->name, "b");
    EXPECT_EQ(grammar.find("c"), nullptr);
}

TEST(EbnfReader, SaysWhatIsWrong) {
    const auto faults = [](const std::string& block) { return grammar_of(block).faults.size(); };
    EXPECT_EQ(faults("a = \"x\" ;"), 0U);
    EXPECT_EQ(faults("a = c ;"), 1U) << "no production";
    EXPECT_EQ(faults("a = \"x\" ;\na = \"y\" ;"), 1U) << "twice";
    EXPECT_EQ(faults("a \"x\" ;"), 1U) << "no equals sign";
    EXPECT_EQ(faults("a = \"x\""), 1U) << "no end";
    EXPECT_EQ(faults("a = [ \"x\" ;"), 1U) << "no bracket";
    EXPECT_EQ(faults("a = \"x ;"), 1U) << "no quote";
    EXPECT_EQ(faults("a = \"x\" | ;"), 1U) << "nothing behind the bar";
    EXPECT_EQ(faults("a = \"x\" ? ;"), 1U) << "a character without meaning";
}

// ---- docs/grammar.md
// -----------------------------------------------------------------------------

TEST(FormalSyntaxPage, IsReadWithoutAFault) {
    EXPECT_EQ(formal_syntax().grammar.faults, std::vector<std::string>{});
    EXPECT_EQ(formal_syntax().grammar.productions.front().name, "library");
    EXPECT_GT(formal_syntax().grammar.productions.size(), 250U);
}

// A production that nothing leads to is in a block marked `ebnf-unreachable`.
TEST(FormalSyntaxPage, LeadsToEachProduction) {
    const Grammar& grammar = formal_syntax().grammar;
    std::set<std::size_t> reached{0};
    std::vector<std::size_t> pending{0};
    while (!pending.empty()) {
        const Production& production = grammar.productions[pending.back()];
        pending.pop_back();
        for_each_expression(production.body, [&](const Expression& one) {
            if (one.kind == Kind::name && reached.insert(one.production).second)
                pending.push_back(one.production);
        });
    }
    for (std::size_t i = 0; i < grammar.productions.size(); ++i)
        EXPECT_TRUE(reached.contains(i)) << grammar.productions[i].name;
}

} // namespace
} // namespace iecfront::test
