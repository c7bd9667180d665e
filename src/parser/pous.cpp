#include "parser/parser.hpp"

#include <utility>

namespace iecfront {
namespace {

bool has_inputs(const ast::VariableDeclarations* block) noexcept {
    return block->block == ast::VariableBlock::var_input ||
           block->block == ast::VariableBlock::var_in_out;
}

} // namespace

// function_declaration = "FUNCTION" derived_function_name ":"
//                        ( elementary_type_name | derived_type_name )
//                        { io_var_declarations | function_var_decls }
//                        function_body
//                        "END_FUNCTION" ;
const ast::FunctionDeclaration* Parser::parse_function_declaration() {
    auto* node = make<ast::FunctionDeclaration>();
    place_ = Place::function;
    open_block(TokenKind::kw_end_function, advance());
    const bool type_first = at_type_before_name();
    if (type_first) {
        report_swapped(next(at_), " : ");
        advance();
    }
    node->name = parse_unit_name("the name of a function");
    skip_parameters();
    node->result_type = type_first ? make_missing<ast::ErrorType>() : parse_result_type();
    skip_rest_of_head();
    node->declarations = parse_declaration_blocks(place_);
    if (std::none_of(node->declarations.begin(), node->declarations.end(), has_inputs))
        report_node(*node->name, DiagnosticId::function_without_input);
    node->body = parse_body();
    close_block("");
    return finish(node);
}

/// `FUNCTION INT f`, as in C.
bool Parser::at_type_before_name() const noexcept {
    const std::uint32_t name = next(at_);
    const std::uint32_t behind = next(name);
    return is_elementary_type_name(kind()) && tokens_[name].kind() == TokenKind::identifier &&
           !tokens_[name].first_on_line() &&
           (tokens_[behind].first_on_line() || block_openers.contains(tokens_[behind].kind()) ||
            tokens_[behind].kind() == TokenKind::left_parenthesis);
}

// derived_function_name = identifier ;
// derived_function_block_name = identifier ;
// program_type_name = identifier ;
/// The name may stand on the next line, but what begins a statement there is none.
const ast::Identifier* Parser::parse_unit_name(std::string_view what) {
    accept_foreign_modifiers();
    if (token().first_on_line() && at_statement_start())
        return make_missing_identifier(what);
    return at_keyword_for_unit_name() ? take_reserved_word() : parse_declared_name(what);
}

/// True at a keyword on the line of the head that begins neither a declaration nor a statement.
bool Parser::at_keyword_for_unit_name() {
    if (!is_keyword(kind()) || token().first_on_line() || at(block_openers) || at(unit_ends) ||
        begins_chart_element(at_))
        return false;
    if (tokens_[next(at_)].first_on_line() || block_openers.contains(peek()))
        return true;
    if (at(block_statements))
        return !opens_block(kind());
    return peek() == TokenKind::identifier || is_keyword(peek());
}

/// `FUNCTION f(a : INT; b : INT)`: the parameters of other languages, which are passed over.
void Parser::skip_parameters() {
    if (!at(TokenKind::left_parenthesis) || token().first_on_line())
        return;
    const std::uint32_t open = at_;
    std::uint32_t depth = 0;
    do {
        depth += at(TokenKind::left_parenthesis) ? 1 : 0;
        depth -= at(TokenKind::right_parenthesis) ? 1 : 0;
        advance();
    } while (depth > 0 && !at(block_openers) && !at(unit_ends) && !at(statement_words) &&
             !(token().first_on_line() && at_statement_start()));
    const TextRange parentheses = token_range(open, end_);
    Report parameters = report(DiagnosticId::parameters_in_head, parentheses);
    if (end_ == next(open) + 1)
        parameters.remove(parentheses);
    if (depth > 0)
        reported_at_ = at_; // the rest of the head may be among them
}

// Part of function_declaration: ":" ( elementary_type_name | derived_type_name )
const ast::TypeSpecification* Parser::parse_result_type() {
    const bool without = !at(TokenKind::colon) && (at(block_openers) || token().first_on_line());
    if (without) {
        report_missing(DiagnosticId::function_without_result);
        return make_missing<ast::ErrorType>();
    }
    expect_colon();
    const bool parameters = is_elementary_type_name(kind()) &&
                            peek() == TokenKind::left_parenthesis &&
                            peek_second() == TokenKind::identifier &&
                            tokens_[next(next(next(at_)))].kind() == TokenKind::colon;
    if (parameters) { // `FUNCTION f : INT (a : INT)`
        const auto* name = take<ast::ElementaryTypeName>();
        skip_parameters();
        return name;
    }
    const ast::TypeSpecification* type = parse_type_specification();
    switch (type->kind) {
    case ast::NodeKind::elementary_type_name:
    case ast::NodeKind::derived_type_name:
    case ast::NodeKind::error_type: break;
    case ast::NodeKind::string_specification:
        report_node(*type, DiagnosticId::function_result_type, {"a string with a length"});
        break;
    default: report_node(*type, DiagnosticId::function_result_type, {"a type written out"}); break;
    }
    return type;
}

/// Whatever stands between the head of a program organization unit and its next line.
void Parser::skip_rest_of_head() {
    if (at(TokenKind::semicolon)) {
        accept_extra_semicolon_before_body();
        return;
    }
    if (at_foreign_clause()) {
        skip_foreign_clauses();
        if (at(TokenKind::semicolon)) // the body
            return;
    }
    if (token().first_on_line() || at(block_openers) || at(unit_ends) ||
        at_declarations_without_opener() || at_statement_start() || body_begins_in_head())
        return;
    report_unexpected("a declaration block or the body");
    while (!token().first_on_line() && !at(block_openers) && !at(unit_ends) &&
           !at(TokenKind::semicolon))
        advance();
    if (at(TokenKind::semicolon) && !unit_ends.contains(peek())) {
        while (accept(TokenKind::semicolon)) {
        }
    }
}

/// An instruction or a chart on the line of the head, with no declarations behind it.
bool Parser::body_begins_in_head() {
    if (begins_chart_element(at_))
        return true;
    std::uint32_t line = at_;
    while (line == at_ || (line < count_ && !tokens_[line].first_on_line()))
        line = next(line);
    const bool word =
        at(TokenKind::identifier) || line_kind(at_, LineKind::operation) != LineKind::other;
    return word && !block_openers.contains(tokens_[line].kind()) &&
           body_language() == BodyLanguage::instruction_list;
}

// function_block_declaration = "FUNCTION_BLOCK" derived_function_block_name
//                              { io_var_declarations | other_var_declarations }
//                              function_block_body
//                              "END_FUNCTION_BLOCK" ;
const ast::FunctionBlockDeclaration* Parser::parse_function_block_declaration() {
    auto* node = make<ast::FunctionBlockDeclaration>();
    place_ = Place::function_block;
    open_block(TokenKind::kw_end_function_block, advance());
    node->name = parse_unit_name("the name of a function block type");
    skip_parameters();
    skip_rest_of_head();
    node->declarations = parse_declaration_blocks(place_);
    node->body = parse_body();
    close_block("");
    return finish(node);
}

// program_declaration = "PROGRAM" program_type_name
//                       { io_var_declarations | other_var_declarations
//                       | located_var_declarations | global_var_declarations
//                       | program_access_decls }
//                       function_block_body
//                       "END_PROGRAM" ;
const ast::ProgramDeclaration* Parser::parse_program_declaration() {
    auto* node = make<ast::ProgramDeclaration>();
    place_ = Place::program;
    open_block(TokenKind::kw_end_program, advance());
    node->name = parse_unit_name("the name of a program type");
    skip_parameters();
    skip_rest_of_head();
    node->declarations = parse_declaration_blocks(place_);
    node->body = parse_body();
    close_block("");
    return finish(node);
}

// io_var_declarations = input_declarations | output_declarations | input_output_declarations ;
// other_var_declarations = external_var_declarations | var_declarations
//                        | retentive_var_declarations | non_retentive_var_decls
//                        | temp_var_decls | incompl_located_var_declarations ;
Parser::Children<ast::VariableDeclarations> Parser::parse_declaration_blocks(Place place) {
    ListBuilder<ast::VariableDeclarations> blocks(*this);
    for (;;) {
        if (at(block_openers) || at_declarations_without_opener()) {
            const std::uint32_t before = at_;
            blocks.add(parse_variable_declarations(place));
            if (at_ == before) // what stands there only looked like a declaration
                return blocks.finish();
        } else if (at(TokenKind::kw_end_var)) {
            // The block has ended already, or its opening word is missing.
            report_at(at_, DiagnosticId::stray_closing_word, {text(at_)}).remove(token().range());
            advance();
        } else if (at_foreign_member()) {
            skip_foreign_member();
        } else {
            return blocks.finish();
        }
    }
}

// ---- bodies -------------------------------------------------------------------------------------

// function_body = instruction_list | statement_list ;
// function_block_body = sequential_function_chart | instruction_list | statement_list ;
const ast::Body* Parser::parse_body() {
    const TokenKind closer = open_.back().closer;
    if (at(unit_ends) || at(closer))
        return parse_empty_body();
    if (at_misspelt_closer() && unclosed(closer) > 0) // else it is an instruction without operand
        return parse_empty_body();
    if (at_presumable_statements())
        return parse_presumed_statements();
    const BodyLanguage language = body_language();
    if (language == BodyLanguage::instruction_list)
        return parse_instruction_list();
    if (language == BodyLanguage::sequential_function_chart) {
        if (place_ == Place::function && !in_chart_)
            report(DiagnosticId::chart_in_function, token().range());
        return parse_sequential_function_chart();
    }
    return parse_statement_list("in a body");
}

/// True at what very probably begins a body of statements.
bool Parser::at_presumable_statements() {
    return presumes_statements_ && (at_plain_assignment() || at(block_statements)) && balanced() &&
           reported_at_ != at_;
}

/// Part of function_body, function_block_body: a statement_list as long as nothing is reported.
const ast::Body* Parser::parse_presumed_statements() {
    presumed_body_ = {at_, open_.back().closer};
    const ast::Body* body = parse_statement_list("in a body");
    presumed_body_.reset();
    return body;
}

/// In place of function_block_body: nothing at all between declarations and closing word. With a
/// line end there it is an instruction list of one empty line, without one it is no body.
const ast::Body* Parser::parse_empty_body() {
    auto* body = make<ast::InstructionList>();
    end_ = at_;
    if (!token().first_on_line() && !at_end())
        report_missing(DiagnosticId::empty_body).insert(previous_end(), " ;");
    return body;
}

} // namespace iecfront
