#include "support/tree_faults.hpp"

#include <iecfront/ast/stored_nodes.hpp>
#include <iecfront/ast/visitor.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>
#include <ranges>
#include <set>
#include <string>

using namespace iecfront;
using iecfront::test::tree_fault;

namespace {

static_assert(std::forward_iterator<ast::StoredNodes::iterator>);
static_assert(std::ranges::borrowed_range<ast::StoredNodes>);

const Unit& first_unit(const SyntaxTree& tree) {
    return *tree.slots().front().unit;
}

std::ptrdiff_t count(const Unit& unit, ast::NodeKind kind) {
    return std::ranges::count(unit.nodes(), kind, &ast::Node::kind);
}

SyntaxTree parse_in_program(const std::string& lines) {
    return parse(SourceText("PROGRAM p\n" + lines + "\nEND_PROGRAM\n"));
}

TEST(StoredNodes, AreThoseThatAWalkComesTo) {
    const SyntaxTree tree = parse_in_program("VAR a, b : ARRAY [1..2, 3..4] OF INT; END_VAR\n"
                                             "IF a[1, 3] > b[b[1, 3], 4] THEN t(IN := a); END_IF;");
    EXPECT_TRUE(tree.diagnostics().empty());
    std::multiset<const ast::Node*> walked;
    ast::walk(first_unit(tree).root(), [&](const ast::Node& node) {
        walked.insert(&node);
        return ast::Walk::into;
    });
    std::multiset<const ast::Node*> stored;
    for (const ast::Node& node : first_unit(tree).nodes())
        stored.insert(&node);
    EXPECT_EQ(stored, walked);
}

TEST(StoredNodes, CanBeSearched) {
    const SyntaxTree tree = parse_in_program("RETURN;");
    const auto found = std::ranges::find(first_unit(tree).nodes(), ast::NodeKind::return_statement,
                                         &ast::Node::kind);
    ASSERT_NE(found, first_unit(tree).nodes().end());
    EXPECT_EQ(first_unit(tree).text(*found), "RETURN");
    EXPECT_EQ(count(first_unit(tree), ast::NodeKind::if_statement), 0);
}

TEST(StoredNodes, PassLongRowsOfChildren) {
    std::string values = "1";
    for (int i = 1; i < 3000; ++i)
        values += ", " + std::to_string(i);
    const SyntaxTree tree =
        parse_in_program("VAR a : ARRAY [0..2999] OF INT := [" + values + "]; END_VAR\n;");
    EXPECT_TRUE(tree.diagnostics().empty());
    EXPECT_EQ(count(first_unit(tree), ast::NodeKind::integer_literal), 3002);
}

// A call is read as an operand before it is known to be a statement, and STRING as a name of a type
// before it has a length.
TEST(StoredNodes, HaveNoneThatWasMadeInVain) {
    const SyntaxTree tree =
        parse_in_program("VAR s : STRING[5]; t : TON; END_VAR\nt(IN := TRUE); t();");
    const Unit& unit = first_unit(tree);
    EXPECT_TRUE(unit.diagnostics().empty());
    EXPECT_EQ(count(unit, ast::NodeKind::fb_invocation), 2);
    EXPECT_EQ(count(unit, ast::NodeKind::function_call), 0);
    EXPECT_EQ(count(unit, ast::NodeKind::string_specification), 1);
    EXPECT_EQ(count(unit, ast::NodeKind::elementary_type_name), 0);
}

TEST(StoredNodes, HaveNoneThatRecoveryGaveUp) {
    const std::string text = "PROGRAM p\nVAR a : POINTER TO INT; END_VAR\na := 1 2;\nEND_PROGRAM\n";
    const SyntaxTree tree = parse(SourceText(text));
    EXPECT_EQ(tree_fault(tree, text), "");
    EXPECT_EQ(count(first_unit(tree), ast::NodeKind::error_type), 1);
    EXPECT_EQ(count(first_unit(tree), ast::NodeKind::elementary_type_name), 0); // INT
}

// The comma explains all that is wrong, so that the unit is read again without it.
TEST(StoredNodes, AreThoseOfTheRepairedText) {
    const std::string text = "PROGRAM p\nWHILE , a DO b := 1; END_WHILE;\nEND_PROGRAM\n";
    const SyntaxTree tree = parse(SourceText(text));
    EXPECT_EQ(tree_fault(tree, text), "");
    EXPECT_EQ(tree.diagnostics().size(), 1U);
    EXPECT_EQ(count(first_unit(tree), ast::NodeKind::while_statement), 1);
    EXPECT_EQ(count(first_unit(tree), ast::NodeKind::variable_name), 2);
    EXPECT_EQ(count(first_unit(tree), ast::NodeKind::error_expression), 0);
}

TEST(StoredNodes, AreOneOfAUnitThatIsNotExamined) {
    ParseOptions options;
    options.maximum_unit_memory = 1;
    const SyntaxTree tree = parse(SourceText("PROGRAM p ; END_PROGRAM"), options);
    EXPECT_EQ(std::ranges::distance(first_unit(tree).nodes()), 1);
    EXPECT_EQ(&*first_unit(tree).nodes().begin(), &first_unit(tree).root());
}

TEST(StoredNodes, AreNoneWithoutMemory) {
    EXPECT_EQ(std::ranges::distance(ast::StoredNodes()), 0);
}

} // namespace
