#include <iecfront/ast/nodes.hpp>

#include <gtest/gtest.h>
#include <set>
#include <type_traits>

using namespace iecfront::ast;

namespace {

TEST(NodeKind, HasANameAndAProduction) {
    EXPECT_EQ(to_string(NodeKind::library_unit), "library_unit");
    EXPECT_EQ(to_string(NodeKind::assignment_statement), "assignment_statement");
    EXPECT_EQ(to_string(NodeKind::il_error_operation), "il_error_operation");
    EXPECT_EQ(production(NodeKind::library_unit), "library");
    EXPECT_EQ(production(NodeKind::for_statement), "for_statement");
    EXPECT_EQ(production(NodeKind::skipped_text), "-");
}

TEST(NodeKind, NamesAreDifferent) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < node_kind_count; ++i) {
        names.insert(to_string(static_cast<NodeKind>(i)));
        EXPECT_FALSE(production(static_cast<NodeKind>(i)).empty());
    }
    EXPECT_EQ(names.size(), node_kind_count);
}

// A row of nodes.def and its struct say the same.
template<class Struct, class Category>
constexpr bool is_sound(NodeKind kind) {
    return Struct::node_kind == kind && std::is_base_of_v<Category, Struct> &&
           std::is_trivially_destructible_v<Struct> && !std::is_polymorphic_v<Struct>;
}

#define IECFRONT_NODE(enumerator, Struct, Category, production)                                    \
    static_assert(is_sound<Struct, Category>(NodeKind::enumerator), #Struct);
#include <iecfront/ast/nodes.def>

static_assert(sizeof(Node) == 12);

TEST(EnumerationNames, AreThoseOfTheHeaders) {
    EXPECT_EQ(to_string(VariableBlock::var), "var");
    EXPECT_EQ(to_string(VariableBlock::var_in_out), "var_in_out");
    EXPECT_EQ(to_string(VariableBlock::var_config), "var_config");
    EXPECT_EQ(to_string(BlockQualifier::none), "none");
    EXPECT_EQ(to_string(BlockQualifier::non_retain), "non_retain");
    EXPECT_EQ(to_string(ActionQualifierKind::overriding_reset), "R");
    EXPECT_EQ(to_string(ActionQualifierKind::stored_and_time_limited), "SL");
    EXPECT_EQ(to_string(ActionQualifierKind::unknown), "unknown");
    EXPECT_EQ(to_string(Edge::rising), "rising");
    EXPECT_EQ(to_string(Direction::read_write), "read_write");
}

TEST(EnumerationNames, OperatorsAreSpeltAsInTable55) {
    EXPECT_EQ(to_string(BinaryOperator::power), "**");
    EXPECT_EQ(to_string(BinaryOperator::modulo), "MOD");
    EXPECT_EQ(to_string(BinaryOperator::not_equal), "<>");
    EXPECT_EQ(to_string(BinaryOperator::logical_and), "AND");
    EXPECT_EQ(to_string(BinaryOperator::logical_or), "OR");
    EXPECT_EQ(to_string(UnaryOperator::minus), "-");
    EXPECT_EQ(to_string(UnaryOperator::logical_not), "NOT");
    EXPECT_EQ(to_string(UnaryOperator::plus), "+");
}

TEST(Constant, KnowsItsSign) {
    IntegerLiteral literal;
    literal.first_token = 3;
    literal.end_token = 5;
    literal.literal_token = 4;
    EXPECT_TRUE(literal.has_sign());
    literal.first_token = 4;
    EXPECT_FALSE(literal.has_sign());
}

} // namespace
