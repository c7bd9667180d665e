#include "parser/parser.hpp"

#include <iecfront/lexer/standard_names.hpp>

#include <utility>

namespace iecfront {
namespace {

constexpr TokenSet statement_closers{TokenKind::kw_end_if, TokenKind::kw_end_case,
                                     TokenKind::kw_end_for, TokenKind::kw_end_while,
                                     TokenKind::kw_end_repeat};

constexpr TokenSet other_closers{TokenKind::kw_end_struct,     TokenKind::kw_end_var,
                                 TokenKind::kw_end_resource,   TokenKind::kw_end_step,
                                 TokenKind::kw_end_transition, TokenKind::kw_end_action};

constexpr TokenSet library_element_closers{
    TokenKind::kw_end_type,    TokenKind::kw_end_function,      TokenKind::kw_end_function_block,
    TokenKind::kw_end_program, TokenKind::kw_end_configuration, TokenKind::end_of_unit};

constexpr TokenSet block_statements{TokenKind::kw_if, TokenKind::kw_case, TokenKind::kw_for,
                                    TokenKind::kw_while, TokenKind::kw_repeat};

constexpr TokenSet declaration_words = TokenSet::range(TokenKind::kw_var, TokenKind::kw_var_config);

// Words between the parts of a statement.
constexpr TokenSet part_words{TokenKind::kw_then, TokenKind::kw_do, TokenKind::kw_of,
                              TokenKind::kw_to, TokenKind::kw_by};

} // namespace

// ---- statement lists ----------------------------------------------------------------------------

// statement_list = statement ";" { statement ";" } ;
const ast::StatementList* Parser::parse_statement_list(std::string_view where) {
    auto* list = make<ast::StatementList>();
    ListBuilder<ast::Statement> statements(*this);
    parse_statements(statements);
    list->statements = statements.finish();
    finish(list);
    check_not_empty(*list, where);
    return list;
}

void Parser::check_not_empty(const ast::StatementList& list, std::string_view where) {
    if (list.statements.empty())
        report_missing(DiagnosticId::empty_statement_list, {std::string(where)})
            .insert(previous_end(), " ;");
}

void Parser::parse_statements(ListBuilder<ast::Statement>& statements) {
    while (!at_end_of_statements()) {
        if (at(statement_closers) || at(other_closers) || at(TokenKind::kw_else) ||
            at(TokenKind::kw_elsif) || at(TokenKind::kw_until) || at_split_closer()) {
            skip_stray_word();
            continue;
        }
        const ast::Statement* statement = nullptr;
        add_in_loop(statements, [&] { return statement = parse_statement(); });
        if (const ast::Statement* rest = expect_semicolon_of_statement(*statement))
            statements.add(rest);
    }
}

/// True when what follows belongs to something that is open further out, or closes this list.
bool Parser::at_end_of_statements() {
    if (at(library_element_closers))
        return true;
    const TokenKind innermost = open_.back().closer;
    if (at(statement_closers) || at(other_closers))
        return is_open(kind()) ||
               (statement_closers.contains(innermost) && unclosed(innermost) > 0);
    switch (kind()) {
    case TokenKind::kw_else:
        return is_open(TokenKind::kw_end_if) || is_open(TokenKind::kw_end_case);
    case TokenKind::kw_elsif: return is_open(TokenKind::kw_end_if);
    case TokenKind::kw_until: return is_open(TokenKind::kw_end_repeat);
    default: break;
    }
    if (innermost == TokenKind::kw_end_case && at_case_label())
        return true;
    // A label inside another statement: that statement is not closed.
    if (token().first_on_line() && is_open(TokenKind::kw_end_case) && at_case_label() &&
        unclosed(innermost) > 0)
        return true;
    return at_misspelt_closer() && unclosed(innermost) > 0;
}

/// `END IF` and its like.
bool Parser::at_split_closer() const noexcept {
    return at_word("END") && block_statements.contains(peek()) &&
           !tokens_[next(at_)].first_on_line();
}

/// A closing word, or another word inside a statement, of which nothing is open.
void Parser::skip_stray_word() {
    const std::uint32_t first = at_;
    Report stray = report_at(at_, DiagnosticId::stray_closing_word, {std::string(text(at_))});
    if (at_split_closer())
        advance();
    const bool has_condition = at(TokenKind::kw_elsif) || at(TokenKind::kw_until);
    advance();
    if (has_condition) {
        parse_condition();
        accept(TokenKind::kw_then);
    }
    if (tokens_[first].kind() != TokenKind::kw_else)
        accept(TokenKind::semicolon);
    stray.remove(token_range(first, end_));
}

const ast::ErrorStatement* Parser::expect_semicolon_of_statement(const ast::Statement& statement) {
    const bool assumed = std::exchange(closer_assumed_, false);
    if (accept(TokenKind::semicolon) || assumed || statement.kind == ast::NodeKind::error_statement)
        return nullptr;
    // On the same line a name begins a statement only when an assignment follows: an operator may
    // just as well be missing.
    const bool statement_follows =
        at_statement_start() && (is_keyword(kind()) || peek() == TokenKind::assign);
    const bool missing = token().first_on_line() || statement_follows || at(part_words) ||
                         at(declaration_words) || at_end_of_statements() || at(statement_closers) ||
                         at(TokenKind::kw_else) || at(TokenKind::kw_elsif) ||
                         at(TokenKind::kw_until);
    if (missing) {
        report_missing(DiagnosticId::missing_semicolon).insert(previous_end(), ";");
        return nullptr;
    }
    report_unexpected("an operator or `;`");
    const ast::ErrorStatement* rest = skip_statement();
    accept(TokenKind::semicolon);
    return rest;
}

// ---- statements ---------------------------------------------------------------------------------

// statement = NIL | assignment_statement | subprogram_control_statement | selection_statement
//           | iteration_statement ;
const ast::Statement* Parser::parse_statement() {
    if (at(block_statements)) {
        const NestingGuard guard(*this);
        if (guard.too_deep())
            return parse_too_deep_statement();
        switch (kind()) {
        case TokenKind::kw_if: return parse_if_statement();
        case TokenKind::kw_case: return parse_case_statement();
        case TokenKind::kw_for: return parse_for_statement();
        case TokenKind::kw_while: return parse_while_statement();
        default: return parse_repeat_statement();
        }
    }
    switch (kind()) {
    case TokenKind::semicolon: return make<ast::EmptyStatement>();
    case TokenKind::kw_return:
    case TokenKind::kw_exit: return parse_word_statement();
    default: break;
    }
    if (at(declaration_words))
        return parse_misplaced_declarations();
    const bool name = at_operand_keyword() || (is_keyword(kind()) && used_as_name(kind()));
    if (at_expression_start() || name)
        return parse_simple_statement();
    if (at(part_words)) {
        auto* stray = make<ast::ErrorStatement>();
        report_at(at_, DiagnosticId::not_a_statement, {quoted(at_)}).remove(token().range());
        advance();
        return finish(stray);
    }
    report_at(at_, DiagnosticId::not_a_statement, {quoted(at_)});
    return skip_statement();
}

const ast::Statement* Parser::parse_misplaced_declarations() {
    auto* error = make<ast::ErrorStatement>();
    report_at(at_, DiagnosticId::declaration_after_body);
    parse_variable_declarations(place_);
    return finish(error);
}

/// Passes over a statement that is nested too deep, up to its closing word.
const ast::Statement* Parser::parse_too_deep_statement() {
    auto* error = make<ast::ErrorStatement>();
    std::uint32_t depth = 0;
    do {
        depth += at(block_statements) ? 1 : 0;
        depth -= at(statement_closers) && depth > 0 ? 1 : 0;
        advance();
    } while (depth > 0 && !at(library_element_closers));
    return finish(error);
}

// subprogram_control_statement = fb_invocation | "RETURN" ;
// exit_statement = "EXIT" ;
const ast::Statement* Parser::parse_word_statement() {
    if (at(TokenKind::kw_exit)) {
        auto* exit = make<ast::ExitStatement>();
        advance();
        return finish(exit);
    }
    auto* node = make<ast::ReturnStatement>();
    advance();
    return finish(node);
}

/// What begins with a variable: an assignment or the invocation of a function block.
const ast::Statement* Parser::parse_simple_statement() {
    const std::size_t reports = diagnostics_.size();
    const bool variable = at(TokenKind::identifier) || at_operand_keyword() || used_as_name(kind());
    if (!variable && !at(TokenKind::direct_variable)) {
        const ast::Expression* expression = parse_expression();
        return at(TokenKind::assign) ? parse_assignment(expression)
                                     : finish_expression_statement(expression, reports);
    }
    const std::uint32_t first = at_;
    const ast::Expression* left = variable ? parse_variable() : parse_direct_variable();
    static constexpr TokenSet assigns{TokenKind::assign, TokenKind::equal, TokenKind::colon};
    if (at(assigns))
        return parse_assignment(left);
    if (const auto* call = ast::as<ast::FunctionCall>(left);
        call != nullptr && operator_strength(kind()) == 0)
        return make_invocation(*call);
    const ast::Expression* expression = parse_binary_rest(left, 1);
    static constexpr TokenSet words_of_other_languages{TokenKind::identifier, TokenKind::integer};
    if (at(TokenKind::semicolon) || !at(words_of_other_languages) || reported_at_ == at_)
        return finish_expression_statement(expression, reports);
    // Two names in a row: neither an assignment nor an invocation.
    auto* error = make<ast::ErrorStatement>();
    error->first_token = first;
    report_unexpected("`:=` or `(`");
    skip_statement();
    return finish(error);
}

// assignment_statement = variable ":=" expression ;
const ast::Statement* Parser::parse_assignment(const ast::Expression* variable) {
    auto* node = make_from<ast::AssignmentStatement>(variable);
    if (!is_variable(*variable))
        report_node(*variable, DiagnosticId::unexpected_token,
                    {"a variable before `:=`",
                     ast::is<ast::Constant>(variable->kind) ? "a constant" : "an expression"});
    expect_assign();
    node->variable = variable;
    node->expression = parse_expression();
    return finish(node);
}

bool Parser::is_variable(const ast::Expression& expression) noexcept {
    switch (expression.kind) {
    case ast::NodeKind::variable_name:
    case ast::NodeKind::array_variable:
    case ast::NodeKind::structured_variable:
    case ast::NodeKind::direct_variable:
    case ast::NodeKind::error_expression: return true;
    default: return false;
    }
}

/// `:=`, or what is written instead of it by mistake.
void Parser::expect_assign() {
    const std::uint32_t first = at_;
    if (accept(TokenKind::assign))
        return;
    if (at(TokenKind::equal)) {
        report_at(at_, DiagnosticId::equal_for_assignment).replace(token().range(), ":=");
        advance();
    } else if (at(TokenKind::colon) && peek() == TokenKind::equal) {
        const TextRange gap{token().end(), tokens_[next(at_)].offset()};
        report_at(at_, DiagnosticId::white_space_in_delimiter, {":="}).remove(gap);
        advance();
        advance();
    } else if (at(TokenKind::colon)) {
        report_unexpected("`:=`").replace(token().range(), ":=");
        advance();
    } else {
        expect(TokenKind::assign);
        return;
    }
    reported_at_ = first; // what follows is reported on its own
}

// fb_invocation = fb_name "(" [ param_assignment { "," param_assignment } ] ")" ;
const ast::Statement* Parser::make_invocation(const ast::FunctionCall& call) {
    auto* node = make_from<ast::FbInvocation>(&call);
    node->fb_name = call.function;
    node->arguments = call.arguments;
    finish(node);
    if (call.function->kind != ast::NodeKind::variable_name) {
        report_node(*call.function, DiagnosticId::call_of_member,
                    {call.function->kind == ast::NodeKind::array_variable
                         ? "an array element"
                         : "a member or a result"});
    } else if (const std::string name(text(call.function->first_token));
               standard_name(name) == StandardName::function) {
        report_node(*call.function, DiagnosticId::function_call_statement, {name});
    }
    return node;
}

/// `reports` is how many there were before the statement: what is wrong inside goes first.
const ast::Statement* Parser::finish_expression_statement(const ast::Expression* expression,
                                                          std::size_t reports) {
    auto* node = make_from<ast::ExpressionStatement>(expression);
    node->expression = expression;
    finish(node);
    if (diagnostics_.size() == reports && reported_at_ != at_)
        report_node(*expression, DiagnosticId::expression_statement);
    return node;
}

// ---- selection ----------------------------------------------------------------------------------

// if_statement = "IF" expression "THEN" statement_list
//                { "ELSIF" expression "THEN" statement_list }
//                [ "ELSE" statement_list ]
//                "END_IF" ;
const ast::Statement* Parser::parse_if_statement() {
    auto* node = make<ast::IfStatement>();
    open_block(TokenKind::kw_end_if, advance());
    node->condition = parse_condition();
    expect_word(TokenKind::kw_then);
    node->then_list = parse_statement_list("after THEN");
    ListBuilder<ast::ElsifClause> clauses(*this);
    while (open_.back().closer == TokenKind::kw_end_if) {
        const bool elsif = at(TokenKind::kw_elsif) || at_else_if_for_elsif();
        if (!elsif && (!at(TokenKind::kw_else) || node->else_list != nullptr))
            break;
        if (node->else_list != nullptr)
            report_at(at_, DiagnosticId::stray_closing_word, {std::string(text(at_))});
        if (elsif) {
            clauses.add(parse_elsif_clause());
        } else {
            advance();
            node->else_list = parse_statement_list("after ELSE");
        }
    }
    node->elsif_clauses = clauses.finish();
    close_block(";");
    return finish(node);
}

// "ELSIF" expression "THEN" statement_list
const ast::ElsifClause* Parser::parse_elsif_clause() {
    auto* clause = make<ast::ElsifClause>();
    if (at(TokenKind::kw_else)) {
        const TextRange both{token().offset(), tokens_[next(at_)].end()};
        report(DiagnosticId::else_if, both).replace(both, "ELSIF");
        --unclosed(TokenKind::kw_end_if);
        advance();
    }
    advance();
    clause->condition = parse_condition();
    expect_word(TokenKind::kw_then);
    clause->statements = parse_statement_list("after THEN");
    return finish(clause);
}

/// At `ELSE IF` on one line: true when ELSIF is meant. That is so when some IF of the unit is not
/// closed, and the END_IF of this chain is not followed by another one for the IF around it.
bool Parser::at_else_if_for_elsif() {
    if (!at(TokenKind::kw_else) || peek() != TokenKind::kw_if || tokens_[next(at_)].first_on_line())
        return false;
    if (unclosed(TokenKind::kw_end_if) <= 0)
        return false;
    if (at_ < else_if_chain_end_ && else_if_block_ == open_.back().opener)
        return else_if_means_elsif_;
    std::uint32_t end = next(next(at_));
    for (std::uint32_t depth = 0; !library_element_closers.contains(tokens_[end].kind());
         end = next(end)) {
        if (tokens_[end].kind() == TokenKind::kw_if)
            depth += tokens_[end - 1].kind() == TokenKind::kw_else ? 0 : 1;
        else if (tokens_[end].kind() == TokenKind::kw_end_if && depth-- == 0)
            break;
    }
    else_if_chain_end_ = end;
    else_if_block_ = open_.back().opener;
    else_if_means_elsif_ = !followed_by_end_if_of(end, open_.back().opener);
    return else_if_means_elsif_;
}

/// True when a second END_IF stands directly behind the one at `end`, and is not, by its column,
/// the one of a block around the IF at `opener`.
bool Parser::followed_by_end_if_of(std::uint32_t end, std::uint32_t opener) const noexcept {
    std::uint32_t second = next(end);
    if (tokens_[second].kind() == TokenKind::semicolon)
        second = next(second);
    if (tokens_[second].kind() != TokenKind::kw_end_if)
        return false;
    const bool columns_tell = tokens_[end].first_on_line() && tokens_[second].first_on_line() &&
                              tokens_[opener].first_on_line();
    return !columns_tell || column(end) != column(opener) || column(second) == column(opener);
}

// case_statement = "CASE" expression "OF"
//                  case_element { case_element }
//                  [ "ELSE" statement_list ]
//                  "END_CASE" ;
const ast::Statement* Parser::parse_case_statement() {
    auto* node = make<ast::CaseStatement>();
    open_block(TokenKind::kw_end_case, advance());
    node->selector = parse_condition();
    expect_word(TokenKind::kw_of);
    ListBuilder<ast::CaseElement> elements(*this);
    do
        elements.add(parse_case_element());
    while (at_case_label() || !at_end_of_statements());
    if (accept(TokenKind::kw_else))
        node->else_list = parse_statement_list("after ELSE");
    node->elements = elements.finish();
    close_block(";");
    return finish(node);
}

/// True when a label begins here: a constant or name with `:`, `,` or `..` behind it.
bool Parser::at_case_label() const noexcept {
    std::uint32_t label = at_;
    if (at(TokenKind::minus) || at(TokenKind::plus))
        label = next(label);
    const TokenKind here = tokens_[label].kind();
    const bool value = here == TokenKind::identifier || here == TokenKind::enumerated_value ||
                       (here >= TokenKind::integer && here <= TokenKind::date_and_time) ||
                       here == TokenKind::kw_true || here == TokenKind::kw_false ||
                       TokenSet::range(TokenKind::kw_bool, TokenKind::kw_date).contains(here) ||
                       used_as_name(here);
    if (!value)
        return false;
    const std::uint32_t after = next(label);
    switch (tokens_[after].kind()) {
    case TokenKind::colon: return tokens_[next(after)].kind() != TokenKind::equal;
    case TokenKind::comma:
    case TokenKind::dot_dot: return true;
    default: return false;
    }
}

// case_element = case_list ":" statement_list ;
// case_list = case_list_element { "," case_list_element } ;
const ast::CaseElement* Parser::parse_case_element() {
    auto* element = make<ast::CaseElement>();
    // A number begins no statement: its `:` is missing.
    if (at_case_label() || at(TokenKind::integer)) {
        ListBuilder<ast::Node> labels(*this);
        do
            labels.add(parse_case_label());
        while (accept(TokenKind::comma));
        element->labels = labels.finish();
        expect(TokenKind::colon);
    } else {
        report_unexpected("a CASE label");
    }
    element->statements = parse_statement_list("after a CASE label");
    return finish(element);
}

// case_list_element = subrange | signed_integer | enumerated_value ;
const ast::Node* Parser::parse_case_label() {
    const TokenKind after = peek();
    const bool simple = after == TokenKind::colon || after == TokenKind::comma;
    if (simple && (at(TokenKind::identifier) || at(TokenKind::enumerated_value)))
        return parse_enumerated_value();
    const std::uint32_t first = at_;
    const ast::Expression* label = parse_constant_label();
    if (!at(TokenKind::dot_dot))
        return label;
    auto* range = make<ast::Subrange>();
    range->first_token = first;
    advance();
    range->lower = label;
    range->upper = parse_constant_label();
    return finish(range);
}

const ast::Expression* Parser::parse_constant_label() {
    const ast::Expression* label = parse_expression();
    if (label->missing || is_signed_integer(*label) ||
        label->kind == ast::NodeKind::error_expression)
        return label;
    report_node(*label, DiagnosticId::case_label,
                {label->kind == ast::NodeKind::variable_name ? "a named constant"
                 : ast::is<ast::Constant>(label->kind)       ? "a literal of this form"
                                                             : "an expression"});
    return label;
}

// ---- iteration ----------------------------------------------------------------------------------

// for_statement = "FOR" control_variable ":=" for_list "DO" statement_list "END_FOR" ;
// control_variable = identifier ;
// for_list = expression "TO" expression [ "BY" expression ] ;
const ast::Statement* Parser::parse_for_statement() {
    auto* node = make<ast::ForStatement>();
    open_block(TokenKind::kw_end_for, advance());
    const bool variable = at(TokenKind::identifier) || at_operand_keyword() || used_as_name(kind());
    node->control_variable = variable                         ? parse_variable()
                             : at(TokenKind::direct_variable) ? parse_direct_variable()
                                                              : parse_missing_expression();
    if (!node->control_variable->missing &&
        node->control_variable->kind != ast::NodeKind::variable_name)
        report_node(*node->control_variable, DiagnosticId::control_variable);
    expect_assign();
    node->from = parse_expression();
    expect_word(TokenKind::kw_to);
    node->to = parse_expression();
    if (accept(TokenKind::kw_by))
        node->by = parse_expression();
    expect_word(TokenKind::kw_do);
    node->statements = parse_statement_list("after DO");
    close_block(";");
    return finish(node);
}

// while_statement = "WHILE" expression "DO" statement_list "END_WHILE" ;
const ast::Statement* Parser::parse_while_statement() {
    auto* node = make<ast::WhileStatement>();
    open_block(TokenKind::kw_end_while, advance());
    node->condition = parse_condition();
    expect_word(TokenKind::kw_do);
    node->statements = parse_statement_list("after DO");
    close_block(";");
    return finish(node);
}

// repeat_statement = "REPEAT" statement_list "UNTIL" expression "END_REPEAT" ;
const ast::Statement* Parser::parse_repeat_statement() {
    auto* node = make<ast::RepeatStatement>();
    open_block(TokenKind::kw_end_repeat, advance());
    node->statements = parse_statement_list("after REPEAT");
    if (expect(TokenKind::kw_until)) {
        node->condition = parse_condition();
        if (at(TokenKind::semicolon) && peek() == TokenKind::kw_end_repeat) {
            report_unexpected("`END_REPEAT`").remove(token().range());
            advance();
        }
    } else {
        node->condition = make_missing<ast::ErrorExpression>();
    }
    close_block(";");
    return finish(node);
}

/// A word between the parts of a statement, or another such word in its place.
void Parser::expect_word(TokenKind word) {
    if (at(part_words) && !at(word) && peek() != word) {
        report_unexpected("`" + std::string(spelling(word)) + "`")
            .replace(token().range(), std::string(spelling(word)));
        advance();
        return;
    }
    if (expect(word))
        return;
    // What stands between here and the word on the same line was meant to be part of the head.
    std::uint32_t i = at_;
    while (!tokens_[i].first_on_line() && tokens_[i].kind() != word &&
           tokens_[i].kind() != TokenKind::semicolon && i < count_)
        i = next(i);
    if (tokens_[i].kind() != word || tokens_[i].first_on_line())
        return;
    while (at_ < i)
        advance();
    advance();
}

} // namespace iecfront
