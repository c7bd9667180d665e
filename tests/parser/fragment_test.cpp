#include "support/invariants.hpp"

#include <iecfront/ast/dump.hpp>
#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/diagnostics/render_text.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <string>

using namespace iecfront;
using iecfront::test::expect_invariants;

namespace {

ParseOptions as(FragmentKind kind) {
    ParseOptions options;
    options.read_as = kind;
    return options;
}

// The elements of the one unit as S-expressions, and the codes of what is found.
std::string read(const std::string& text, FragmentKind kind) {
    const SourceText source(text);
    expect_invariants(source, as(kind));
    const SyntaxTree tree = parse(source, as(kind));
    EXPECT_EQ(tree.slots().size(), 1U);
    std::string out;
    for (const ast::Node* element : tree.slots()[0].unit->root().elements)
        out += (out.empty() ? "" : " ") + s_expression(*tree.slots()[0].unit, *element);
    for (const Diagnostic& diagnostic : tree.diagnostics())
        out += ' ' + code_string(diagnostic.id);
    return out;
}

TEST(Fragment, AnExpression) {
    EXPECT_EQ(read("a + 1", FragmentKind::expression),
              "(binary_expression + left:(variable_name \"a\") right:(integer_literal \"1\"))");
    EXPECT_EQ(read("", FragmentKind::expression), "(error_expression missing) IEC2009");
}

TEST(Fragment, AStatementList) {
    EXPECT_EQ(read("a := 1; RETURN;", FragmentKind::statement_list),
              "(statement_list [(assignment_statement variable:(variable_name \"a\") "
              "expression:(integer_literal \"1\")) (return_statement \"RETURN\")])");
}

TEST(Fragment, BlocksOfDeclarations) {
    EXPECT_EQ(
        read("VAR_INPUT a : INT; END_VAR VAR END_VAR", FragmentKind::variable_declarations),
        "(variable_declarations var_input [(variable_declaration names:[\"a\"] "
        "specification:(elementary_type_name \"INT\"))]) (variable_declarations var) IEC5102");
    EXPECT_EQ(read("", FragmentKind::variable_declarations), "");
}

TEST(Fragment, ABodyInAnyLanguage) {
    EXPECT_EQ(read("a := 1;", FragmentKind::body).substr(0, 16), "(statement_list ");
    EXPECT_NE(read("LD a\nST b\n", FragmentKind::body).substr(0, 16), "(statement_list ");
}

TEST(Fragment, WhatIsLeftOverIsReportedOnce) {
    EXPECT_EQ(read("a b c d", FragmentKind::expression),
              "(variable_name \"a\") (skipped_text \"b c d\") IEC2008");
    EXPECT_EQ(read("VAR a : INT; END_VAR a := 1; b := 2;", FragmentKind::variable_declarations),
              "(variable_declarations var [(variable_declaration names:[\"a\"] "
              "specification:(elementary_type_name \"INT\"))]) "
              "(skipped_text \"a := 1; b := 2;\") IEC2008");
    EXPECT_EQ(read("a := 1; END_PROGRAM", FragmentKind::statement_list),
              "(statement_list [(assignment_statement variable:(variable_name \"a\") "
              "expression:(integer_literal \"1\"))]) (skipped_text \"END_PROGRAM\") IEC2008");
}

// B.3.1
TEST(Fragment, AnAssignmentIsNoExpression) {
    EXPECT_EQ(read("a := b", FragmentKind::expression),
              "(variable_name \"a\") (skipped_text \":= b\") IEC2008");
}

// B.1.4.3, B.1.7
TEST(Fragment, BlocksOfEveryPlace) {
    EXPECT_EQ(read("VAR_CONFIG r.p.x : INT := 1; END_VAR", FragmentKind::variable_declarations),
              "(variable_declarations var_config [(instance_specific_init path:[\"r\" \"p\" \"x\"] "
              "specification:(elementary_type_name \"INT\") "
              "initial_value:(integer_literal \"1\"))])");
    for (const char* text :
         {"VAR_ACCESS a : r.%IX0.0 : BOOL READ_ONLY; END_VAR", "VAR_ACCESS a : x : BOOL; END_VAR",
          "VAR_ACCESS a : %IX0.0 : BOOL; END_VAR", "VAR_GLOBAL CONSTANT a : INT; END_VAR",
          "VAR_INPUT RETAIN a : BOOL R_EDGE; END_VAR", "VAR_EXTERNAL a : INT; END_VAR",
          "VAR_TEMP a : INT; END_VAR", "VAR a AT %I* : INT; END_VAR",
          "VAR a AT %IX0.0 : BOOL; END_VAR"})
        EXPECT_EQ(read(text, FragmentKind::variable_declarations).find("IEC"), std::string::npos)
            << text;
    EXPECT_NE(read("VAR_TEMP RETAIN a : INT; END_VAR", FragmentKind::variable_declarations)
                  .find(" IEC5113"),
              std::string::npos);
}

// B.0
TEST(Fragment, ALibraryElementIsReportedOnce) {
    const std::string text = "PROGRAM p x := 1; END_PROGRAM";
    const std::string skipped = " (skipped_text \"" + text + "\") IEC2008";
    EXPECT_EQ(read(text, FragmentKind::statement_list), "(statement_list missing)" + skipped);
    EXPECT_EQ(read(text, FragmentKind::body), "(statement_list missing)" + skipped);
    EXPECT_EQ(read(text, FragmentKind::expression), "(error_expression missing)" + skipped);
    EXPECT_EQ(read(text, FragmentKind::variable_declarations), skipped.substr(1));
    const SyntaxTree tree = parse(SourceText(text), as(FragmentKind::statement_list));
    EXPECT_EQ(message(tree.diagnostics().at(0), tree.encoding()),
              "expected statements, found the library element `PROGRAM`");
}

TEST(Fragment, LibraryElementsAreNoUnitsInIt) {
    const SyntaxTree tree = parse(SourceText("PROGRAM p ; END_PROGRAM PROGRAM q ; END_PROGRAM"),
                                  as(FragmentKind::statement_list));
    EXPECT_EQ(tree.slots().size(), 1U);
}

TEST(Fragment, ReportsCarryThePlacesOfTheFileAroundIt) {
    const SourceText piece("a := 1\nb = 2;", "plant.xml");
    const SyntaxTree tree = parse(piece, as(FragmentKind::statement_list));
    ASSERT_EQ(tree.diagnostics().size(), 2U);
    const SourceText placed = piece.at({100, 12, 20});
    const std::string text = render_text(tree.diagnostics(), placed);
    EXPECT_EQ(text.substr(0, text.find(' ')), "plant.xml:12:26:") << text;
    EXPECT_NE(text.find("plant.xml:13:3:"), std::string::npos) << text;
    EXPECT_NE(text.find("\n  13 | b = 2;"), std::string::npos) << text;

    std::string json;
    const LineTable lines(placed.bytes());
    render_json(json, tree.diagnostics()[1], Severity::error, placed, lines);
    EXPECT_NE(json.find("\"line\":13,\"column\":3,"), std::string::npos) << json;
    EXPECT_NE(json.find("\"offset\":109,\"endOffset\":110,"), std::string::npos) << json;
}

TEST(Fragment, TheTreeKnowsWhereItBegins) {
    const Origin origin{.offset = 2049, .line = 88, .column = 13};
    const SourceText piece = SourceText("count + + 1", "plant.xml").at(origin);
    const SyntaxTree tree = parse(piece, as(FragmentKind::expression));
    EXPECT_EQ(tree.origin(), origin);
    EXPECT_EQ(tree.source().origin(), origin);

    const SyntaxTree edited = tree.edited({0, 5}, "\nx");
    EXPECT_EQ(edited.origin(), origin);
    EXPECT_EQ(edited.source().origin(), origin);
    const std::string text = render_text(edited.diagnostics(), edited.source());
    EXPECT_EQ(text.substr(0, text.find(' ')), "plant.xml:89:5:") << text;
    EXPECT_EQ(edited.edited({0, 2}, "count").host_place(8), tree.host_place(8));
}

TEST(Fragment, PlacesInTheFileAroundItAreNumbersToo) {
    // Before it on its line stand six characters, two of them outside the basic plane (4 bytes).
    const SyntaxTree tree = parse(SourceText("\xF0\x9F\x98\x80\nb")
                                      .at({.offset = 100,
                                           .line = 12,
                                           .column = 7,
                                           .column_in_utf16_units = 9,
                                           .column_in_bytes = 13}),
                                  as(FragmentKind::expression));
    EXPECT_EQ(tree.host_place(4), (HostPlace{104, {12, 8}}));
    EXPECT_EQ(tree.host_place(4, ColumnUnit::utf16_units), (HostPlace{104, {12, 11}}));
    EXPECT_EQ(tree.host_place(4, ColumnUnit::bytes), (HostPlace{104, {12, 17}}));
    EXPECT_EQ(tree.host_place(5, ColumnUnit::utf16_units), (HostPlace{105, {13, 1}}));
    EXPECT_EQ(parse(SourceText("a\nb")).host_place(2), (HostPlace{2, {2, 1}}));
}

TEST(Fragment, ReportsCanBeMappedIntoAnotherForm) {
    // `a &lt; b c` in the file, from offset 10 on; the piece has `<` for `&lt;`.
    const std::string piece = "a < b c";
    const auto map = [](std::uint32_t offset) { return 10 + offset + (offset > 2 ? 3 : 0); };
    const SyntaxTree tree = parse(SourceText(piece), as(FragmentKind::expression));
    ASSERT_EQ(tree.diagnostics().size(), 1U);
    EXPECT_EQ(tree.diagnostics()[0].range, (TextRange{6, 7}));
    EXPECT_EQ(mapped(tree.diagnostics()[0], map).range, (TextRange{19, 20}));
}

} // namespace
