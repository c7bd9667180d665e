#include "ast/unused_nodes.hpp"
#include "parser/misspelling.hpp"
#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/standard_names.hpp>

#include <algorithm>
#include <utility>

namespace iecfront {
namespace {

// Of what can hold statements.
constexpr TokenSet inner_closers = statement_closers | TokenSet{TokenKind::kw_end_action};

// Close or part something, which is not open where they stand for a statement.
constexpr TokenSet stray_words =
    statement_closers | other_closers |
    TokenSet{TokenKind::kw_else, TokenKind::kw_elsif, TokenKind::kw_until};

} // namespace

// ---- statement lists ----------------------------------------------------------------------------

// statement_list = statement ";" { statement ";" } ;
const ast::StatementList* Parser::parse_statement_list(std::string_view where) {
    auto* list = make<ast::StatementList>();
    ListBuilder<ast::Statement> statements(*this);
    open_.back().first_statement = at_;
    parse_statements(statements);
    list->statements = statements.finish();
    finish(list);
    if (list->statements.empty())
        report_empty_list(where);
    return list;
}

void Parser::report_empty_list(std::string_view where) {
    report_missing(DiagnosticId::empty_statement_list, {where}).insert(previous_end(), " ;");
}

// Part of statement_list: { statement ";" }
/// All statements of a list.
void Parser::parse_statements(ListBuilder<ast::Statement>& statements) {
    for (;;) {
        const ast::Statement* statement = nullptr;
        if (at_plain_assignment() && balanced())
            statements.add(statement = parse_plain_assignment());
        else if (at(open_.back().closer) || at_end_of_statements())
            return;
        else
            statement = parse_statement_or_stray_word(statements);
        if (statement == nullptr)
            continue;
        if (at(TokenKind::semicolon)) {
            closer_assumed_ = false;
            advance();
        } else if (const ast::Statement* rest = expect_semicolon_of_statement(*statement)) {
            statements.add(rest);
        }
    }
}

/// Part of statement_list: a statement; null when it was no whole one.
const ast::Statement*
Parser::parse_statement_or_stray_word(ListBuilder<ast::Statement>& statements) {
    const bool if_part = at(TokenKind::kw_else) || at(TokenKind::kw_elsif);
    if (if_part && !open_.back().in_else && unclosed(TokenKind::kw_end_if) < 0) {
        const ast::Statement* rest_of_if = parse_if_without_head();
        statements.add(rest_of_if);
        expect_semicolon_of_statement(*rest_of_if);
        return nullptr;
    }
    if (at(stray_words) || at_split_closer()) {
        skip_stray_word(statements.empty());
        return nullptr;
    }
    const ast::Statement* statement = nullptr;
    add_in_loop(statements, [&] { return statement = parse_statement(); });
    return statement;
}

/// `name :=` begins an assignment, and no word that closes or parts a statement is misspelt so.
bool Parser::at_plain_assignment() const noexcept {
    return at(TokenKind::identifier) && tokens_[at_ + 1].kind() == TokenKind::assign;
}

/// True when what follows belongs to something that is open further out, or closes this list.
bool Parser::at_end_of_statements() {
    // CASE may be a label's that is repeated, and WHILE may stand for UNTIL.
    static constexpr TokenSet plain_statements{TokenKind::kw_if, TokenKind::kw_for,
                                               TokenKind::kw_repeat};
    if (at(open_.back().closer))
        return true;
    if (at_plain_assignment() || at(plain_statements))
        return unclosed(open_.back().closer) > 0 && at_outdented_statement();
    if (at(unit_ends) || (!balanced() && at_foreign_closer()) || at_chart_structure())
        return true;
    const TokenKind innermost = open_.back().closer;
    if (at(statement_closers) || at(other_closers))
        return is_open(kind()) || (inner_closers.contains(innermost) && unclosed(innermost) > 0);
    switch (kind()) {
    case TokenKind::kw_else:
        return open_.back().in_else
                   ? belongs_to_outer_if()
                   : is_open(TokenKind::kw_end_if) || is_open(TokenKind::kw_end_case);
    case TokenKind::kw_elsif:
        return open_.back().in_else ? belongs_to_outer_if() : is_open(TokenKind::kw_end_if);
    case TokenKind::kw_until: return is_open(TokenKind::kw_end_repeat);
    default: break;
    }
    if (innermost == TokenKind::kw_end_case &&
        (at_case_label() || at_repeated_case() || at_label_without_colon()))
        return !open_.back().in_else;
    if ((innermost == TokenKind::kw_end_if && (at_misspelt_elsif() || at_missing_elsif())) ||
        at_misspelt_else() || at_misspelt_until() || at_while_for_until() ||
        at_condition_without_until())
        return true;
    if (unclosed(innermost) <= 0)
        return false;
    // A label inside another statement: that statement is not closed.
    if ((token().first_on_line() || at(TokenKind::integer)) && is_open(TokenKind::kw_end_case) &&
        at_case_label())
        return true;
    return at_misspelt_closer() || at_outdented_statement();
}

/// At a statement that by its column stands behind the innermost block.
bool Parser::at_outdented_statement() noexcept {
    OpenBlock& block = open_.back();
    if (block.first_statement != no_token) { // asked for the first time
        const bool lines = statement_closers.contains(block.closer) &&
                           tokens_[block.first_statement].first_on_line() &&
                           tokens_[block.opener].first_on_line();
        const bool indented = lines && column(block.first_statement) > column(block.opener);
        block.column = indented ? column(block.opener) : OpenBlock::not_indented;
        block.first_statement = no_token;
    }
    return block.column != OpenBlock::not_indented && token().first_on_line() &&
           at_statement_start() && column(at_) <= block.column;
}

/// At ELSE or ELSIF after the ELSE of the innermost statement: true when it is for another one,
/// because the innermost is not closed.
bool Parser::belongs_to_outer_if() noexcept {
    if (unclosed(open_.back().closer) <= 0)
        return false;
    return std::any_of(open_.rbegin() + 1, open_.rend(), [this](const OpenBlock& block) {
        return !block.in_else &&
               (block.closer == TokenKind::kw_end_if ||
                (block.closer == TokenKind::kw_end_case && at(TokenKind::kw_else)));
    });
}

/// `ELSEIF`, `ELIF` and the like, with its THEN.
bool Parser::at_misspelt_elsif() const noexcept {
    return at(TokenKind::identifier) && !open_.back().in_else && peek() != TokenKind::assign &&
           is_misspelling(text(at_), spelling(TokenKind::kw_elsif)) &&
           find_on_line(TokenKind::kw_then) < count_;
}

/// `b = 2 THEN` on a line of its own, where no IF is missing.
bool Parser::at_missing_elsif() noexcept {
    return (begins_operand(kind()) || at(TokenKind::left_parenthesis) || at(TokenKind::kw_not)) &&
           token().first_on_line() && !open_.back().in_else && !at_assignment_on_new_line() &&
           unclosed(TokenKind::kw_end_if) >= 0 && find_on_line(TokenKind::kw_then) < count_;
}

/// `ELS` and the like, on a line of its own or before a statement.
bool Parser::at_misspelt_else() const noexcept {
    const TokenKind innermost = open_.back().closer;
    return at(TokenKind::identifier) && !open_.back().in_else &&
           (innermost == TokenKind::kw_end_if || innermost == TokenKind::kw_end_case) &&
           (tokens_[next(at_)].first_on_line() ? !at_statement_start()
                                               : peek() == TokenKind::identifier) &&
           is_misspelling(text(at_), spelling(TokenKind::kw_else));
}

/// `UNTILL` and the like, with its condition.
bool Parser::at_misspelt_until() const noexcept {
    return at(TokenKind::identifier) && open_.back().closer == TokenKind::kw_end_repeat &&
           is_misspelling(text(at_), spelling(TokenKind::kw_until)) &&
           begins_operand_on_line(next(at_));
}

/// `WHILE condition;` before END_REPEAT, as other languages end this loop.
bool Parser::at_while_for_until() {
    return at(TokenKind::kw_while) && open_.back().closer == TokenKind::kw_end_repeat &&
           unclosed(TokenKind::kw_end_while) > 0 && find_on_line(TokenKind::kw_do) == count_;
}

/// A condition as the last statement before END_REPEAT: an operation, or a variable alone. The
/// first statement of the list is none, for that list must not be empty.
bool Parser::at_condition_without_until() const noexcept {
    static constexpr TokenSet words_of_conditions{TokenKind::kw_not, TokenKind::kw_true,
                                                  TokenKind::kw_false};
    static constexpr TokenSet marks_of_statements{TokenKind::assign, TokenKind::output_arrow,
                                                  TokenKind::colon};
    const OpenBlock& block = open_.back();
    if (block.closer != TokenKind::kw_end_repeat || at_ == next(block.opener) ||
        !(begins_operand(kind()) || at(TokenKind::kw_not)))
        return false;
    bool is_condition = !at(TokenKind::left_parenthesis) && peek() != TokenKind::left_parenthesis;
    std::uint32_t depth = 0;
    std::uint32_t i = at_;
    for (std::uint32_t steps = 0; steps < furthest_on_line; i = next(i), ++steps) {
        const TokenKind here = tokens_[i].kind();
        const bool operation = operator_strength(here) > 0;
        const bool in_expression =
            operation || !is_keyword(here) || words_of_conditions.contains(here);
        if (here == TokenKind::semicolon || !in_expression ||
            (depth == 0 && marks_of_statements.contains(here)))
            break;
        depth += here == TokenKind::left_parenthesis ? 1 : 0;
        depth -= here == TokenKind::right_parenthesis && depth > 0 ? 1 : 0;
        is_condition = is_condition || (operation && depth == 0);
    }
    if (tokens_[i].kind() == TokenKind::semicolon)
        i = next(i);
    return is_condition && tokens_[i].kind() == TokenKind::kw_end_repeat;
}

bool Parser::begins_operand_on_line(std::uint32_t index) const noexcept {
    const TokenKind here = tokens_[index].kind();
    return !tokens_[index].first_on_line() && (begins_operand(here) || here == TokenKind::kw_not);
}

/// The place of `word` further on in this line, before any `;`; the end when it is not there.
std::uint32_t Parser::find_on_line(TokenKind word) const noexcept {
    std::uint32_t steps = 0;
    for (std::uint32_t i = at_; i < count_ && steps < furthest_on_line; i = next(i), ++steps) {
        if (tokens_[i].kind() == word)
            return i;
        if (tokens_[i].kind() == TokenKind::semicolon ||
            (i > at_ && ((tokens_[i].first_on_line() && !joined_by_operator(i)) ||
                         statement_words.contains(tokens_[i].kind()))))
            break;
    }
    return count_;
}

/// True when an operator goes on with the line before: `a AND` or, on the next line, `AND a`.
bool Parser::joined_by_operator(std::uint32_t index) const noexcept {
    return operator_strength(tokens_[index].kind()) > 0 ||
           (index > 0 && operator_strength(tokens_[index - 1].kind()) > 0);
}

/// `END IF` and its like.
bool Parser::at_split_closer() const noexcept {
    return at_word("END") && block_statements.contains(peek()) &&
           !tokens_[next(at_)].first_on_line();
}

/// The first of the lines above the cursor that all begin further right; the cursor when not even
/// the last one does.
std::uint32_t Parser::first_indented_above() const noexcept {
    constexpr std::uint32_t furthest = 500; // tokens, for the time that many such words take
    const std::uint32_t limit = column(at_);
    std::uint32_t first = at_;
    for (std::uint32_t i = at_; i > open_.back().opener && at_ - i < furthest; --i) {
        if (!tokens_[i - 1].first_on_line())
            continue;
        if (column(i - 1) <= limit)
            return first;
        first = i - 1;
    }
    return at_;
}

/// Where statements stand further right than the word behind them, which closes nothing that is
/// open, the head of their block is missing before them.
bool Parser::report_missing_head(TokenKind closer) {
    struct Head {
        TokenKind closer;
        const char* words;
    };
    static constexpr Head heads[] = {
        {TokenKind::kw_end_if, "`IF` with a condition and `THEN`"},
        {TokenKind::kw_end_for, "`FOR` with its control variable and `DO`"},
        {TokenKind::kw_end_while, "`WHILE` with a condition and `DO`"},
    };
    const Head* const head = std::find_if(std::begin(heads), std::end(heads),
                                          [closer](Head one) { return one.closer == closer; });
    if (head == std::end(heads) || !token().first_on_line() || reported_at_ == at_)
        return false;
    const std::uint32_t first = first_indented_above();
    if (first == at_)
        return false;
    // In a block that begins there: it stands further right than that block.
    const TokenKind before = tokens_[first - 1].kind();
    const bool in_block = is_keyword(before) && column(at_) > column(open_.back().opener);
    if (before != TokenKind::semicolon && !in_block)
        return false;
    const std::uint32_t offset = tokens_[first - 1].end();
    reported_at_ = at_;
    report(DiagnosticId::missing_token, {offset, offset}, {head->words});
    return true;
}

/// A closing word, or another word inside a statement, of which nothing is open. When it is all
/// that stands in the list, the empty statement is put in its place.
void Parser::skip_stray_word(bool first_in_list) {
    const std::uint32_t first = at_;
    if (report_missing_head(kind())) {
        advance();
        accept(TokenKind::semicolon);
        return;
    }
    const bool after_else =
        open_.back().in_else && (at(TokenKind::kw_else) || at(TokenKind::kw_elsif));
    Report stray = after_else
                       ? report_unexpected("`" + std::string(spelling(open_.back().closer)) + "`")
                       : report_at(at_, DiagnosticId::stray_closing_word, {text(at_)});
    if (at_split_closer())
        advance();
    const bool has_condition = at(TokenKind::kw_elsif) || at(TokenKind::kw_until);
    advance();
    if (has_condition) {
        parse_condition();
        accept(tokens_[first].kind() == TokenKind::kw_until ? TokenKind::kw_end_repeat
                                                            : TokenKind::kw_then);
    }
    if (tokens_[first].kind() != TokenKind::kw_else)
        accept(TokenKind::semicolon);
    if (first_in_list && at_end_of_statements()) {
        stray.replace(token_range(first, end_), ";");
        reported_at_ = at_;
    } else if (!after_else || !has_condition) { // else the statements would lose their condition
        stray.remove(token_range(first, end_));
    }
}

const ast::ErrorStatement* Parser::expect_semicolon_of_statement(const ast::Statement& statement) {
    const bool assumed = std::exchange(closer_assumed_, false);
    if (assumed || statement.kind == ast::NodeKind::error_statement) {
        accept(TokenKind::semicolon);
        return nullptr;
    }
    if (accept_semicolon())
        return nullptr;
    // On the same line a name begins a statement only when an assignment follows: an operator may
    // just as well be missing.
    const bool statement_follows =
        at_statement_start() && (is_keyword(kind()) || peek() == TokenKind::assign);
    if (at(statement_closers) && !is_open(kind()) && tokens_[end_ - 1].kind() == kind()) {
        report_at(at_, DiagnosticId::stray_closing_word, {text(at_)}).remove(token().range());
        advance();
        accept(TokenKind::semicolon);
        return nullptr;
    }
    const bool closed_too_early = at(TokenKind::kw_else) && !token().first_on_line() &&
                                  tokens_[end_ - 1].kind() == TokenKind::kw_end_if &&
                                  !is_open(TokenKind::kw_end_if);
    if (closed_too_early) {
        report_unexpected("`;`");
        return nullptr;
    }
    const bool condition_behind = at_condition_behind_statement();
    if (condition_behind)
        count_as_name(kind()); // it opens nothing
    const bool missing = (token().first_on_line() && !at_semicolon_look_alike()) ||
                         (statement_follows && !condition_behind) || at(part_words) ||
                         at(block_openers) || at_end_of_statements() || at(statement_closers) ||
                         at(TokenKind::kw_else) || at(TokenKind::kw_elsif) ||
                         at(TokenKind::kw_until);
    if (missing) {
        report_missing_semicolon();
        return nullptr;
    }
    const bool has_expression = statement.kind == ast::NodeKind::assignment_statement ||
                                statement.kind == ast::NodeKind::expression_statement;
    Report unexpected = report_unexpected(has_expression ? "an operator or `;`" : "`;`");
    for (std::uint32_t i = at_; closing_brackets.contains(tokens_[i].kind()); i = next(i))
        if (i > at_)
            unexpected.also_remove(tokens_[i].range());
    const ast::ErrorStatement* rest = skip_statement();
    accept(TokenKind::semicolon);
    return rest;
}

/// `x := 1 IF a;`, as other languages have it.
bool Parser::at_condition_behind_statement() {
    return at(TokenKind::kw_if) && !token().first_on_line() && unclosed(TokenKind::kw_end_if) > 0 &&
           find_on_line(TokenKind::kw_then) == count_ &&
           find_on_line(TokenKind::semicolon) < count_;
}

// ---- statements ---------------------------------------------------------------------------------

// statement = NIL | assignment_statement | subprogram_control_statement | selection_statement
//           | iteration_statement ;
// selection_statement = if_statement | case_statement ;
// iteration_statement = for_statement | while_statement | repeat_statement | exit_statement ;
const ast::Statement* Parser::parse_statement() {
    if (at_plain_assignment() && missing_opener() == TokenKind::end_of_unit)
        return parse_plain_assignment();
    static constexpr TokenSet selectors{TokenKind::left_parenthesis, TokenKind::dot,
                                        TokenKind::left_bracket};
    if (at(TokenKind::identifier) && selectors.contains(tokens_[at_ + 1].kind()) &&
        !open_.back().in_else && balanced())
        return parse_simple_statement();
    const bool name_of_keyword = at_keyword_for_variable();
    const TokenKind opener = at(block_statements) ? kind() : missing_opener();
    if (block_statements.contains(opener) && !name_of_keyword) {
        const NestingGuard guard(*this);
        if (guard.too_deep())
            return parse_too_deep_statement();
        switch (opener) {
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
    case TokenKind::kw_exit:
        if (!name_of_keyword)
            return parse_word_statement();
        break;
    default: break;
    }
    if (at(block_openers))
        return parse_misplaced_declarations();
    if (at_foreign_member()) {
        auto* member = make<ast::ErrorStatement>();
        skip_foreign_member();
        return finish(member);
    }
    if (begins_chart_element(at_) && chart_element_end(at_) != at_)
        return parse_chart_element_for_statement();
    if (at_statement_label()) {
        auto* label = make<ast::ErrorStatement>();
        report_at(at_, DiagnosticId::not_a_statement, {"a label"});
        advance();
        advance();
        return finish(label);
    }
    if ((at(TokenKind::identifier) || at_operand_keyword()) && peek() == TokenKind::colon &&
        (is_elementary_type_name(peek_second()) || peek_second() == TokenKind::kw_array)) {
        report_at(at_, DiagnosticId::declaration_after_body);
        return skip_statement();
    }
    if (open_.back().in_else && open_.back().closer == TokenKind::kw_end_case && at_case_label())
        return parse_label_after_else();
    if (unclosed(TokenKind::kw_end_case) < 0 && token().first_on_line() && at_case_label())
        return parse_case_without_head();
    if (at_prefix_increment())
        return parse_prefix_increment();
    static constexpr TokenSet operator_functions{TokenKind::kw_and, TokenKind::kw_or,
                                                 TokenKind::kw_xor, TokenKind::kw_mod};
    const bool name = at_operand_keyword() || name_of_keyword ||
                      (is_keyword(kind()) && used_as_name(kind())) ||
                      (at(operator_functions) && peek() == TokenKind::left_parenthesis);
    const bool two_words = is_keyword(kind()) && peek() == TokenKind::identifier &&
                           !tokens_[next(at_)].first_on_line();
    if (at_expression_start() || at(TokenKind::incomplete_location) || (name && !two_words))
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

/// In place of statement: a whole step, transition or action.
const ast::Statement* Parser::parse_chart_element_for_statement() {
    auto* error = make<ast::ErrorStatement>();
    report_at(at_, DiagnosticId::not_a_statement, {quoted(at_)});
    skip_chart_element();
    return finish(error);
}

/// `label: x := 1;`, as in instruction lists and other languages.
bool Parser::at_statement_label() const noexcept {
    const std::uint32_t third = next(next(at_));
    return at(TokenKind::identifier) && token().first_on_line() && peek() == TokenKind::colon &&
           tokens_[third].kind() == TokenKind::identifier &&
           tokens_[next(third)].kind() == TokenKind::assign;
}

/// In place of statement: a block of variables.
const ast::Statement* Parser::parse_misplaced_declarations() {
    auto* error = make<ast::ErrorStatement>();
    report_at(at_, DiagnosticId::declaration_after_body);
    parse_variable_declarations(place_);
    return finish(error);
}

/// In place of statement: passes over one that is nested too deep, up to its closing word.
const ast::Statement* Parser::parse_too_deep_statement() {
    auto* error = make<ast::ErrorStatement>();
    std::uint32_t depth = 0;
    do {
        depth += at(block_statements) ? 1 : 0;
        depth -= at(statement_closers) && depth > 0 ? 1 : 0;
        advance();
    } while (depth > 0 && !at(unit_ends));
    return finish(error);
}

// subprogram_control_statement = fb_invocation | "RETURN" ;
// exit_statement = "EXIT" ;
const ast::Statement* Parser::parse_word_statement() {
    if (at(TokenKind::kw_exit)) {
        auto* exit = make<ast::ExitStatement>();
        advance();
        if (at(block_statements) && peek() == TokenKind::semicolon && !token().first_on_line()) {
            report_unexpected("`;`").remove(token().range()); // `EXIT FOR;`
            count_as_name(kind());
            advance();
        }
        return finish(exit);
    }
    return take<ast::ReturnStatement>();
}

/// Part of statement: what begins with a variable, which is an assignment or the invocation of a
/// function block.
const ast::Statement* Parser::parse_simple_statement() {
    const std::size_t reports = diagnostics_.size();
    const bool variable = at(TokenKind::identifier) || at_operand_keyword() ||
                          used_as_name(kind()) || at_keyword_for_variable();
    if (!variable && !at(TokenKind::direct_variable) && !at(TokenKind::incomplete_location)) {
        const ast::Expression* expression = parse_expression();
        return at(TokenKind::assign) ? parse_assignment(expression)
                                     : finish_expression_statement(expression, reports);
    }
    const std::uint32_t first = at_;
    if (at(TokenKind::incomplete_location))
        report_at(at_, DiagnosticId::incomplete_location);
    if (peek() == TokenKind::left_parenthesis)
        invocation_ = next(at_);
    const ast::Expression* left = variable ? parse_variable() : parse_direct_variable();
    if (left->kind == ast::NodeKind::function_call && at(TokenKind::colon) &&
        tokens_[next(at_)].first_on_line())
        return make_invocation(*ast::as<ast::FunctionCall>(left)); // its `;` was meant
    static constexpr TokenSet assigns{TokenKind::assign, TokenKind::equal, TokenKind::colon,
                                      TokenKind::equal_equal, TokenKind::output_arrow};
    if (at(assigns))
        return parse_assignment(left);
    const bool truth = at(TokenKind::kw_true) || at(TokenKind::kw_false);
    if (truth && !token().first_on_line() && is_variable(*left))
        return parse_assignment(left);
    if (at_reference_assignment())
        return parse_reference_assignment(left);
    if (at_compound_assignment())
        return parse_compound_assignment(left);
    if (const auto* call = ast::as<ast::FunctionCall>(left);
        call != nullptr && operator_strength(kind()) == 0)
        return make_invocation(*call);
    if (left->kind == ast::NodeKind::variable_name && at(TokenKind::semicolon))
        if (const ast::Statement* statement = as_word_statement(*left))
            return statement;
    const bool alone = left->kind == ast::NodeKind::variable_name && !at(TokenKind::semicolon) &&
                       token().first_on_line() && operator_strength(kind()) == 0 &&
                       diagnostics_.size() == reports;
    if (alone) {
        auto* error = make_from<ast::ErrorStatement>(left);
        report_node(*left, DiagnosticId::not_a_statement, {quoted(first)});
        return finish(error);
    }
    const ast::Expression* expression = parse_binary_rest(left, 1);
    if (at(TokenKind::assign))
        return parse_assignment(expression);
    static constexpr TokenSet words_of_other_languages{TokenKind::identifier, TokenKind::integer};
    if (at(TokenKind::semicolon) || !at(words_of_other_languages) || reported_at_ == at_)
        return finish_expression_statement(expression, reports);
    // Two names in a row: neither an assignment nor an invocation.
    auto* error = make<ast::ErrorStatement>();
    error->first_token = first;
    if (names_equal(text(first), "GOTO"))
        report_at(first, DiagnosticId::not_a_statement, {quoted(first)});
    else
        report_unexpected("`:=` or `(`");
    skip_statement();
    return finish(error);
}

/// What a lone name is meant for: a misspelt RETURN or EXIT, or a statement of other languages.
/// Null when it can be meant as a name.
const ast::Statement* Parser::as_word_statement(const ast::Expression& name) {
    const std::string word(text(name.first_token));
    const auto report_misspelt = [&](TokenKind meant) {
        report_node(name, DiagnosticId::misspelt_word, {word, spelling(meant)})
            .replace(tokens_[name.first_token].range(), std::string(spelling(meant)));
    };
    if (is_misspelling(word, spelling(TokenKind::kw_return))) {
        report_misspelt(TokenKind::kw_return);
        return finish(make_from<ast::ReturnStatement>(&name));
    }
    if (is_misspelling(word, spelling(TokenKind::kw_exit)) || names_equal(word, "BREAK")) {
        report_misspelt(TokenKind::kw_exit);
        return finish(make_from<ast::ExitStatement>(&name));
    }
    if (!names_equal(word, "CONTINUE"))
        return nullptr;
    report_node(name, DiagnosticId::continue_statement);
    return finish(make_from<ast::ContinueStatement>(&name));
}

/// Part of assignment_statement: one to a variable of which only the name is given.
const ast::Statement* Parser::parse_plain_assignment() {
    const ast::Expression* const variable = parse_plain_name();
    advance();
    const ast::Expression* const expression = parse_expression();
    auto* node = make_from<ast::AssignmentStatement>(variable);
    node->variable = variable;
    node->expression = expression;
    return finish(node);
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

/// `+=` and its like, or `++` and `--` at the end of a statement.
bool Parser::at_compound_assignment() const noexcept {
    static constexpr TokenSet operators{TokenKind::plus, TokenKind::minus, TokenKind::star,
                                        TokenKind::slash};
    if (!at(operators) || !adjoins_next())
        return false;
    const bool counts = at(TokenKind::plus) || at(TokenKind::minus);
    const std::uint32_t second = next(at_);
    return peek() == TokenKind::equal ||
           (counts && peek() == kind() &&
            (peek_second() == TokenKind::semicolon || tokens_[next(second)].first_on_line()));
}

/// In place of assignment_statement: `x += 1` or `x++`, which is written `x := x + 1`.
const ast::Statement* Parser::parse_compound_assignment(const ast::Expression* variable) {
    auto* node = make_from<ast::AssignmentStatement>(variable);
    const TextRange name = token_range(variable->first_token, variable->end_token);
    const TextRange range = token_range(at_, next(at_) + 1);
    const bool with_operand = peek() == TokenKind::equal;
    const std::string meant = ":= " + std::string(text_.substr(name.begin, name.size())) + " " +
                              std::string(text(at_)) + (with_operand ? "" : " 1");
    Report compound = report(DiagnosticId::foreign_operator, range,
                             {text_.substr(range.begin, range.size()), meant});
    advance();
    advance();
    node->variable = variable;
    node->expression = with_operand ? parse_expression() : make_missing<ast::ErrorExpression>();
    if (node->expression->kind != ast::NodeKind::binary_expression)
        compound.replace(range, range.begin == name.end ? " " + meant : meant);
    return finish(node);
}

/// `++x` or `--x` as a statement.
bool Parser::at_prefix_increment() const noexcept {
    return (at(TokenKind::plus) || at(TokenKind::minus)) && adjoins_next() && peek() == kind() &&
           peek_second() == TokenKind::identifier;
}

/// In place of assignment_statement: `++x`, which is written `x := x + 1`.
const ast::Statement* Parser::parse_prefix_increment() {
    auto* node = make<ast::AssignmentStatement>();
    const std::string sign(text(at_));
    const TextRange range = token_range(at_, next(at_) + 1);
    advance();
    advance();
    node->variable = parse_variable();
    const TextRange name = token_range(node->variable->first_token, node->variable->end_token);
    const std::string variable(text_.substr(name.begin, name.size()));
    const std::string meant = variable + " := " + variable + " " + sign + " 1";
    report(DiagnosticId::foreign_operator, range, {sign + sign, meant})
        .replace({range.begin, name.end}, meant);
    node->expression = make_missing<ast::ErrorExpression>();
    return finish(node);
}

bool Parser::is_variable(const ast::Expression& expression) noexcept {
    switch (expression.kind) {
    case ast::NodeKind::variable_name:
    case ast::NodeKind::array_variable:
    case ast::NodeKind::structured_variable:
    case ast::NodeKind::dereferenced_variable:
    case ast::NodeKind::direct_variable:
    case ast::NodeKind::error_expression: return true;
    default: return false;
    }
}

/// Where it does not stand at the cursor.
void Parser::expect_missing_assign() {
    const std::uint32_t first = at_;
    static constexpr TokenSet firsts{TokenKind::equal, TokenKind::equal_equal};
    const bool reversed = at(TokenKind::equal) && peek() == TokenKind::colon && adjoins_next();
    const bool repeated = peek() == TokenKind::equal && on_same_line(at_, next(at_));
    if (at(firsts) && (reversed || repeated)) { // `=:`, `= =` and `===`
        const TextRange range = token_range(at_, next(at_) + 1);
        report(DiagnosticId::foreign_operator, range,
               {text_.substr(range.begin, range.size()), ":="})
            .replace(range, ":=");
        advance();
        advance();
    } else if (at(TokenKind::equal)) {
        report_at(at_, DiagnosticId::equal_for_assignment).replace(token().range(), ":=");
        advance();
    } else if (at(TokenKind::colon) && peek() == TokenKind::equal) {
        const TextRange gap{token().end(), tokens_[next(at_)].offset()};
        report_at(at_, DiagnosticId::white_space_in_delimiter, {":="}).remove(gap);
        advance();
        advance();
    } else if (at(TokenKind::equal_equal)) {
        report_at(at_, DiagnosticId::foreign_operator, {text(at_), ":="})
            .replace(token().range(), ":=");
        advance();
    } else if (at(TokenKind::colon) || at(TokenKind::output_arrow)) {
        report_unexpected("`:=`").replace(token().range(), ":=");
        advance();
    } else {
        expect(TokenKind::assign);
        return;
    }
    reported_at_ = first; // what follows is reported on its own
}

// fb_invocation = fb_name "(" [ param_list ] ")" ;
const ast::Statement* Parser::make_invocation(const ast::FunctionCall& call) {
    auto* node = make_from<ast::FbInvocation>(&call);
    node->fb_name = call.function.get();
    node->arguments = call.arguments.children();
    ast::mark_unused(call, arena_.bytes());
    finish(node);
    const ast::Expression& called = *node->fb_name;
    if (called.kind == ast::NodeKind::dereferenced_variable)
        return node; // which was reported
    if (called.kind != ast::NodeKind::variable_name) {
        report_call_of_member(called);
    } else if (const std::string name(text(called.first_token));
               standard_name(name) == StandardName::function) {
        report_node(called, DiagnosticId::function_call_statement, {name});
    }
    return node;
}

/// `reports` is how many there were before the statement: what is wrong inside goes first.
const ast::Statement* Parser::finish_expression_statement(const ast::Expression* expression,
                                                          std::size_t reports) {
    if (const auto* call = ast::as<ast::FunctionCall>(expression);
        call != nullptr && call->function->kind == ast::NodeKind::variable_name)
        return make_invocation(*call);
    auto* node = make_from<ast::ExpressionStatement>(expression);
    node->expression = expression;
    finish(node);
    if (diagnostics_.size() == reports && reported_at_ != at_ &&
        !tokens_[expression->first_token].malformed())
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
    open_statement(TokenKind::kw_if, TokenKind::kw_end_if);
    node->condition = parse_condition();
    expect_word(TokenKind::kw_then);
    node->then_list = parse_statement_list("after THEN");
    return parse_if_rest(node);
}

// Part of if_statement: { "ELSIF" expression "THEN" statement_list } [ "ELSE" statement_list ]
// "END_IF"
const ast::Statement* Parser::parse_if_rest(ast::IfStatement* node) {
    ListBuilder<ast::ElsifClause> clauses(*this);
    while (open_.back().closer == TokenKind::kw_end_if) {
        if (at(TokenKind::kw_elsif) || at_else_if_for_elsif() || at_misspelt_elsif() ||
            at_else_for_elsif() || at_missing_elsif()) {
            clauses.add(parse_elsif_clause());
        } else if (at(TokenKind::kw_else) || at_misspelt_else()) {
            node->else_list = parse_else_list();
            break;
        } else if (at_early_end_if()) {
            skip_early_end_if();
        } else {
            break;
        }
    }
    node->elsif_clauses = clauses.finish();
    close_block(";");
    return finish(node);
}

/// `END_IF; ELSIF`, when an END_IF too many is there.
bool Parser::at_early_end_if() {
    if (!at(TokenKind::kw_end_if) || unclosed(TokenKind::kw_end_if) >= 0)
        return false;
    return peek() == TokenKind::kw_elsif ||
           (peek() == TokenKind::semicolon && peek_second() == TokenKind::kw_elsif);
}

void Parser::skip_early_end_if() {
    const std::uint32_t last = peek() == TokenKind::semicolon ? next(at_) : at_;
    report_unexpected("`ELSIF`").remove(token_range(at_, last + 1));
    change_unclosed(TokenKind::kw_end_if, 1);
    advance();
    accept(TokenKind::semicolon);
}

/// In place of if_statement: at ELSE or ELSIF outside of IF, when an END_IF waits for it.
const ast::Statement* Parser::parse_if_without_head() {
    auto* node = make<ast::IfStatement>();
    if (!report_missing_head(TokenKind::kw_end_if))
        report_at(at_, DiagnosticId::stray_closing_word, {text(at_)});
    change_unclosed(TokenKind::kw_end_if, 1);
    open_block(TokenKind::kw_end_if, at_);
    node->condition = make_missing<ast::ErrorExpression>();
    node->then_list = make_missing<ast::StatementList>();
    return parse_if_rest(node);
}

// Part of if_statement, case_statement: [ "ELSE" statement_list ]
const ast::StatementList* Parser::parse_else_list() {
    if (!accept(TokenKind::kw_else))
        accept_misspelt(TokenKind::kw_else);
    open_.back().in_else = true;
    if (at(TokenKind::colon)) {
        report_unexpected("a statement").remove(token().range());
        advance();
    }
    return parse_statement_list("after ELSE");
}

/// The word that opens a statement. When it is missing, as another word or a closing word has told,
/// it is reported, and the statement begins where it ought to stand.
void Parser::open_statement(TokenKind opener, TokenKind closer) {
    const std::uint32_t first = at_;
    if (!accept(opener)) {
        const std::string word(spelling(opener));
        const std::uint32_t offset = token().offset();
        change_unclosed(closer, 1);
        const bool unary = at(TokenKind::left_parenthesis) || at(TokenKind::kw_not) ||
                           at(TokenKind::minus) || at(TokenKind::plus);
        const bool two_operands =
            !unary && begins_operand_on_line(next(at_)) && operator_strength(peek()) == 0;
        if (two_operands || opener == TokenKind::kw_repeat) {
            // Two operands in a row: the first stands for the word.
            (is_misspelling(text(at_), word)
                 ? report_at(at_, DiagnosticId::misspelt_word, {text(at_), word})
                 : report_unexpected("`" + word + "`"))
                .replace(token().range(), word);
            advance();
        } else {
            report(DiagnosticId::missing_token, {offset, offset}, {"`" + word + "`"})
                .insert(offset, word + " ");
        }
    }
    open_block(closer, first);
}

/// At the head of a statement that lacks its first word, when a closing word waits for it: that
/// word; else end_of_unit.
TokenKind Parser::missing_opener() {
    struct Head {
        TokenKind opener, word, closer;
    };
    static constexpr Head heads[] = {
        {TokenKind::kw_if, TokenKind::kw_then, TokenKind::kw_end_if},
        {TokenKind::kw_case, TokenKind::kw_of, TokenKind::kw_end_case},
        {TokenKind::kw_for, TokenKind::kw_to, TokenKind::kw_end_for},
        {TokenKind::kw_while, TokenKind::kw_do, TokenKind::kw_end_while},
    };
    if (balanced())
        return TokenKind::end_of_unit;
    // Negative when one of them is: hardly ever.
    if ((unclosed(TokenKind::kw_end_if) | unclosed(TokenKind::kw_end_case) |
         unclosed(TokenKind::kw_end_for) | unclosed(TokenKind::kw_end_while) |
         unclosed(TokenKind::kw_end_repeat)) >= 0)
        return TokenKind::end_of_unit;
    for (const Head& head : heads)
        if (unclosed(head.closer) < 0 && find_on_line(head.word) < count_)
            return head.opener;
    const bool repeat = unclosed(TokenKind::kw_end_repeat) < 0 && at(TokenKind::identifier) &&
                        tokens_[next(at_)].first_on_line() &&
                        is_misspelling(text(at_), spelling(TokenKind::kw_repeat));
    return repeat ? TokenKind::kw_repeat : TokenKind::end_of_unit;
}

// Part of if_statement: "ELSIF" expression "THEN" statement_list
const ast::ElsifClause* Parser::parse_elsif_clause() {
    auto* clause = make<ast::ElsifClause>();
    bool given = true;
    if (at(TokenKind::kw_else) && peek() != TokenKind::kw_if) {
        report_unexpected("`ELSIF`").replace(token().range(), "ELSIF");
    } else if (at(TokenKind::kw_else)) {
        const TextRange both{token().offset(), tokens_[next(at_)].end()};
        report(DiagnosticId::else_if, both).replace(both, "ELSIF");
        change_unclosed(TokenKind::kw_end_if, -1);
        advance();
    } else if (at_missing_elsif() && !at_misspelt_elsif()) {
        const std::uint32_t offset = token().offset();
        report(DiagnosticId::missing_token, {offset, offset}, {"`ELSIF`"}).insert(offset, "ELSIF ");
        given = false;
    } else if (at(TokenKind::identifier)) {
        const std::string meant(spelling(TokenKind::kw_elsif));
        report_at(at_, DiagnosticId::misspelt_word, {text(at_), meant})
            .replace(token().range(), meant);
    }
    if (given)
        advance();
    clause->condition = parse_condition();
    expect_word(TokenKind::kw_then);
    clause->statements = parse_statement_list("after THEN");
    return finish(clause);
}

/// At `ELSE` with a condition and THEN behind it in the line.
bool Parser::at_else_for_elsif() const noexcept {
    return at(TokenKind::kw_else) && begins_operand_on_line(next(at_)) &&
           find_on_line(TokenKind::kw_then) < count_;
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
    for (std::uint32_t depth = 0; !unit_ends.contains(tokens_[end].kind()); end = next(end)) {
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
    open_statement(TokenKind::kw_case, TokenKind::kw_end_case);
    if (at(TokenKind::integer) && at_case_label()) {
        report_missing(DiagnosticId::missing_token, {"a selector with `OF`"});
        node->selector = make_missing<ast::ErrorExpression>();
    } else {
        node->selector = parse_condition();
        expect_word(TokenKind::kw_of);
    }
    return parse_case_rest(node);
}

// Part of case_statement: case_element { case_element } [ "ELSE" statement_list ] "END_CASE"
const ast::Statement* Parser::parse_case_rest(ast::CaseStatement* node) {
    ListBuilder<ast::CaseElement> elements(*this);
    do {
        accept_repeated_case();
        elements.add(parse_case_element());
    } while (at_case_label() || at_repeated_case() || at_label_without_colon() ||
             !at_end_of_statements());
    node->elements = elements.finish();
    if (at(TokenKind::kw_else) || at_misspelt_else())
        node->else_list = parse_else_list();
    close_block(";");
    return finish(node);
}

/// `CASE 1:` for `1:`, when no END_CASE is there for it.
bool Parser::at_repeated_case() {
    static constexpr TokenSet values{TokenKind::integer, TokenKind::identifier,
                                     TokenKind::enumerated_value};
    static constexpr TokenSet behind{TokenKind::colon, TokenKind::comma, TokenKind::dot_dot};
    return at(TokenKind::kw_case) && open_.back().closer == TokenKind::kw_end_case &&
           values.contains(peek()) && behind.contains(peek_second()) &&
           unclosed(TokenKind::kw_end_case) > 0;
}

void Parser::accept_repeated_case() {
    if (!at_repeated_case())
        return;
    report_unexpected("a CASE label").remove(token().range());
    change_unclosed(TokenKind::kw_end_case, -1);
    advance();
}

/// In place of case_statement: at a label outside of CASE, when an END_CASE waits for it. The head
/// of the statement is missing.
const ast::Statement* Parser::parse_case_without_head() {
    const std::uint32_t offset = token().offset();
    report(DiagnosticId::missing_token, {offset, offset}, {"`CASE` with a selector and `OF`"});
    auto* node = make<ast::CaseStatement>();
    change_unclosed(TokenKind::kw_end_case, 1);
    open_block(TokenKind::kw_end_case, at_);
    node->selector = make_missing<ast::ErrorExpression>();
    return parse_case_rest(node);
}

/// True when a label begins here: a constant or name with `:`, `,` or `..` behind it.
bool Parser::at_case_label() const noexcept {
    static constexpr TokenSet plain_labels{TokenKind::integer, TokenKind::identifier};
    if (at(plain_labels) && tokens_[at_ + 1].kind() == TokenKind::colon)
        return tokens_[next(at_ + 1)].kind() != TokenKind::equal;
    if (at(TokenKind::left_parenthesis))
        return at_label_in_parentheses();
    std::uint32_t label = at_;
    if (at(TokenKind::minus) || at(TokenKind::plus))
        label = next(label);
    const TokenKind here = tokens_[label].kind();
    if (is_keyword(here) && here != TokenKind::kw_else)
        if (tokens_[next(label)].kind() == TokenKind::colon)
            return true;
    static constexpr TokenSet type_names = TokenSet::range(TokenKind::kw_bool, TokenKind::kw_date);
    const bool value = here == TokenKind::identifier || here == TokenKind::enumerated_value ||
                       (here >= TokenKind::integer && here <= TokenKind::date_and_time) ||
                       here == TokenKind::kw_true || here == TokenKind::kw_false ||
                       type_names.contains(here) || used_as_name(here);
    if (!value)
        return false;
    const bool name = here == TokenKind::identifier || used_as_name(here);
    std::uint32_t after = next(label);
    if (!name && tokens_[after].kind() == TokenKind::assign)
        return true;
    // An expression can stand for a label as an extension.
    static constexpr TokenSet inside{
        TokenKind::identifier,   TokenKind::integer, TokenKind::plus,   TokenKind::minus,
        TokenKind::star,         TokenKind::slash,   TokenKind::power,  TokenKind::kw_mod,
        TokenKind::kw_to,        TokenKind::dot,     TokenKind::kw_and, TokenKind::kw_or,
        TokenKind::less,         TokenKind::greater, TokenKind::equal,  TokenKind::less_equal,
        TokenKind::greater_equal};
    for (std::uint32_t steps = 0;
         steps < furthest_on_line && inside.contains(tokens_[after].kind()) &&
         !tokens_[after].first_on_line();
         ++steps)
        after = next(after);
    switch (tokens_[after].kind()) {
    case TokenKind::colon: return tokens_[next(after)].kind() != TokenKind::equal;
    case TokenKind::comma:
    case TokenKind::dot_dot: return true;
    default: return false;
    }
}

/// `2 x := 1;` or `off x := 1;` for `2: x := 1;`. A number begins no statement. A name can be a
/// label when it stands in the column of the labels.
bool Parser::at_label_without_colon() const noexcept {
    const OpenBlock& block = open_.back();
    if (block.in_else || !token().first_on_line())
        return false;
    if (at(TokenKind::integer))
        return begins_statement(next(at_));
    if (!name_before_statement(at_) || at_misspelt_closer())
        return false;
    const bool first_label = at_ > 0 && tokens_[at_ - 1].kind() == TokenKind::kw_of;
    return first_label || (block.label != no_token && column(block.label) == column(at_));
}

/// A name that nothing connects with the statement behind it.
bool Parser::name_before_statement(std::uint32_t index) const noexcept {
    const TokenKind here = tokens_[index].kind();
    const bool name = here == TokenKind::identifier || here == TokenKind::enumerated_value;
    const std::uint32_t behind = next(index);
    return name && begins_statement(behind) &&
           tokens_[next(behind)].kind() != TokenKind::left_parenthesis;
}

bool Parser::begins_statement(std::uint32_t index) const noexcept {
    static constexpr TokenSet behind_name{TokenKind::assign, TokenKind::left_parenthesis,
                                          TokenKind::left_bracket, TokenKind::dot,
                                          TokenKind::caret};
    return statement_words.contains(tokens_[index].kind()) ||
           (tokens_[index].kind() == TokenKind::identifier &&
            behind_name.contains(tokens_[next(index)].kind()));
}

/// `(1):`, which no statement begins with.
bool Parser::at_label_in_parentheses() const noexcept {
    std::uint32_t i = next(at_);
    for (std::uint32_t steps = 0; steps < furthest_on_line && !tokens_[i].first_on_line();
         i = next(i), ++steps)
        if (tokens_[i].kind() == TokenKind::right_parenthesis)
            return tokens_[next(i)].kind() == TokenKind::colon;
    return false;
}

/// In place of statement: after ELSE the branches of a CASE are over. The label is passed over,
/// what follows is read.
const ast::Statement* Parser::parse_label_after_else() {
    auto* error = make<ast::ErrorStatement>();
    report_unexpected("a statement or `END_CASE`");
    do
        parse_case_label();
    while (accept(TokenKind::comma));
    accept(TokenKind::colon);
    return finish(error);
}

// case_element = case_list ":" statement_list ;
// case_list = case_list_element { "," case_list_element } ;
const ast::CaseElement* Parser::parse_case_element() {
    auto* element = make<ast::CaseElement>();
    open_.back().label = token().first_on_line() ? at_ : no_token;
    if (at_case_label() || at(TokenKind::integer) || at_label_without_colon()) {
        ListBuilder<ast::Node> labels(*this);
        do
            labels.add(parse_case_label());
        while (accept(TokenKind::comma));
        element->labels = labels.finish();
        if (at(TokenKind::assign) || at(TokenKind::output_arrow))
            accept_as(TokenKind::colon);
        else
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
    const bool simple =
        after == TokenKind::colon || after == TokenKind::comma || name_before_statement(at_);
    const bool keyword = is_keyword(kind()) && !at(TokenKind::kw_true) && !at(TokenKind::kw_false);
    if (simple && keyword)
        report_reserved_word(at_);
    if (simple && (keyword || at(TokenKind::identifier) || at(TokenKind::enumerated_value)))
        return parse_enumerated_value();
    const std::uint32_t first = at_;
    const ast::Expression* label = parse_constant_label();
    if (at(TokenKind::kw_to))
        report_unexpected("`..`").replace(token().range(), "..");
    else if (!at(TokenKind::dot_dot))
        return label;
    auto* range = make<ast::Subrange>();
    range->first_token = first;
    advance();
    range->lower = label;
    range->upper = parse_constant_label();
    return finish(range);
}

// Part of case_list_element: subrange | signed_integer
/// A bound of the subrange, or the integer.
const ast::Expression* Parser::parse_constant_label() {
    const bool apart = (at(TokenKind::minus) || at(TokenKind::plus)) &&
                       peek() == TokenKind::integer && !adjoins_next();
    const std::uint32_t sign = at_;
    const ast::Expression* label = parse_expression();
    if (label->missing || is_signed_integer(*label) ||
        label->kind == ast::NodeKind::error_expression)
        return label;
    if (apart && label->end_token == next(sign) + 1) {
        const TextRange gap{tokens_[sign].end(), tokens_[next(sign)].offset()};
        report(DiagnosticId::sign_apart_from_number, gap).remove(gap);
        return label;
    }
    if (const auto* qualified = ast::as<ast::StructuredVariable>(label)) {
        const TextRange dot{
            token_range(label->first_token, qualified->record_variable->end_token).end,
            tokens_[label->end_token - 1].offset()};
        report_node(*label, DiagnosticId::case_label, {"a value qualified by `.`"})
            .replace(dot, "#");
        return label;
    }
    report_node(*label, DiagnosticId::case_label,
                {label->kind == ast::NodeKind::variable_name ? "a named constant"
                 : ast::is<ast::Constant>(label->kind)       ? "a literal of this form"
                                                             : "an expression"});
    return label;
}

// ---- iteration ----------------------------------------------------------------------------------

// for_statement = "FOR" control_variable ":=" for_list "DO" statement_list "END_FOR" ;
// control_variable = identifier ;
const ast::Statement* Parser::parse_for_statement() {
    auto* node = make<ast::ForStatement>();
    open_statement(TokenKind::kw_for, TokenKind::kw_end_for);
    std::optional<Report> parenthesis;
    if (loop_head_of_other_language()) {
        skip_loop_head(*node);
        return parse_loop(node);
    }
    if (at(TokenKind::left_parenthesis)) {
        parenthesis.emplace(report_unexpected("a variable").remove(token().range()));
        advance();
    }
    if (at(execution_control))
        report_reserved_word(at_); // a control variable has a name
    const bool variable = at(TokenKind::identifier) || at_operand_keyword() ||
                          used_as_name(kind()) || at_keyword_for_variable();
    node->control_variable = variable                         ? parse_variable()
                             : at(TokenKind::direct_variable) ? parse_direct_variable()
                                                              : parse_missing_expression();
    if (!node->control_variable->missing &&
        node->control_variable->kind != ast::NodeKind::variable_name)
        report_node(*node->control_variable, DiagnosticId::control_variable);
    if (at(TokenKind::colon) && peek_second() == TokenKind::assign) { // `FOR i : INT := 1`
        const TextRange type = token_range(at_, next(at_) + 1);
        report(DiagnosticId::declaration_after_body, type).remove(type);
        advance();
        advance();
    }
    parse_for_list(*node);
    if (parenthesis && at(TokenKind::right_parenthesis))
        parenthesis->also_remove(tokens_[advance()].range());
    expect_word(TokenKind::kw_do);
    return parse_loop(node);
}

// Part of for_statement: statement_list "END_FOR"
const ast::Statement* Parser::parse_loop(ast::ForStatement* node) {
    node->statements = parse_statement_list("after DO");
    close_block(";");
    return finish(node);
}

/// Behind FOR: true at a head with `;` in it, as in C, or at `x IN a DO`.
bool Parser::loop_head_of_other_language() const noexcept {
    constexpr std::uint32_t furthest = 200; // bounds the time that a line full of FOR takes
    const bool parentheses = at(TokenKind::left_parenthesis);
    if (at(TokenKind::identifier) && names_equal(text(next(at_)), "IN"))
        return find_on_line(TokenKind::dot_dot) == count_ &&
               find_on_line(TokenKind::kw_to) == count_;
    const auto goes_on = [this](std::uint32_t i) {
        return i < count_ && i - at_ < furthest && !tokens_[i].first_on_line() &&
               !part_words.contains(tokens_[i].kind());
    };
    std::uint32_t i = next(at_);
    while (goes_on(i) && tokens_[i].kind() != TokenKind::semicolon)
        i = next(i);
    if (tokens_[i].kind() != TokenKind::semicolon || tokens_[i].first_on_line() || parentheses)
        return tokens_[i].kind() == TokenKind::semicolon && !tokens_[i].first_on_line();
    if (is_semicolon_for_to(i))
        return false;
    while (goes_on(i) && !statement_words.contains(tokens_[i].kind()))
        i = next(i);
    return tokens_[i].kind() == TokenKind::kw_do && !tokens_[i].first_on_line();
}

/// Passes over a head like `(i := 1; i < 3; i := i + 1)`.
void Parser::skip_loop_head(ast::ForStatement& loop) {
    auto* head = make<ast::ErrorExpression>();
    const std::uint32_t first = at_;
    while (!at_end() && !at(TokenKind::kw_do) && (at_ == first || !token().first_on_line()))
        advance();
    report(DiagnosticId::unexpected_token, token_range(first, end_),
           {"`variable := first TO last DO`", "the head of a loop in another language"});
    loop.control_variable = finish(head);
    loop.from = make_missing<ast::ErrorExpression>();
    loop.to = make_missing<ast::ErrorExpression>();
    accept(TokenKind::kw_do);
}

// for_list = expression "TO" expression [ "BY" expression ] ;
/// With the `:=` before it.
void Parser::parse_for_list(ast::ForStatement& loop) {
    std::optional<Report> in;
    if (at_word("IN") && find_on_line(TokenKind::dot_dot) < count_) {
        in.emplace(accept_as(TokenKind::assign)); // `x IN 1..3`
        loop.from = parse_expression();
    } else if (at(TokenKind::kw_to)) {
        report_missing(DiagnosticId::missing_token, {"`:=` with a first value"});
        loop.from = make_missing<ast::ErrorExpression>();
    } else {
        expect_assign();
        loop.from = parse_expression();
    }
    const bool head_ends =
        at(TokenKind::semicolon) && peek() != TokenKind::kw_to && !is_semicolon_for_to(at_);
    if (at(TokenKind::kw_do) || head_ends) {
        report_missing(DiagnosticId::missing_token, {"`TO` with a last value"});
        loop.to = make_missing<ast::ErrorExpression>();
        return;
    }
    if (at(TokenKind::kw_by) && find_on_line(TokenKind::kw_to) < count_) {
        // The parts in the wrong order.
        report_unexpected("`TO`");
        auto* skipped = make<ast::ErrorExpression>();
        advance();
        parse_expression();
        finish(skipped);
        loop.to = skipped;
        if (accept(TokenKind::kw_to))
            loop.by = parse_expression();
        return;
    }
    if (at_word("DOWNTO")) {
        report_unexpected("`TO` with `BY` and a negative step");
        advance();
    } else if (in && *in && at(TokenKind::dot_dot)) {
        const TextRange dots = token().range();
        diagnostics_[in->index()].fixes.front().edits.push_back({dots, spaced("TO", dots)});
        advance();
    } else {
        expect_word(TokenKind::kw_to);
    }
    loop.to = parse_expression();
    if (accept_by())
        loop.by = parse_expression();
}

/// BY, or STEP as other languages say.
bool Parser::accept_by() {
    if (at(TokenKind::kw_step) && begins_operand_on_line(next(at_))) {
        report_unexpected("`BY`").replace(token().range(), "BY");
        advance();
        return true;
    }
    return accept(TokenKind::kw_by) ||
           (begins_operand_on_line(next(at_)) && accept_misspelt_word(TokenKind::kw_by));
}

// while_statement = "WHILE" expression "DO" statement_list "END_WHILE" ;
const ast::Statement* Parser::parse_while_statement() {
    auto* node = make<ast::WhileStatement>();
    open_statement(TokenKind::kw_while, TokenKind::kw_end_while);
    node->condition = parse_condition();
    expect_word(TokenKind::kw_do);
    node->statements = parse_statement_list("after DO");
    close_block(";");
    return finish(node);
}

// repeat_statement = "REPEAT" statement_list "UNTIL" expression "END_REPEAT" ;
const ast::Statement* Parser::parse_repeat_statement() {
    auto* node = make<ast::RepeatStatement>();
    open_statement(TokenKind::kw_repeat, TokenKind::kw_end_repeat);
    node->statements = parse_statement_list("after REPEAT");
    const bool misspelt = at_misspelt_until();
    std::optional<Report> without_until;
    if (misspelt) {
        accept_misspelt(TokenKind::kw_until);
    } else if (at_while_for_until()) {
        change_unclosed(TokenKind::kw_end_while, -1);
        without_until.emplace(accept_as(TokenKind::kw_until));
    } else if (at_condition_without_until()) {
        without_until.emplace(report_missing(DiagnosticId::missing_token, {"`UNTIL`"})
                                  .insert(token().offset(), "UNTIL "));
    }
    if (misspelt || without_until || accept(TokenKind::kw_until)) {
        node->condition = parse_condition();
        const bool closer_follows =
            peek() == TokenKind::kw_end_repeat ||
            (peek() == TokenKind::identifier &&
             is_misspelling(text(next(at_)), spelling(TokenKind::kw_end_repeat)));
        if (at(TokenKind::semicolon) && closer_follows) {
            if (without_until && *without_until)
                without_until->also_remove(token().range());
            else
                report_unexpected("`END_REPEAT`").remove(token().range());
            advance();
        }
    } else if (at(TokenKind::kw_end_repeat) && peek() == TokenKind::kw_until) {
        return parse_until_behind_closer(node);
    } else {
        if (at(TokenKind::kw_end_repeat))
            report_missing(DiagnosticId::missing_token, {"`UNTIL` with a condition"});
        node->condition = make_missing<ast::ErrorExpression>();
    }
    close_block(";");
    const bool missing = closer_assumed_ && !diagnostics_.empty() &&
                         diagnostics_.back().id == DiagnosticId::missing_closing_word;
    if (missing && node->condition->missing)
        diagnostics_.back().fixes.clear(); // there is no condition to insert
    return finish(node);
}

/// In place of repeat_statement: `END_REPEAT UNTIL condition`.
const ast::Statement* Parser::parse_until_behind_closer(ast::RepeatStatement* node) {
    const TextRange closer = token().range();
    const std::string words(text(at_));
    Report swapped = report_unexpected("`UNTIL`");
    close_block(";");
    advance();
    node->condition = parse_condition();
    if (!node->condition->missing && swapped) {
        swapped.remove(closer);
        swapped.also_insert(previous_end(), " " + words);
    }
    return finish(node);
}

/// A word like `THNE` at the end of the head of a statement.
bool Parser::accept_misspelt_word(TokenKind word) {
    if (!at(TokenKind::identifier) || token().first_on_line())
        return false;
    const std::string meant(spelling(word));
    if (!(tokens_[next(at_)].first_on_line() || begins_operand_on_line(next(at_)) ||
          (meant.size() > 2 && !at_statement_start())) ||
        !is_misspelling(text(at_), meant))
        return false;
    report_at(at_, DiagnosticId::misspelt_word, {text(at_), meant}).replace(token().range(), meant);
    advance();
    return true;
}

/// Where it does not stand at the cursor.
void Parser::expect_missing_word(TokenKind word) {
    if ((at(part_words) && !at(word) && peek() != word) || at_word_of_other_language(word)) {
        report_unexpected("`" + std::string(spelling(word)) + "`")
            .replace(token().range(), std::string(spelling(word)));
        advance();
        return;
    }
    if (at(TokenKind::semicolon) && peek() == word && !tokens_[next(at_)].first_on_line()) {
        report_unexpected("`" + std::string(spelling(word)) + "`").remove(token().range());
        advance();
        accept(word);
        return;
    }
    if (accept_misspelt_word(word))
        return;
    // What stands between here and the word on the same line was meant to be part of the head.
    const std::uint32_t found = token().first_on_line() ? count_ : find_on_line(word);
    if (found == count_) {
        expect(word);
        return;
    }
    report_unexpected("an operator or `" + std::string(spelling(word)) + "`");
    advance_past(found);
}

/// `FOR i := 1; 3 DO`
bool Parser::is_semicolon_for_to(std::uint32_t index) const noexcept {
    static constexpr TokenSet ends{TokenKind::kw_do, TokenKind::kw_by};
    const std::uint32_t operand = next(index);
    return tokens_[index].kind() == TokenKind::semicolon && begins_operand_on_line(operand) &&
           ends.contains(tokens_[next(operand)].kind());
}

/// `IF a : x := 1;` and `FOR i := 1 .. 3 DO`.
bool Parser::at_word_of_other_language(TokenKind word) const noexcept {
    if (word == TokenKind::kw_to)
        return at(TokenKind::dot_dot) || at(TokenKind::comma) || at(TokenKind::kw_until) ||
               is_semicolon_for_to(at_);
    return at(TokenKind::colon) || (word == TokenKind::kw_do && at(TokenKind::comma));
}

} // namespace iecfront
