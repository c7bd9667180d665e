#include "parser/keyword_sets.hpp"
#include "parser/parser.hpp"

#include <array>
#include <utility>

namespace iecfront {
namespace {

constexpr TokenSet argument_marks{TokenKind::assign, TokenKind::output_arrow, TokenKind::equal};

} // namespace

// ---- arguments ----------------------------------------------------------------------------------

/// Part of il_fb_call: non-formal arguments in parentheses, from behind the `(` or the first of
/// them.
Parser::Children<ast::Node> Parser::parse_il_arguments(std::uint32_t open,
                                                       const ast::Expression* first) {
    ListBuilder<ast::Node> arguments(*this);
    const auto add = [&](const ast::Expression* value) {
        auto* argument = make_from<ast::InputArgument>(value);
        argument->value = value;
        argument->end_token = value->end_token;
        arguments.add(argument);
    };
    if (first != nullptr)
        add(first);
    ++il_parentheses_;
    if (first == nullptr && at(TokenKind::comma) && peek() == TokenKind::right_parenthesis)
        drop_intruder("`)`");
    if (first == nullptr && !at(TokenKind::right_parenthesis))
        add(expect_il_operand("`(`"));
    while (accept_il_comma()) {
        if (at_formal_argument(at_))
            arguments.add(parse_il_argument(true));
        else
            add(parse_next_il_operand());
    }
    --il_parentheses_;
    const Children<ast::Node> list = arguments.finish();
    check_arguments(list);
    if (at(TokenKind::right_parenthesis)) {
        if (at_line_end())
            report_line_end();
        advance();
        return list;
    }
    if (!at_line_end() && !at_end_of_instructions() && !at(TokenKind::semicolon)) {
        report_unexpected("`,` or `)`");
        skip_line();
        return list;
    }
    report_missing(DiagnosticId::missing_token, {"`)`"})
        .label(LabelId::opened_here, open)
        .insert(previous_end(), ")");
    return list;
}

/// `name :=`, `name =>` or `NOT name =>`, also with `=` for `:=`, and with slips that can be
/// nothing else.
bool Parser::at_formal_argument(std::uint32_t index) const noexcept {
    static constexpr TokenSet slips{TokenKind::colon, TokenKind::minus};
    if (tokens_[index].kind() == TokenKind::kw_not)
        index = next(index);
    const std::uint32_t mark = next(index);
    const TokenKind kind = tokens_[mark].kind();
    return begins_name(index) &&
           (argument_marks.contains(kind) || (slips.contains(kind) && mark_slip(mark).end != 0));
}

/// The same with its mark on one line. Behind an operator the mark does not end it: it would be in
/// the place of an operand or `(`.
bool Parser::has_mark_on_line(std::uint32_t index) const noexcept {
    if (!at_formal_argument(index))
        return false;
    const std::uint32_t name = tokens_[index].kind() == TokenKind::kw_not ? next(index) : index;
    const std::uint32_t mark = next(name);
    return !begins_line(mark) && !is_expression_operator(name) &&
           (!begins_line(next(mark)) || il_operator(name) == nullptr);
}

/// The same at the beginning of a line that goes on behind the mark.
bool Parser::begins_argument_line(std::uint32_t index) const noexcept {
    const std::uint32_t name = tokens_[index].kind() == TokenKind::kw_not ? next(index) : index;
    return begins_line(index) && has_mark_on_line(index) && !begins_line(next(next(name)));
}

bool Parser::begins_name(std::uint32_t index) const noexcept {
    return tokens_[index].kind() == TokenKind::identifier || is_keyword(tokens_[index].kind());
}

// ---- calls over several lines -------------------------------------------------------------------

/// Behind the name of what is called, at token `index`: true when formal arguments follow, or any
/// on lines of their own. Their `(` may be missing, and another token may stand in its place or
/// beside it.
bool Parser::argument_lines_follow(std::uint32_t index) const noexcept {
    const std::uint32_t behind = next(index);
    if (begins_line(index))
        return begins_argument_line(index) && lacks_parenthesis(index);
    if (tokens_[index].kind() == TokenKind::left_parenthesis)
        return has_mark_on_line(behind) || has_mark_on_line(next(behind)) ||
               (begins_line(behind) && rest_of_line(behind).last == TokenKind::comma &&
                has_formal_argument(index));
    if (tokens_[behind].kind() == TokenKind::left_parenthesis && !begins_line(behind))
        return begins_argument_line(next(behind));
    return begins_argument_line(behind) && lacks_parenthesis(behind);
}

/// Behind an operator that instructions can follow, at the `(` at token `open`: true when the first
/// line in the parentheses is a statement of ST that looks like an argument. Arguments or a `)`
/// follow an argument, and instructions a statement.
bool Parser::statement_begins_in_parentheses(std::uint32_t open) const noexcept {
    const std::uint32_t first = next(open);
    const bool operand = !begins_line(first) && !at_formal_argument(first);
    const std::uint32_t line = operand ? next(first) : first;
    if (tokens_[open].kind() != TokenKind::left_parenthesis || begins_line(open) ||
        !begins_argument_line(line) || opens_line(next(next(line))))
        return false;
    RestOfLine rest = rest_of_line(line);
    for (std::uint32_t lines = 0; rest.last == TokenKind::semicolon && lines < furthest_on_line &&
                                  begins_argument_line(rest.end);
         ++lines) // several statements
        rest = rest_of_line(rest.end);
    if (rest.parentheses > 0 || rest.closed || (rest.last == TokenKind::comma && !operand))
        return false;
    const bool closes = tokens_[rest.end].kind() == TokenKind::right_parenthesis;
    return closes ? operand && rest.last == TokenKind::semicolon : !has_mark_on_line(rest.end);
}

bool Parser::at_argument_lines() const noexcept {
    return opens_line(at_) || argument_lines_follow(at_);
}

/// `(` at the end of a line.
bool Parser::opens_line(std::uint32_t index) const noexcept {
    return tokens_[index].kind() == TokenKind::left_parenthesis && !begins_line(index) &&
           begins_line(next(index));
}

/// Passes over the `(` before arguments on lines of their own, and reports what is wrong with it.
void Parser::expect_parenthesis_of_arguments() {
    const bool open = at(TokenKind::left_parenthesis) && !at_line_end();
    if (at_line_end()) {
        report_missing(DiagnosticId::missing_token, {"`(`"}).insert(previous_end(), "(");
    } else if (!open && !begins_line(next(at_))) {
        drop_intruder("`(`");
        advance();
    } else if (!open) {
        accept_as(TokenKind::left_parenthesis);
    } else {
        advance();
        if (at_line_end() || has_mark_on_line(at_) || !begins_argument_line(next(at_)))
            return;
        drop_intruder("the end of the line");
    }
}

// il_param_list = { il_param_instruction } il_param_last_instruction ;
// il_param_instruction = ( il_param_assignment | il_param_out_assignment ) "," EOL { EOL } ;
// il_param_last_instruction = ( il_param_assignment | il_param_out_assignment ) EOL { EOL } ;
/// From behind the `(` at token `open`, or what stands in its place.
Parser::Children<ast::Node> Parser::parse_il_param_list(std::uint32_t open, bool function) {
    const bool closed = parenthesis_closes(open);
    MissingLineEnds missing;
    ListBuilder<ast::Node> arguments(*this);
    if (function || !at(TokenKind::right_parenthesis))
        expect_line_end_in(missing, "after `(`");
    ++il_parentheses_;
    bool formal = true; // as the last one
    while (!at_end_of_il_arguments(closed)) {
        const std::uint32_t begin = at_;
        const std::size_t reports = diagnostics_.size();
        if (at(TokenKind::comma) && !at_intruder_before_argument() && !has_mark(at_))
            report_unexpected("an argument");
        else
            add_in_loop(arguments, [&] {
                const ast::Node* argument = parse_il_argument(formal);
                formal = is_formal(*argument);
                return argument;
            });
        if (at_ == begin && !at(TokenKind::comma))
            advance(); // also over a `;`, which add_in_loop() leaves
        expect_end_of_argument(missing, closed, diagnostics_.size() != reports);
    }
    close_il_parenthesis(open, missing);
    const Children<ast::Node> list = arguments.finish();
    check_il_arguments(list, open);
    return list;
}

bool Parser::at_end_of_il_arguments(bool closed) {
    if (at_end_of_instructions() || at_stand_in_for_parenthesis())
        return true;
    if (at(TokenKind::right_parenthesis))
        return !at_stray_parenthesis();
    return !closed && !at(TokenKind::comma) && !at_formal_argument(at_) &&
           !at_intruder_before_argument() && !has_mark(at_) && !at_argument_with_intruder();
}

/// At a `)` before another argument, when there is one too many.
bool Parser::at_stray_parenthesis() const noexcept {
    if (!at(TokenKind::right_parenthesis))
        return false;
    const std::uint32_t second = next(at_);
    const std::uint32_t behind = tokens_[second].kind() == TokenKind::comma ? next(second) : second;
    const bool mark = argument_marks.contains(tokens_[second].kind()) && !begins_line(second);
    return (mark || at_formal_argument(behind)) && surplus_parentheses() > 0;
}

/// Only formal arguments stand on lines of their own.
void Parser::check_il_arguments(Children<ast::Node> arguments, std::uint32_t open) {
    check_arguments(arguments);
    if (arguments.empty())
        return;
    const auto* first = ast::as<ast::InputArgument>(arguments.front());
    const std::uint32_t behind = tokens_[open].end();
    if (first != nullptr && first->name == nullptr && !first->value->missing)
        report(DiagnosticId::line_end_in_instruction, {behind, behind});
}

/// "," EOL, or the end of the list. What is left of an argument that was `reported` is passed over.
void Parser::expect_end_of_argument(MissingLineEnds& missing, bool closed, bool reported) {
    if (reported)
        skip_argument();
    if (at_stray_parenthesis())
        return report_parenthesis_for_comma();
    if (at(TokenKind::comma)) {
        if (at_line_end() && reported_at_ != at_)
            report_line_end();
        const std::uint32_t comma = advance();
        if (at(TokenKind::right_parenthesis))
            report_at(comma, DiagnosticId::unexpected_token, {"`)`", "`,`"})
                .remove(tokens_[comma].range());
        else if (!at(TokenKind::comma))
            expect_line_end_in(missing, "after `,`");
        return;
    }
    if (at(TokenKind::right_parenthesis) || at_end_of_instructions())
        return;
    if (at_formal_argument(at_)) {
        report_missing(DiagnosticId::missing_token, {"`,`"}).insert(previous_end(), ",");
        expect_line_end_in(missing, "after `,`");
        return;
    }
    if (at_line_end() && (reported || !closed))
        return;
    if (!at_line_end() && at_formal_argument(next(at_))) {
        accept_as(TokenKind::comma);
        return;
    }
    report_unexpected("`,` or `)`");
    skip_argument();
    accept(TokenKind::comma);
}

/// A `)` in the place of the comma, or before it.
void Parser::report_parenthesis_for_comma() {
    const bool comma = peek() == TokenKind::comma;
    const std::uint32_t begin = at_line_end() ? previous_end() : token().offset();
    report_at(at_, DiagnosticId::unexpected_token, {"`,`", describe(at_)})
        .replace({begin, token().end()}, comma ? "" : ",");
    advance();
    accept(TokenKind::comma);
}

/// Passes over a token that stands before what is `expected`.
void Parser::drop_intruder(std::string_view expected) {
    report_at(at_, DiagnosticId::unexpected_token, {expected, describe(at_)})
        .remove(token().range());
    advance();
}

/// Passes over the rest of a broken argument, up to what ends it or its line.
void Parser::skip_argument() {
    std::uint32_t depth = 0;
    while (!at_line_end() && !at_end_of_instructions()) {
        const std::uint32_t behind = next(at_);
        const bool comma =
            at(TokenKind::comma) && (begins_line(behind) || at_formal_argument(behind));
        if (comma || (at(TokenKind::right_parenthesis) && depth == 0))
            return;
        depth += at(TokenKind::left_parenthesis) ? 1 : 0;
        depth -= at(TokenKind::right_parenthesis) ? 1 : 0;
        advance();
    }
}

// ---- one argument -------------------------------------------------------------------------------

// il_param_assignment = il_assign_operator
//                       ( il_operand | "(" EOL { EOL } simple_instr_list ")" ) ;
// il_assign_operator = ( variable_name | "EN" | "ENO" ) ":=" ;
/// In a list of `formal` arguments, one without its name or mark is taken for one of these.
const ast::Node* Parser::parse_il_argument(bool formal) {
    if (at_intruder_before_argument())
        drop_intruder("an argument");
    const bool negated = at(TokenKind::kw_not);
    const std::uint32_t name = negated ? next(at_) : at_;
    const bool marked = has_mark(name);
    const bool unmarked = !marked && formal && lacks_mark(name);
    const bool output_slip = mark_slip(next(name)).meant == TokenKind::output_arrow;
    if (marked ? has_output_mark(name) : unmarked && (negated || output_slip))
        return parse_il_output_argument();
    auto* node = make<ast::InputArgument>();
    if (!marked && formal && begins_inner_instruction(at_) && lacks_parenthesis(at_)) {
        node->name = make_missing_identifier("the name of a parameter");
        node->value = parse_il_argument_list(end_ - 1);
        return finish(node);
    }
    if (!marked && !unmarked) {
        node->value = parse_il_operand();
        return finish(node);
    }
    if (negated) {
        report_unexpected("an argument");
        advance();
    }
    node->name = parse_il_argument_name();
    if (at_line_end() && !node->name->missing)
        report_line_end();
    expect_argument_mark(TokenKind::assign);
    node->value = parse_il_argument_value();
    return finish(node);
}

/// One token before an argument that is complete without it.
bool Parser::at_intruder_before_argument() const noexcept {
    const std::uint32_t behind = next(at_);
    return !begins_line(behind) && at_formal_argument(behind) && !at_formal_argument(at_);
}

/// True when an argument begins at token `name`, which may be missing or something else.
bool Parser::has_mark(std::uint32_t name) const noexcept {
    const std::uint32_t behind = next(name);
    return at_formal_argument(name) || argument_marks.contains(tokens_[name].kind()) ||
           (!begins_line(behind) && argument_marks.contains(tokens_[behind].kind()));
}

/// True for `=>`, but where only `:=` can be meant.
bool Parser::has_output_mark(std::uint32_t name) const noexcept {
    const std::uint32_t mark = argument_marks.contains(tokens_[name].kind()) ? name : next(name);
    const std::uint32_t list = next(mark);
    if (mark_slip(mark).meant == TokenKind::output_arrow)
        return true;
    return tokens_[mark].kind() == TokenKind::output_arrow &&
           !(opens_instructions(list) && begins_inner_instruction(next(list)));
}

/// A name and what stands behind the mark on its line, without the mark or with something else in
/// its place.
bool Parser::lacks_mark(std::uint32_t name) const noexcept {
    const std::uint32_t second = next(name);
    if (tokens_[name].kind() != TokenKind::identifier &&
        !execution_control.contains(tokens_[name].kind()))
        return false;
    return !begins_line(second) && (begins_operand(tokens_[second].kind()) ||
                                    opens_instructions(second) || stands_for_mark(second));
}

/// A name, and a delimiter in the place of the mark or before it.
bool Parser::at_argument_with_intruder() const noexcept {
    const std::uint32_t second = next(at_);
    return !is_expression_operator(at_) && !begins_operand(tokens_[second].kind()) &&
           !opens_instructions(second) && lacks_mark(at_);
}

/// What the delimiters at token `index` are very probably meant for, when it is a mark.
Parser::MarkSlip Parser::mark_slip(std::uint32_t index) const noexcept {
    struct Slip {
        TokenKind first;
        TokenKind second; // end_of_unit: there is none
        TokenKind meant;
        bool adjoin; // else white space between the two is the slip
    };
    static constexpr std::array<Slip, 8> slips{{
        {TokenKind::greater_equal, TokenKind::end_of_unit, TokenKind::output_arrow, false},
        {TokenKind::less_equal, TokenKind::end_of_unit, TokenKind::output_arrow, false},
        {TokenKind::equal_equal, TokenKind::greater, TokenKind::output_arrow, true},
        {TokenKind::equal, TokenKind::colon, TokenKind::assign, true},
        {TokenKind::minus, TokenKind::greater, TokenKind::output_arrow, true},
        {TokenKind::colon, TokenKind::minus, TokenKind::assign, true},
        {TokenKind::equal, TokenKind::greater, TokenKind::output_arrow, false},
        {TokenKind::colon, TokenKind::equal, TokenKind::assign, false},
    }};
    const std::uint32_t second = next(index);
    const TokenKind kind = tokens_[second].kind();
    const bool adjoin = tokens_[index].end() == tokens_[second].offset();
    for (const Slip& slip : slips) {
        if (slip.first != tokens_[index].kind())
            continue;
        if (slip.second == TokenKind::end_of_unit)
            return {slip.meant, second};
        if (slip.second == kind && !tokens_[second].first_on_line() && (adjoin || !slip.adjoin))
            return {slip.meant, next(second)};
    }
    return {};
}

/// Passes over the delimiters at the cursor, and reports what is meant.
void Parser::accept_mark_slip(const MarkSlip& slip) {
    const std::string meant(spelling(slip.meant));
    const bool one = slip.end == next(at_);
    const TextRange range = token_range(at_, one ? at_ + 1 : next(at_) + 1);
    const std::string written(text_.substr(range.begin, range.size()));
    const TextRange gap{token().end(), one ? token().end() : tokens_[next(at_)].offset()};
    if (gap.size() > 0)
        report(DiagnosticId::white_space_in_delimiter, gap, {meant}).replace(range, meant);
    else
        report(DiagnosticId::unexpected_token, range,
               {"`" + meant + "`", "`" + written + (one ? "`, which compares" : "`")})
            .replace(range, meant);
    while (at_ < slip.end)
        advance();
}

/// Between a name and an operand, or before the mark.
bool Parser::stands_for_mark(std::uint32_t index) const noexcept {
    if (const MarkSlip slip = mark_slip(index); slip.end != 0)
        return !begins_line(slip.end) &&
               (begins_operand(tokens_[slip.end].kind()) || opens_instructions(slip.end));
    static constexpr TokenSet delimiters{TokenKind::comma,
                                         TokenKind::semicolon,
                                         TokenKind::colon,
                                         TokenKind::left_parenthesis,
                                         TokenKind::right_parenthesis,
                                         TokenKind::dot};
    const TokenKind here = tokens_[index].kind();
    const std::uint32_t third = next(index);
    const bool list = opens_instructions(third);
    const bool mark = argument_marks.contains(tokens_[third].kind());
    if (begins_line(third) || (!begins_operand(tokens_[third].kind()) && !list && !mark))
        return false;
    switch (here) {
    case TokenKind::dot: return list || mark;
    case TokenKind::comma: return !at_formal_argument(third);
    case TokenKind::left_parenthesis: return surplus_parentheses() < 0;
    case TokenKind::right_parenthesis: return surplus_parentheses() > 0;
    default: return begins_operand(here) || delimiters.contains(here);
    }
}

// Part of il_assign_operator: ( variable_name | "EN" | "ENO" )
const ast::Identifier* Parser::parse_il_argument_name() {
    constexpr const char* what = "the name of a parameter";
    if (at(execution_control))
        return make_identifier();
    if (is_keyword(kind()))
        return take_reserved_word();
    if (at(TokenKind::identifier) || argument_marks.contains(kind()))
        return parse_name(what);
    const ast::Identifier* name = make_missing_identifier(what);
    advance();
    return name;
}

/// `:=` or `=>`. A second one behind it is dropped.
void Parser::expect_argument_mark(TokenKind mark) {
    if (const MarkSlip slip = mark_slip(at_); slip.meant == mark)
        return accept_mark_slip(slip);
    if (at(TokenKind::equal)) {
        report_at(at_, DiagnosticId::equal_for_assignment)
            .replace(token().range(), std::string(spelling(mark)));
        advance();
    } else if (argument_marks.contains(kind()) || stands_for_mark(at_)) {
        if (argument_marks.contains(peek()) && !argument_marks.contains(kind()))
            drop_intruder("`" + std::string(spelling(mark)) + "`");
        if (!accept(mark))
            accept_as(mark);
    } else {
        const std::string words(spelling(mark));
        report_missing(DiagnosticId::missing_token, {"`" + words + "`"})
            .insert(previous_end(), " " + words);
    }
    if (argument_marks.contains(kind()) && !at_line_end())
        drop_intruder("an operand");
}

// il_param_out_assignment = il_assign_out_operator il_variable ;
// il_assign_out_operator = [ "NOT" ] ( variable_name | "EN" | "ENO" ) "=>" ;
const ast::Node* Parser::parse_il_output_argument() {
    auto* node = make<ast::OutputArgument>();
    node->negated = accept(TokenKind::kw_not);
    const bool after_not = node->negated && at_line_end();
    if (after_not)
        report_line_end();
    node->name = parse_il_argument_name();
    if (at_line_end() && !after_not && !node->name->missing)
        report_line_end();
    expect_argument_mark(TokenKind::output_arrow);
    drop_intruder_before_operand();
    const std::size_t reports = diagnostics_.size();
    node->variable = expect_il_operand("`=>`");
    if (diagnostics_.size() == reports)
        check_variable("=>", *node->variable);
    return finish(node);
}

// ---- what an argument gets ----------------------------------------------------------------------

// Part of il_param_assignment: il_operand | "(" EOL { EOL } simple_instr_list ")"
const ast::Node* Parser::parse_il_argument_value() {
    drop_intruder_before_operand();
    if (opens_instructions(at_))
        return parse_il_argument_list(advance());
    if (at_inner_instruction_of_argument(at_)) {
        report_missing(DiagnosticId::missing_token, {"`(`"}).insert(previous_end(), " (");
        return parse_il_argument_list(end_ - 1);
    }
    if (!at_line_end() && at_inner_instruction_of_argument(next(at_))) {
        accept_as(TokenKind::left_parenthesis);
        return parse_il_argument_list(end_ - 1);
    }
    return expect_il_operand("`:=`");
}

/// True when instructions begin with the line at token `index`, and their `(` is missing.
bool Parser::at_inner_instruction_of_argument(std::uint32_t index) const noexcept {
    return begins_line(index) && begins_inner_instruction(index) && lacks_parenthesis(index);
}

/// `(` and a line end, or an instruction.
bool Parser::opens_instructions(std::uint32_t index) const noexcept {
    const std::uint32_t behind = next(index);
    return tokens_[index].kind() == TokenKind::left_parenthesis && !begins_line(index) &&
           (begins_line(behind) || (il_operator(behind) != nullptr && !begins_line(next(behind))));
}

/// Behind the mark: one token before an operand, or before the `(` at the end of the line.
void Parser::drop_intruder_before_operand() {
    static constexpr TokenSet delimiters{TokenKind::comma, TokenKind::semicolon, TokenKind::colon,
                                         TokenKind::dot};
    const std::uint32_t behind = next(at_);
    if (at_line_end() || begins_line(behind) || opens_instructions(at_))
        return;
    const bool list = opens_line(behind);
    const bool operand = begins_operand(tokens_[behind].kind()) && !at_formal_argument(behind);
    const bool parenthesis = at(TokenKind::right_parenthesis) && surplus_parentheses() > 0;
    if (!list && !(operand && (at(delimiters) || parenthesis)))
        return;
    drop_intruder(list ? "`(`" : "an operand");
}

// Part of il_param_assignment: "(" EOL { EOL } simple_instr_list ")"
/// From behind the `(` at token `open`, or what stands in its place.
const ast::Node* Parser::parse_il_argument_list(std::uint32_t open) {
    const NestingGuard guard(*this);
    if (guard.too_deep()) {
        parse_too_deep_operation(1);
        return make_missing<ast::ErrorExpression>();
    }
    const bool closed = parenthesis_closes(open);
    MissingLineEnds missing;
    expect_line_end_in(missing, "after `(`");
    ++il_parentheses_;
    const ast::InstructionList* list = parse_simple_instruction_list("parentheses", closed, true);
    if (list->instructions.empty())
        report_at(at_, DiagnosticId::not_an_instruction, {describe(at_)});
    close_il_parenthesis(open, missing, at_formal_argument(at_) ? "\n)," : "\n)");
    return list;
}

// ---- parentheses that do not balance ------------------------------------------------------------

/// How many more `)` follow than parentheses of instructions are open. It is counted up to an
/// instruction that stands in none, so that another mistake behind it does not matter.
std::int32_t Parser::surplus_parentheses() const noexcept {
    constexpr std::uint32_t furthest = 1000; // bounds the time that a run of parentheses takes
    std::int32_t closed = 0;
    std::int32_t depth = 0;
    std::uint32_t i = at_;
    for (std::uint32_t steps = 0; steps < furthest; i = next(i), ++steps) {
        const TokenKind here = tokens_[i].kind();
        if (unit_ends.contains(here) || chart_closers.contains(here) ||
            (i != at_ && begins_line(i) && stands_outside_parentheses(i)))
            break;
        depth += here == TokenKind::left_parenthesis ? 1 : 0;
        if (here == TokenKind::right_parenthesis)
            (depth > 0 ? --depth : ++closed);
    }
    return closed - depth - static_cast<std::int32_t>(il_parentheses_);
}

/// True when the `(` before the line at token `index` is missing.
bool Parser::lacks_parenthesis(std::uint32_t index) const noexcept {
    return begins_line(index) && surplus_parentheses() > 0;
}

/// Alone on its line, in the place of a missing `)`: what can be no instruction and no argument.
bool Parser::at_stand_in_for_parenthesis() const noexcept {
    static constexpr TokenSet stand_ins =
        TokenSet::range(TokenKind::integer, TokenKind::date_and_time) |
        TokenSet{TokenKind::comma,       TokenKind::semicolon,        TokenKind::colon,
                 TokenKind::dot,         TokenKind::left_parenthesis, TokenKind::assign,
                 TokenKind::output_arrow};
    const std::uint32_t behind = next(at_);
    const bool comma = tokens_[behind].kind() == TokenKind::comma && !begins_line(behind);
    if (!at_line_end() || at_end() || (!at(stand_ins) && !(comma && at(TokenKind::identifier))) ||
        !begins_line(comma ? next(behind) : behind))
        return false;
    const bool own_comma = at(TokenKind::comma) && !comma && at_formal_argument(behind);
    return !own_comma && surplus_parentheses() < 0;
}

/// Among instructions in parentheses: a `)` that does not close them, when there is one too many.
bool Parser::at_stray_parenthesis_in_instructions(bool argument) const noexcept {
    static constexpr TokenSet ends{TokenKind::comma, TokenKind::right_parenthesis,
                                   TokenKind::semicolon, TokenKind::end_of_unit};
    const std::uint32_t behind = next(at_);
    const bool goes_on = (argument || !begins_line(behind)) && !at_formal_argument(behind) &&
                         !ends.contains(tokens_[behind].kind());
    const bool reported = reported_at_ == at_; // an operand is missing before it
    return (goes_on || reported) && at(TokenKind::right_parenthesis) && surplus_parentheses() > 0;
}

/// Among instructions in parentheses that are not closed: what stands behind them in arguments.
bool Parser::at_end_of_argument_list() const noexcept {
    return at_line_end() && (at(TokenKind::comma) || begins_argument_line(at_)) &&
           surplus_parentheses() < 0;
}

} // namespace iecfront
