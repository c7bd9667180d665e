#include "support/count_nodes.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace iecfront {
namespace {

using test::count_nodes;

// 6.2 A28: nothing in a text says in which language a body is written, and one mistake never turns
// a whole body into another language.

constexpr std::size_t lines = 200;

std::vector<std::string> statements() {
    std::vector<std::string> body;
    for (std::size_t i = 0; i < lines; ++i)
        body.push_back("a := b + " + std::to_string(i) + ";");
    return body;
}

std::vector<std::string> instructions() {
    std::vector<std::string> body;
    for (std::size_t i = 0; i < lines; ++i)
        body.emplace_back(i % 2 == 0 ? "LD a" : "ST b");
    return body;
}

struct Frame {
    const char* head;
    const char* tail;
};

constexpr Frame program = {"PROGRAM p\n", "END_PROGRAM\n"};
constexpr Frame action = {"PROGRAM p\nINITIAL_STEP i: k(N); END_STEP\nTRANSITION FROM i TO i := a; "
                          "END_TRANSITION\nACTION k:\n",
                          "END_ACTION\nACTION last: LD a\nEND_ACTION\nEND_PROGRAM\n"};

SyntaxTree parse_body(const std::vector<std::string>& body, const Frame& frame = program) {
    std::string text = frame.head;
    for (const std::string& line : body)
        text += line + '\n';
    return parse(SourceText(text + frame.tail));
}

// With `line` put in at `place`, all others are read as before, and there is one report.
void expect_lines_kept(std::vector<std::string> body, ast::NodeKind kind, const std::string& line,
                       std::size_t place, const Frame& frame = program) {
    const std::size_t before = count_nodes(parse_body(body, frame), kind);
    body.insert(body.begin() + static_cast<std::ptrdiff_t>(place), line);
    const SyntaxTree tree = parse_body(body, frame);
    EXPECT_GE(count_nodes(tree, kind), before) << line << " at " << place;
    EXPECT_EQ(tree.diagnostics().size(), 1U) << line << " at " << place;
}

constexpr std::size_t places[] = {0, 1, 10, lines / 2, lines - 1, lines};

constexpr const char* chart_lines[] = {
    " STEP s:",       " STEP s: END_STEP",
    " STEP cnt = 1;", " INITIAL_STEP s:",
    " ACTION x:",     " INITIAL_STEP s: END_STEP",
    " ACTION a;",     " ACTION x: ; END_ACTION",
    " STEP := 1;",    " TRANSITION FROM a TO b := x; END_TRANSITION",
};

TEST(BodyLanguage, OfStatementsSurvivesALineOfAChart) {
    for (const char* const line : chart_lines)
        for (const std::size_t place : places)
            expect_lines_kept(statements(), ast::NodeKind::assignment_statement, line, place);
}

TEST(BodyLanguage, OfInstructionsSurvivesALineOfAChart) {
    for (const char* const line : chart_lines)
        for (const std::size_t place : places)
            expect_lines_kept(instructions(), ast::NodeKind::il_simple_operation, line, place);
}

TEST(BodyLanguage, OfAnActionSurvivesALineOfAChart) {
    for (const char* const line : chart_lines)
        for (const std::size_t place : places) {
            expect_lines_kept(statements(), ast::NodeKind::assignment_statement, line, place,
                              action);
            expect_lines_kept(instructions(), ast::NodeKind::il_simple_operation, line, place,
                              action);
        }
}

TEST(BodyLanguage, OfAnActionThatIsAChartSurvivesAFaultOfItsFirstWord) {
    for (const char* const head :
         {"", "n:", "x INITIAL_STEP n:", "INITIAL_STEP ; n:", "INITIAL_STEP n",
          "INITIAL_STEP := n:", "INITAL_STEP n:", "' INITIAL_STEP n:"}) {
        const SyntaxTree tree = parse_body({head, "m(N);", "END_STEP", "STEP o: m(N); END_STEP",
                                            "TRANSITION FROM n TO o := a; END_TRANSITION"},
                                           action);
        EXPECT_EQ(count_nodes(tree, ast::NodeKind::sequential_function_chart), 2U) << head;
        EXPECT_EQ(count_nodes(tree, ast::NodeKind::action), 2U) << head;
        EXPECT_EQ(tree.diagnostics().size(), 1U) << head;
    }
}

TEST(BodyLanguage, OfStatementsSurvivesAnInstruction) {
    for (const char* const line : {"LD a", "JMPC x", "CAL f()", "ST b"})
        for (const std::size_t place : places)
            expect_lines_kept(statements(), ast::NodeKind::assignment_statement, line, place);
}

TEST(BodyLanguage, OfInstructionsSurvivesAStatement) {
    for (const char* const line :
         {"a := 1;", "IF b THEN c := 1; END_IF;", "f(a);", "a := 1; b := 2; c := 3;"})
        for (const std::size_t place : places)
            expect_lines_kept(instructions(), ast::NodeKind::il_simple_operation, line, place);
}

TEST(BodyLanguage, OfTwoInstructionsSurvivesAStatementOfMany) {
    expect_lines_kept({"LD a", "ST b"}, ast::NodeKind::il_simple_operation,
                      "IF b THEN c := 1; END_IF;", 1);
}

// Fewer lines than what decides at once.
TEST(BodyLanguage, SurvivesAStretchOfTheOtherOne) {
    constexpr std::ptrdiff_t stretch = 15;
    std::vector<std::string> body = statements();
    const std::vector<std::string> other = instructions();
    body.insert(body.begin(), other.begin(), other.begin() + stretch);
    EXPECT_GE(count_nodes(parse_body(body), ast::NodeKind::assignment_statement), lines);

    body = other;
    const std::vector<std::string> first = statements();
    body.insert(body.begin(), first.begin(), first.begin() + stretch);
    EXPECT_GE(count_nodes(parse_body(body), ast::NodeKind::il_simple_operation), lines);
}

TEST(BodyLanguage, OfStatementsSurvivesAMissingSemicolon) {
    for (const std::size_t place : {std::size_t{0}, lines / 2, lines - 1}) {
        std::vector<std::string> body = statements();
        body[place].pop_back();
        const SyntaxTree tree = parse_body(body);
        EXPECT_EQ(count_nodes(tree, ast::NodeKind::assignment_statement), lines);
        EXPECT_EQ(tree.diagnostics().size(), 1U);
    }
}

// What stands in parentheses over several lines is no statement of its own, and a `;` ends it; a
// `)` without its `(` is no end of anything.
TEST(BodyLanguage, OfStatementsOverSeveralLines) {
    const std::vector<std::string> three = {"LD a", "ST b", "ST c"};
    const auto is_instruction_list = [&three](std::vector<std::string> body) {
        body.insert(body.end(), three.begin(), three.end());
        const SyntaxTree tree = parse_body(body);
        return count_nodes(tree, ast::NodeKind::instruction_list) == 1;
    };
    EXPECT_TRUE(is_instruction_list({"x := f(a := 1,", "b := 2,", "c := 3);"}));
    EXPECT_FALSE(is_instruction_list({"x := f(a := 1;", "b := 2", "c := 3", "d := 4"}));
    EXPECT_FALSE(is_instruction_list({"x := a)", "b := 2", "c := 3", "d := 4"}));
    EXPECT_FALSE(is_instruction_list({"x := f(a)", "b := 2", "c := 3", "d := 4"}));
}

// Until its `;` makes a statement of it, a line reads as an instruction.
TEST(BodyLanguage, OfLinesThatASemicolonMakesStatements) {
    const SyntaxTree tree = parse_body(
        {"foo a EXIT;", "foo a EXIT;", "foo a EXIT;", "foo a EXIT;", "LD a", "ST b", "ST c"});
    EXPECT_EQ(count_nodes(tree, ast::NodeKind::instruction_list), 0U);
}

// What the lexer has reported, the parser does not report again; the lines are asked nevertheless.
TEST(BodyLanguage, OfInstructionsWithMalformedOperandsSurvivesAStatement) {
    const SyntaxTree tree = parse_body({"x := 1;", "LD 5A", "ADD 5A"});
    EXPECT_EQ(count_nodes(tree, ast::NodeKind::instruction_list), 1U);
}

// A character that has no meaning begins no line: what stands behind it says nothing.
TEST(BodyLanguage, OfAChartSurvivesLinesThatCannotBeRead) {
    const SyntaxTree tree = parse_body(
        {"x := 1;", "$ := 2;", "$ := 2;", "TRANSITION FROM S TO T := TRUE; END_TRANSITION"});
    EXPECT_EQ(count_nodes(tree, ast::NodeKind::sequential_function_chart), 1U);
}

// That a text nests too deeply is reported once a unit: what it hides in the second action is
// asked.
TEST(BodyLanguage, OfInstructionsIsSeenInWhatIsTooDeep) {
    const std::string statement = "IF a THEN x := 1; END_IF;";
    const std::string instructions = "IF a THEN\nLD x\nST y\nLD x\nST y\nEND_IF;";
    const std::string text = std::string("PROGRAM p\nINITIAL_STEP s: END_STEP\n") + "ACTION k:\n" +
                             statement + "\nEND_ACTION\n" + "ACTION l:\n" + instructions +
                             "\nEND_ACTION\nEND_PROGRAM\n";
    ParseOptions options;
    options.maximum_nesting = 1;
    const SyntaxTree tree = parse(SourceText(text), options);
    EXPECT_EQ(count_nodes(tree, ast::NodeKind::instruction_list), 1U);
}

// A stray closing word seems to end the action behind a statement without a fault.
TEST(BodyLanguage, OfInstructionsWithoutEndOfActionSurvivesAStatement) {
    const SyntaxTree tree =
        parse_body({"INITIAL_STEP s: END_STEP", "ACTION k:", "IF a THEN b := 1; END_IF;", "END_IF",
                    "LD a", "ST b"});
    EXPECT_EQ(count_nodes(tree, ast::NodeKind::instruction_list), 1U);
}

// The action is as long as a body, and all of it stands outside of elements then.
TEST(BodyLanguage, OfAChartSurvivesAMissingClosingWord) {
    const std::pair<const char*, const char*> closing_words[] = {
        {" END_STEP", "END_ACTION"}, {"", "END_ACTION"}, {" END_STEP", ""}};
    for (const auto& [end_step, end_action] : closing_words) {
        std::vector<std::string> body = statements();
        body.insert(body.begin(), {"INITIAL_STEP s: x(N);" + std::string(end_step), "ACTION x:"});
        body.emplace_back(end_action);
        const SyntaxTree tree = parse_body(body);
        EXPECT_EQ(count_nodes(tree, ast::NodeKind::action), 1U) << end_step << end_action;
        EXPECT_EQ(count_nodes(tree, ast::NodeKind::assignment_statement), lines);
    }
}

} // namespace
} // namespace iecfront
