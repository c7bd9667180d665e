#include "parser/misspelling.hpp"
#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <array>
#include <utility>

namespace iecfront {
namespace {

TokenKind opener_of(TokenKind closer) noexcept {
    switch (closer) {
    case TokenKind::kw_end_step: return TokenKind::kw_step;
    case TokenKind::kw_end_transition: return TokenKind::kw_transition;
    case TokenKind::kw_end_action: return TokenKind::kw_action;
    default: return TokenKind::end_of_unit;
    }
}

ast::ActionQualifierKind qualifier_named(std::string_view word) noexcept {
    using enum ast::ActionQualifierKind;
    for (const ast::ActionQualifierKind kind :
         {non_stored, overriding_reset, set, time_limited, time_delayed, pulse,
          stored_and_time_delayed, delayed_and_stored, stored_and_time_limited, pulse_rising_edge,
          pulse_falling_edge})
        if (names_equal(word, to_string(kind)))
            return kind;
    return unknown;
}

/// What is very probably meant by a word that is no qualifier; empty when nothing is.
std::string_view meant_qualifier(std::string_view word) noexcept {
    struct Slip {
        std::string_view written, meant;
    };
    static constexpr std::array<Slip, 4> slips{
        {{"LS", "SL"}, {"PO", "P0"}, {"PI", "P1"}, {"PL", "P1"}}};
    for (const Slip& slip : slips)
        if (names_equal(word, slip.written))
            return slip.meant;
    return {};
}

} // namespace

// ---- charts and networks ------------------------------------------------------------------------

// sequential_function_chart = sfc_network { sfc_network } ;
const ast::SequentialFunctionChart* Parser::parse_sequential_function_chart() {
    auto* chart = make<ast::SequentialFunctionChart>();
    const std::size_t reports = diagnostics_.size();
    const bool outer = std::exchange(in_chart_, true);
    ListBuilder<ast::SfcNetwork> networks(*this);
    while (!at_end_of_chart())
        networks.add(parse_sfc_network());
    chart->networks = networks.finish();
    in_chart_ = outer;
    finish(chart);
    if (diagnostics_.size() == reports) // a fault may have hidden a step
        check_initial_steps(*chart);
    return chart;
}

// sfc_network = ( initial_step | step | transition | action )
//               { initial_step | step | transition | action } ;
/// The first initial step may stand anywhere (6.1 D29); with the next one a network begins.
const ast::SfcNetwork* Parser::parse_sfc_network() {
    auto* network = make<ast::SfcNetwork>();
    ListBuilder<ast::Node> elements(*this);
    bool initial = false;
    while (!at_end_of_chart()) {
        const TokenKind opener = chart_element_opener();
        if (opener == TokenKind::kw_initial_step && std::exchange(initial, true))
            break;
        add_in_loop(elements, [&] { return parse_chart_element(opener); });
    }
    network->elements = elements.finish();
    return finish(network);
}

/// In an action, END_ACTION ends a chart; and so does, when that is missing, what stands where
/// ACTION stands.
bool Parser::at_end_of_chart() {
    if (at(unit_ends) || at_misspelt_closer())
        return true;
    const OpenBlock& innermost = open_.back();
    if (innermost.closer != TokenKind::kw_end_action)
        return false;
    return at(TokenKind::kw_end_action) ||
           (at(chart_openers) && token().first_on_line() && unclosed(innermost.closer) > 0 &&
            tokens_[innermost.opener].first_on_line() && column(at_) <= column(innermost.opener));
}

// Part of sfc_network: ( initial_step | step | transition | action )
const ast::Node* Parser::parse_chart_element(TokenKind opener) {
    switch (opener) {
    case TokenKind::kw_initial_step:
    case TokenKind::kw_step: return parse_step(opener);
    case TokenKind::kw_transition: return parse_transition();
    case TokenKind::kw_action: return parse_action();
    default: return skip_text_in_chart();
    }
}

/// What opens the element at the cursor, also when it is misspelt or missing; end_of_unit when
/// there is no element.
TokenKind Parser::chart_element_opener() noexcept {
    if (at(chart_openers))
        return at_chart_word() ? kind() : TokenKind::end_of_unit;
    const TokenKind misspelt = misspelt_chart_word();
    return misspelt != TokenKind::end_of_unit ? misspelt : missing_chart_word();
}

/// A word of charts that is not used as the name of a variable.
bool Parser::at_chart_word() const noexcept {
    static constexpr TokenSet after_variable{TokenKind::assign, TokenKind::dot,
                                             TokenKind::left_bracket, TokenKind::left_parenthesis,
                                             TokenKind::caret};
    return at(TokenKind::kw_transition) || (at(chart_openers) && !after_variable.contains(peek()));
}

/// `INITIAL STEP`, or a word like `STPE` before the name of an element.
TokenKind Parser::misspelt_chart_word() const noexcept {
    if (!at(TokenKind::identifier))
        return TokenKind::end_of_unit;
    if (peek() == TokenKind::kw_step && names_equal(text(at_), "INITIAL"))
        return TokenKind::kw_initial_step;
    const std::uint32_t second = next(at_);
    const bool transition =
        begins_from(second) || (peek() == TokenKind::identifier && begins_from(next(second)));
    if (transition)
        return is_misspelling(text(at_), spelling(TokenKind::kw_transition))
                   ? TokenKind::kw_transition
                   : TokenKind::end_of_unit;
    if (peek() != TokenKind::identifier || peek_second() != TokenKind::colon)
        return TokenKind::end_of_unit;
    for (const TokenKind word :
         {TokenKind::kw_step, TokenKind::kw_initial_step, TokenKind::kw_action})
        if (is_misspelling(text(at_), spelling(word)))
            return word;
    return TokenKind::end_of_unit;
}

/// At `name :` or at FROM: the opening word that is missing before it, as the next closing word
/// tells.
TokenKind Parser::missing_chart_word() noexcept {
    if (begins_from(at_) || (at(TokenKind::identifier) && begins_from(next(at_))))
        return TokenKind::kw_transition;
    if (!at(TokenKind::identifier) || peek() != TokenKind::colon)
        return TokenKind::end_of_unit;
    return opener_of(tokens_[next_chart_word()].kind());
}

/// Where the next word stands that opens or closes an element, or ends the unit. However often it
/// is asked for, no token is looked at twice on the way forwards.
std::uint32_t Parser::next_chart_word() noexcept {
    static constexpr TokenSet words = chart_openers | chart_closers | unit_ends;
    if (at_ < chart_word_sought_from_ || at_ > chart_word_) {
        chart_word_sought_from_ = at_;
        chart_word_ = at_;
        while (!words.contains(tokens_[chart_word_].kind()))
            chart_word_ = next(chart_word_);
    }
    return chart_word_;
}

/// Takes the word that opens an element, or reports that it is misspelt or missing.
void Parser::open_chart_element(TokenKind opener) {
    const std::uint32_t first = at_;
    const TokenKind closer = closer_of(opener);
    const std::string word(spelling(opener));
    if (!accept(opener)) {
        change_unclosed(closer, 1);
        if (misspelt_chart_word() == opener) {
            const bool split = peek() == TokenKind::kw_step;
            const TextRange words = token_range(first, split ? next(at_) + 1 : at_ + 1);
            report(DiagnosticId::misspelt_word, words,
                   {text_.substr(words.begin, words.size()), word})
                .replace(words, word);
            change_unclosed(closer, split ? -1 : 0);
            if (split)
                advance();
            advance();
        } else {
            const std::uint32_t offset = token().offset();
            report(DiagnosticId::missing_token, {offset, offset}, {"`" + word + "`"})
                .insert(offset, word + " ");
        }
    }
    open_block(closer, first);
}

/// Where an element ends, with its closing word or without.
bool Parser::at_end_of_chart_element() {
    return at(chart_closers) || at(unit_ends) || at_chart_word() || at_misspelt_closer() ||
           misspelt_chart_word() != TokenKind::end_of_unit ||
           (at_mismatched_closer() && unclosed(open_.back().closer) > 0);
}

/// True when what follows belongs to the chart in whose action, or among whose elements,
/// statements stand.
bool Parser::at_chart_structure() {
    if (!in_chart_)
        return false;
    const bool in_action = is_open(TokenKind::kw_end_action) && !between_chart_elements_;
    if (begins_chart_element(at_))
        return !in_action || unclosed(TokenKind::kw_end_action) > 0;
    return at(chart_closers) && !in_action;
}

/// Passes over a step, transition or action that begins at the cursor, and has its closing word.
/// False when there is none.
bool Parser::skip_chart_element() {
    const std::uint32_t closer = begins_chart_element(at_) ? chart_element_end(at_) : at_;
    if (closer == at_)
        return false;
    advance_past(closer);
    return true;
}

/// What is no element: text before, between and behind elements. All statements in a row are one
/// finding.
const ast::SkippedText* Parser::skip_text_in_chart() {
    auto* skipped = make<ast::SkippedText>();
    if (at(chart_closers)) {
        report_at(at_, DiagnosticId::stray_closing_word, {text(at_)}).remove(token().range());
        advance();
        return finish(skipped);
    }
    if (at(block_openers)) {
        parse_misplaced_declarations();
        return finish(skipped);
    }
    report_at(at_, DiagnosticId::unexpected_token,
              {"a step, a transition or an action", describe(at_)});
    if (at_statement_start()) {
        ListBuilder<ast::Statement> statements(*this);
        const bool outer = std::exchange(between_chart_elements_, true);
        parse_statements(statements);
        between_chart_elements_ = outer;
    } else {
        do
            skip_balanced();
        while (!at(block_openers) && !at_end_of_chart_element());
    }
    // An element that was closed too early, or whose first words cannot be read.
    if (at(chart_closers) && !is_open(kind()))
        advance();
    return finish(skipped);
}

/// The `:` behind the name of a step or an action. `ACTION x(P):` has the qualifier of a step.
void Parser::expect_colon_of_chart() {
    static constexpr TokenSet look_alikes{TokenKind::assign, TokenKind::equal, TokenKind::semicolon,
                                          TokenKind::comma};
    const std::uint32_t close = at(TokenKind::left_parenthesis) ? closing_parenthesis(at_) : count_;
    if (close != count_ && on_same_line(at_, close)) {
        const std::uint32_t behind = next(close);
        const bool line_ends = tokens_[behind].first_on_line();
        const bool colon = tokens_[behind].kind() == TokenKind::colon && !line_ends;
        if (colon || line_ends) {
            report_unexpected("`:`").replace(token_range(at_, close + 1), colon ? "" : ":");
            advance_past(close);
            if (line_ends)
                return;
        }
    }
    if (at(look_alikes))
        accept_as(TokenKind::colon);
    else
        expect(TokenKind::colon);
}

// ---- steps --------------------------------------------------------------------------------------

// initial_step = "INITIAL_STEP" step_name ":" { action_association ";" } "END_STEP" ;
// step = "STEP" step_name ":" { action_association ";" } "END_STEP" ;
// step_name = identifier ;
const ast::Step* Parser::parse_step(TokenKind opener) {
    auto* step = make<ast::Step>();
    step->initial = opener == TokenKind::kw_initial_step;
    open_chart_element(opener);
    step->name = parse_unit_name("the name of a step");
    expect_colon_of_chart();
    step->actions = parse_action_associations();
    close_block("");
    finish(step);
    accept_extra_semicolon();
    return step;
}

// Part of step: { action_association ";" }
Parser::Children<ast::ActionAssociation> Parser::parse_action_associations() {
    ListBuilder<ast::ActionAssociation> associations(*this);
    while (!at_end_of_chart_element() || at_element_in_step()) {
        if (at_element_in_step()) {
            report_unexpected("an action or `END_STEP`");
            skip_chart_element();
            accept(TokenKind::semicolon);
            continue;
        }
        if (at(TokenKind::semicolon)) {
            report_unexpected("an action or `END_STEP`").remove(token().range());
            advance();
            continue;
        }
        add_in_loop(associations, [&] { return parse_action_association(); });
        expect_semicolon_of_association();
    }
    return associations.finish();
}

/// At an element with its closing word, when more of the step that it stands in follows.
bool Parser::at_element_in_step() {
    if (!begins_chart_element(at_) || unclosed(TokenKind::kw_end_step) > 0)
        return false;
    const std::uint32_t closer = chart_element_end(at_);
    if (closer == at_)
        return false;
    std::uint32_t behind = next(closer);
    if (tokens_[behind].kind() == TokenKind::semicolon)
        behind = next(behind);
    return tokens_[behind].kind() == TokenKind::kw_end_step ||
           (tokens_[behind].kind() == TokenKind::identifier &&
            tokens_[next(behind)].kind() == TokenKind::left_parenthesis &&
            !begins_from(next(behind)));
}

// action_association = action_name "(" [ action_qualifier ] { "," indicator_name } ")" ;
const ast::ActionAssociation* Parser::parse_action_association() {
    auto* node = make<ast::ActionAssociation>();
    node->action_name = parse_name("the name of an action");
    const bool missing =
        !node->action_name->missing && !at(TokenKind::left_parenthesis) &&
        (at(TokenKind::semicolon) || token().first_on_line() || at_end_of_chart_element());
    if (missing) {
        report_missing(DiagnosticId::missing_token, {"`(N)`"}).insert(previous_end(), "(N)");
        return finish(node);
    }
    if (node->action_name->missing || !expect_qualifier_parenthesis()) {
        skip_association();
        return finish(node);
    }
    if (!at(TokenKind::comma) && !at(TokenKind::right_parenthesis))
        node->qualifier = parse_action_qualifier();
    ListBuilder<ast::Expression> indicators(*this);
    while (accept(TokenKind::comma) || (at(TokenKind::identifier) && accept_missing_comma()))
        indicators.add(parse_indicator());
    expect_closing(TokenKind::right_parenthesis);
    node->indicators = indicators.finish();
    return finish(node);
}

/// The `(` behind the name of an action. False when nothing like an association follows.
bool Parser::expect_qualifier_parenthesis() {
    if (accept(TokenKind::left_parenthesis))
        return true;
    const bool qualifier = at(TokenKind::identifier) &&
                           qualifier_named(text(at_)) != ast::ActionQualifierKind::unknown &&
                           argument_list_closes(at_);
    if (qualifier) {
        expect(TokenKind::left_parenthesis);
        return true;
    }
    report_unexpected("`(`");
    return false;
}

/// Passes over what is left of an association that cannot be read. Statements end where statements
/// do.
void Parser::skip_association() {
    const std::uint32_t first = at_;
    if (at(statement_words)) {
        const ast::Statement* statement = parse_statement();
        expect_semicolon_of_statement(*statement);
        reported_at_ = at_; // statements in a row are one mistake
        return;
    }
    while (!at(TokenKind::semicolon) && !at_end_of_chart_element()) {
        const bool association = at(TokenKind::identifier) && peek() == TokenKind::left_parenthesis;
        if (at_ != first && token().first_on_line() && association)
            break;
        skip_balanced();
    }
    reported_at_ = at_; // a missing `;` is part of the same mistake
}

void Parser::expect_semicolon_of_association() {
    if (accept(TokenKind::semicolon))
        return;
    static constexpr TokenSet look_alikes{TokenKind::comma, TokenKind::colon, TokenKind::dot};
    if (at(look_alikes) && reported_at_ != at_) {
        accept_as(TokenKind::semicolon);
        return;
    }
    if (at_end_of_chart_element() || token().first_on_line() || at(TokenKind::identifier)) {
        report_missing_semicolon();
        return;
    }
    report_unexpected("`;`");
    skip_association();
    accept(TokenKind::semicolon);
}

// action_qualifier = "N" | "R" | "S" | "P" | "P0" | "P1" | timed_qualifier "," action_time ;
// timed_qualifier = "L" | "D" | "SD" | "DS" | "SL" ;
const ast::ActionQualifier* Parser::parse_action_qualifier() {
    auto* node = make<ast::ActionQualifier>();
    if (!at(TokenKind::identifier)) {
        report_unexpected("an action qualifier");
        if (at(TokenKind::duration))
            advance();
        return finish(node);
    }
    node->qualifier = qualifier_named(text(at_));
    const bool known = node->qualifier != ast::ActionQualifierKind::unknown;
    if (!known)
        report_unknown_qualifier();
    const std::uint32_t qualifier = advance();
    if (!known)
        reported_at_ = at_; // what is no qualifier may go on

    const bool duration = at(TokenKind::comma) && peek() == TokenKind::duration;
    if (is_timed(node->qualifier)) {
        node->time = parse_time_of_qualifier();
    } else if (duration && known) {
        report(DiagnosticId::time_of_untimed_qualifier, tokens_[next(at_)].range(),
               {text(qualifier)})
            .remove(token_range(at_, next(at_) + 1));
        advance();
        advance();
    } else if (duration) {
        advance();
        node->time = parse_action_time();
    }
    return finish(node);
}

void Parser::report_unknown_qualifier() {
    Report unknown = report_at(at_, DiagnosticId::unknown_action_qualifier, {text(at_)});
    if (const std::string_view meant = meant_qualifier(text(at_)); !meant.empty())
        unknown.replace(token().range(), std::string(meant));
}

// Part of action_qualifier: "," action_time
const ast::Expression* Parser::parse_time_of_qualifier() {
    if (accept(TokenKind::comma))
        return parse_action_time();
    if (at(TokenKind::duration) || at(TokenKind::identifier)) {
        expect(TokenKind::comma);
        return parse_action_time();
    }
    report_missing(DiagnosticId::missing_token, {"`,` with a time"});
    return make_missing<ast::ErrorExpression>();
}

// action_time = duration | variable_name ;
const ast::Expression* Parser::parse_action_time() {
    if (at(TokenKind::duration) && operator_strength(peek()) == 0)
        return parse_constant();
    return parse_parameter_of_action("an action time");
}

// indicator_name = variable_name ;
const ast::Expression* Parser::parse_indicator() {
    return parse_parameter_of_action("an indicator");
}

/// Part of action_time, indicator_name: a simple name (6.1 D27); a part of a variable, or an
/// expression, is an extension.
const ast::Expression* Parser::parse_parameter_of_action(std::string_view what) {
    const std::size_t reports = diagnostics_.size();
    const std::uint32_t first = at_;
    const bool control = at(execution_control) && !used_as_name(kind());
    const ast::Expression* expression = parse_expression();
    if (control)
        report_reserved_word(first);
    if (expression->missing || diagnostics_.size() != reports ||
        expression->kind == ast::NodeKind::variable_name)
        return expression;
    if (ast::is<ast::Constant>(expression->kind)) {
        report_node(*expression, DiagnosticId::unexpected_token, {what, "a constant"});
        return expression;
    }
    const char* found = nullptr;
    switch (expression->kind) {
    case ast::NodeKind::structured_variable: found = "a member"; break;
    case ast::NodeKind::array_variable: found = "an array element"; break;
    case ast::NodeKind::direct_variable: found = "a directly represented variable"; break;
    default: found = "an expression"; break;
    }
    report_node(*expression, DiagnosticId::parameter_of_action, {found, what});
    return expression;
}

// ---- transitions --------------------------------------------------------------------------------

// transition = "TRANSITION" [ transition_name ] [ "(" "PRIORITY" ":=" integer ")" ]
//              "FROM" steps "TO" steps
//              transition_condition
//              "END_TRANSITION" ;
const ast::Transition* Parser::parse_transition() {
    auto* node = make<ast::Transition>();
    open_chart_element(TokenKind::kw_transition);
    node->name = parse_optional_transition_name();
    const bool colon = node->name != nullptr && at(TokenKind::colon);
    if (colon && behind_priority(next(at_)) != next(at_)) // as behind the name of a step
        drop_intruder("`(`");
    node->priority = parse_optional_priority();
    node->from = parse_steps_behind(TokenKind::kw_from);
    node->to = parse_steps_behind(TokenKind::kw_to);
    if (at(TokenKind::kw_from)) {
        if (!node->from->missing) // else the parts are in the wrong order, which was reported
            report_unexpected("`:=`");
        advance();
        parse_steps();
    }
    const std::size_t reports = diagnostics_.size();
    node->condition = parse_transition_condition();
    skip_rest_of_transition(diagnostics_.size() != reports);
    close_block("");
    finish(node);
    accept_extra_semicolon();
    return node;
}

// transition_name = identifier ;
/// A name with TO behind it is a step, and FROM is missing before it.
const ast::Identifier* Parser::parse_optional_transition_name() {
    static constexpr TokenSet behind_step{TokenKind::kw_to, TokenKind::comma};
    if (at(TokenKind::identifier)) {
        const bool step =
            behind_step.contains(peek()) && find_on_line(TokenKind::kw_from) == count_;
        const bool other = step || begins_priority(at_) ||
                           (peek() == TokenKind::identifier &&
                            is_misspelling(text(at_), spelling(TokenKind::kw_from)));
        return other ? nullptr : parse_declared_name("the name of a transition");
    }
    const bool keyword = is_keyword(kind()) && !at(TokenKind::kw_from) && !at(TokenKind::kw_to) &&
                         (peek() == TokenKind::kw_from || peek() == TokenKind::left_parenthesis);
    if (!keyword)
        return nullptr;
    report_reserved_word(at_);
    return make_identifier();
}

/// True when PRIORITY and its value stand at token `index`, perhaps misspelt.
bool Parser::begins_priority(std::uint32_t index) const noexcept {
    const TokenKind after = tokens_[next(index)].kind();
    return tokens_[index].kind() == TokenKind::identifier &&
           (after == TokenKind::assign || after == TokenKind::equal ||
            after == TokenKind::integer) &&
           is_misspelling(text(index), "PRIORITY");
}

/// Behind a priority in parentheses that begins at token `index`; `index` when there is none.
std::uint32_t Parser::behind_priority(std::uint32_t index) const noexcept {
    if (tokens_[index].kind() != TokenKind::left_parenthesis || !begins_priority(next(index)))
        return index;
    const std::uint32_t close = closing_parenthesis(index);
    return close == count_ ? index : next(close);
}

/// True when FROM follows at token `index`, or behind a priority.
bool Parser::begins_from(std::uint32_t index) const noexcept {
    return tokens_[behind_priority(index)].kind() == TokenKind::kw_from;
}

// Part of transition: [ "(" "PRIORITY" ":=" integer ")" ]
const ast::Expression* Parser::parse_optional_priority() {
    const bool parenthesis = at(TokenKind::left_parenthesis) &&
                             (peek() == TokenKind::integer || peek_second() == TokenKind::assign ||
                              begins_priority(next(at_)));
    if (!parenthesis && !begins_priority(at_))
        return nullptr;
    const std::uint32_t first = at_;
    const std::size_t reports = diagnostics_.size();
    if (parenthesis)
        advance();
    if (at(TokenKind::integer)) {
        report_missing(DiagnosticId::missing_token, {"`PRIORITY :=`"})
            .insert(token().offset(), "PRIORITY := ");
    } else {
        expect_priority_word();
        expect_assign();
    }
    const ast::Expression* priority = parse_integer("a priority");
    if (parenthesis)
        expect_closing(TokenKind::right_parenthesis);
    else if (diagnostics_.size() == reports)
        report_missing_parentheses(first, "the priority");
    return priority;
}

void Parser::expect_priority_word() {
    if (!at_word("PRIORITY")) {
        if (is_misspelling(text(at_), "PRIORITY"))
            report_at(at_, DiagnosticId::misspelt_word, {text(at_), "PRIORITY"})
                .replace(token().range(), "PRIORITY");
        else
            report_unexpected("`PRIORITY`").replace(token().range(), "PRIORITY");
    }
    advance();
}

/// `( )` around what stands from token `first` to the cursor.
void Parser::report_missing_parentheses(std::uint32_t first, std::string_view around) {
    const std::uint32_t before = tokens_[first - 1].end();
    const Report missing = report(DiagnosticId::missing_token, {before, before},
                                  {"`( )` around " + std::string(around)});
    diagnostics_[missing.index()].fixes.push_back(
        {{{{tokens_[first].offset(), tokens_[first].offset()}, "("},
          {{previous_end(), previous_end()}, ")"}}});
}

// Part of transition: "FROM" steps "TO" steps
/// One of the two.
const ast::Steps* Parser::parse_steps_behind(TokenKind word) {
    static constexpr TokenSet condition{TokenKind::assign, TokenKind::equal, TokenKind::colon,
                                        TokenKind::semicolon};
    const std::string words(spelling(word));
    const bool to_first = word == TokenKind::kw_from && at(TokenKind::kw_to);
    if (to_first && find_on_line(word) < count_) {
        report_unexpected("`" + words + "`");
        return make_missing<ast::Steps>();
    }
    if ((at(condition) && peek() != word) || to_first || (!at(word) && at_end_of_chart_element())) {
        report_missing(DiagnosticId::missing_token, {"`" + words + "` with a step"});
        return make_missing<ast::Steps>();
    }
    const bool arrow = word == TokenKind::kw_to && accept_arrow();
    if (!arrow && !accept(word) && !accept_misspelt_part(word)) {
        if (peek() != word && find_on_line(word) < count_) {
            report_unexpected("`" + words + "`");
            skip_to({word, TokenKind::semicolon, TokenKind::assign});
            accept(word);
        } else if (at(TokenKind::identifier) && peek() == TokenKind::identifier &&
                   condition.contains(peek_second())) { // `JUMP step`
            report_unexpected("`" + words + "`").replace(token().range(), words);
            advance();
        } else {
            expect(word);
        }
    }
    return parse_steps();
}

/// `->` for TO.
bool Parser::accept_arrow() {
    const std::uint32_t second = next(at_);
    if (!at(TokenKind::minus) || tokens_[second].kind() != TokenKind::greater ||
        tokens_[second].offset() != token().end())
        return false;
    const TextRange arrow = token_range(at_, second + 1);
    report(DiagnosticId::unexpected_token, arrow, {"`TO`", "`->`"}).replace(arrow, "TO");
    advance();
    advance();
    return true;
}

/// A word like `FORM` before a step.
bool Parser::accept_misspelt_part(TokenKind word) {
    const bool step = peek() == TokenKind::identifier || peek() == TokenKind::left_parenthesis;
    const std::string meant(spelling(word));
    if (!at(TokenKind::identifier) || !step || !is_misspelling(text(at_), meant))
        return false;
    report_at(at_, DiagnosticId::misspelt_word, {text(at_), meant}).replace(token().range(), meant);
    advance();
    return true;
}

// steps = step_name | "(" step_name "," step_name { "," step_name } ")" ;
const ast::Steps* Parser::parse_steps() {
    auto* node = make<ast::Steps>();
    const std::uint32_t first = at_;
    const std::size_t reports = diagnostics_.size();
    const bool parenthesis = accept(TokenKind::left_parenthesis);
    ListBuilder<ast::Identifier> names(*this);
    do
        names.add(parse_name("the name of a step"));
    while (accept(TokenKind::comma) ||
           (parenthesis && at(TokenKind::identifier) && accept_missing_comma()));
    if (!parenthesis && at(TokenKind::right_parenthesis) && at_ > first + 1) {
        const std::uint32_t offset = tokens_[first].offset();
        report(DiagnosticId::missing_token, {offset, offset}, {"`(`"}).insert(offset, "(");
        advance();
    }
    const std::uint32_t last = at_;
    static constexpr TokenSet behind{TokenKind::assign, TokenKind::equal, TokenKind::colon};
    if (parenthesis && at(behind))
        expect(TokenKind::right_parenthesis);
    else if (parenthesis)
        expect_closing(TokenKind::right_parenthesis);
    node->names = names.finish();
    finish(node);
    if (diagnostics_.size() != reports)
        return node;
    if (parenthesis && node->names.size() == 1) {
        const Report single = report_node(*node, DiagnosticId::parentheses_of_one_step);
        diagnostics_[single.index()].fixes.push_back(
            {{{tokens_[first].range(), {}}, {tokens_[last].range(), {}}}});
    } else if (!parenthesis && node->names.size() > 1) {
        report_missing_parentheses(first, "the steps");
    }
    return node;
}

// transition_condition = ":" { EOL } simple_instr_list | ":=" expression ";" ;
const ast::TransitionCondition* Parser::parse_transition_condition() {
    auto* node = make<ast::TransitionCondition>();
    if (at(TokenKind::semicolon) || at_end_of_chart_element()) {
        report_missing(DiagnosticId::missing_token, {"`:=` with a condition"});
        node->condition = make_missing<ast::ErrorExpression>();
        accept(TokenKind::semicolon);
        return finish(node);
    }
    if (at(TokenKind::colon) && peek() == TokenKind::semicolon) { // in no language
        advance();
        node->condition = parse_missing_expression();
        advance();
        return finish(node);
    }
    const bool instructions = at(TokenKind::colon)
                                  ? instructions_follow_colon()
                                  : line_kind(at_, LineKind::other) == LineKind::operation;
    if (instructions) {
        expect(TokenKind::colon);
        const ast::InstructionList* list = parse_simple_instruction_list("a transition condition");
        node->condition = list;
        if (list->instructions.empty())
            report_missing(DiagnosticId::missing_token, {"an instruction"});
        return finish(node);
    }
    static constexpr TokenSet begin{TokenKind::assign, TokenKind::colon, TokenKind::equal,
                                    TokenKind::equal_equal, TokenKind::output_arrow};
    if (!at(begin) && find_on_line(TokenKind::assign) < count_) {
        report_unexpected("`:=`");
        skip_to({TokenKind::assign});
    }
    expect_assign();
    node->condition = parse_condition();
    expect_semicolon_of_condition();
    return finish(node);
}

/// At the `:` of a condition: false when an expression with its `;` stands there, behind `:` for
/// `:=`.
bool Parser::instructions_follow_colon() const noexcept {
    if (peek() == TokenKind::equal)
        return false;
    std::uint32_t i = next(at_);
    if (line_kind(i, LineKind::operation) != LineKind::other)
        return true;
    while (tokens_[i].kind() != TokenKind::semicolon) {
        if (chart_closers.contains(tokens_[i].kind()) || begins_chart_element(i) ||
            unit_ends.contains(tokens_[i].kind()))
            return true;
        i = next(i);
    }
    return false;
}

void Parser::expect_semicolon_of_condition() {
    if (accept_semicolon())
        return;
    if (at_end_of_chart_element() || token().first_on_line()) {
        report_missing_semicolon();
        return;
    }
    report_unexpected("an operator or `;`");
    std::uint32_t blocks = 0; // a statement for the condition is passed over to its end
    while ((blocks > 0 || !at(TokenKind::semicolon)) && !at_end_of_chart_element()) {
        blocks += at(block_statements) ? 1 : 0;
        blocks -= at(statement_closers) && blocks > 0 ? 1 : 0;
        advance();
    }
    accept(TokenKind::semicolon);
}

/// Text between the condition and END_TRANSITION. Instructions behind a condition that was
/// `reported` are a second one, and what is wrong with the first cannot be mended alone.
void Parser::skip_rest_of_transition(bool reported) {
    if (at_end_of_chart_element())
        return;
    if (reported && line_kind(at_, LineKind::other) == LineKind::operation) {
        diagnostics_.back().fixes.clear();
    } else {
        Report rest = report_unexpected("`END_TRANSITION`");
        if (at(TokenKind::semicolon))
            rest.remove(token().range());
    }
    while (!at_end_of_chart_element())
        skip_balanced();
}

// ---- actions ------------------------------------------------------------------------------------

// action = "ACTION" action_name ":" function_block_body "END_ACTION" ;
// action_name = identifier ;
const ast::Action* Parser::parse_action() {
    auto* node = make<ast::Action>();
    open_chart_element(TokenKind::kw_action);
    node->name = parse_unit_name("the name of an action");
    expect_colon_of_chart();
    const NestingGuard guard(*this);
    node->body = guard.too_deep() ? parse_too_deep_body() : parse_body();
    close_block("");
    finish(node);
    accept_extra_semicolon();
    return node;
}

/// In place of function_block_body: passes over the body of an action that is nested too deep.
const ast::Body* Parser::parse_too_deep_body() {
    auto* body = make<ast::StatementList>();
    std::uint32_t depth = 0;
    while (!at(unit_ends) && (depth > 0 || !at(TokenKind::kw_end_action))) {
        depth += begins_chart_element(at_) && at(TokenKind::kw_action) ? 1 : 0;
        depth -= at(TokenKind::kw_end_action) ? 1 : 0;
        advance();
    }
    return finish(body);
}

} // namespace iecfront
