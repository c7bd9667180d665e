#include "ast/tree_builder.hpp"

#include <iecfront/ast/nodes.hpp>

#include <gtest/gtest.h>

using namespace iecfront;
using namespace iecfront::ast;
using iecfront::test::assignment;
using iecfront::test::chain;
using iecfront::test::chain_text;
using iecfront::test::TreeBuilder;

namespace {

std::vector<NodeKind> child_kinds(const Node& node) {
    std::vector<NodeKind> kinds;
    for_each_child(node, [&](const Node& child) { kinds.push_back(child.kind); });
    return kinds;
}

using Kinds = std::vector<NodeKind>;

TEST(Dispatch, GivesEachKindItsStruct){
#define IECFRONT_NODE(enumerator, Struct, Category, production)                                    \
    {                                                                                              \
        const Struct node;                                                                         \
        const bool right = dispatch(node, [](const auto& typed) {                                  \
            return std::is_same_v<decltype(typed), const Struct&>;                                 \
        });                                                                                        \
        EXPECT_TRUE(right) << #Struct;                                                             \
    }
#include <iecfront/ast/nodes.def>
}

TEST(As, TakesStructsAndCategories) {
    const IntegerLiteral literal;
    const Node* node = &literal;
    EXPECT_EQ(as<IntegerLiteral>(node), node);
    EXPECT_EQ(as<Constant>(node), node);
    EXPECT_EQ(as<Expression>(node), node);
    EXPECT_EQ(as<RealLiteral>(node), nullptr);
    EXPECT_EQ(as<Statement>(node), nullptr);
    EXPECT_EQ(as<Node>(nullptr), nullptr);
    EXPECT_TRUE(is<Node>(NodeKind::step));
    EXPECT_FALSE(is<Constant>(NodeKind::variable_name));
}

TEST(ForEachChild, GoesInSourceOrderAndLeavesOutWhatIsNotThere) {
    TreeBuilder builder("FOR i := 1 TO 9 DO END_FOR");
    auto* loop = builder.node<ForStatement>(0, 8);
    loop->control_variable = builder.leaf<VariableName>(1);
    loop->from = builder.leaf<IntegerLiteral>(3);
    loop->to = builder.leaf<IntegerLiteral>(5);
    loop->statements = builder.node<StatementList>(7, 7);
    EXPECT_EQ(child_kinds(*loop), Kinds({NodeKind::variable_name, NodeKind::integer_literal,
                                         NodeKind::integer_literal, NodeKind::statement_list}));
    EXPECT_TRUE(child_kinds(*loop->from).empty());
}

TEST(ForEachChild, GoesThroughLists) {
    TreeBuilder builder("a b c : INT");
    auto* declaration = builder.node<VariableDeclaration>(0, 5);
    declaration->names = builder.list<Identifier>(
        {builder.leaf<Identifier>(0), builder.leaf<Identifier>(1), builder.leaf<Identifier>(2)});
    declaration->specification = builder.leaf<ElementaryTypeName>(4);
    EXPECT_EQ(child_kinds(*declaration),
              Kinds({NodeKind::identifier, NodeKind::identifier, NodeKind::identifier,
                     NodeKind::elementary_type_name}));
}

TEST(ForEachMember, GivesNamesAndAllValues) {
    const OutputArgument argument;
    std::vector<std::string_view> names;
    for_each_member(argument, [&](std::string_view name, const auto&) { names.push_back(name); });
    EXPECT_EQ(names, std::vector<std::string_view>({"negated", "name", "variable"}));

    names.clear();
    const Node& node = argument; // whose struct is found first
    for_each_member(node, [&](std::string_view name, const auto&) { names.push_back(name); });
    EXPECT_EQ(names.size(), 3U);
}

// JSON dumps write these of each node; a member of the same name would clash.
TEST(ForEachMember, NoMemberIsCalledLikeAFieldOfTheJsonDump) {
    const auto check = [](const auto& node) {
        for_each_member(node, [&](std::string_view name, const auto&) {
            for (const std::string_view taken : {"kind", "offset", "endOffset", "missing", "text"})
                EXPECT_NE(name, taken) << to_string(node.kind);
        });
    };
#define IECFRONT_NODE(enumerator, Struct, Category, production) check(Struct());
#include <iecfront/ast/nodes.def>
}

class Equal : public ::testing::Test {
protected:
    TreeBuilder builder{"x := a + b"};
    AssignmentStatement* a = assignment(builder);
    AssignmentStatement* b = assignment(builder);
    BinaryExpression* sum_of_b = const_cast<BinaryExpression*>(as<BinaryExpression>(b->expression));
};

TEST_F(Equal, OfTheSameShape) {
    EXPECT_TRUE(equal(*a, *a));
    EXPECT_TRUE(equal(*a, *b));
}

TEST_F(Equal, NotWhenAKindDiffers) {
    sum_of_b->right = builder.leaf<IntegerLiteral>(4);
    EXPECT_FALSE(equal(*a, *b));
}

TEST_F(Equal, NotWhenAScalarDiffers) {
    sum_of_b->op = BinaryOperator::subtract;
    EXPECT_FALSE(equal(*a, *b));
}

TEST_F(Equal, NotWhenAHashDiffers) {
    auto* name = builder.leaf<VariableName>(2);
    name->hash = 1;
    sum_of_b->left = name;
    EXPECT_FALSE(equal(*a, *b));
}

TEST_F(Equal, NotWhenTokensDiffer) {
    sum_of_b->end_token = 4;
    EXPECT_FALSE(equal(*a, *b));
}

TEST_F(Equal, NotWhenOneIsMissing) {
    b->missing = true;
    EXPECT_FALSE(equal(*a, *b));
}

TEST_F(Equal, NotWhenAChildIsNull) {
    sum_of_b->right = nullptr;
    EXPECT_FALSE(equal(*a, *b));
    EXPECT_FALSE(equal(*b, *a));
}

TEST_F(Equal, NotWhenAListIsLonger) {
    auto* one = builder.node<StatementList>(0, 5);
    auto* two = builder.node<StatementList>(0, 5);
    one->statements = builder.list<Statement>({a});
    two->statements = builder.list<Statement>({a, b});
    EXPECT_FALSE(equal(*one, *two));
    one->statements = builder.list<Statement>({b, a});
    EXPECT_TRUE(equal(*one, *two));
}

TEST_F(Equal, SeesWhichTokenOfAConstantIsTheLiteral) {
    auto* one = builder.node<IntegerLiteral>(0, 2);
    auto* two = builder.node<IntegerLiteral>(0, 2);
    one->literal_token = 1;
    EXPECT_FALSE(equal(*one, *two));
}

TEST_F(Equal, NeedsNoStackForALongChain) {
    constexpr std::uint32_t operands = 500'000;
    TreeBuilder long_builder(chain_text(operands));
    EXPECT_TRUE(equal(*chain(long_builder, operands), *chain(long_builder, operands)));
}

} // namespace
