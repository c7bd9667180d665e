#include <iecfront/ast/token_classes.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <map>
#include <string>

using namespace iecfront;

namespace {

// The class of each token by its text; the last of several with the same text.
std::map<std::string, std::string> classes(const std::string& text) {
    const SyntaxTree tree = parse(SourceText(text));
    std::map<std::string, std::string> result;
    for (const SyntaxTree::Slot& slot : tree.slots())
        for (const ClassifiedToken& token : token_classes(*slot.unit))
            result[std::string(slot.unit->text(token.range))] = to_string(token.token_class);
    return result;
}

TEST(TokenClasses, ClassTokensByTheirKind) {
    auto found = classes("PROGRAM p x := NOT y AND (%IX1 <> 5); s := 'a'; t := T#5s; b := TRUE;"
                         "{pragma} (* comment *) END_PROGRAM");
    EXPECT_EQ(found["PROGRAM"], "keyword");
    EXPECT_EQ(found["x"], "variable");
    EXPECT_EQ(found[":="], "operator_sign");
    EXPECT_EQ(found["NOT"], "operator_sign");
    EXPECT_EQ(found["("], "delimiter");
    EXPECT_EQ(found["%IX1"], "direct_variable");
    EXPECT_EQ(found["5"], "number");
    EXPECT_EQ(found["'a'"], "string");
    EXPECT_EQ(found["T#5s"], "time");
    EXPECT_EQ(found["TRUE"], "boolean");
    EXPECT_EQ(found["{pragma}"], "pragma");
    EXPECT_EQ(found["(* comment *)"], "comment");
}

TEST(TokenClasses, ClassNamesByTheirPlace) {
    auto found = classes("FUNCTION_BLOCK fb VAR v : MyType := (element := red); w : INT; END_VAR\n"
                         "v.field := calc(arg := w, out => w); inst(in1 := C#blue);\n"
                         "END_FUNCTION_BLOCK");
    EXPECT_EQ(found["fb"], "library_element");
    EXPECT_EQ(found["MyType"], "type_name");
    EXPECT_EQ(found["INT"], "type_name");
    EXPECT_EQ(found["element"], "field");
    EXPECT_EQ(found["field"], "field");
    EXPECT_EQ(found["calc"], "function");
    EXPECT_EQ(found["arg"], "parameter");
    EXPECT_EQ(found["out"], "parameter");
    EXPECT_EQ(found["inst"], "variable");
    EXPECT_EQ(found["C#blue"], "enumerated_value");
}

// B.1.3.3, B.1.5.1, B.1.6, B.2: what is declared, and where it is used.
TEST(TokenClasses, ClassNamesByWhatTheyDeclare) {
    auto found = classes("TYPE t : (red, green); s : STRUCT f, g : INT; END_STRUCT; END_TYPE\n"
                         "FUNCTION fu : ANY v[i].m := r^.n; fu := EN OR ENO; END_FUNCTION\n"
                         "PROGRAM p INITIAL_STEP st : act (N); END_STEP\n"
                         "TRANSITION FROM (st, su) TO st := x; END_TRANSITION\n"
                         "ACTION act : x := 1; END_ACTION END_PROGRAM\n"
                         "FUNCTION_BLOCK fb\nl1: JMPC l2\nEND_FUNCTION_BLOCK\n"
                         "CONFIGURATION c PROGRAM i : p (inst WITH ta, v2[1].m2 := g, v3^ := g);"
                         " END_CONFIGURATION");
    const std::map<std::string, std::string> expected = {
        {"t", "type_name"},
        {"red", "enumerated_value"},
        {"green", "enumerated_value"},
        {"s", "type_name"},
        {"f", "field"},
        {"g", "variable"},
        {"ANY", "type_name"},
        {"v", "variable"},
        {"m", "field"},
        {"r", "variable"},
        {"n", "field"},
        {"EN", "variable"},
        {"ENO", "variable"},
        {"st", "step"},
        {"su", "step"},
        {"act", "action"},
        {"N", "keyword"},
        {"l1", "label"},
        {"JMPC", "il_operator"},
        {"l2", "label"},
        {"inst", "variable"},
        {"ta", "configuration_element"},
        {"v2", "parameter"},
        {"v3", "parameter"},
        {"m2", "field"},
    };
    for (const auto& [text, token_class] : expected)
        EXPECT_EQ(found[text], token_class) << text;
    EXPECT_EQ(classes("FUNCTION fu : INT END_FUNCTION")["fu"], "function");
}

TEST(TokenClasses, ClassNamesOfConfigurations) {
    auto found =
        classes("CONFIGURATION c RESOURCE r ON cpu TASK t (INTERVAL := T#1s, PRIORITY := 1);"
                " PROGRAM i WITH t : prog; END_RESOURCE END_CONFIGURATION");
    EXPECT_EQ(found["c"], "library_element");
    EXPECT_EQ(found["r"], "configuration_element");
    EXPECT_EQ(found["cpu"], "type_name");
    EXPECT_EQ(found["INTERVAL"], "parameter");
    EXPECT_EQ(found["i"], "configuration_element");
    EXPECT_EQ(found["prog"], "type_name");
}

// B.1.6, B.1.7: PRIORITY is the name of a parameter in both.
TEST(TokenClasses, ClassPriorityAsAParameter) {
    auto found =
        classes("PROGRAM p INITIAL_STEP s : END_STEP STEP t : END_STEP\n"
                "TRANSITION tr (PRIORITY := 1) FROM s TO t := x; END_TRANSITION END_PROGRAM");
    EXPECT_EQ(found["PRIORITY"], "parameter");
    EXPECT_EQ(found["tr"], "transition");
}

// B.2
TEST(TokenClasses, ClassOperatorsAndFunctionsOfInstructions) {
    auto found = classes("PROGRAM p\nLD a\n&N b\nANDN c\nSIN\nfoo d, e\nLIMIT(\n  MN := 1\n)\n"
                         "CAL inst(in1 := 2)\nEND_PROGRAM");
    EXPECT_EQ(found["LD"], "il_operator");
    EXPECT_EQ(found["&"], "il_operator");
    EXPECT_EQ(found["N"], "il_operator");
    EXPECT_EQ(found["ANDN"], "il_operator");
    EXPECT_EQ(found["SIN"], "function");
    EXPECT_EQ(found["foo"], "function");
    EXPECT_EQ(found["LIMIT"], "function");
    EXPECT_EQ(found["MN"], "parameter");
    EXPECT_EQ(found["CAL"], "il_operator");
    EXPECT_EQ(found["inst"], "variable");
    EXPECT_EQ(classes("PROGRAM p\nLD a\n&N( b\n)\nEND_PROGRAM")["N"], "il_operator");
}

// B.1.7
TEST(TokenClasses, ClassConnectionsAndPathsOfConfigurations) {
    auto found = classes("CONFIGURATION c RESOURCE r ON cpu PROGRAM i : p (a := g, q.b => %QX1);"
                         " END_RESOURCE VAR_ACCESS acc : res.prog.x : INT; END_VAR\n"
                         "VAR_CONFIG res2.prog2.x2 : INT := 1; END_VAR END_CONFIGURATION");
    EXPECT_EQ(found["a"], "parameter");
    EXPECT_EQ(found["g"], "variable");
    EXPECT_EQ(found["q"], "parameter");
    EXPECT_EQ(found["b"], "field");
    EXPECT_EQ(found["acc"], "configuration_element");
    EXPECT_EQ(found["res"], "variable");
    EXPECT_EQ(found["prog"], "field");
    EXPECT_EQ(found["x"], "field");
    EXPECT_EQ(found["res2"], "variable");
    EXPECT_EQ(found["prog2"], "field");
    EXPECT_EQ(found["x2"], "field");
}

TEST(TokenClasses, AreInOrderAndLeaveNothingOut) {
    const SyntaxTree tree = parse(SourceText("(*a*) PROGRAM (*b*) p ? ; (*c*) END_PROGRAM (*d*)"));
    const Unit& unit = *tree.slots()[0].unit;
    const std::vector<ClassifiedToken> found = token_classes(unit);
    EXPECT_EQ(found.size(), unit.tokens().size() + unit.trivia().size());
    for (std::size_t i = 1; i < found.size(); ++i)
        EXPECT_LE(found[i - 1].range.end, found[i].range.begin);
}

} // namespace
