#include "ast/tree_builder.hpp"

#include <iecfront/ast/dump.hpp>

#include <algorithm>
#include <gtest/gtest.h>

using namespace iecfront;
using namespace iecfront::ast;
using iecfront::test::assignment;
using iecfront::test::chain;
using iecfront::test::chain_text;
using iecfront::test::nested;
using iecfront::test::nested_text;
using iecfront::test::TreeBuilder;

namespace {

SyntaxTree tree_of(std::vector<std::shared_ptr<const Unit>> units) {
    return SyntaxTree("a\"b.st", Encoding::utf8, std::move(units), {});
}

TEST(SExpression, NamesMembersWhereThereAreSeveral) {
    TreeBuilder builder("x := a + b");
    const auto* statement = assignment(builder);
    const auto unit = builder.unit({statement});
    EXPECT_EQ(s_expression(*unit, *statement),
              R"((assignment_statement variable:(variable_name "x") expression:)"
              R"((binary_expression + left:(variable_name "a") right:(variable_name "b"))))");
}

TEST(SExpression, AnOnlyMemberNeedsNoName) {
    TreeBuilder builder("( x )");
    const auto* expression = nested(builder, 1);
    EXPECT_EQ(s_expression(*builder.unit(), *expression),
              R"((parenthesized_expression (variable_name "x")))");
}

TEST(SExpression, ListsStandInBrackets) {
    TreeBuilder builder("VAR CONSTANT a , b : INT ; END_VAR");
    auto* declaration = builder.node<VariableDeclaration>(2, 7);
    declaration->names =
        builder.list<Identifier>({builder.leaf<Identifier>(2), builder.leaf<Identifier>(4)});
    declaration->specification = builder.leaf<ElementaryTypeName>(6);
    auto* block = builder.node<VariableDeclarations>(0, 9);
    block->qualifier = BlockQualifier::constant;
    block->declarations = builder.list<Node>({declaration});
    EXPECT_EQ(s_expression(*builder.unit({block}), *block),
              R"((variable_declarations var constant [(variable_declaration names:["a" "b"] )"
              R"(specification:(elementary_type_name "INT"))]))");
}

TEST(SExpression, LeavesOutWhatIsNotThere) {
    TreeBuilder builder("PROGRAM p END_PROGRAM");
    auto* program = builder.node<ProgramDeclaration>(0, 3);
    program->name = builder.leaf<Identifier>(1);
    auto* body = builder.node<StatementList>(2, 2);
    body->missing = false;
    program->body = body;
    EXPECT_EQ(s_expression(*builder.unit(), *program),
              R"((program_declaration name:"p" body:(statement_list)))");
}

TEST(SExpression, SaysWhatIsMissing) {
    TreeBuilder builder("x");
    auto* argument = builder.node<OutputArgument>(0, 1);
    argument->negated = true;
    argument->name = builder.node<Identifier>(0, 0);
    argument->variable = builder.node<ErrorExpression>(1, 1);
    EXPECT_EQ(s_expression(*builder.unit(), *argument),
              "(output_argument negated name:(identifier missing) "
              "variable:(error_expression missing))");
}

TEST(SExpression, ShortensLongTextsBetweenCharacters) {
    const std::string euro = "\xE2\x82\xAC"; // three bytes: the 40th lies within one
    std::string text;
    for (int i = 0; i < 14; ++i)
        text += euro;
    TreeBuilder builder(text);
    const auto* skipped = builder.leaf<SkippedText>(0);
    EXPECT_EQ(s_expression(*builder.unit(), *skipped),
              "(skipped_text \"" + text.substr(0, 39) + "...\")");
    TreeBuilder exact(std::string(40, 'x'));
    const auto* kept = exact.leaf<SkippedText>(0);
    EXPECT_EQ(s_expression(*exact.unit(), *kept),
              "(skipped_text \"" + std::string(40, 'x') + "\")");
}

TEST(SExpression, EscapesWhatIsNotPlain) {
    TreeBuilder builder("\"a\"\n\\");
    const auto* skipped = builder.node<SkippedText>(0, 2);
    EXPECT_EQ(s_expression(*builder.unit(), *skipped), R"((skipped_text "\"a\"\n\\"))");
    TreeBuilder latin("\xC4", Encoding::iso_8859_1);
    const auto* name = latin.leaf<Identifier>(0);
    EXPECT_EQ(s_expression(*latin.unit(), *name), "\"\xC3\x84\"");
}

TEST(DumpTree, IsALineANode) {
    TreeBuilder builder("\n x := a\n+ b");
    const auto* statement = assignment(builder);
    EXPECT_EQ(dump_tree(tree_of({TreeBuilder("first").unit(), builder.unit({statement})})),
              R"(library_unit 1:1-1:6
library_unit 2:2-3:4
  assignment_statement 2:2-3:4
    variable: variable_name "x" 2:2-2:3
    expression: binary_expression + 2:7-3:4
      left: variable_name "a" 2:7-2:8
      right: variable_name "b" 3:3-3:4
)");
}

TEST(DumpTree, ANodeWithoutTextHasOnePosition) {
    TreeBuilder builder("x :=");
    auto* statement = builder.node<AssignmentStatement>(0, 2);
    statement->variable = builder.leaf<VariableName>(0);
    statement->expression = builder.node<ErrorExpression>(2, 2);
    EXPECT_EQ(dump_tree(tree_of({builder.unit({statement})})), R"(library_unit 1:1-1:5
  assignment_statement 1:1-1:5
    variable: variable_name "x" 1:1-1:2
    expression: error_expression missing 1:5
)");
}

TEST(DumpTree, PositionsAreThoseOfTheTree) {
    const std::string mark = "\xEF\xBB\xBF";
    const auto tree = tree_of({TreeBuilder(mark + "a\xC3\x84").unit(), TreeBuilder("b").unit(),
                               TreeBuilder(" c\r\n d").unit(), TreeBuilder(mark).unit()});
    EXPECT_EQ(dump_tree(tree), "library_unit 1:1-1:3\n"
                               "library_unit 1:3-1:4\n"
                               "library_unit 1:5-2:3\n"
                               "library_unit 2:3-2:4\n");
    EXPECT_EQ(tree.position(tree.size()), (Position{2, 4}));
}

TEST(DumpTree, WritesDeepLevelsAsNumbers) {
    TreeBuilder builder(nested_text(100));
    const auto* expression = nested(builder, 100);
    const std::string dump = dump_tree(tree_of({builder.unit({expression})}));
    const std::string margin(120, ' ');
    EXPECT_NE(dump.find('\n' + margin + "parenthesized_expression"), std::string::npos);
    EXPECT_NE(dump.find('\n' + margin + "61: parenthesized_expression"), std::string::npos);
    EXPECT_NE(dump.find('\n' + margin + "101: variable_name \"a\""), std::string::npos);
}

TEST(DumpJson, HasAllMembers) {
    TreeBuilder first("NOT x =>");
    auto* argument = first.node<OutputArgument>(0, 3);
    argument->negated = true;
    argument->name = first.leaf<Identifier>(1);
    argument->variable = first.node<ErrorExpression>(3, 3);
    TreeBuilder second(" FOR");
    auto* body = second.leaf<SkippedText>(0);
    EXPECT_EQ(
        dump_json(tree_of({first.unit({argument}), second.unit({body})})),
        R"({"file": "a\"b.st", "units": [
{"kind": "library_unit", "offset": 0, "endOffset": 8, "elements": [)"
        R"({"kind": "output_argument", "offset": 0, "endOffset": 8, "negated": true, "name": )"
        R"({"kind": "identifier", "offset": 4, "endOffset": 5, "text": "x"}, "variable": )"
        R"({"kind": "error_expression", "offset": 8, "endOffset": 8, "missing": true, )"
        R"("text": ""}}]},
{"kind": "library_unit", "offset": 9, "endOffset": 12, "elements": [)"
        R"({"kind": "skipped_text", "offset": 9, "endOffset": 12, )"
        R"("text": "FOR"}]}
]}
)");
}

TEST(DumpJson, NullAndEmptyAreWritten) {
    TreeBuilder builder("STEP");
    auto* declaration = builder.leaf<VariableDeclaration>(0);
    const std::string dump = dump_json(tree_of({builder.unit({declaration})}));
    EXPECT_NE(dump.find(R"("edge": "none", "names": [], "location": null, "specification": null)"),
              std::string::npos);
}

TEST(DumpJson, IsUtf8WhateverTheBytes) {
    TreeBuilder builder(std::string("\xFF\x01\"\\\0z", 6));
    const auto* skipped = builder.leaf<SkippedText>(0);
    const std::string dump = dump_json(tree_of({builder.unit({skipped})}));
    EXPECT_NE(dump.find("\"text\": \"\xEF\xBF\xBD\\u0001\\\"\\\\\\u0000z\""), std::string::npos);
}

// Neither recursion nor output that grows with the square of the size.
TEST(Dump, TakesDeepTrees) {
    constexpr std::uint32_t size = 200'000;
    constexpr std::size_t most_bytes_a_node = 200;
    TreeBuilder chained(chain_text(size));
    const auto* sum = chain(chained, size);
    TreeBuilder deep(nested_text(size));
    const auto* inner = nested(deep, size);
    for (const auto& unit : {chained.unit({sum}), deep.unit({inner})}) {
        EXPECT_LT(s_expression(*unit, unit->root()).size(), 2 * size * most_bytes_a_node);
        EXPECT_LT(dump_tree(tree_of({unit})).size(), 2 * size * most_bytes_a_node);
        EXPECT_LT(dump_json(tree_of({unit})).size(), 2 * size * most_bytes_a_node);
    }
}

// Of a line that many units share, each column is counted once.
TEST(Dump, TakesManyUnitsOnOneLine) {
    const std::vector<std::shared_ptr<const Unit>> units(200'000, TreeBuilder("a b c ").unit());
    const std::string dump = dump_tree(tree_of(units));
    EXPECT_EQ(std::count(dump.begin(), dump.end(), '\n'), 200'000);
    EXPECT_NE(dump.find("library_unit 1:1199995-1:1200000\n"), std::string::npos);
}

} // namespace
