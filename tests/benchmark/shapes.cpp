#include "benchmark/shapes.hpp"

#include <array>

namespace iecfront::bench {
namespace {

constexpr std::array table = {
    // Valid, but of no usual form.
    Shape{
        "one_unit", "PROGRAM p\n", "  x1 := y + f(a := 1, b := z[2]);\n", {}, {}, "END_PROGRAM\n"},
    Shape{"tiny_units", "", "TYPE a : INT; END_TYPE\n"},
    Shape{"tiny_functions", "", "FUNCTION f : INT f := 1; END_FUNCTION\n"},
    Shape{"empty_programs", "", "PROGRAM p\n;\nEND_PROGRAM\n"},
    Shape{"giant_comment", "(*", " words in a comment\n", {}, {}, "*)"},
    Shape{"giant_comment_of_stars", "(*", "*", {}, {}, "*)"},
    Shape{"giant_line", "PROGRAM p ", "x := y + 1; ", {}, {}, "END_PROGRAM"},
    Shape{"giant_line_of_comments", "PROGRAM p x := 1 ", "(* a *) ", {}, {}, "; END_PROGRAM"},
    Shape{"giant_expression", "PROGRAM p x := a", " + b * c", {}, {}, "; END_PROGRAM"},
    Shape{"giant_string", "PROGRAM p x := '", "text ", {}, {}, "'; END_PROGRAM"},
    Shape{"giant_name", "PROGRAM ", "name", {}, {}, "\n;END_PROGRAM"},
    Shape{"giant_number", "PROGRAM p x := 1", "234", {}, {}, "; END_PROGRAM"},
    Shape{"empty_lines", "", "\n"},
    Shape{"line_ends_of_cr", "", "\r\r\n"},
    Shape{"blanks", "", " "},
    Shape{"comments", "", "(* a *)\n"},
    Shape{"pragmas", "", "{a}"},
    Shape{"long_il", "PROGRAM p\n", "LD a\nAND b\nST c\n", {}, {}, "END_PROGRAM\n"},
    Shape{"long_il_call", "PROGRAM p\nCAL f(\n", "a := b,\n", {}, {}, "c := d\n)\nEND_PROGRAM\n"},
    Shape{"il_labels", "PROGRAM p\n", "l1:\nJMP l1\n", {}, {}, "END_PROGRAM\n"},
    Shape{"long_case",
          "PROGRAM p CASE a OF\n",
          "1, 2..5: x := 1;\n",
          {},
          {},
          "END_CASE; END_PROGRAM\n"},
    Shape{"long_case_list",
          "PROGRAM p CASE a OF\n1",
          ", 2",
          {},
          {},
          ": x := 1; END_CASE; END_PROGRAM\n"},
    Shape{"long_elsif",
          "PROGRAM p IF a THEN\n;",
          "ELSIF b THEN x := 1;\n",
          {},
          {},
          "END_IF; END_PROGRAM\n"},
    Shape{"long_var", "PROGRAM p VAR\n", "a : INT := 5;\n", {}, {}, "END_VAR ; END_PROGRAM\n"},
    Shape{"long_name_list", "PROGRAM p VAR a", ", b", {}, {}, " : INT; END_VAR ; END_PROGRAM\n"},
    Shape{"many_var_blocks", "PROGRAM p\n", "VAR a : INT; END_VAR\n", {}, {}, "; END_PROGRAM\n"},
    Shape{"long_enumeration", "TYPE t : (a", ", b", {}, {}, "); END_TYPE\n"},
    Shape{"long_structure", "TYPE t : STRUCT\n", "a : INT;\n", {}, {}, "END_STRUCT; END_TYPE\n"},
    Shape{"long_initial_values",
          "TYPE t : ARRAY [1..2] OF INT := [1",
          ", 2(3)",
          {},
          {},
          "]; END_TYPE\n"},
    Shape{"long_argument_list", "PROGRAM p f(a := 1", ", b := 2", {}, {}, "); END_PROGRAM\n"},
    Shape{"long_selection", "PROGRAM p x := a", ".b[1]", {}, {}, "; END_PROGRAM\n"},
    Shape{"many_steps",
          "PROGRAM p INITIAL_STEP a: END_STEP\n",
          "STEP b: c(N); END_STEP\nTRANSITION FROM a TO b := c; END_TRANSITION\n",
          {},
          {},
          "END_PROGRAM\n"},
    Shape{"many_actions",
          "PROGRAM p INITIAL_STEP a: END_STEP\n",
          "ACTION b: c := 1; END_ACTION\n",
          {},
          {},
          "END_PROGRAM\n"},
    Shape{
        "many_initial_steps", "PROGRAM p\n", "INITIAL_STEP a: END_STEP\n", {}, {}, "END_PROGRAM\n"},
    Shape{"many_tasks",
          "CONFIGURATION c\nRESOURCE r ON s\n",
          "TASK t (PRIORITY := 1);\n",
          {},
          {},
          "PROGRAM p : q; END_RESOURCE END_CONFIGURATION\n"},

    // Nested deeper than is read.
    Shape{"parentheses", "PROGRAM p x := ", "(", "a", ")", "; END_PROGRAM\n"},
    Shape{"open_parentheses", "PROGRAM p x := ", "("},
    Shape{"closing_parentheses", "PROGRAM p x := ", ")"},
    Shape{"open_brackets", "PROGRAM p x", "["},
    Shape{"open_calls", "PROGRAM p x := ", "f("},
    Shape{"not_not", "PROGRAM p x := ", "NOT "},
    Shape{"minus_minus", "PROGRAM p x := ", "- "},
    Shape{"nested_if", "PROGRAM p\n", "IF a THEN\n", ";", "END_IF;\n", "END_PROGRAM\n"},
    Shape{"open_if", "PROGRAM p\n", "IF a THEN\n"},
    Shape{"open_for", "PROGRAM p\n", "FOR i := 1 TO 2 DO\n"},
    Shape{"open_case", "PROGRAM p\n", "CASE a OF 1:\n"},
    Shape{"open_repeat", "PROGRAM p\n", "REPEAT\n"},
    Shape{"closing_if", "PROGRAM p\n", "END_IF;\n"},
    Shape{"closing_mixed", "PROGRAM p\n", "IF a THEN WHILE b DO\n", "", "END_IF; END_WHILE;\n"},
    Shape{"open_structures", "TYPE a : ", "STRUCT b : "},
    Shape{"open_arrays", "TYPE a : ARRAY [1..2] OF INT := ", "["},
    Shape{"open_enumerations", "TYPE a : ", "(b, "},
    Shape{"open_il", "PROGRAM p\n", "LD( a\n"},
    Shape{"open_il_calls", "PROGRAM p\n", "CAL a(\nb := "},
    Shape{"open_actions", "PROGRAM p\nINITIAL_STEP s: END_STEP\n", "ACTION a:\n"},
    Shape{"open_steps", "PROGRAM p\n", "STEP a:\n"},
    Shape{"open_transitions", "PROGRAM p\nINITIAL_STEP s: END_STEP\n",
          "TRANSITION FROM a TO b :=\n"},

    // Never closed.
    Shape{"open_comments", "", "(*"},
    Shape{"open_comments_on_lines", "", "(*\n"},
    Shape{"open_comments_before_code", "", "(* a\nx := 1;\n"},
    Shape{"nested_comments", "", "(*", "", "*)"},
    Shape{"closed_and_open_comments", "", "(* (* *) "},
    Shape{"c_comments", "", "/*\n"},
    Shape{"open_pragmas", "", "{"},
    Shape{"open_pragmas_on_lines", "", "{\n"},
    Shape{"closing_pragmas", "", "}"},
    Shape{"open_strings", "PROGRAM p x := ", "'"},
    Shape{"open_strings_on_lines", "PROGRAM p\n", "x := 'a;\n"},
    Shape{"string_with_code", "PROGRAM p x := '", "THEN;a "},
    Shape{"closing_comments", "", "*)"},
    Shape{"comments_without_star", "PROGRAM p ", "; (a *) ", {}, {}, "END_PROGRAM"},
    Shape{"giant_line_of_closing_comments",
          "PROGRAM p x := 1",
          " + a + b *)",
          {},
          {},
          "; END_PROGRAM"},
    Shape{"open_programs", "", "PROGRAM p\n"},
    Shape{"open_types", "", "TYPE\n"},
    Shape{"open_functions", "", "FUNCTION f : INT\n"},
    Shape{"open_configurations", "", "CONFIGURATION c\n"},
    Shape{"open_resources", "CONFIGURATION c\n", "RESOURCE r ON s\n"},
    Shape{"open_var", "PROGRAM p\n", "VAR\n"},
    Shape{"end_programs", "", "END_PROGRAM\n"},

    // Full of mistakes.
    Shape{"missing_semicolons", "PROGRAM p\n", "x := 1\n", {}, {}, "END_PROGRAM\n"},
    Shape{"missing_operands", "PROGRAM p\n", "x := ;\n", {}, {}, "END_PROGRAM\n"},
    Shape{"missing_then", "PROGRAM p\n", "IF a x := 1; END_IF;\n", {}, {}, "END_PROGRAM\n"},
    Shape{"missing_end_if", "PROGRAM p\n", "IF a THEN\n  x := 1;\n"},
    Shape{"misspelt_words", "PROGRAM p\n", "IF a THNE x := 1; END_FI;\n", {}, {}, "END_PROGRAM\n"},
    Shape{"look_alikes", "PROGRAM p\n", "x = a == b && c;\n", {}, {}, "END_PROGRAM\n"},
    Shape{"names", "", "a "},
    Shape{"numbers", "", "1 "},
    Shape{"keywords", "PROGRAM p\n", "THEN "},
    Shape{"points", "PROGRAM p x", "."},
    Shape{"signs", "PROGRAM p x := ", "+ "},
    Shape{"commas", "PROGRAM p x := f(", ","},
    Shape{"colons", "PROGRAM p\n", ":"},
    Shape{"number_signs", "PROGRAM p x := ", "#"},
    Shape{"unknown_bytes", "", "\x01"},
    Shape{"broken_utf8", "", "\xE4"},
    Shape{"broken_utf8_in_words", "PROGRAM p\n", "a\xE4 := 1;\n"},
    Shape{"malformed_literals", "PROGRAM p\n", "x := T#1x + 16#G + 2#3 + D#2;\n"},
    Shape{"malformed_names", "PROGRAM p\n", "a__b := c_;\n"},
    Shape{"bad_declarations",
          "PROGRAM p VAR\n",
          "a INT; b : ; : c\n",
          {},
          {},
          "END_VAR END_PROGRAM\n"},
    Shape{"bad_types", "TYPE\n", "a INT; b : ; : c\n", {}, {}, "END_TYPE\n"},
    Shape{"bad_il", "PROGRAM p\nLD a\n", "LD b c\nAND (\n)\n", {}, {}, "END_PROGRAM\n"},
    Shape{
        "bad_il_call", "PROGRAM p\nLD a\nCAL f(\n", "a = b\n, c :=\n", {}, {}, ")\nEND_PROGRAM\n"},
    Shape{"st_in_il", "PROGRAM p\nLD a\n", "x := 1;\n", {}, {}, "END_PROGRAM\n"},
    Shape{"il_in_st", "PROGRAM p\nx := 1;\n", "LD a\n", {}, {}, "END_PROGRAM\n"},
    Shape{"classes", "", "CLASS c METHOD m END_METHOD END_CLASS\n"},
    Shape{"case_then_string", "PROGRAM p CASE a OF ", "T ", "a:", "'"},
    Shape{"names_then_commas", "PROGRAM p CASE a OF ", "a b ", "LD ", ", "},
    Shape{"else_if", "FUNCTION f : INT\n", "ELSE IF ", "VAR_ACCESS ", "3("},
    Shape{"access_then_ranges", "CONFIGURATION c ", "VAR_ACCESS ", ";", "3.."},
    Shape{"then_then_percent", "PROGRAM p CASE a OF ", "THEN ", "VAR_ACCESS ", "%"},
    Shape{"brackets_then_end_var", "PROGRAM p VAR ", "x[", "OF ", "END_VAR "},
    Shape{"end_type_then_percent", "", "END_TYPE ", "FUNCTION ", "%"},
    Shape{"access_then_points", "PROGRAM p IF a THEN ", "VAR_ACCESS ", "INT#5 ", "x."},
    Shape{"minus_end_while", "PROGRAM p x(", "-END_WHILE ", "END_FOR ", "*x:="},
    Shape{"assign_then_closing", "PROGRAM p ", "x := ", "'", ") "},
    Shape{"repeat_misspelt", "PROGRAM p ", "REPEAT UNTILL a ", "\n", "x += "},
    Shape{"type_first", "PROGRAM p VAR ", "INT x, y : INT AT %I1 ", "\n", "!a | "},
    Shape{"closing_words_in_one", "PROGRAM p (* ", "PROGRAM p\n ST FROM", "{ a", "END_WHILE"},
    Shape{"for_on_one_line", "PROGRAM p ", "**END_FOR FOR"},
    Shape{"unknown_then_arguments", "PROGRAM p f(", "$ ", "INT#5", "ENDIF ", "TO"},
    Shape{"inputs", "FUNCTION_BLOCK b VAR_INPUT a : INT := ", "(a:=2.5 3(", ":= ", "a:"},
};

void repeat(std::string& text, std::string_view piece, std::size_t size) {
    while (!piece.empty() && text.size() < size)
        text += piece;
}

} // namespace

std::string Shape::text(std::size_t size) const {
    std::string result(begin);
    result.reserve(size + 100);
    repeat(result, first, second.empty() ? size : size / 2);
    result += between;
    repeat(result, second, size);
    return result += end;
}

std::span<const Shape> shapes() noexcept {
    return table;
}

} // namespace iecfront::bench
