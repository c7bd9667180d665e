#include "grammar/formal_syntax.hpp"
#include "support/repository_files.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {
namespace {

/// A function that reads productions of other names than its own.
struct Reader {
    std::string_view function;
    std::string_view productions; ///< with a blank between two
};

/// A production that is not here is read by the function of its name: `if_statement` by
/// `parse_if_statement`.
constexpr Reader readers[] = {
    {"", "standard_function_name standard_function_block_name"}, // words that the lexer knows
    {"add_il_operands", "il_operand_list"},
    {"check_il_subscripts", "il_subscript il_subscript_list"},
    {"check_initial_value",
     "simple_spec_init subrange_spec_init enumerated_spec_init array_spec_init "
     "initialized_structure"},
    {"check_reference", "global_var_reference program_output_reference"},
    {"check_name_of_standard", "function_name function_block_type_name"},
    {"make_invocation", "fb_invocation"},
    {"operator_strength", "comparison_operator add_operator multiply_operator"},
    {"parse_access_declaration", "program_access_decl direction access_name"},
    {"parse_action", "action_name"},
    {"parse_action_qualifier", "timed_qualifier"},
    {"parse_argument", "param_assignment"},
    {"parse_arguments", "param_list"},
    {"parse_assignment", "assignment_statement"},
    {"parse_binary", "xor_expression and_expression comparison equ_expression add_expression term "
                     "power_expression"},
    {"parse_body", "function_body function_block_body"},
    {"parse_case_element", "case_list"},
    {"parse_case_label", "case_list_element"},
    {"parse_configuration_elements", "single_resource_declaration"},
    {"parse_declaration_blocks", "io_var_declarations other_var_declarations"},
    {"parse_declared_names", "var1_list fb_name_list fb_name global_var_list global_var_name"},
    {"parse_elementary_type",
     "elementary_type_name numeric_type_name integer_type_name signed_integer_type_name "
     "unsigned_integer_type_name real_type_name date_type_name bit_string_type_name"},
    {"parse_field", "structured_variable field_selector"},
    {"parse_for_statement", "control_variable"},
    {"parse_il_argument", "il_param_assignment il_assign_operator"},
    {"parse_il_expression", "il_expr_operator"},
    {"parse_il_fb_call", "il_call_operator"},
    {"parse_il_formal_funct_call", "il_expr_function"},
    {"parse_il_function", "il_function_name"},
    {"parse_il_jump_operation", "il_jump_operator"},
    {"parse_il_output_argument", "il_param_out_assignment il_assign_out_operator"},
    {"parse_il_param_list", "il_param_instruction il_param_last_instruction"},
    {"parse_il_return_operation", "il_return_operator"},
    {"parse_il_simple_operation", "il_simple_operator il_store_operator"},
    {"parse_il_variable", "il_symbolic_variable"},
    {"parse_indicator", "indicator_name"},
    {"parse_initial_value", "array_initial_element"},
    {"parse_library_element", "library_element_declaration"},
    {"parse_library_unit", "library"},
    {"parse_name", "identifier"},
    {"parse_optional_label", "label"},
    {"parse_optional_location", "location incompl_location"},
    {"parse_optional_transition_name", "transition_name"},
    {"parse_primary", "primary_expression"},
    {"parse_prog_conf_element", "fb_task prog_cnxn"},
    {"parse_program_configuration", "program_name prog_conf_elements"},
    {"parse_resource_declaration", "resource_name resource_type_name"},
    {"parse_selectors", "array_variable subscripted_variable record_variable"},
    {"parse_simple_instruction_list", "simple_instr_list"},
    {"parse_statement", "selection_statement iteration_statement"},
    {"parse_step", "initial_step step_name"},
    {"parse_string_specification", "single_byte_string_spec double_byte_string_spec"},
    {"parse_structure_element_declaration", "structure_element_name"},
    {"parse_subscripts", "subscript_list subscript"},
    {"parse_task_configuration", "task_name"},
    {"parse_type_declaration",
     "single_element_type_declaration simple_type_declaration subrange_type_declaration "
     "enumerated_type_declaration array_type_declaration structure_type_declaration "
     "structure_specification string_type_declaration"},
    {"parse_type_name",
     "derived_type_name single_element_type_name simple_type_name subrange_type_name "
     "enumerated_type_name array_type_name structure_type_name string_type_name"},
    {"parse_type_specification", "simple_specification var_spec non_generic_type_name"},
    {"parse_unary", "unary_expression unary_operator"},
    {"parse_unit_name", "derived_function_name derived_function_block_name program_type_name"},
    {"parse_variable", "multi_element_variable"},
    {"parse_variable_declaration",
     "input_declaration output_declaration parameter_spec_init edge_declaration var_init_decl "
     "var1_init_decl array_var_init_decl "
     "structured_var_init_decl fb_name_decl var2_init_decl var_declaration temp_var_decl "
     "var1_declaration array_var_declaration structured_var_declaration "
     "string_var_declaration single_byte_string_var_declaration "
     "double_byte_string_var_declaration located_var_decl located_var_spec_init "
     "incompl_located_var_decl external_declaration global_var_decl global_var_spec"},
    {"parse_variable_declarations",
     "input_declarations output_declarations input_output_declarations var_declarations "
     "retentive_var_declarations non_retentive_var_decls function_var_decls "
     "located_var_declarations incompl_located_var_declarations temp_var_decls "
     "external_var_declarations global_var_declarations program_access_decls "
     "access_declarations instance_specific_initializations"},
    {"parse_word_statement", "subprogram_control_statement exit_statement"},
};

/// The function above which `production` has to stand; empty when it stands nowhere.
[[nodiscard]] std::string reader_of(const std::string& production) {
    for (const Reader& reader : readers)
        if ((" " + std::string(reader.productions) + " ").find(" " + production + " ") !=
            std::string::npos)
            return std::string(reader.function);
    return "parse_" + production;
}

/// A comment of the parser that begins in the first column, and the function below it.
struct Comment {
    std::string path;
    std::string function;   ///< without `Parser::`; empty when no function follows directly
    std::string notation;   ///< the lines behind `//`
    std::string prose = {}; ///< the lines behind `///`, made one
};

/// `name` of a line like `Type Parser::name(`, where a definition begins; else nothing.
[[nodiscard]] std::string function_defined_in(std::string_view line) {
    constexpr std::string_view scope = "Parser::";
    const std::string_view head = line.substr(0, line.find('('));
    const std::size_t begin = head.rfind(scope);
    if (line.starts_with(' ') || head.size() == line.size() || begin == std::string_view::npos)
        return {};
    return std::string(head.substr(begin + scope.size()));
}

/// All comments, and the functions that have none.
[[nodiscard]] std::vector<Comment> comments_of_parser() {
    std::vector<Comment> comments;
    for (const auto& file : repository_files({"src"}, {".cpp"})) {
        if (!file.path.starts_with("src/parser/"))
            continue;
        Comment comment{file.path, {}, {}};
        for (const std::string_view line : lines_of(file.text)) {
            if (line.starts_with("/// ")) {
                comment.prose += std::string(line.substr(comment.prose.empty() ? 4 : 3));
            } else if (line.starts_with("// ")) {
                comment.notation += std::string(line.substr(3)) + "\n";
            } else if (!line.ends_with('*')) { // a type that has a line of its own
                comment.function = function_defined_in(line);
                comments.push_back(comment);
                comment = {file.path, {}, {}};
            }
        }
    }
    return comments;
}

/// A production begins a line and ends in ` ;`; the reader of the page reads those in a block.
[[nodiscard]] std::vector<Production> productions_in(std::string_view notation) {
    std::string block = "```ebnf\n";
    bool inside = false;
    for (const std::string_view line : lines_of(notation)) {
        const std::size_t name_end =
            line.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_");
        inside = inside ||
                 (name_end != 0 && line.substr(std::min(name_end, line.size())).starts_with(" = "));
        if (inside)
            block += std::string(line) + "\n";
        inside = inside && !line.ends_with(" ;");
    }
    return read_grammar(block + "```\n").productions;
}

/// `Part of a, b: ...` or `In place of a: ...`
struct Share {
    std::vector<std::string> productions;
    std::string what;
};

[[nodiscard]] Share share_in(std::string_view text) {
    Share share;
    for (const std::string_view lead : {"Part of ", "In place of "}) {
        if (!text.starts_with(lead))
            continue;
        const std::size_t colon = std::min(text.find(": "), text.size());
        std::string_view names = text.substr(lead.size(), colon - lead.size());
        share.what = text.substr(std::min(colon + 2, text.size()));
        for (std::size_t end = names.find(", "); end != names.npos; end = names.find(", ")) {
            share.productions.emplace_back(names.substr(0, end));
            names.remove_prefix(end + 2);
        }
        share.productions.emplace_back(names);
    }
    return share;
}

/// With one blank between two words, and none at the ends.
[[nodiscard]] std::string normalized(const std::string& text) {
    std::istringstream words(text);
    std::string result;
    for (std::string word; words >> word;)
        result += (result.empty() ? "" : " ") + word;
    return result;
}

/// What `notation` says to be a part of a production.
[[nodiscard]] Share quoted_part_in(const std::string& notation) {
    const std::string text = normalized(notation);
    return share_in(std::string_view(text).substr(std::min(text.find("Part of "), text.size())));
}

/// True when it is nothing but productions, and perhaps a part of one behind them.
[[nodiscard]] bool is_well_formed(const std::string& notation) {
    std::string productions;
    for (const Production& production : productions_in(notation))
        productions += production.text + " ";
    const std::string text = normalized(notation) + " ";
    return text == " " || text == productions || text.starts_with(productions + "Part of ");
}

// 1.5.1 i): the parser and the formal syntax do not drift apart.
TEST(QuotedProductions, AreThoseOfTheFormalSyntax) {
    for (const Comment& comment : comments_of_parser()) {
        for (const Production& production : productions_in(comment.notation)) {
            const Production* documented = formal_syntax().grammar.find(production.name);
            ASSERT_NE(documented, nullptr) << comment.path << ": " << production.name;
            EXPECT_EQ(production.text, documented->text) << comment.path;
        }
    }
}

TEST(QuotedProductions, StandAboveTheFunctionThatReadsThem) {
    std::map<std::string, std::vector<std::string>> functions;
    for (const Comment& comment : comments_of_parser())
        for (const Production& production : productions_in(comment.notation))
            functions[production.name].push_back(comment.function);
    for (const Production& production : formal_syntax().grammar.productions) {
        std::vector<std::string> expected;
        if (const std::string reader = reader_of(production.name); !reader.empty())
            expected.push_back(reader);
        const std::vector<std::string>& found = functions[production.name];
        EXPECT_TRUE(found == expected || (production.lexical() && found.empty()))
            << production.name << " has to stand above " << reader_of(production.name)
            << ", and nowhere else";
    }
}

TEST(QuotedProductions, HaveTheQuotedParts) {
    for (const Comment& comment : comments_of_parser()) {
        const Share part = quoted_part_in(comment.notation);
        for (const std::string& name : part.productions) {
            const Production* documented = formal_syntax().grammar.find(name);
            ASSERT_NE(documented, nullptr) << comment.path << ": " << name;
            EXPECT_NE(documented->text.find(part.what), std::string::npos)
                << comment.path << ": `" << part.what << "` is no part of " << name;
        }
    }
}

// A function whose name is that of a production has to do with that one.
TEST(ParseFunctions, SayWhatTheyRead) {
    std::size_t functions = 0;
    for (const Comment& comment : comments_of_parser()) {
        constexpr std::string_view prefix = "parse_";
        if (!comment.function.starts_with(prefix))
            continue;
        ++functions;
        EXPECT_TRUE(is_well_formed(comment.notation)) << comment.path << ": " << comment.function;
        std::vector<std::string> names;
        for (const Production& production : productions_in(comment.notation))
            names.push_back(production.name);
        for (const Share& share : {quoted_part_in(comment.notation), share_in(comment.prose)})
            names.insert(names.end(), share.productions.begin(), share.productions.end());
        EXPECT_FALSE(names.empty()) << comment.path << ": " << comment.function;
        for (const std::string& name : names)
            EXPECT_NE(formal_syntax().grammar.find(name), nullptr)
                << comment.path << ": " << comment.function << ": " << name;
        const std::string own_name = comment.function.substr(prefix.size());
        EXPECT_TRUE(formal_syntax().grammar.find(own_name) == nullptr ||
                    std::ranges::find(names, own_name) != names.end())
            << comment.path << ": " << comment.function;
    }
    EXPECT_GT(functions, 100U);
}

} // namespace
} // namespace iecfront::test
