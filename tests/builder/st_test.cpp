#include <iecfront/ast/dump.hpp>
#include <iecfront/builder/builder.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

// Expressions and statements (B.3): parentheses, layout, and what cannot be made.

namespace iecfront::test {
namespace {

using namespace build;
using ast::BinaryOperator;
using ast::UnaryOperator;

constexpr int operator_count = static_cast<int>(BinaryOperator::logical_or) + 1;

// The tree of an expression without its parentheses.
[[nodiscard]] std::string meaning(const Expression& expression) {
    const std::optional<SyntaxTree> tree = fragment(expression);
    EXPECT_TRUE(tree && tree->diagnostics().empty()) << expression.text();
    std::string shape =
        s_expression(*tree->slots()[0].unit, *tree->slots()[0].unit->root().elements[0]);
    constexpr std::string_view opening = "(parenthesized_expression ";
    for (std::size_t at = shape.find(opening); at != std::string::npos; at = shape.find(opening)) {
        shape.erase(at, opening.size());
        int depth = 1;
        std::size_t end = at;
        for (; depth > 0; ++end)
            depth += shape[end] == '(' ? 1 : shape[end] == ')' ? -1 : 0;
        shape.erase(end - 1, 1);
    }
    return shape;
}

[[nodiscard]] std::string operation(BinaryOperator op, const std::string& left,
                                    const std::string& right) {
    return "(binary_expression " + std::string(to_string(op)) + " left:" + left +
           " right:" + right + ")";
}

[[nodiscard]] std::string name(const std::string& letter) {
    return "(variable_name \"" + letter + "\")";
}

// Table 55: whatever operator stands in the operand of another.
TEST(BuiltExpressions, MeanWhatTheyWereMadeOf) {
    const Expression a = variable_name("a");
    const Expression b = variable_name("b");
    const Expression c = variable_name("c");
    for (int outer = 0; outer < operator_count; ++outer)
        for (int inner = 0; inner < operator_count; ++inner) {
            const auto op = static_cast<BinaryOperator>(outer);
            const auto nested = static_cast<BinaryOperator>(inner);
            EXPECT_EQ(meaning(binary_expression(op, binary_expression(nested, a, b), c)),
                      operation(op, operation(nested, name("a"), name("b")), name("c")));
            EXPECT_EQ(meaning(binary_expression(op, a, binary_expression(nested, b, c))),
                      operation(op, name("a"), operation(nested, name("b"), name("c"))));
        }
    for (int inner = 0; inner < operator_count; ++inner)
        for (const UnaryOperator op : {UnaryOperator::minus, UnaryOperator::logical_not}) {
            const auto nested = static_cast<BinaryOperator>(inner);
            const std::string unary = "(unary_expression " + std::string(to_string(op)) + " ";
            EXPECT_EQ(meaning(unary_expression(op, binary_expression(nested, a, b))),
                      unary + operation(nested, name("a"), name("b")) + ")");
            EXPECT_EQ(meaning(binary_expression(nested, a, unary_expression(op, b))),
                      operation(nested, name("a"), unary + name("b") + ")"));
        }
}

TEST(BuiltExpressions, HaveNoMoreParenthesesThanTheyNeed) {
    const Expression a = variable_name("a");
    const Expression sum = binary_expression(BinaryOperator::add, a, integer_literal(1));
    EXPECT_EQ(binary_expression(BinaryOperator::add, sum, a).text(), "a + 1 + a");
    EXPECT_EQ(binary_expression(BinaryOperator::subtract, a, sum).text(), "a - (a + 1)");
    EXPECT_EQ(binary_expression(BinaryOperator::multiply, sum, sum).text(), "(a + 1) * (a + 1)");
    EXPECT_EQ(binary_expression(BinaryOperator::less, sum, sum).text(), "a + 1 < a + 1");
    EXPECT_EQ(unary_expression(UnaryOperator::logical_not, a).text(), "NOT a");
    EXPECT_EQ(parenthesized_expression(a).text(), "(a)");
}

// A sign that adjoins a number is a part of the number (B.1.2.1).
TEST(BuiltExpressions, NegateNumbers) {
    const Expression minus_five = unary_expression(UnaryOperator::minus, integer_literal(5));
    EXPECT_EQ(meaning(minus_five), "(unary_expression - (integer_literal \"5\"))");
    EXPECT_EQ(meaning(unary_expression(UnaryOperator::minus, integer_literal(-5))),
              "(unary_expression - (integer_literal \"-5\"))");
    EXPECT_EQ(meaning(unary_expression(UnaryOperator::minus, minus_five)),
              "(unary_expression - (unary_expression - (integer_literal \"5\")))");
    EXPECT_EQ(meaning(binary_expression(BinaryOperator::subtract, minus_five, integer_literal(-5))),
              operation(BinaryOperator::subtract, "(unary_expression - (integer_literal \"5\"))",
                        "(integer_literal \"-5\")"));
}

// In `a + b.c` the point would go with `b` alone.
TEST(BuiltExpressions, AreNoVariablesWhenTheyAreOperations) {
    const Expression sum =
        binary_expression(ast::BinaryOperator::add, variable_name("a"), variable_name("b"));
    EXPECT_EQ(structured_variable(sum, "c").fault(), "`a + b` is no variable");
    EXPECT_EQ(array_variable(sum, {integer_literal(1)}).fault(), "`a + b` is no variable");
    EXPECT_EQ(array_variable(variable_name("a"), {sum}).fault(), "");
    EXPECT_EQ(structured_variable(variable_name("IF"), "c").fault(), "`IF` is no identifier");
}

TEST(BuiltStatements, AreLaidOut) {
    const Expression x = variable_name("x");
    const Statement increment =
        assignment_statement(x, binary_expression(BinaryOperator::add, x, integer_literal(1)));
    const Statement inner =
        if_statement(x, statement_list({increment, exit_statement()}),
                     {elsif_clause(x, statement_list({increment}))}, statement_list({}));
    const Statement loop = for_statement(
        "i", integer_literal(1), integer_literal(9), integer_literal(2),
        statement_list(
            {inner, fb_invocation("timer", {input_argument("IN", x), output_argument("Q", x)})}));
    EXPECT_EQ(loop.text(), "FOR i := 1 TO 9 BY 2 DO\n"
                           "    IF x THEN\n"
                           "        x := x + 1;\n"
                           "        EXIT;\n"
                           "    ELSIF x THEN\n"
                           "        x := x + 1;\n"
                           "    ELSE\n"
                           "        ;\n"
                           "    END_IF;\n"
                           "    timer(IN := x, Q => x);\n"
                           "END_FOR");
    const Statement choice = case_statement(
        x,
        {case_element({integer_literal(1), subrange(integer_literal(3), integer_literal(5))},
                      statement_list({return_statement()})),
         case_element({enumerated_value("Idle", "Mode")}, statement_list({}))},
        statement_list({increment}));
    EXPECT_EQ(choice.text(), "CASE x OF\n"
                             "    1, 3..5:\n"
                             "        RETURN;\n"
                             "    Mode#Idle:\n"
                             "        ;\n"
                             "ELSE\n"
                             "    x := x + 1;\n"
                             "END_CASE");
}

// What a user of a builder types must not become more than a name (2.1.2, 2.1.3).
TEST(BuiltNames, AreIdentifiers) {
    for (const std::string_view name :
         {"", " ", "1a", "a b", "a; b := 1", "IF", "end_if", "STEP", "a(*x*)", "a//x", "a.b",
          "a__b", "\xC3\x84", "a\n", "T#1s", "INT", "TRUE", "a#b", "AND"}) {
        EXPECT_NE(variable_name(name).fault(), "") << name;
        EXPECT_NE(derived_type_name(name).fault(), "") << name;
        EXPECT_NE(fb_invocation(name, {}).fault(), "") << name;
        EXPECT_NE(enumerated_value("a", std::string("x").append(name).append(" ")).fault(), "");
    }
    EXPECT_EQ(variable_name("1a").fault(), "`1a` is no identifier");
    EXPECT_EQ(enumerated_value("a", "D").fault(), "`D#a` is no enumerated value"); // a date (2.2.3)
    EXPECT_EQ(enumerated_value("a", "colour").text(), "colour#a");
    for (const std::string_view name : {"a", "_a1", "LD", "TON", "T", "EN", "ENO"})
        EXPECT_EQ(variable_name(name).fault(), "") << name;
    EXPECT_NE(derived_type_name("EN").fault(), "");
    EXPECT_EQ(function_call("AND", {boolean_literal(true)}).fault(), "");
}

// The first fault of a part is the fault of what it stands in.
TEST(BuiltParts, HaveTheFaultsOfTheirParts) {
    const Expression broken = variable_name("1a");
    const std::string fault = broken.fault();
    const Part<ast::StatementList> list = statement_list({assignment_statement(broken, broken)});
    EXPECT_EQ(list.fault(), fault);
    EXPECT_EQ(while_statement(variable_name("a"), list).fault(), fault);
    EXPECT_EQ(unary_expression(UnaryOperator::minus, broken).fault(), fault);
    EXPECT_EQ(variable_declaration({"a"}, elementary_type_name("INT"), broken).fault(), fault);
    EXPECT_EQ(program_declaration("p", {}, list).fault(), fault);
    EXPECT_EQ(input_argument("a", broken).fault(), fault);
    EXPECT_FALSE(fragment(broken).has_value());
    EXPECT_FALSE(library({program_declaration("p", {}, list)}).has_value());
}

TEST(BuiltParts, NeedTheElementsOfTheirLists) {
    const Expression x = variable_name("x");
    const TypeSpecification type = elementary_type_name("INT");
    const std::vector<AnyPart> none = {
        elementary_type_name("ANY"),
        elementary_type_name("MyType"),
        enumerated_specification({}),
        array_specification({}, type),
        structure_declaration({}),
        data_type_declaration({}),
        array_initialization({}),
        structure_initialization({}),
        array_variable(x, {}),
        variable_declaration({}, type),
        edge_declaration({"a"}, ast::Edge::none),
        edge_declaration({}, ast::Edge::rising),
        instance_specific_init({}, {}, type),
        variable_declarations(ast::VariableBlock::var, {}),
        function_call("f", {}),
        case_element({}, statement_list({})),
        case_statement(x, {}),
        unary_expression(UnaryOperator::plus, x),
        steps({}),
        sfc_network({}),
        sequential_function_chart({}),
        action_qualifier(ast::ActionQualifierKind::unknown),
        action_qualifier(ast::ActionQualifierKind::time_limited),
        action_qualifier(ast::ActionQualifierKind::set, x),
        task_initialization("SPEED", x),
        task_configuration("t", {}),
        program_configuration("p", "", "P", {}, ast::BlockQualifier::constant),
        resource_declaration("r", "R", {}),
        configuration_declaration("c", {}),
        il_simple_operation(ast::IlOperator::jump),
        il_simple_operation(ast::IlOperator::none),
        il_simple_operation(ast::IlOperator::add, {x}, ast::IlModifier::negated),
        il_simple_operation(ast::IlOperator::load, {x}, ast::IlModifier::conditional),
        il_expression(ast::IlOperator::load, x, instruction_list({})),
        il_jump_operation("l", ast::IlModifier::negated),
        il_return_operation(ast::IlModifier::negated)};
    for (const AnyPart& part : none)
        EXPECT_NE(part.fault(), "") << part.text();
}

} // namespace
} // namespace iecfront::test
