#include <iecfront/ast/document_symbols.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace iecfront;

namespace {

// `kind name[children]`, one after the other.
std::string outline(const std::vector<DocumentSymbol>& symbols) {
    std::string out;
    for (const DocumentSymbol& symbol : symbols) {
        out += out.empty() ? "" : " ";
        out += std::string(to_string(symbol.kind)) + ' ' + std::string(symbol.name);
        if (!symbol.children.empty())
            out += '[' + outline(symbol.children) + ']';
    }
    return out;
}

std::string outline_of(const std::string& text) {
    return outline(document_symbols(parse(SourceText(text))));
}

TEST(DocumentSymbols, ListsUnitsWithTheirVariables) {
    EXPECT_EQ(outline_of("FUNCTION f : INT VAR_INPUT a, b : INT; END_VAR f := a; END_FUNCTION\n"
                         "FUNCTION_BLOCK g VAR c : BOOL; END_VAR c := TRUE; END_FUNCTION_BLOCK\n"
                         "PROGRAM p ; END_PROGRAM"),
              "function f[variable a variable b] function_block g[variable c] program p");
}

TEST(DocumentSymbols, ListsTypesWithWhatTheyConsistOf) {
    EXPECT_EQ(outline_of("TYPE Color : (Red, Green); Pair : STRUCT x : INT; y : (On1, Off1);"
                         " END_STRUCT; END_TYPE"),
              "data_type Color[enumerated_value Red enumerated_value Green] "
              "data_type Pair[structure_element x structure_element "
              "y[enumerated_value On1 enumerated_value Off1]]");
    EXPECT_EQ(outline_of("PROGRAM p VAR m, n : (A, B); END_VAR ; END_PROGRAM"),
              "program p[variable m[enumerated_value A enumerated_value B] variable n]");
}

TEST(DocumentSymbols, ListsConfigurations) {
    EXPECT_EQ(outline_of("CONFIGURATION c VAR_GLOBAL g : INT; END_VAR\n"
                         "RESOURCE r ON cpu TASK t (PRIORITY := 1); PROGRAM i WITH t : p;\n"
                         "END_RESOURCE VAR_ACCESS a : r.i.x : INT; END_VAR END_CONFIGURATION"),
              "configuration c[variable g resource r[task t program_instance i] access_path a]");
}

// B.1.6: a transition without a name is none of the outline.
TEST(DocumentSymbols, ListsTheElementsOfCharts) {
    EXPECT_EQ(outline_of("PROGRAM p VAR x : BOOL; END_VAR INITIAL_STEP s : act (N); END_STEP\n"
                         "STEP t : END_STEP TRANSITION go FROM s TO t := x; END_TRANSITION\n"
                         "TRANSITION FROM t TO s := x; END_TRANSITION\n"
                         "ACTION act : x := TRUE; END_ACTION END_PROGRAM"),
              "program p[variable x step s step t transition go action act]");
}

TEST(DocumentSymbols, GiveTheRangesOfDeclarationAndName) {
    const std::string text = "\nPROGRAM p ; END_PROGRAM\nTYPE T1 : INT; END_TYPE\n";
    const SyntaxTree tree = parse(SourceText(text));
    const std::vector<DocumentSymbol> symbols = document_symbols(tree);
    ASSERT_EQ(symbols.size(), 2U);
    const auto words = [&](TextRange range) { return text.substr(range.begin, range.size()); };
    EXPECT_EQ(words(symbols[0].range), "PROGRAM p ; END_PROGRAM");
    EXPECT_EQ(words(symbols[0].name_range), "p");
    EXPECT_EQ(words(symbols[1].range), "T1 : INT");
    EXPECT_EQ(words(symbols[1].name_range), "T1");
    const std::vector<DocumentSymbol> in_unit = document_symbols(*tree.slots()[1].unit);
    EXPECT_EQ(in_unit[0].range.begin + tree.slots()[1].offset, symbols[1].range.begin);
}

// Editors refuse an outline whose names lie outside of what they name.
TEST(DocumentSymbols, NamesLieInsideTheirDeclarations) {
    for (const char* const text : {"TYPE T : (A, 5); END_TYPE", "TYPE T : (A, \"x\"); END_TYPE",
                                   "PROGRAM p\nLD a\n5:  LD b\nEND_PROGRAM",
                                   "PROGRAM p\nVAR_ACCESS\n : a.b : INT;\nEND_VAR\n;END_PROGRAM",
                                   "PROGRAM p VAR a : INT; END_VAR ; END_PROGRAM"}) {
        std::vector<DocumentSymbol> symbols = document_symbols(parse(SourceText(text)));
        EXPECT_FALSE(symbols.empty());
        while (!symbols.empty()) {
            const DocumentSymbol symbol = symbols.back();
            symbols.pop_back();
            EXPECT_TRUE(symbol.range.contains(symbol.name_range)) << text << ": " << symbol.name;
            symbols.insert(symbols.end(), symbol.children.begin(), symbol.children.end());
        }
    }
}

TEST(DocumentSymbols, AMissingNameIsEmpty) {
    EXPECT_EQ(outline_of("PROGRAM VAR a : INT; END_VAR a := 1; END_PROGRAM"),
              "program [variable a]");
    EXPECT_EQ(outline_of(""), "");
}

} // namespace
