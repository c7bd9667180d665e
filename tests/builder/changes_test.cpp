#include "support/repository_files.hpp"

#include <iecfront/ast/visitor.hpp>
#include <iecfront/builder/builder.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <vector>

// Changes to trees: what stands where afterwards, and what stays shared.

namespace iecfront::test {
namespace {

using namespace build;

constexpr std::string_view program = "PROGRAM Main\n"
                                     "    VAR\n"
                                     "        a : INT; // first\n"
                                     "        (* the second *)\n"
                                     "        b : INT;\n"
                                     "    END_VAR\n"
                                     "    a := b * 2; (* so *)\n"
                                     "    IF a > b THEN\n"
                                     "        f(x := a, y := b);\n"
                                     "    END_IF;\n"
                                     "END_PROGRAM\n";

[[nodiscard]] SyntaxTree tree_of(std::string_view text, Encoding encoding = Encoding::utf8) {
    return parse(SourceText(std::string(text), {}, encoding));
}

// The first node that is a `T`, beginning at a line and column.
template<class T>
[[nodiscard]] const T& node_at(const SyntaxTree& tree, Position position) {
    const T* found = tree.node_at(tree.offset(position)).find<T>();
    EXPECT_NE(found, nullptr);
    return *found;
}

// `program` with one stretch of it replaced.
[[nodiscard]] std::string program_with(std::string_view old, std::string_view replacement) {
    std::string text(program);
    return text.replace(text.find(old), old.size(), replacement);
}

void expect_text(const Changes& changes, std::string_view text) {
    EXPECT_EQ(changes.fault(), "");
    const std::optional<SyntaxTree> tree = changes.tree();
    ASSERT_TRUE(tree.has_value());
    EXPECT_EQ(tree->source().bytes(), text);
    EXPECT_EQ(*tree, parse(tree->source())) << "edited is fresh";
}

/// The program, its tree, and changes to it.
class ChangesToAProgram : public testing::Test {
protected:
    template<class T>
    [[nodiscard]] const T& at(std::uint32_t line, std::uint32_t column) const {
        return node_at<T>(tree_, {line, column});
    }

    const SyntaxTree tree_ = tree_of(program);
    const SyntaxTree::Slot& slot_ = tree_.slots()[0];
    Changes changes_{tree_};
    const Expression a_ = variable_name("a");
    const Statement call_ = fb_invocation("g", {});
};

TEST_F(ChangesToAProgram, ReplaceAnOperand) {
    changes_.replace(slot_, at<ast::VariableName>(7, 10),
                     binary_expression(ast::BinaryOperator::add, a_, integer_literal(1)));
    expect_text(changes_, program_with("b * 2", "(a + 1) * 2"));
}

TEST_F(ChangesToAProgram, ReplaceStatementsTypesAndNames) {
    changes_.replace(slot_, at<ast::AssignmentStatement>(7, 5),
                     if_statement(a_, statement_list({call_})));
    changes_.replace(slot_, at<ast::ElementaryTypeName>(5, 13), derived_type_name("Speed"));
    changes_.replace(slot_, at<ast::InputArgument>(9, 19), output_argument("z", a_));
    std::string text = program_with("a := b * 2;", "IF a THEN\n        g();\n    END_IF;");
    text.replace(text.find("b : INT"), 7, "b : Speed");
    text.replace(text.find("y := b"), 6, "z => a");
    expect_text(changes_, text);
}

TEST_F(ChangesToAProgram, InsertBeforeWithTheCommentsAbove) {
    changes_.insert_before(slot_, at<ast::VariableDeclaration>(5, 9),
                           variable_declaration({"c"}, elementary_type_name("BOOL")));
    expect_text(changes_, program_with("        (* the", "        c : BOOL;\n        (* the"));
}

TEST_F(ChangesToAProgram, InsertAfterWithTheCommentsBehind) {
    changes_.insert_after(slot_, at<ast::AssignmentStatement>(7, 5), call_);
    changes_.insert_after(slot_, at<ast::AssignmentStatement>(7, 5), exit_statement());
    changes_.insert_after(slot_, at<ast::VariableDeclaration>(3, 9),
                          variable_declaration({"c"}, elementary_type_name("BOOL")));
    std::string text = program_with("(* so *)\n", "(* so *)\n    g();\n    EXIT;\n");
    text.replace(text.find("// first\n"), 9, "// first\n        c : BOOL;\n");
    expect_text(changes_, text);
}

TEST_F(ChangesToAProgram, InsertArguments) {
    const auto& x = at<ast::InputArgument>(9, 11);
    changes_.insert_before(slot_, x, input_argument("u", a_));
    changes_.insert_after(slot_, x, input_argument("v", a_));
    expect_text(changes_, program_with("x := a,", "u := a, x := a, v := a,"));
}

TEST_F(ChangesToAProgram, Append) {
    changes_.append(slot_, *at<ast::IfStatement>(8, 5).then_list, call_);
    changes_.append(slot_, at<ast::VariableDeclarations>(2, 5),
                    variable_declaration({"c"}, elementary_type_name("BOOL")));
    changes_.append(slot_, at<ast::ProgramDeclaration>(1, 1),
                    variable_declarations(ast::VariableBlock::var_temp,
                                          {variable_declaration({"t"}, derived_type_name("T1"))}));
    std::string text = program_with("y := b);\n", "y := b);\n        g();\n");
    text.replace(text.find("END_VAR\n"), 8,
                 "END_VAR\n    VAR_TEMP\n        t : T1;\n    END_VAR\n");
    text.replace(text.find("b : INT;\n"), 9, "b : INT;\n        c : BOOL;\n");
    expect_text(changes_, text);
}

TEST_F(ChangesToAProgram, Remove) {
    changes_.remove(slot_, at<ast::VariableDeclaration>(5, 9));
    changes_.remove(slot_, at<ast::InputArgument>(9, 11));
    std::string text = program_with("        b : INT;\n", "");
    text.replace(text.find("x := a, "), 8, "");
    expect_text(changes_, text);
}

TEST_F(ChangesToAProgram, RemoveTheLastOfAList) {
    changes_.remove(slot_, at<ast::InputArgument>(9, 19));
    expect_text(changes_, program_with(", y := b", ""));
}

TEST_F(ChangesToAProgram, RemoveTheOnlyStatement) {
    changes_.remove(slot_, at<ast::FbInvocation>(9, 9));
    expect_text(changes_, program_with("f(x := a, y := b);", ";"));
}

TEST_F(ChangesToAProgram, KeepTheirPlaces) {
    const auto& statement = at<ast::AssignmentStatement>(7, 5);
    changes_.replace(slot_, statement, call_);
    changes_.insert_before(slot_, statement, exit_statement());
    expect_text(changes_, program_with("a := b * 2", "EXIT;\n    g()"));
}

TEST_F(ChangesToAProgram, AreRefusedWithAFault) {
    changes_.replace(slot_, at<ast::AssignmentStatement>(7, 5), fb_invocation("IF", {}));
    EXPECT_EQ(changes_.fault(), "`IF` is no identifier");
    EXPECT_FALSE(changes_.tree().has_value());
}

TEST_F(ChangesToAProgram, AreRefusedWhenTheyOverlap) {
    changes_.replace(slot_, at<ast::AssignmentStatement>(7, 5), call_);
    EXPECT_EQ(changes_.fault(), "");
    changes_.remove(slot_, at<ast::AssignmentStatement>(7, 5));
    EXPECT_EQ(changes_.fault(), "two changes are of the same place");
    EXPECT_FALSE(changes_.tree().has_value());
}

TEST_F(ChangesToAProgram, AreEditsAsWell) {
    changes_.remove(slot_, at<ast::FbInvocation>(9, 9));
    changes_.replace(slot_, at<ast::VariableName>(7, 10), a_);
    EXPECT_EQ(apply_edits(program, changes_.edits()), changes_.tree()->source().bytes());
}

// An empty list, a list of an empty statement, a program without blocks.
TEST(Changes, FillWhatIsEmpty) {
    const SyntaxTree tree = tree_of("PROGRAM p\n    IF a THEN ; END_IF;\nEND_PROGRAM\n");
    const SyntaxTree::Slot& slot = tree.slots()[0];
    Changes changes(tree);
    changes.append(slot, *node_at<ast::IfStatement>(tree, {2, 5}).then_list, exit_statement());
    changes.append(
        slot, node_at<ast::ProgramDeclaration>(tree, {1, 1}),
        variable_declarations(ast::VariableBlock::var,
                              {variable_declaration({"a"}, elementary_type_name("BOOL"))}));
    expect_text(changes, "PROGRAM p\n    VAR\n        a : BOOL;\n    END_VAR\n"
                         "    IF a THEN EXIT; END_IF;\nEND_PROGRAM\n");
}

// B.1.4.3, B.3.2: the same where something is missing.
TEST(Changes, FillWhatIsMissing) {
    const SyntaxTree tree = tree_of("FUNCTION f : INT\n    VAR_INPUT\n    END_VAR\n"
                                    "    IF a THEN\n    END_IF;\nEND_FUNCTION\n"
                                    "FUNCTION g : INT\n    g := 1;\nEND_FUNCTION\n"
                                    "FUNCTION_BLOCK h\n    ;\nEND_FUNCTION_BLOCK\n");
    const Declaration a = variable_declaration({"a"}, elementary_type_name("BOOL"));
    const auto block = variable_declarations(ast::VariableBlock::var_input, {a});
    Changes changes(tree);
    changes.append(tree.slots()[0], node_at<ast::VariableDeclarations>(tree, {2, 5}), a);
    changes.append(tree.slots()[0], *node_at<ast::IfStatement>(tree, {4, 5}).then_list,
                   return_statement());
    changes.append(tree.slots()[1], node_at<ast::FunctionDeclaration>(tree, {7, 1}), block);
    changes.append(tree.slots()[2], node_at<ast::FunctionBlockDeclaration>(tree, {10, 1}), block);
    expect_text(changes, "FUNCTION f : INT\n    VAR_INPUT\n        a : BOOL;\n    END_VAR\n"
                         "    IF a THEN\n        RETURN;\n    END_IF;\nEND_FUNCTION\n"
                         "FUNCTION g : INT\n    VAR_INPUT\n        a : BOOL;\n    END_VAR\n"
                         "    g := 1;\nEND_FUNCTION\n"
                         "FUNCTION_BLOCK h\n    VAR_INPUT\n        a : BOOL;\n    END_VAR\n"
                         "    ;\nEND_FUNCTION_BLOCK\n");
}

TEST(Changes, TakeTheBlockOfTheOnlyDeclaration) {
    const SyntaxTree tree =
        tree_of("FUNCTION f : INT\n    VAR_INPUT\n        a : INT;\n    END_VAR\n    f := 1;\n"
                "END_FUNCTION\n");
    Changes changes(tree);
    changes.remove(tree.slots()[0], node_at<ast::VariableDeclaration>(tree, {3, 9}));
    expect_text(changes, "FUNCTION f : INT\n    f := 1;\nEND_FUNCTION\n");
}

TEST(Changes, KeepLineEndsAndEncoding) {
    const SyntaxTree tree =
        tree_of("PROGRAM p\r\n    a := 1;\r\nEND_PROGRAM\r\n", Encoding::windows_1252);
    const auto& statement = node_at<ast::AssignmentStatement>(tree, {2, 5});
    Changes changes(tree);
    changes.insert_after(tree.slots()[0], statement,
                         commented(exit_statement(), "10 \xE2\x82\xAC"));
    expect_text(changes, "PROGRAM p\r\n    a := 1;\r\n    (* 10 \x80 *)\r\n    EXIT;\r\n"
                         "END_PROGRAM\r\n");
    changes.insert_before(tree.slots()[0], statement,
                          commented(exit_statement(), "\xE2\x82\xAC \xCE\xA9"));
    EXPECT_EQ(changes.fault(), "a character is not in the encoding of the tree");
}

// What a bracket or a sign kept apart stays apart.
TEST(Changes, RunNothingTogether) {
    const SyntaxTree tree = tree_of("PROGRAM p\n    IF NOT(a)OR b THEN; END_IF;\n"
                                    "    a := b -c;\nEND_PROGRAM\n");
    Changes changes(tree);
    const SyntaxTree::Slot& slot = tree.slots()[0];
    changes.replace(slot, node_at<ast::ParenthesizedExpression>(tree, {2, 11}), variable_name("a"));
    changes.replace(slot, node_at<ast::VariableName>(tree, {3, 13}), integer_literal(-5));
    changes.append(slot, *node_at<ast::IfStatement>(tree, {2, 5}).then_list, exit_statement());
    expect_text(changes, "PROGRAM p\n    IF NOT a OR b THEN EXIT; END_IF;\n"
                         "    a := b - -5;\nEND_PROGRAM\n");
}

// Library elements stand apart, and units that nothing touches are those of the old tree.
TEST(Changes, ShareUnits) {
    const SyntaxTree tree =
        tree_of("PROGRAM a\n    ;;;;;;;;\nEND_PROGRAM\n\nPROGRAM b\n    ;;;;;;;;\n"
                "END_PROGRAM\n\nPROGRAM c\n    ;\nEND_PROGRAM\n");
    Changes changes(tree);
    changes.insert_before(tree.slots()[2], node_at<ast::ProgramDeclaration>(tree, {9, 1}),
                          program_declaration("d", {}, statement_list({})));
    expect_text(changes,
                "PROGRAM a\n    ;;;;;;;;\nEND_PROGRAM\n\nPROGRAM b\n    ;;;;;;;;\nEND_PROGRAM\n\n"
                "PROGRAM d\n    ;\nEND_PROGRAM\n\nPROGRAM c\n    ;\nEND_PROGRAM\n");
    EXPECT_EQ(changes.tree()->slots()[0].unit, tree.slots()[0].unit);
    EXPECT_EQ(changes.tree()->slots().size(), 4U);
}

// A copy in the place of what it is a copy of changes nothing but layout.
TEST(Changes, PutCopiesInTheirPlaces) {
    for (const RepositoryFile& file : example_programs()) {
        const SyntaxTree tree = parse(SourceText(file.text));
        for (const SyntaxTree::Slot& slot : tree.slots())
            ast::walk(slot.unit->root(), [&](const ast::Node& node) {
                Changes changes(tree);
                if (const auto* expression = ast::as<ast::Expression>(&node))
                    changes.replace(slot, *expression, copy(*slot.unit, *expression));
                else if (const auto* statement = ast::as<ast::Statement>(&node))
                    changes.replace(slot, *statement, copy(*slot.unit, *statement));
                else
                    return ast::Walk::into;
                const bool whole = changes.fault().empty();
                EXPECT_TRUE(!whole || apply_edits(file.text, changes.edits()) == file.text)
                    << file.path << ": " << slot.unit->text(node);
                return ast::Walk::into;
            });
    }
}

// ---- several changes in one list ---------------------------------------------------------------

// A piece of a program, and its tree.
struct Piece {
    SyntaxTree tree;

    explicit Piece(std::string_view text) : tree(tree_of(text)) {}

    [[nodiscard]] const SyntaxTree::Slot& slot() const { return tree.slots()[0]; }
    template<class T>
    [[nodiscard]] std::vector<const T*> all() const {
        std::vector<const T*> found;
        ast::walk(slot().unit->root(), [&](const ast::Node& node) {
            if (const T* one = ast::as<T>(&node))
                found.push_back(one);
            return ast::Walk::into;
        });
        return found;
    }
    // The text without those of its `T`s whose numbers are given.
    template<class T>
    [[nodiscard]] std::string without(const std::vector<std::size_t>& numbers) const {
        Changes changes(tree);
        for (const std::size_t number : numbers)
            changes.remove(slot(), *all<T>().at(number));
        EXPECT_EQ(changes.fault(), "");
        return apply_edits(tree.source().bytes(), changes.edits());
    }
};

TEST(Changes, RemoveSeveralStatements) {
    const Piece piece("PROGRAM p\n    IF a THEN\n        b := 1; c := 2;\n        d := 3;\n"
                      "    END_IF;\nEND_PROGRAM\n");
    using Assignment = ast::AssignmentStatement;
    EXPECT_EQ(piece.without<Assignment>({0, 1}),
              "PROGRAM p\n    IF a THEN\n        d := 3;\n    END_IF;\nEND_PROGRAM\n");
    EXPECT_EQ(piece.without<Assignment>({2, 0, 1}),
              "PROGRAM p\n    IF a THEN\n        ;\n    END_IF;\nEND_PROGRAM\n");
}

TEST(Changes, RemoveSeveralOfAListWithCommas) {
    const Piece piece("PROGRAM p\n    f(a := 1, b := 2, c := 3);\nEND_PROGRAM\n");
    const auto call = [](std::string_view arguments) {
        return "PROGRAM p\n    f(" + std::string(arguments) + ");\nEND_PROGRAM\n";
    };
    using Argument = ast::InputArgument;
    EXPECT_EQ(piece.without<Argument>({0, 1}), call("c := 3"));
    EXPECT_EQ(piece.without<Argument>({1, 2}), call("a := 1"));
    EXPECT_EQ(piece.without<Argument>({2, 0}), call("b := 2"));
    EXPECT_EQ(piece.without<Argument>({0, 1, 2}), call(""));
    EXPECT_EQ(piece.without<Argument>({1, 1}), call("a := 1, c := 3")) << "once is enough";
    const Piece step("PROGRAM p\n    INITIAL_STEP s:\n        a(N, x, y);\n    END_STEP\n"
                     "END_PROGRAM\n");
    EXPECT_EQ(step.without<ast::VariableName>({0, 1}),
              "PROGRAM p\n    INITIAL_STEP s:\n        a(N);\n    END_STEP\nEND_PROGRAM\n");
}

TEST(Changes, RemoveSeveralDeclarations) {
    const Piece piece("FUNCTION f : INT\n    VAR\n        a : INT;\n        b : INT;\n"
                      "    END_VAR\n    f := 1;\nEND_FUNCTION\n");
    EXPECT_EQ(piece.without<ast::VariableDeclaration>({0, 1}),
              "FUNCTION f : INT\n    f := 1;\nEND_FUNCTION\n");
    const Piece type("TYPE\n    A : INT;\n    B : INT;\nEND_TYPE\n");
    EXPECT_EQ(type.without<ast::TypeDeclaration>({0, 1}), "");
}

TEST(Changes, RemoveNamesOfADeclaration) {
    const Piece piece("FUNCTION f : INT VAR a, b, c : INT; END_VAR f := 1; END_FUNCTION\n");
    EXPECT_EQ(piece.without<ast::Identifier>({1}),
              "FUNCTION f : INT VAR b, c : INT; END_VAR f := 1; END_FUNCTION\n");
    EXPECT_EQ(piece.without<ast::Identifier>({2, 3}),
              "FUNCTION f : INT VAR a : INT; END_VAR f := 1; END_FUNCTION\n");
}

// What is put in beside an element that is taken out comes into its place.
TEST(Changes, PutOthersInThePlaceOfAnElement) {
    const Piece piece("PROGRAM p\n    a := 1;\n    f(a := 1, b := 2);\nEND_PROGRAM\n");
    const auto& statement = *piece.all<ast::AssignmentStatement>().at(0);
    Changes changes(piece.tree);
    changes.insert_before(piece.slot(), statement, return_statement());
    changes.remove(piece.slot(), statement);
    changes.insert_after(piece.slot(), statement, exit_statement());
    for (const ast::InputArgument* argument : piece.all<ast::InputArgument>()) {
        changes.remove(piece.slot(), *argument);
        changes.insert_after(piece.slot(), *argument, input_argument("c", variable_name("x")));
        changes.insert_after(piece.slot(), *argument, input_argument("d", variable_name("y")));
    }
    expect_text(changes, "PROGRAM p\n    RETURN;\n    EXIT;\n"
                         "    f(c := x, d := y, c := x, d := y);\nEND_PROGRAM\n");
}

TEST(Changes, RemoveAllAndAppend) {
    const Piece piece("PROGRAM p\n    VAR\n        a : INT;\n        b : INT;\n    END_VAR\n"
                      "    a := 1; (* so *)\n    b := 2;\nEND_PROGRAM\n");
    Changes changes(piece.tree);
    for (const auto* statement : piece.all<ast::AssignmentStatement>())
        changes.remove(piece.slot(), *statement);
    for (const auto* declaration : piece.all<ast::VariableDeclaration>())
        changes.remove(piece.slot(), *declaration);
    changes.append(piece.slot(), *piece.all<ast::StatementList>().at(0), exit_statement());
    changes.append(piece.slot(), *piece.all<ast::VariableDeclarations>().at(0),
                   variable_declaration({"c"}, elementary_type_name("INT")));
    expect_text(changes, "PROGRAM p\n    VAR\n        c : INT;\n    END_VAR\n"
                         "    (* so *)\n    EXIT;\nEND_PROGRAM\n");
}

TEST(Changes, AppendSeveralToAnEmptyList) {
    const Piece piece("PROGRAM p\n    WHILE a DO\n        ;\n    END_WHILE;\nEND_PROGRAM\n");
    Changes changes(piece.tree);
    const auto& list = *piece.all<ast::WhileStatement>().at(0)->statements;
    changes.append(piece.slot(), list, fb_invocation("f", {}));
    changes.append(piece.slot(), list, exit_statement());
    expect_text(changes, "PROGRAM p\n    WHILE a DO\n        f();\n        EXIT;\n"
                         "    END_WHILE;\nEND_PROGRAM\n");
}

TEST(Changes, KeepCommentsBehindTheirElements) {
    const Piece piece("TYPE\n    E : (\n        one, (* first *)\n        two (* second *)\n"
                      "    );\nEND_TYPE\n");
    Changes changes(piece.tree);
    for (const auto* value : piece.all<ast::EnumeratedValueDeclaration>()) {
        changes.insert_after(piece.slot(), *value, enumerated_value_declaration("x"));
        changes.insert_after(piece.slot(), *value, enumerated_value_declaration("y"));
    }
    expect_text(changes, "TYPE\n    E : (\n        one, (* first *)\n        x,\n        y,\n"
                         "        two, (* second *)\n        x,\n        y\n    );\nEND_TYPE\n");
    for (const auto* value : piece.all<ast::EnumeratedValueDeclaration>())
        changes.remove(piece.slot(), *value);
    expect_text(changes, "TYPE\n    E : (\n        (* first *)\n        x,\n        y,\n"
                         "        (* second *)\n        x,\n        y\n    );\nEND_TYPE\n");
}

// Beside an operand or an initial value nothing can stand, and it cannot be left out.
TEST(Changes, AreRefusedOutsideOfLists) {
    const Piece piece("PROGRAM p\n    VAR a : INT := 1; END_VAR\n    a := a + 1;\n"
                      "END_PROGRAM\n");
    const auto& operand = *piece.all<ast::BinaryExpression>().at(0)->left;
    Changes beside(piece.tree);
    beside.insert_after(piece.slot(), operand, variable_name("b"));
    EXPECT_EQ(beside.fault(), "this `variable_name` is no element of a list");
    Changes without(piece.tree);
    without.remove(piece.slot(), *piece.all<ast::IntegerLiteral>().at(0));
    EXPECT_EQ(without.fault(), "this `integer_literal` is no element of a list");
    EXPECT_FALSE(without.tree().has_value());
    Changes without_all(piece.tree);
    without_all.remove(piece.slot(), piece.slot().unit->root());
    EXPECT_EQ(without_all.fault(), "this `library_unit` is no element of a list");
    EXPECT_TRUE(without_all.edits().empty());
}

TEST(Changes, PutNoOperationInThePlaceOfAVariable) {
    const Piece piece("PROGRAM p\n    a.x := b[i];\nEND_PROGRAM\n");
    const Expression sum =
        binary_expression(ast::BinaryOperator::add, variable_name("a"), variable_name("b"));
    const std::vector<const ast::VariableName*> names = piece.all<ast::VariableName>();
    for (const std::size_t variable : {0U, 1U}) {
        Changes changes(piece.tree);
        changes.replace(piece.slot(), *names.at(variable), sum);
        EXPECT_EQ(changes.fault(), "`a + b` is no variable");
    }
    Changes subscript(piece.tree);
    subscript.replace(piece.slot(), *names.at(2), sum);
    expect_text(subscript, "PROGRAM p\n    a.x := b[a + b];\nEND_PROGRAM\n");
}

TEST(Changes, AreRefusedForAnotherTree) {
    const Piece piece("PROGRAM p\n    a := 1;\nEND_PROGRAM\n");
    const Piece other("PROGRAM p\n    a := 1; a := 2; a := 3;\nEND_PROGRAM\n");
    Changes changes(piece.tree);
    changes.replace(other.slot(), *other.all<ast::IntegerLiteral>().at(2), integer_literal(4));
    changes.remove(other.slot(), *other.all<ast::AssignmentStatement>().at(0));
    EXPECT_EQ(changes.fault(), "a slot is of another tree");
    EXPECT_FALSE(changes.tree().has_value());
}

TEST(Changes, GiveNewNames) {
    const Piece piece(
        "PROGRAM p\n    VAR\n        a, b : INT;\n    END_VAR\n    a := 1;\nEND_PROGRAM\n");
    Changes changes(piece.tree);
    changes.replace(piece.slot(), *piece.all<ast::Identifier>().at(0), identifier("Main"));
    changes.insert_after(piece.slot(), *piece.all<ast::Identifier>().at(1), identifier("c"));
    expect_text(changes, "PROGRAM Main\n    VAR\n        a, c, b : INT;\n    END_VAR\n    a := 1;\n"
                         "END_PROGRAM\n");
    EXPECT_EQ(identifier("IF").fault(), "`IF` is no identifier");
}

// Edits of one unit are made in one go; the time does not grow with their square.
TEST(Changes, ChangeManyPlaces) {
    std::string text;
    for (int i = 0; i < 9; ++i)
        text += "PROGRAM p\n    a := b;\n    a := b;\n    a := b;\nEND_PROGRAM\n\n";
    const SyntaxTree tree = tree_of(text);
    Changes changes(tree);
    for (std::size_t i : {0U, 1U, 5U})
        ast::walk(tree.slots()[i].unit->root(), [&](const ast::Node& node) {
            if (const auto* name = ast::as<ast::VariableName>(&node))
                changes.replace(tree.slots()[i], *name, variable_name("count"));
            return ast::Walk::into;
        });
    expect_text(changes, apply_edits(text, changes.edits()));
    EXPECT_EQ(changes.tree()->slots()[3].unit, tree.slots()[3].unit);
    EXPECT_EQ(changes.tree()->slots()[8].unit, tree.slots()[8].unit);
}

} // namespace
} // namespace iecfront::test
