#include <iecfront/ast/attached_comments.hpp>
#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/visitor.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <string>

using namespace iecfront;

namespace {

// Of every variable declaration: the comments before, `|`, those behind.
std::vector<std::string> comments(const std::string& lines) {
    const SyntaxTree tree =
        parse(SourceText("PROGRAM p\nVAR\n" + lines + "\nEND_VAR\n;\nEND_PROGRAM\n"));
    const Unit& unit = *tree.slots()[0].unit;
    std::vector<std::string> result;
    ast::walk(unit.root(), [&](const ast::Node& node) {
        if (node.kind == ast::NodeKind::variable_declaration) {
            const AttachedComments found = attached_comments(unit, node);
            std::string words;
            for (const Trivia& trivia : found.before)
                words += unit.text(trivia.range);
            words += '|';
            for (const Trivia& trivia : found.behind)
                words += unit.text(trivia.range);
            result.push_back(words);
        }
        return ast::Walk::into;
    });
    return result;
}

using Comments = std::vector<std::string>;

TEST(AttachedComments, StandAboveOrBehind) {
    EXPECT_EQ(comments("(*1*)\na : INT; (*2*)\n(*3*)\nb : INT; (*4*) (*5*)"),
              (Comments{"(*1*)|(*2*)", "(*3*)|(*4*)(*5*)"}));
}

TEST(AttachedComments, SeveralLinesAboveAreOneText) {
    EXPECT_EQ(comments("(*1\n2*)\n(*3*)\na : INT;"), (Comments{"(*1\n2*)(*3*)|"}));
}

TEST(AttachedComments, AnEmptyLineParts) {
    EXPECT_EQ(comments("(*1*)\n\n(*2*)\na : INT;"), (Comments{"(*2*)|"}));
    EXPECT_EQ(comments("(*1*)\n\na : INT;"), (Comments{"|"}));
}

TEST(AttachedComments, OfTwoOnALineEachHasItsOwn) {
    EXPECT_EQ(comments("a : INT; (*1*) b : INT; (*2*)"), (Comments{"|(*1*)", "|(*2*)"}));
}

TEST(AttachedComments, APragmaIsNone) {
    EXPECT_EQ(comments("{x}\na : INT; {y}"), (Comments{"|"}));
}

// 2.1.6
TEST(AttachedComments, PragmasAreLookedOver) {
    EXPECT_EQ(comments("(*1*)\n{attribute 'a'}\na : INT;"), (Comments{"(*1*)|"}));
    EXPECT_EQ(comments("(*1*)\n\n{attribute 'a'}\na : INT;"), (Comments{"|"}));
    EXPECT_EQ(comments("(*1*)\n{p}\n(*2*)\na : INT; {p} (*3*) {q}\n{r}\nb : INT;"),
              (Comments{"(*1*)(*2*)|(*3*)", "|"}));
}

// Of every library element in a file: the comments before, `|`, those behind.
std::vector<std::string> comments_of_elements(const std::string& text) {
    const SyntaxTree tree = parse(SourceText(text));
    std::vector<std::string> result;
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        const Unit& unit = *slot.unit;
        const AttachedComments found = attached_comments(unit, *unit.root().elements[0]);
        result.emplace_back();
        for (const Trivia& trivia : found.before)
            result.back() += unit.text(trivia.range);
        result.back() += '|';
        for (const Trivia& trivia : found.behind)
            result.back() += unit.text(trivia.range);
    }
    return result;
}

// B.0
TEST(AttachedComments, BehindALibraryElementBelongToIt) {
    const std::string p = "PROGRAM p ; END_PROGRAM";
    const std::string q = "PROGRAM q ; END_PROGRAM";
    EXPECT_EQ(comments_of_elements(p + " (*1*)\n" + q + " (*2*)\n"),
              (Comments{"|(*1*)", "|(*2*)"}));
    EXPECT_EQ(comments_of_elements(p + "; {x} (*1*) (*2*)\n(*3*)\n" + q),
              (Comments{"|(*1*)(*2*)", "(*3*)|"}));
    EXPECT_EQ(comments_of_elements(p + " (*1\n*) (*2*)\n" + q), (Comments{"|(*1\n*)", "(*2*)|"}));
    EXPECT_EQ(comments_of_elements(p + " (*1*) " + q), (Comments{"|", "(*1*)|"}));
}

TEST(AttachedComments, BelongToALibraryElementToo) {
    const SyntaxTree tree = parse(SourceText("(* what p does *)\nPROGRAM p ; END_PROGRAM"));
    const Unit& unit = *tree.slots()[0].unit;
    const AttachedComments found = attached_comments(unit, *unit.root().elements[0]);
    ASSERT_EQ(found.before.size(), 1U);
    EXPECT_EQ(unit.text(found.before[0].range), "(* what p does *)");
}

} // namespace
