#include <iecfront/builder/builder.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>

// From trees to parts and back.

namespace iecfront::test {
namespace {

using namespace build;

[[nodiscard]] SyntaxTree expression_tree(std::string text, Encoding encoding = Encoding::utf8) {
    ParseOptions options;
    options.read_as = FragmentKind::expression;
    return parse(SourceText(std::move(text), {}, encoding), options);
}

[[nodiscard]] Expression copied(const SyntaxTree& tree) {
    const Unit& unit = *tree.slots()[0].unit;
    return copy(unit, *ast::as<ast::Expression>(unit.root().elements[0]));
}

TEST(BuiltLibrary, IsInTheAgreedLayout) {
    const auto speed =
        variable_declaration({"speed", "target"}, elementary_type_name("REAL"), real_literal(0.5));
    const auto lamp = located_variable_declaration(
        "lamp", location(direct_variable({.location = 'Q', .size = 'X', .hierarchy = {1, 0}})),
        elementary_type_name("BOOL"));
    const std::optional<SyntaxTree> tree = library(
        {data_type_declaration({type_declaration(
             "Mode", enumerated_specification({enumerated_value_declaration("Idle"),
                                               enumerated_value_declaration("Run")}))}),
         commented(program_declaration(
                       "Main",
                       {variable_declarations(ast::VariableBlock::var, {speed},
                                              ast::BlockQualifier::retain),
                        variable_declarations(ast::VariableBlock::var, {lamp})},
                       statement_list({commented(
                           assignment_statement(variable_name("speed"), variable_name("target")),
                           "all (* that *) there is")})),
                   "the program")},
        "main.st");
    ASSERT_TRUE(tree.has_value());
    EXPECT_EQ(tree->name(), "main.st");
    EXPECT_TRUE(tree->diagnostics().empty());
    EXPECT_EQ(tree->source().bytes(), "TYPE\n"
                                      "    Mode : (Idle, Run);\n"
                                      "END_TYPE\n"
                                      "\n"
                                      "(* the program *)\n"
                                      "PROGRAM Main\n"
                                      "    VAR RETAIN\n"
                                      "        speed, target : REAL := 0.5;\n"
                                      "    END_VAR\n"
                                      "    VAR\n"
                                      "        lamp AT %QX1.0 : BOOL;\n"
                                      "    END_VAR\n"
                                      "    (* all ( * that * ) there is *)\n"
                                      "    speed := target;\n"
                                      "END_PROGRAM\n");
}

TEST(BuiltFragments, AreRead) {
    const auto is_read = [](const std::optional<SyntaxTree>& tree, ast::NodeKind kind) {
        return tree && tree->diagnostics().empty() &&
               tree->slots()[0].unit->root().elements[0]->kind == kind;
    };
    EXPECT_TRUE(is_read(fragment(variable_name("x")), ast::NodeKind::variable_name));
    EXPECT_TRUE(
        is_read(fragment(statement_list({exit_statement()})), ast::NodeKind::statement_list));
    EXPECT_TRUE(is_read(fragment(instruction_list({il_instruction(
                            il_simple_operation(ast::IlOperator::load, {variable_name("x")}))})),
                        ast::NodeKind::instruction_list));
    EXPECT_TRUE(is_read(fragment({variable_declarations(
                            ast::VariableBlock::var_input,
                            {variable_declaration({"x"}, elementary_type_name("INT"))})}),
                        ast::NodeKind::variable_declarations));
}

TEST(BuiltComments, AreUtf8) {
    EXPECT_EQ(commented(exit_statement(), "\xC3\xA4").fault(), "");
    EXPECT_EQ(commented(exit_statement(), "\xE4").fault(), "a comment is not UTF-8");
}

TEST(Copies, HaveTheStrengthOfTheirOperator) {
    const Expression product = copied(expression_tree("a*b"));
    const Expression sum = copied(expression_tree("a + (* c *) b"));
    const auto op = ast::BinaryOperator::multiply;
    EXPECT_EQ(binary_expression(op, product, sum).text(), "a*b * (a + (* c *) b)");
    EXPECT_EQ(unary_expression(ast::UnaryOperator::logical_not, sum).text(), "NOT (a + (* c *) b)");
    EXPECT_EQ(unary_expression(ast::UnaryOperator::minus, copied(expression_tree("f(x)"))).text(),
              "-f(x)");
}

TEST(Copies, AreInUtf8AndMovedOut) {
    EXPECT_EQ(copied(expression_tree("f('\xC4')", Encoding::iso_8859_1)).text(), "f('\xC3\x84')");
    const SyntaxTree tree = parse(SourceText("PROGRAM p\r\n    IF a THEN\r\n        b := 1;\r\n"
                                             "    END_IF;\r\nEND_PROGRAM\r\n"));
    const Unit& unit = *tree.slots()[0].unit;
    const auto* statement = tree.node_at(tree.offset({2, 5})).find<ast::Statement>();
    EXPECT_EQ(copy(unit, *statement).text(), "IF a THEN\n    b := 1;\nEND_IF");
}

TEST(Copies, OfWhatIsBrokenHaveAFault) {
    EXPECT_NE(copied(expression_tree("a +")).fault(), "");
    EXPECT_NE(copied(expression_tree("f(a, )")).fault(), "");
    EXPECT_EQ(copied(expression_tree("f(a, b)")).fault(), "");
}

} // namespace
} // namespace iecfront::test
