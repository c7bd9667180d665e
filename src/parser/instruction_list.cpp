#include "lexer/name_table.hpp"
#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace iecfront {

/// An operator of B.2.2.
struct IlOperatorRow {
    std::string_view spelling;
    ast::IlOperator op;
    ast::IlModifier modifier = ast::IlModifier::none;
};

namespace {

using ast::IlModifier;
using ast::IlOperator;

constexpr std::array<IlOperatorRow, 43> il_operators{{
    {"LD", IlOperator::load},
    {"LDN", IlOperator::load, IlModifier::negated},
    {"ST", IlOperator::store},
    {"STN", IlOperator::store, IlModifier::negated},
    {"S", IlOperator::set},
    {"R", IlOperator::reset},
    {"AND", IlOperator::logical_and},
    {"&", IlOperator::logical_and},
    {"ANDN", IlOperator::logical_and, IlModifier::negated},
    {"&N", IlOperator::logical_and, IlModifier::negated},
    {"OR", IlOperator::logical_or},
    {"ORN", IlOperator::logical_or, IlModifier::negated},
    {"XOR", IlOperator::exclusive_or},
    {"XORN", IlOperator::exclusive_or, IlModifier::negated},
    {"NOT", IlOperator::logical_not},
    {"ADD", IlOperator::add},
    {"SUB", IlOperator::subtract},
    {"MUL", IlOperator::multiply},
    {"DIV", IlOperator::divide},
    {"MOD", IlOperator::modulo},
    {"GT", IlOperator::greater},
    {"GE", IlOperator::greater_equal},
    {"EQ", IlOperator::equal},
    {"NE", IlOperator::not_equal},
    {"LE", IlOperator::less_equal},
    {"LT", IlOperator::less},
    {"JMP", IlOperator::jump},
    {"JMPC", IlOperator::jump, IlModifier::conditional},
    {"JMPCN", IlOperator::jump, IlModifier::conditional_negated},
    {"CAL", IlOperator::call},
    {"CALC", IlOperator::call, IlModifier::conditional},
    {"CALCN", IlOperator::call, IlModifier::conditional_negated},
    {"RET", IlOperator::return_},
    {"RETC", IlOperator::return_, IlModifier::conditional},
    {"RETCN", IlOperator::return_, IlModifier::conditional_negated},
    {"S1", IlOperator::s1},
    {"R1", IlOperator::r1},
    {"CLK", IlOperator::clk},
    {"CU", IlOperator::cu},
    {"CD", IlOperator::cd},
    {"PV", IlOperator::pv},
    {"IN", IlOperator::in},
    {"PT", IlOperator::pt},
}};

constexpr NameTable<il_operators.size()> il_operator_names([] {
    std::array<std::string_view, il_operators.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = il_operators[i].spelling;
    return names;
}());

/// il_expr_operator: what can wait for the result of instructions in parentheses.
constexpr bool waits_for_result(IlOperator op) noexcept {
    return op >= IlOperator::logical_and && op <= IlOperator::less && op != IlOperator::logical_not;
}

/// True for `AND` and the like, which with several operands are functions (A24).
constexpr bool is_function_name(const IlOperatorRow& row) noexcept {
    return waits_for_result(row.op) && row.modifier == IlModifier::none && row.spelling != "&";
}

/// The operator writes to its operand, or to an input of it.
constexpr bool needs_variable(IlOperator op) noexcept {
    return op == IlOperator::store || op == IlOperator::set || op == IlOperator::reset ||
           op >= IlOperator::s1;
}

constexpr TokenSet operator_tokens{TokenKind::identifier, TokenKind::kw_and, TokenKind::kw_or,
                                   TokenKind::kw_xor,     TokenKind::kw_mod, TokenKind::kw_not,
                                   TokenKind::ampersand};

} // namespace

// ---- lines --------------------------------------------------------------------------------------

/// True when the token is the first on its line, but for some that could not be read.
bool Parser::begins_line(std::uint32_t index) const noexcept {
    while (!tokens_[index].first_on_line() && index > 0 &&
           tokens_[index - 1].kind() == TokenKind::unknown)
        --index;
    return tokens_[index].first_on_line();
}

/// Behind a part of an instruction: EOL.
bool Parser::at_line_end() const noexcept {
    return at_end() || begins_line(at_);
}

/// Passes over the rest of the line. A `)` that closes what is open further out is left there.
void Parser::skip_line() {
    std::uint32_t depth = 0;
    do {
        if (at(TokenKind::left_parenthesis))
            ++depth;
        else if (at(TokenKind::right_parenthesis) && depth > 0)
            --depth;
        else if (at(TokenKind::right_parenthesis) && il_parentheses_ > 0)
            break;
        advance();
    } while (!at_line_end() && !at_end_of_instructions());
    skipped_parentheses_ += depth;
}

/// An instruction ends with its line.
void Parser::expect_line_end() {
    if (at(TokenKind::semicolon) && !at_line_end())
        return report_semicolon();
    const bool closes = at(TokenKind::right_parenthesis) && il_parentheses_ > 0;
    if (at_line_end() || closes)
        return;
    if (at_end_of_instructions() || begins_instruction_on_line()) {
        report_missing(DiagnosticId::missing_line_end, {quoted(at_)}).insert(previous_end(), "\n");
        return;
    }
    const bool reported = !diagnostics_.empty() &&
                          diagnostics_.back().id == DiagnosticId::not_an_operand &&
                          diagnostics_.back().range.end == previous_end();
    if (!reported) // else what stands behind it belongs to it: `ST f(x).y`
        report_unexpected("the end of the line");
    skip_line();
}

/// A `;` in the place of a line end. What stands behind it is no second mistake.
void Parser::report_semicolon() {
    const TextRange range = token().range();
    Report semicolon = report_at(at_, DiagnosticId::semicolon_in_instruction_list);
    advance();
    const bool closes = at(TokenKind::right_parenthesis) && il_parentheses_ > 0;
    if (at_line_end() || closes)
        semicolon.remove(range);
    else if (at_end_of_instructions() || begins_instruction_on_line())
        semicolon.replace(range, "\n");
    else
        skip_line();
}

/// True when another instruction begins inside a line.
bool Parser::begins_instruction_on_line() const noexcept {
    if (at(TokenKind::identifier) && peek() == TokenKind::colon)
        return true;
    const IlOperatorRow* row = il_operator(at_);
    if (row == nullptr)
        return false;
    const bool alone = begins_line(next(at_)) || peek() == TokenKind::end_of_unit;
    if (row->op == IlOperator::return_ || row->op == IlOperator::logical_not)
        return alone;
    static constexpr TokenSet others{TokenKind::plus, TokenKind::minus,
                                     TokenKind::left_parenthesis};
    return !alone && (begins_operand(peek()) || others.contains(peek()));
}

/// `( RETCN` and nothing else in the line: no instruction that can stand in parentheses, but a name
/// that can.
bool Parser::at_return_for_name() const noexcept {
    return at(TokenKind::identifier) && il_operator(at_) != nullptr &&
           il_operator(at_)->op == IlOperator::return_;
}

/// Behind `(` or `,` and before `)`: where line ends are missing inside one pair of parentheses.
void Parser::expect_line_end_in(MissingLineEnds& missing, std::string_view where) {
    if (at_line_end())
        return;
    if (missing.offsets.empty())
        missing.where = where;
    else if (missing.offsets.back() == previous_end())
        return;
    missing.offsets.push_back(previous_end());
}

/// One report for all of them.
void Parser::report_line_ends(const MissingLineEnds& missing) {
    if (missing.offsets.empty())
        return;
    const std::uint32_t first = missing.offsets.front();
    const Report one =
        report(DiagnosticId::parentheses_without_line_end, {first, first}, {missing.where});
    DiagnosticFix fix;
    for (const std::uint32_t offset : missing.offsets)
        fix.edits.push_back({{offset, offset}, "\n"});
    diagnostics_[one.index()].fixes.push_back(std::move(fix));
}

// ---- instructions -------------------------------------------------------------------------------

/// True when what follows belongs to something that is open further out.
bool Parser::at_end_of_instructions() {
    if (at(unit_ends))
        return true;
    const TokenKind innermost = open_.back().closer;
    if (at(chart_openers))
        return at_chart_structure();
    if (at(chart_closers))
        return at(innermost) || (chart_closers.contains(innermost) && unclosed(innermost) > 0);
    return at(TokenKind::identifier) && unclosed(innermost) > 0 && begins_line(at_) &&
           at_misspelt_closer();
}

// instruction_list = il_instruction { il_instruction } ;
const ast::InstructionList* Parser::parse_instruction_list() {
    auto* list = make<ast::InstructionList>();
    ListBuilder<ast::IlInstruction> instructions(*this);
    const bool outer = std::exchange(in_instructions_, true);
    while (!at_end_of_instructions())
        add_in_loop(instructions, [this] { return parse_il_instruction(); });
    in_instructions_ = outer;
    list->instructions = instructions.finish();
    return finish(list);
}

// il_instruction = [ label ":" ]
//                  [ il_simple_operation | il_expression | il_jump_operation
//                  | il_fb_call | il_formal_funct_call | il_return_operator ]
//                  EOL { EOL } ;
const ast::IlInstruction* Parser::parse_il_instruction() {
    auto* node = make<ast::IlInstruction>();
    node->label = parse_optional_label();
    if (node->label == nullptr || (!at_line_end() && !at_end_of_instructions()))
        node->operation = parse_il_operation();
    expect_line_end();
    return finish(node);
}

// label = identifier ;
/// With the `:` behind it.
const ast::Identifier* Parser::parse_optional_label() {
    if (peek() != TokenKind::colon || begins_line(next(at_)))
        return nullptr;
    const bool literal = at_literal();
    if (!at(TokenKind::identifier) && !is_keyword(kind()) && !literal)
        return nullptr;
    const ast::Identifier* label = parse_declared_name("the name of a label");
    if (literal)
        advance();
    accept(TokenKind::colon);
    return label;
}

// simple_instr_list = il_simple_instruction { il_simple_instruction } ;
const ast::InstructionList* Parser::parse_simple_instruction_list(std::string_view where,
                                                                  bool closed, bool argument) {
    auto* list = make<ast::InstructionList>();
    ListBuilder<ast::IlInstruction> instructions(*this);
    const bool begun = !at_line_end(); // with the operand before the first line
    const bool outer = std::exchange(in_instructions_, true);
    while ((!at(TokenKind::right_parenthesis) || at_stray_parenthesis_in_instructions(argument)) &&
           !at_end_of_instructions() && !at_stand_in_for_parenthesis() &&
           !at_end_of_argument_list() &&
           (closed || !begins_outer_instruction(begun || !instructions.empty())))
        add_in_loop(instructions, [&] { return parse_il_simple_instruction(where); });
    in_instructions_ = outer;
    list->instructions = instructions.finish();
    return finish(list);
}

// il_simple_instruction = ( il_simple_operation | il_expression | il_formal_funct_call )
//                         EOL { EOL } ;
const ast::IlInstruction* Parser::parse_il_simple_instruction(std::string_view where) {
    const std::uint32_t first = at_;
    const std::size_t reports = diagnostics_.size();
    const ast::IlInstruction* instruction = parse_il_instruction();
    if (diagnostics_.size() != reports)
        return instruction;
    if (instruction->label != nullptr) {
        report_at(first, DiagnosticId::not_a_simple_instruction, {"a label", where});
        return instruction;
    }
    switch (instruction->operation->kind) {
    case ast::NodeKind::il_jump_operation:
    case ast::NodeKind::il_fb_call:
    case ast::NodeKind::il_return_operation:
        report_at(first, DiagnosticId::not_a_simple_instruction, {quoted(first), where});
        break;
    default: break;
    }
    return instruction;
}

/// An operator of B.2.2 that can wait for instructions in parentheses.
bool Parser::is_expression_operator(std::uint32_t index) const noexcept {
    const IlOperatorRow* row = il_operator(index);
    return row != nullptr && waits_for_result(row->op);
}

/// True for an instruction with an operand that can stand in parentheses.
bool Parser::begins_inner_instruction(std::uint32_t index) const noexcept {
    const IlOperatorRow* row = il_operator(index);
    const std::uint32_t second = next(index);
    return row != nullptr && !stands_outside_parentheses(index) && !needs_variable(row->op) &&
           !begins_line(second) &&
           (begins_operand(tokens_[second].kind()) ||
            tokens_[second].kind() == TokenKind::left_parenthesis);
}

/// True for an instruction that stores, jumps, calls or returns.
bool Parser::stands_outside_parentheses(std::uint32_t index) const noexcept {
    const IlOperatorRow* row = il_operator(index);
    return row != nullptr && (row->op == IlOperator::store || row->op == IlOperator::jump ||
                              row->op == IlOperator::call || row->op == IlOperator::return_);
}

/// In parentheses that nothing closes: true when the line stores, jumps, calls or loads anew, and
/// so very probably stands behind them.
bool Parser::begins_outer_instruction(bool begun) const noexcept {
    if (at(TokenKind::identifier) && peek() == TokenKind::colon)
        return true;
    const IlOperatorRow* row = il_operator(at_);
    return row != nullptr &&
           (needs_variable(row->op) || row->op == IlOperator::jump || row->op == IlOperator::call ||
            row->op == IlOperator::return_ || (row->op == IlOperator::load && begun));
}

// ---- operations ---------------------------------------------------------------------------------

/// The operator at token `index`, or null. `&N` is two tokens.
const IlOperatorRow* Parser::il_operator(std::uint32_t index) const noexcept {
    constexpr std::uint32_t longest = 5;
    static_assert(std::ranges::all_of(
        il_operators, [](const IlOperatorRow& row) { return row.spelling.size() <= longest; }));
    const Token& token = tokens_[index];
    if (token.length() > longest || !operator_tokens.contains(token.kind()))
        return nullptr;
    const std::string_view word = at_ampersand_n(index) ? "&N" : text(index);
    const std::size_t row = il_operator_names.find(word, hash_name(word));
    return row == il_operators.size() ? nullptr : &il_operators[row];
}

/// True when `&` and `N` adjoin, and more stands behind them: alone, N is the operand of `&`.
bool Parser::is_ampersand_n(std::uint32_t index) const noexcept {
    const std::uint32_t second = index + 1;
    return tokens_[second].offset() == tokens_[index].end() &&
           tokens_[second].kind() == TokenKind::identifier && names_equal(text(second), "N") &&
           !begins_line(next(second)) && tokens_[next(second)].kind() != TokenKind::end_of_unit;
}

void Parser::advance_operator() noexcept {
    if (at_ampersand_n(at_))
        advance();
    advance();
}

// Part of il_instruction: [ il_simple_operation | il_expression | il_jump_operation | il_fb_call
//     | il_formal_funct_call | il_return_operator ]
const ast::IlOperation* Parser::parse_il_operation() {
    if (at_arguments_without_call())
        return parse_arguments_without_call();
    if (at_structured_text())
        return parse_structured_text_in_il();
    const bool parenthesis = peek() == TokenKind::left_parenthesis && !begins_line(next(at_));
    if (const IlOperatorRow* row = il_operator(at_)) {
        const std::uint32_t second = at_ampersand_n(at_) ? next(next(at_)) : next(at_);
        const bool open =
            tokens_[second].kind() == TokenKind::left_parenthesis && !begins_line(second);
        const bool deferred =
            waits_for_result(row->op) && (open || lacks_parenthesis_of_instructions(second));
        switch (row->op) {
        case IlOperator::jump: return parse_il_jump_operation(*row);
        case IlOperator::call: return parse_il_fb_call(*row);
        case IlOperator::return_: return parse_il_return_operation(*row);
        default: break;
        }
        if (is_function_name(*row) && argument_lines_follow(second) &&
            !statement_begins_in_parentheses(second))
            return parse_il_formal_funct_call();
        return deferred ? parse_il_expression(*row) : parse_il_simple_operation(*row);
    }
    if (at_unknown_expression()) {
        report_at(at_, DiagnosticId::unexpected_token, {"an operator", quoted(at_)});
        return parse_il_expression({});
    }
    if (at(TokenKind::identifier))
        return parenthesis || argument_lines_follow(next(at_)) ? parse_il_formal_funct_call()
                                                               : parse_il_function();
    return parse_il_error_operation();
}

/// `f(a);`
bool Parser::at_invocation_statement() const noexcept {
    const std::uint32_t open = next(at_);
    if (!at(TokenKind::identifier) || tokens_[open].kind() != TokenKind::left_parenthesis ||
        begins_line(open) || il_operator(at_) != nullptr)
        return false;
    const std::uint32_t close = closing_parenthesis(open);
    const std::uint32_t behind = next(close);
    return close != count_ && tokens_[behind].kind() == TokenKind::semicolon &&
           !begins_line(behind);
}

/// A statement of ST: a variable and `:=`, an invocation, or a word that begins one.
bool Parser::at_structured_text() const noexcept {
    static constexpr TokenSet after_variable{TokenKind::assign, TokenKind::equal, TokenKind::dot,
                                             TokenKind::left_bracket, TokenKind::caret};
    const bool variable =
        at(TokenKind::identifier) || at(TokenKind::direct_variable) || at(execution_control);
    if (peek() == TokenKind::left_bracket && is_expression_operator(at_) &&
        lacks_parenthesis_of_instructions(next(at_))) // `ADD[ a`
        return false;
    return at(statement_words) || at_invocation_statement() ||
           (variable && after_variable.contains(peek()) && !begins_line(next(at_)));
}

/// In place of il_instruction: a statement. One report for all of it, and none for what stands in
/// it.
const ast::IlOperation* Parser::parse_structured_text_in_il() {
    auto* error = make<ast::IlErrorOperation>();
    report_at(at_, DiagnosticId::statement_in_instruction_list);
    std::uint32_t blocks = 0;
    std::uint32_t parentheses = 0;
    do {
        // What lacks its closing word ends with its line.
        blocks += at(block_statements) && unclosed(closer_of(kind())) <= 0 ? 1 : 0;
        blocks -= at(statement_closers) && blocks > 0 ? 1 : 0;
        if (at(TokenKind::left_parenthesis) && argument_list_closes(next(at_)))
            ++parentheses;
        else if (at(TokenKind::right_parenthesis) && parentheses > 0)
            --parentheses;
        advance();
    } while ((blocks > 0 || parentheses > 0 || !at_line_end()) && !at_end_of_instructions());
    return finish(error);
}

/// In place of il_instruction: what begins no operation.
const ast::IlOperation* Parser::parse_il_error_operation() {
    auto* error = make<ast::IlErrorOperation>();
    if (at(block_openers)) {
        report_at(at_, DiagnosticId::declaration_after_body);
        parse_variable_declarations(place_);
        return finish(error);
    }
    if (at(TokenKind::semicolon)) {
        report_at(at_, DiagnosticId::semicolon_in_instruction_list).remove(token().range());
        advance();
        return at_operator_field() ? parse_il_operation() : finish(error);
    }
    if (!at(TokenKind::right_parenthesis)) {
        report_at(at_, DiagnosticId::not_an_instruction, {quoted(at_)});
        if (!skip_chart_element())
            skip_line();
        return finish(error);
    }
    if (skipped_parentheses_ > 0) // its opening one stands in a line that was reported
        --skipped_parentheses_;
    else
        report_at(at_, DiagnosticId::stray_closing_word, {text(at_)}).remove(token().range());
    advance();
    return at_operator_field() ? parse_il_operation() : finish(error);
}

/// In a line, at what can be an operator.
bool Parser::at_operator_field() const noexcept {
    return !at_line_end() && (at(TokenKind::identifier) || il_operator(at_) != nullptr);
}

// il_simple_operation = il_simple_operator il_operand | il_store_operator il_variable | "NOT"
//                     | il_function_name [ il_operand_list ]
//                     | il_expr_function il_operand "," il_operand_list ;
// il_simple_operator = "LD" | "LDN" | il_expr_operator ;
// il_store_operator = "ST" | "STN" | "S" | "R" | "S1" | "R1" | "CLK" | "CU" | "CD" | "PV"
//                   | "IN" | "PT" ;
const ast::IlOperation* Parser::parse_il_simple_operation(const IlOperatorRow& row) {
    auto* node = make<ast::IlSimpleOperation>();
    node->op = row.op;
    node->modifier = row.modifier;
    const std::uint32_t word = at_;
    advance_operator();
    if (row.op == IlOperator::logical_not) {
        report_operand_of(row);
        return finish(node);
    }
    const std::size_t reports = diagnostics_.size();
    ListBuilder<ast::Expression> operands(*this);
    const ast::Expression* operand =
        at_end_of_operands() ? parse_missing_il_operand(quoted(word)) : parse_il_operand();
    operands.add(operand);
    const bool several = at(TokenKind::comma) && !at_line_end();
    if (several && is_function_name(row)) {
        node->op = IlOperator::none;
        node->function_name = make_identifier_of(word);
    } else if (several) {
        report_at(at_, DiagnosticId::too_many_operands, {row.spelling});
    } else if (needs_variable(row.op) && diagnostics_.size() == reports) {
        check_variable(row.spelling, *operand);
    }
    if (several)
        add_il_operands(operands);
    node->operands = operands.finish();
    return finish(node);
}

// il_function_name = function_name ;
// Part of il_simple_operation: il_function_name [ il_operand_list ]
const ast::IlOperation* Parser::parse_il_function() {
    auto* node = make<ast::IlSimpleOperation>();
    node->function_name = make_identifier();
    check_standard_name(node->function_name->first_token, node->function_name->hash, NameUse::call);
    ListBuilder<ast::Expression> operands(*this);
    if (!at_end_of_operands()) {
        operands.add(parse_il_operand());
        add_il_operands(operands);
    }
    node->operands = operands.finish();
    return finish(node);
}

const ast::Identifier* Parser::make_identifier_of(std::uint32_t token) {
    auto* name = make<ast::Identifier>();
    name->hash = hash_name(text(token));
    name->first_token = token;
    name->end_token = token + 1;
    return name;
}

/// Behind NOT and RET, which have no operand.
void Parser::report_operand_of(const IlOperatorRow& row) {
    if (at_end_of_operands() || begins_instruction_on_line())
        return;
    const std::uint32_t first = at_;
    Report operand = report_at(first, DiagnosticId::unexpected_operand, {row.spelling});
    const std::uint32_t closing = at(TokenKind::left_parenthesis) ? closing_parenthesis(at_) : at_;
    const bool closes = tokens_[closing].kind() == TokenKind::right_parenthesis;
    if (closes && at_formal_argument(next(first))) { // no instructions, which could stay
        advance_past(closing);
        operand.remove(token_range(first, end_));
        return;
    }
    const std::uint32_t opened = skipped_parentheses_;
    skip_line();
    operand.remove(token_range(first, end_));
    if (closes && skipped_parentheses_ == opened + 1)
        operand.also_remove(tokens_[closing].range());
}

/// The operand of ST, of the input operators and of `=>` is written to.
void Parser::check_variable(std::string_view writer, const ast::Expression& operand) {
    if (ast::is<ast::Constant>(operand.kind) || operand.kind == ast::NodeKind::enumerated_value)
        report_node(operand, DiagnosticId::operand_is_no_variable, {writer, "a constant"});
}

// il_jump_operation = il_jump_operator label ;
// il_jump_operator = "JMP" | "JMPC" | "JMPCN" ;
const ast::IlOperation* Parser::parse_il_jump_operation(const IlOperatorRow& row) {
    auto* node = make<ast::IlJumpOperation>();
    node->modifier = row.modifier;
    const std::uint32_t word = advance();
    if (at_end_of_operands()) {
        report_missing(DiagnosticId::missing_operand, {quoted(word)});
        node->label = make_missing<ast::Identifier>();
    } else {
        node->label = parse_name("the name of a label");
    }
    return finish(node);
}

// il_return_operator = "RET" | "RETC" | "RETCN" ;
const ast::IlOperation* Parser::parse_il_return_operation(const IlOperatorRow& row) {
    auto* node = make<ast::IlReturnOperation>();
    node->modifier = row.modifier;
    advance();
    finish(node);
    report_operand_of(row);
    return finish(node);
}

// ---- parentheses --------------------------------------------------------------------------------

/// Where the parenthesis at token `open` is closed, or somewhere behind it when that is far away;
/// the number of tokens when it is not closed before the body ends. What stands in the place of a
/// `(` counts as one.
std::uint32_t Parser::closing_parenthesis(std::uint32_t open) const noexcept {
    constexpr std::uint32_t furthest = 1000; // bounds the time that a run of parentheses takes
    std::uint32_t depth = 1;
    std::uint32_t i = next(open);
    for (std::uint32_t steps = 0; steps < furthest; i = next(i), ++steps) {
        const TokenKind kind = tokens_[i].kind();
        if (unit_ends.contains(kind) || chart_closers.contains(kind))
            return count_;
        if (kind == TokenKind::left_parenthesis)
            ++depth;
        else if (kind == TokenKind::right_parenthesis && --depth == 0)
            break;
    }
    return i;
}

/// `closing` is what to insert for a `)` that is missing.
void Parser::close_il_parenthesis(std::uint32_t open, MissingLineEnds& missing,
                                  std::string_view closing) {
    if (at(TokenKind::right_parenthesis)) {
        expect_line_end_in(missing, "before `)`");
        advance();
    } else if (at_stand_in_for_parenthesis()) {
        accept_as(TokenKind::right_parenthesis).label(LabelId::opened_here, open);
    } else {
        Report report = report_missing(DiagnosticId::missing_token, {"`)`"});
        if (tokens_[open].kind() == TokenKind::left_parenthesis)
            report.label(LabelId::opened_here, open);
        if (at(TokenKind::comma) && at_line_end())
            report.insert(token().offset(), ")");
        else
            report.insert(previous_end(), std::string(closing));
    }
    --il_parentheses_;
    report_line_ends(missing);
}

// il_expression = il_expr_operator "(" [ il_operand ] EOL { EOL }
//                 [ simple_instr_list ] ")" ;
// il_expr_operator = "AND" | "&" | "OR" | "XOR" | "ANDN" | "&N" | "ORN" | "XORN" | "ADD"
//                  | "SUB" | "MUL" | "DIV" | "MOD" | "GT" | "GE" | "EQ" | "LT" | "LE"
//                  | "NE" ;
const ast::IlOperation* Parser::parse_il_expression(const IlOperatorRow& row) {
    const NestingGuard guard(*this);
    if (guard.too_deep())
        return parse_too_deep_operation();
    auto* node = make<ast::IlExpression>();
    node->op = row.op;
    node->modifier = row.modifier;
    const std::uint32_t word = at_;
    advance_operator();
    const std::uint32_t open = accept_parenthesis_of_instructions();
    const bool closed = parenthesis_closes(open);
    MissingLineEnds missing;
    ++il_parentheses_;
    if (!at_line_end() && begins_instruction_on_line() && !at_return_for_name()) {
        expect_line_end_in(missing, "after `(`");
    } else if (!at_line_end() && !at(TokenKind::right_parenthesis)) {
        const std::size_t reports = diagnostics_.size();
        drop_intruder_before_operand();
        node->operand = expect_il_operand("`(`");
        const bool line_goes_on = at(TokenKind::comma) && !at_line_end();
        if (line_goes_on && begins_line(next(at_)) && begins_inner_instruction(next(at_)))
            drop_intruder("the end of the line");
        const bool reported = diagnostics_.size() != reports;
        if (!reported && at(TokenKind::comma) && !at_line_end() && is_function_name(row)) {
            --il_parentheses_;
            return parse_operands_in_parentheses(make_identifier_of(word), open, node->operand);
        }
        if (reported && at(TokenKind::comma) && !at_line_end())
            skip_line();
        else
            expect_line_end();
    }
    node->instructions = parse_simple_instruction_list("parentheses", closed);
    close_il_parenthesis(open, missing);
    return finish(node);
}

/// The `(` behind an operator, or what stands in its place before instructions on lines of their
/// own. Gives the token.
std::uint32_t Parser::accept_parenthesis_of_instructions() {
    if (at(TokenKind::left_parenthesis) && !at_line_end())
        return advance();
    if (at_line_end())
        report_missing(DiagnosticId::missing_token, {"`(`"}).insert(previous_end(), "(");
    else
        accept_as(TokenKind::left_parenthesis);
    return end_ - 1;
}

/// Behind an operator at token `index`: true when instructions in parentheses follow, and the `(`
/// is missing or something else that is no operand.
bool Parser::lacks_parenthesis_of_instructions(std::uint32_t index) const noexcept {
    if (!begins_line(index)) {
        const bool closes = tokens_[index].kind() == TokenKind::right_parenthesis;
        if (begins_operand(tokens_[index].kind()) || (closes && surplus_parentheses() < 2))
            return false;
        if (tokens_[index].kind() == TokenKind::left_bracket && rest_of_line(index).brackets > 0)
            return surplus_parentheses() > 0;
        index = next(index);
    }
    return at_inner_instruction_of_argument(index);
}

/// In place of il_expression: passes over one that is nested too deep, up to its closing
/// parenthesis.
const ast::IlOperation* Parser::parse_too_deep_operation(std::uint32_t depth) {
    auto* error = make<ast::IlErrorOperation>();
    do {
        depth += at(TokenKind::left_parenthesis) ? 1 : 0;
        depth -= at(TokenKind::right_parenthesis) && depth > 0 ? 1 : 0;
        advance();
    } while ((depth > 0 || !at_line_end()) && !at_end_of_instructions() &&
             (depth > 0 || !at(TokenKind::right_parenthesis)));
    return finish(error);
}

// il_formal_funct_call = ( il_function_name | il_expr_function )
//                        "(" EOL { EOL } [ il_param_list ] ")" ;
// il_expr_function = "AND" | "OR" | "XOR" | "ADD" | "SUB" | "MUL" | "DIV" | "MOD" | "GT"
//                  | "GE" | "EQ" | "LT" | "LE" | "NE" ;
const ast::IlOperation* Parser::parse_il_formal_funct_call() {
    const std::uint32_t word = advance();
    const ast::Identifier* name = make_identifier_of(word);
    check_standard_name(word, name->hash, NameUse::call);
    if (!at_argument_lines() && peek() != TokenKind::right_parenthesis)
        return parse_operands_in_parentheses(name, advance(), nullptr);
    expect_parenthesis_of_arguments();
    auto* node = make_from<ast::IlFormalFunctCall>(name);
    node->function_name = name;
    node->arguments = parse_il_param_list(end_ - 1, true);
    return finish(node);
}

/// At arguments of which what is called is missing, or something that is no name.
bool Parser::at_arguments_without_call() const noexcept {
    static constexpr TokenSet ends{TokenKind::comma, TokenKind::left_parenthesis};
    const std::uint32_t open = next(at_);
    if (tokens_[open].kind() == TokenKind::left_parenthesis && !begins_line(open) &&
        !at(TokenKind::identifier) && il_operator(at_) == nullptr)
        return begins_argument_line(next(open));
    if (follows_skipped_parenthesis())
        return begins_argument_line(at_);
    return at_formal_argument(at_) && ends.contains(rest_of_line(at_).last) &&
           lacks_parenthesis(at_);
}

/// Behind a line that was reported and passed over up to a `(` at its end.
bool Parser::follows_skipped_parenthesis() const noexcept {
    return skipped_parentheses_ > 0 && at_ > 0 && at_line_end() &&
           tokens_[at_ - 1].kind() == TokenKind::left_parenthesis;
}

/// In place of il_formal_funct_call: arguments, and what is called is missing before them.
const ast::IlOperation* Parser::parse_arguments_without_call() {
    auto* node = make<ast::IlFormalFunctCall>();
    const std::uint32_t first = at_;
    node->function_name = make_missing<ast::Identifier>();
    if (follows_skipped_parenthesis()) {
        --skipped_parentheses_;
    } else if (at_formal_argument(first)) {
        report_at(first, DiagnosticId::not_an_instruction, {"an argument without a call"});
    } else {
        report_at(first, DiagnosticId::not_an_instruction, {quoted(first)});
        advance();
        expect_parenthesis_of_arguments();
    }
    node->arguments = parse_il_param_list(first, true);
    return finish(node);
}

/// A name and instructions in parentheses, as only an operator has them.
bool Parser::at_unknown_expression() const noexcept {
    const std::uint32_t open = next(at_);
    std::uint32_t line = next(open);
    if (!at(TokenKind::identifier) || tokens_[open].kind() != TokenKind::left_parenthesis ||
        begins_line(open))
        return false;
    if (!begins_line(line) && begins_operand(tokens_[line].kind()))
        line = next(line);
    return begins_line(line) && begins_inner_instruction(line) && !at_formal_argument(line) &&
           !at_formal_argument(next(line)) && parenthesis_closes(open) &&
           surplus_parentheses() == 0;
}

/// In place of il_formal_funct_call: `LIMIT(1, x, 5)`, which the standard does not have, from
/// behind the parenthesis, or from behind the first operand.
const ast::IlOperation* Parser::parse_operands_in_parentheses(const ast::Identifier* name,
                                                              std::uint32_t open,
                                                              const ast::Expression* first) {
    auto* node = make_from<ast::IlFormalFunctCall>(name);
    node->function_name = name;
    const std::size_t reports = diagnostics_.size();
    node->arguments = parse_il_arguments(open, first);
    finish(node);
    if (diagnostics_.size() == reports)
        report_node(*node, DiagnosticId::operands_in_parentheses);
    return node;
}

// il_fb_call = il_call_operator fb_name
//              [ "(" ( EOL { EOL } [ il_param_list ] | [ il_operand_list ] ) ")" ] ;
// il_call_operator = "CAL" | "CALC" | "CALCN" ;
const ast::IlOperation* Parser::parse_il_fb_call(const IlOperatorRow& row) {
    auto* node = make<ast::IlFbCall>();
    node->modifier = row.modifier;
    const std::uint32_t word = advance();
    if (at_end_of_operands() || !at(TokenKind::identifier)) {
        report_missing_instance(word);
        node->fb_name = make_missing<ast::ErrorExpression>();
    } else {
        node->fb_name = parse_called_instance();
    }
    if (at_argument_lines()) {
        expect_parenthesis_of_arguments();
        node->arguments = parse_il_param_list(end_ - 1, false);
    } else if (at(TokenKind::left_parenthesis) && !at_line_end() && !node->fb_name->missing) {
        const std::uint32_t open = advance();
        node->arguments = parse_il_arguments(open, nullptr);
    }
    return finish(node);
}

/// Behind CAL. Something else in the place of the name is passed over before a `(`.
void Parser::report_missing_instance(std::uint32_t word) {
    if (at_end_of_operands()) {
        report_missing(DiagnosticId::missing_operand, {quoted(word)});
        return;
    }
    report_at(at_, DiagnosticId::missing_name,
              {"the name of a function block instance", quoted(at_)});
    if (peek() == TokenKind::left_parenthesis && !begins_line(next(at_)) &&
        begins_line(next(next(at_))))
        advance();
}

// Part of il_fb_call: fb_name
const ast::Expression* Parser::parse_called_instance() {
    const std::uint32_t first = at_;
    const ast::Expression* instance = parse_il_variable();
    if (const auto* name = ast::as<ast::VariableName>(instance))
        check_standard_name(first, name->hash, NameUse::other);
    else if (instance->kind != ast::NodeKind::dereferenced_variable) // which was reported
        report_node(
            *instance, DiagnosticId::call_of_member,
            {instance->kind == ast::NodeKind::array_variable ? "an array element" : "a member"});
    return instance;
}

// ---- operands -----------------------------------------------------------------------------------

/// Nothing that could be an operand follows in this line.
bool Parser::at_end_of_operands() noexcept {
    static constexpr TokenSet ends{TokenKind::semicolon, TokenKind::right_parenthesis,
                                   TokenKind::comma};
    return at_line_end() || at(ends) || at_end_of_instructions();
}

/// An operand, or a report that it is missing `after` what stands before it.
const ast::Expression* Parser::expect_il_operand(std::string_view after) {
    return at_end_of_operands() ? parse_missing_il_operand(after) : parse_il_operand();
}

/// In place of il_operand: there is none.
const ast::Expression* Parser::parse_missing_il_operand(std::string_view after) {
    report_missing(DiagnosticId::missing_operand, {after});
    return make_missing<ast::ErrorExpression>();
}

// il_operand = constant | il_variable | enumerated_value ;
const ast::Expression* Parser::parse_il_operand() {
    const ast::Expression* operand = nullptr;
    if (at_literal() || at_signed_number()) {
        operand = parse_constant();
    } else if (at(TokenKind::identifier) || at_operand_keyword()) {
        operand = parse_il_variable();
    } else if (at(TokenKind::enumerated_value)) {
        operand = parse_enumerated_value();
    } else if (at(TokenKind::direct_variable) || at(TokenKind::incomplete_location)) {
        operand = parse_primary();
    } else if (at_expression_start() && expression_ends_on_line()) {
        const std::size_t reports = diagnostics_.size();
        operand = parse_binary_rest(parse_unary(), 1);
        return diagnostics_.size() == reports ? report_expression(operand) : operand;
    } else {
        report_at(at_, DiagnosticId::not_an_operand, {quoted(at_)});
        return make_missing<ast::ErrorExpression>();
    }
    if (at_line_end())
        return operand;
    if (at(TokenKind::left_parenthesis) && expression_ends_on_line())
        return report_expression(parse_call(operand));
    const bool operation =
        operator_strength(kind()) > 0 && !is_keyword(kind()) && !at(TokenKind::ampersand);
    return operation && expression_ends_on_line() ? report_expression(parse_binary_rest(operand, 1))
                                                  : operand;
}

const ast::Expression* Parser::report_expression(const ast::Expression* expression) {
    const bool call = expression->kind == ast::NodeKind::function_call;
    report_node(*expression, DiagnosticId::not_an_operand, {call ? "a call" : "an expression"});
    return expression;
}

/// True for what an operand stands behind.
bool Parser::wants_operand(TokenKind kind) noexcept {
    return kind == TokenKind::left_parenthesis || kind == TokenKind::left_bracket ||
           kind == TokenKind::kw_not || operator_strength(kind) > 0;
}

/// True when the rest of the line closes all parentheses that it opens, and breaks off nowhere.
bool Parser::expression_ends_on_line() const noexcept {
    const RestOfLine rest = rest_of_line(at_);
    return rest.parentheses == 0 && !wants_operand(rest.last);
}

Parser::RestOfLine Parser::rest_of_line(std::uint32_t i) const noexcept {
    RestOfLine rest;
    std::uint32_t steps = 0;
    do {
        rest.last = tokens_[i].kind();
        if (rest.last == TokenKind::left_parenthesis)
            ++rest.parentheses;
        else if (rest.last == TokenKind::right_parenthesis && rest.parentheses > 0)
            --rest.parentheses;
        else if (rest.last == TokenKind::right_parenthesis)
            rest.closed = true;
        else if (rest.last == TokenKind::left_bracket)
            ++rest.brackets;
        else if (rest.last == TokenKind::right_bracket && rest.brackets > 0)
            --rest.brackets;
        i = next(i);
    } while (!begins_line(i) && i != count_ && ++steps < furthest_on_line);
    rest.end = i;
    return rest;
}

// il_symbolic_variable = variable_name { il_subscript_list | "." field_selector } ;
// il_variable = direct_variable | il_symbolic_variable | "EN" | "ENO" ;
const ast::Expression* Parser::parse_il_variable() {
    const ast::Expression* variable = parse_variable_name();
    for (;;) {
        if (at(TokenKind::caret) && !at_line_end() && at_dereference()) {
            variable = parse_dereference(variable);
            continue;
        }
        if (at_line_end() || (!at(TokenKind::dot) && !at(TokenKind::left_bracket)))
            return variable;
        if (at(TokenKind::left_bracket) && argument_lines_follow(at_))
            return variable; // it stands for `(`
        if (variable_breaks_off()) {
            auto* node = make_from<ast::StructuredVariable>(variable);
            do
                advance();
            while (!at_line_end());
            node->record_variable = variable;
            report_missing(DiagnosticId::missing_operand, {quoted(end_ - 1)});
            node->field_selector = make_missing<ast::Identifier>();
            return finish(node);
        }
        if (at(TokenKind::dot)) {
            variable = parse_field(variable);
            continue;
        }
        const std::size_t reports = diagnostics_.size();
        variable = parse_subscripts(variable);
        if (diagnostics_.size() == reports)
            check_il_subscripts(*variable);
    }
}

/// At `.` or `[`: true when nothing stands behind it, or the line ends where a subscript goes on.
bool Parser::variable_breaks_off() const noexcept {
    if (begins_line(next(at_)) || peek() == TokenKind::end_of_unit)
        return true;
    if (!at(TokenKind::left_bracket))
        return false;
    const RestOfLine rest = rest_of_line(at_);
    return rest.brackets > 0 && (rest.last == TokenKind::comma || wants_operand(rest.last));
}

// il_subscript = integer_literal | direct_variable | variable_name | "EN" | "ENO" ;
// il_subscript_list = "[" il_subscript { "," il_subscript } "]" ;
void Parser::check_il_subscripts(const ast::Expression& variable) {
    const auto* array = ast::as<ast::ArrayVariable>(&variable);
    if (array == nullptr)
        return;
    for (const ast::Expression* subscript : array->subscripts) {
        switch (subscript->kind) {
        case ast::NodeKind::integer_literal:
        case ast::NodeKind::variable_name:
        case ast::NodeKind::direct_variable: break;
        case ast::NodeKind::array_variable:
        case ast::NodeKind::structured_variable:
        case ast::NodeKind::dereferenced_variable:
            report_node(*subscript, DiagnosticId::il_subscript, {"a part of a variable"});
            break;
        default:
            report_node(*subscript, DiagnosticId::il_subscript,
                        {ast::is<ast::Constant>(subscript->kind)
                             ? "another constant than an integer"
                             : "an expression"});
            break;
        }
    }
}

// il_operand_list = il_operand { "," il_operand } ;
void Parser::add_il_operands(ListBuilder<ast::Expression>& operands) {
    while (accept_il_comma())
        operands.add(parse_next_il_operand());
}

/// "," between two operands
bool Parser::accept_il_comma() {
    if (at_line_end() || at_end_of_instructions())
        return false;
    return accept(TokenKind::comma) || (!begins_instruction_on_line() && accept_missing_comma());
}

/// Part of il_operand_list: behind a comma. A list that goes on in the next line is reported.
const ast::Expression* Parser::parse_next_il_operand() {
    const std::uint32_t behind = next(at_);
    static constexpr TokenSet in_list{TokenKind::comma, TokenKind::right_parenthesis};
    const bool goes_on = at_line_end() && at_expression_start() && il_operator(at_) == nullptr &&
                         (in_list.contains(tokens_[behind].kind()) || begins_line(behind));
    if (!goes_on)
        return expect_il_operand("`,`");
    report_line_end();
    return parse_il_operand();
}

/// A line end in an operand list: reported, and passed over.
void Parser::report_line_end() {
    const TextRange gap{previous_end(), token().offset()};
    const bool blank =
        text_.substr(gap.begin, gap.size()).find_first_not_of(" \t\r\n") == std::string_view::npos;
    Report line_end = report(DiagnosticId::line_end_in_instruction, {gap.begin, gap.begin});
    if (blank)
        line_end.replace(gap, " ");
}

} // namespace iecfront
