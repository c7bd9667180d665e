#include "parser/misspelling.hpp"
#include "parser/parser.hpp"

#include <iecfront/lexer/literals.hpp>
#include <iecfront/lexer/name.hpp>

#include <array>
#include <utility>

namespace iecfront {

/// What a token means as an operator: which one, and how strong it binds; 0 is none.
struct OperatorReading {
    std::uint8_t strength = 0;
    ast::BinaryOperator op = ast::BinaryOperator::power;
};

namespace {

/// A row of Table 55. A larger `strength` binds tighter; 0 is no operator.
struct OperatorRow {
    unsigned strength = 0;
    ast::BinaryOperator op = ast::BinaryOperator::power;
    std::string_view meant; ///< what to write instead, for an operator of another language
};

constexpr OperatorRow operator_row(TokenKind kind) noexcept {
    using enum ast::BinaryOperator;
    switch (kind) {
    case TokenKind::kw_or: return {1, logical_or, {}};
    case TokenKind::bar_bar: return {1, logical_or, "OR"};
    case TokenKind::kw_xor: return {2, exclusive_or, {}};
    case TokenKind::kw_and:
    case TokenKind::ampersand: return {3, logical_and, {}};
    case TokenKind::ampersand_ampersand: return {3, logical_and, "AND"};
    case TokenKind::equal: return {4, equal, {}};
    case TokenKind::equal_equal: return {4, equal, "="};
    case TokenKind::not_equal: return {4, not_equal, {}};
    case TokenKind::exclamation_equal: return {4, not_equal, "<>"};
    case TokenKind::less: return {5, less, {}};
    case TokenKind::greater: return {5, greater, {}};
    case TokenKind::less_equal: return {5, less_equal, {}};
    case TokenKind::greater_equal: return {5, greater_equal, {}};
    case TokenKind::plus: return {6, add, {}};
    case TokenKind::minus: return {6, subtract, {}};
    case TokenKind::star: return {7, multiply, {}};
    case TokenKind::slash: return {7, divide, {}};
    case TokenKind::kw_mod: return {7, modulo, {}};
    case TokenKind::power: return {8, power, {}};
    default: return {};
    }
}

constexpr auto operator_table = [] {
    std::array<OperatorRow, token_kind_count> table{};
    for (std::size_t i = 0; i < token_kind_count; ++i)
        table[i] = operator_row(static_cast<TokenKind>(i));
    return table;
}();

/// Operators of later editions that are names in this one, and before an operand misspelt ones.
OperatorRow operator_of_other_languages(std::string_view word, bool before_operand) noexcept {
    if (names_equal(word, "AND_THEN"))
        return {3, ast::BinaryOperator::logical_and, "AND"};
    if (names_equal(word, "OR_ELSE"))
        return {1, ast::BinaryOperator::logical_or, "OR"};
    if (before_operand && names_equal(word, "RO"))
        return {1, ast::BinaryOperator::logical_or, "OR"};
    if (before_operand)
        for (const TokenKind meant : {TokenKind::kw_and, TokenKind::kw_xor, TokenKind::kw_mod})
            if (is_misspelling(word, spelling(meant))) {
                const OperatorRow row = operator_row(meant);
                return {row.strength, row.op, spelling(meant)};
            }
    return {};
}

// Operators of one token and of this language; `doubtful` is what may be another one, or none.
constexpr std::uint8_t doubtful = 0xFF;
constexpr auto plain_operators = [] {
    std::array<OperatorReading, token_kind_count> table{};
    for (std::size_t i = 0; i < token_kind_count; ++i) {
        const OperatorRow& row = operator_table[i];
        table[i] = {row.meant.empty() ? static_cast<std::uint8_t>(row.strength) : doubtful, row.op};
    }
    for (const TokenKind kind :
         {TokenKind::identifier, TokenKind::assign, TokenKind::output_arrow, TokenKind::caret})
        table[static_cast<std::size_t>(kind)].strength = doubtful;
    return table;
}();

// What is part of the operator before it in other languages, or when they are apart.
constexpr TokenSet second_halves{TokenKind::less, TokenKind::greater, TokenKind::equal,
                                 TokenKind::equal_equal, TokenKind::star};

// Behind an operand: it has no parts, and is not the whole of a mistake. Not so `-`, as `a->b`
// stands for `a.b`.
constexpr TokenSet behind_plain_operand{
    TokenKind::semicolon,     TokenKind::comma,   TokenKind::right_parenthesis,
    TokenKind::kw_or,         TokenKind::kw_xor,  TokenKind::kw_and,
    TokenKind::ampersand,     TokenKind::equal,   TokenKind::not_equal,
    TokenKind::less,          TokenKind::greater, TokenKind::less_equal,
    TokenKind::greater_equal, TokenKind::plus,    TokenKind::star,
    TokenKind::slash,         TokenKind::kw_mod,  TokenKind::kw_then,
    TokenKind::kw_do,         TokenKind::kw_of,   TokenKind::kw_to,
    TokenKind::kw_by};

constexpr unsigned weakest = 1;
constexpr unsigned equality = 4;
constexpr unsigned relation = 5;

// Keywords that name a standard function as well (2.5.1.5).
constexpr TokenSet operator_functions{TokenKind::kw_and, TokenKind::kw_or, TokenKind::kw_xor,
                                      TokenKind::kw_mod, TokenKind::kw_not};

// Keywords with no part in statements and expressions: in an expression they can only be meant as
// names.
constexpr TokenSet foreign_keywords =
    TokenSet::range(TokenKind::kw_bool, TokenKind::kw_type) |
    TokenSet{TokenKind::kw_function,     TokenKind::kw_function_block,
             TokenKind::kw_program,      TokenKind::kw_configuration,
             TokenKind::kw_struct,       TokenKind::kw_array,
             TokenKind::kw_constant,     TokenKind::kw_retain,
             TokenKind::kw_non_retain,   TokenKind::kw_at,
             TokenKind::kw_r_edge,       TokenKind::kw_f_edge,
             TokenKind::kw_read_only,    TokenKind::kw_read_write,
             TokenKind::kw_resource,     TokenKind::kw_on,
             TokenKind::kw_task,         TokenKind::kw_with,
             TokenKind::kw_initial_step, TokenKind::kw_step,
             TokenKind::kw_transition,   TokenKind::kw_from,
             TokenKind::kw_action};

} // namespace

// comparison_operator = "<" | ">" | "<=" | ">=" ;
// add_operator = "+" | "-" ;
// multiply_operator = "*" | "/" | "MOD" ;
unsigned Parser::operator_strength(TokenKind kind) noexcept {
    return operator_table[static_cast<std::size_t>(kind)].strength;
}

bool Parser::at_operand_keyword() const noexcept {
    return at(execution_control) || at(foreign_keywords);
}

bool Parser::at_expression_start() const noexcept {
    static constexpr TokenSet starts{TokenKind::identifier,      TokenKind::enumerated_value,
                                     TokenKind::direct_variable, TokenKind::left_parenthesis,
                                     TokenKind::minus,           TokenKind::plus,
                                     TokenKind::kw_not,          TokenKind::kw_en,
                                     TokenKind::kw_eno};
    return at(starts) || at_literal();
}

// expression = xor_expression { "OR" xor_expression } ;
const ast::Expression* Parser::parse_expression() {
    return parse_binary(weakest);
}

/// Part of if_statement, while_statement, repeat_statement, transition_condition,
/// primary_expression: an expression where an assignment cannot stand; `:=` is taken for `=`.
const ast::Expression* Parser::parse_condition() {
    const bool outer = std::exchange(in_condition_, true);
    const ast::Expression* condition = parse_expression();
    in_condition_ = outer;
    return condition;
}

// xor_expression = and_expression { "XOR" and_expression } ;
// and_expression = comparison { ( "&" | "AND" ) comparison } ;
// comparison = equ_expression { ( "=" | "<>" ) equ_expression } ;
// equ_expression = add_expression { comparison_operator add_expression } ;
// add_expression = term { add_operator term } ;
// term = power_expression { multiply_operator power_expression } ;
// power_expression = unary_expression { "**" unary_expression } ;
const ast::Expression* Parser::parse_binary(unsigned minimum) {
    const ast::Expression* const left =
        at_plain_operand() ? parse_plain_operand() : parse_doubtful_unary();
    return may_be_at_operator(minimum) ? parse_binary_rest(left, minimum) : left;
}

/// When false, `parse_binary_rest` would consume nothing; when true, it may: what is an operator by
/// itself may be a part of one that binds tighter.
bool Parser::may_be_at_operator(unsigned minimum) const noexcept {
    const unsigned strength = plain_operators[static_cast<std::size_t>(kind())].strength;
    return strength >= minimum ||
           (strength != 0 && (in_instructions_ || second_halves.contains(tokens_[at_ + 1].kind())));
}

/// At what is an operator, or may be one.
bool Parser::at_operator() const noexcept {
    return plain_operators[static_cast<std::size_t>(kind())].strength != 0;
}

/// Part of expression: precedence climbing over Table 55; all operators associate to the left.
const ast::Expression* Parser::parse_binary_rest(const ast::Expression* left, unsigned minimum) {
    while (at_operator()) {
        OperatorReading found = plain_operators[static_cast<std::size_t>(kind())];
        const bool plain = found.strength != doubtful && !in_instructions_ &&
                           !second_halves.contains(tokens_[at_ + 1].kind());
        if (!plain && at_shift() && minimum <= relation) {
            left = parse_shift(left);
            continue;
        }
        if (!plain)
            found = accept_doubtful_operator(minimum);
        if (found.strength < minimum)
            return left;
        advance();
        const bool alone = left->missing && !begins_operand(kind()); // lacks both, as was reported
        const ast::Expression* const right =
            alone ? make_missing<ast::ErrorExpression>() : parse_binary(found.strength + 1U);
        auto* node = make_from<ast::BinaryExpression>(left);
        node->op = found.op;
        node->left = left;
        node->right = right;
        left = finish(node);
    }
    return left;
}

/// At an operator that may be another one than it seems, or none: says which, and is left at its
/// last token. When it binds less than `minimum`, nothing is consumed.
OperatorReading Parser::accept_doubtful_operator(unsigned minimum) {
    OperatorRow row = operator_table[static_cast<std::size_t>(kind())];
    if (at(TokenKind::identifier))
        row = operator_of_other_languages(text(at_), begins_operand_on_line(next(at_)));
    else if (at_caret_for_power())
        row = {8, ast::BinaryOperator::power, "**"};
    const bool assign = in_condition_ && at(TokenKind::assign);
    const TokenKind split =
        in_condition_ && at(TokenKind::output_arrow) ? TokenKind::greater_equal : split_operator();
    if (assign)
        row = {equality, ast::BinaryOperator::equal, {}};
    else if (split != TokenKind::end_of_unit)
        row = operator_row(split);
    if (row.strength < minimum || row.strength == 0)
        return {};
    if (in_instructions_ && at_line_end()) // the operator of the next instruction
        return {};
    if (assign)
        report_at(at_, DiagnosticId::assignment_for_equal).replace(token().range(), "=");
    else if (split != TokenKind::end_of_unit)
        accept_split_operator(split);
    else if (!row.meant.empty())
        report_at(at_, DiagnosticId::foreign_operator, {text(at_), row.meant})
            .replace(token().range(), std::string(row.meant));
    return {static_cast<std::uint8_t>(row.strength), row.op};
}

/// `<<` or `>>`.
bool Parser::at_shift() const noexcept {
    return (at(TokenKind::less) || at(TokenKind::greater)) && peek() == kind() && adjoins_next();
}

/// In place of expression: `a << 2`, which is written `SHL(a, 2)`.
const ast::Expression* Parser::parse_shift(const ast::Expression* left) {
    auto* node = make_from<ast::ErrorExpression>(left);
    const TextRange range = token_range(at_, next(at_) + 1);
    const std::string function = at(TokenKind::less) ? "SHL" : "SHR";
    const Report shift = report_at(at_, DiagnosticId::foreign_operator,
                                   {text_.substr(range.begin, 2), function + "(...)"});
    if (shift)
        diagnostics_[shift.index()].range = range;
    advance();
    advance();
    const ast::Expression* right = parse_binary(relation + 1);
    finish(node);
    if (!shift || left->missing || right->missing)
        return node;
    const TextRange operands = token_range(node->first_token, node->end_token);
    const std::uint32_t left_end = token_range(left->first_token, left->end_token).end;
    const bool blank = left_end + 1 == range.begin && text_[left_end] == ' ';
    diagnostics_[shift.index()].fixes.push_back(
        {{{{operands.begin, operands.begin}, function + "("},
          {{blank ? left_end : range.begin, range.end}, ","},
          {{operands.end, operands.end}, ")"}}});
    return node;
}

/// What two delimiters in a row mean that cannot stand so: `< =`, `* *`, `=<` or `===`; end_of_unit
/// for any others.
TokenKind Parser::split_operator() const noexcept {
    static constexpr TokenSet firsts{TokenKind::less,  TokenKind::greater,
                                     TokenKind::equal, TokenKind::equal_equal,
                                     TokenKind::star,  TokenKind::exclamation_equal};
    if (!at(firsts) || !on_same_line(at_, next(at_)))
        return TokenKind::end_of_unit;
    const TokenKind after = peek();
    switch (kind()) {
    case TokenKind::less:
        return after == TokenKind::equal     ? TokenKind::less_equal
               : after == TokenKind::greater ? TokenKind::not_equal
                                             : TokenKind::end_of_unit;
    case TokenKind::greater:
        return after == TokenKind::equal ? TokenKind::greater_equal : TokenKind::end_of_unit;
    case TokenKind::equal_equal:
        return after == TokenKind::equal ? TokenKind::equal : TokenKind::end_of_unit;
    case TokenKind::exclamation_equal:
        return after == TokenKind::equal && adjoins_next() ? TokenKind::not_equal
                                                           : TokenKind::end_of_unit;
    case TokenKind::equal:
        if (after == TokenKind::equal)
            return TokenKind::equal;
        return after == TokenKind::less && adjoins_next() ? TokenKind::less_equal
                                                          : TokenKind::end_of_unit;
    case TokenKind::star:
        return after == TokenKind::star ? TokenKind::power : TokenKind::end_of_unit;
    default: return TokenKind::end_of_unit;
    }
}

/// Reports what stands for `meant`, and leaves its last token to be consumed.
void Parser::accept_split_operator(TokenKind meant) {
    const std::string words(spelling(meant));
    const bool one = at(TokenKind::output_arrow);
    const TextRange range = token_range(at_, one ? at_ + 1 : next(at_) + 1);
    if (one || adjoins_next() || meant == TokenKind::equal)
        report(DiagnosticId::foreign_operator, range,
               {text_.substr(range.begin, range.size()), words})
            .replace(range, words);
    else
        report(DiagnosticId::white_space_in_delimiter, {token().end(), tokens_[next(at_)].offset()},
               {words})
            .replace(range, words);
    if (!one)
        advance();
}

// unary_expression = [ unary_operator ] primary_expression
//                  | "NOT" "(" ( variable_name | "EN" | "ENO" )
//                    ( ":=" expression | "=>" variable ) { "," param_assignment } ")" ;
// unary_operator = "-" | "NOT" ;
const ast::Expression* Parser::parse_unary() {
    return at_plain_operand() ? parse_plain_operand() : parse_doubtful_unary();
}

/// Part of unary_expression: one that is no plain operand.
const ast::Expression* Parser::parse_doubtful_unary() {
    if (at_plain_variable())
        return check_function_call(parse_selectors(parse_plain_name()));
    if (at(TokenKind::left_parenthesis))
        return parse_parenthesized();
    if (at_signed_number())
        return parse_constant();
    const bool minus = at(TokenKind::minus);
    const bool plus = at(TokenKind::plus);
    const bool misspelt = at(TokenKind::identifier) && at_misspelt_not();
    if (!minus && !plus && !at(TokenKind::kw_not) && !misspelt)
        return parse_primary();
    if (misspelt)
        report_at(at_, DiagnosticId::misspelt_word, {text(at_), "NOT"})
            .replace(token().range(), "NOT");
    if (at(TokenKind::kw_not) && peek() == TokenKind::left_parenthesis && formal_list_follows())
        return check_function_call(parse_operator_call());
    const NestingGuard guard(*this);
    if (guard.too_deep())
        return parse_too_deep_expression();
    auto* node = make<ast::UnaryExpression>();
    node->op = minus  ? ast::UnaryOperator::minus
               : plus ? ast::UnaryOperator::plus
                      : ast::UnaryOperator::logical_not;
    const std::uint32_t sign = advance();
    if (plus && at(TokenKind::plus) && !at_signed_number() &&
        tokens_[sign].end() == token().offset())
        advance(); // `++x` is one mistake
    const bool call = at(operator_functions) && peek() == TokenKind::left_parenthesis;
    if (plus && (at_expression_start() || call))
        report_at(sign, DiagnosticId::unary_plus).remove(token_range(sign, end_));
    const bool repeated = (at(TokenKind::minus) || at(TokenKind::plus) || at(TokenKind::kw_not)) &&
                          !at_signed_number();
    if (repeated && !plus)
        report_at(at_, DiagnosticId::repeated_unary_operator);
    node->operand = parse_unary();
    return finish(node);
}

/// A literal, or a name that is an operand as it stands, which nearly all of them are.
bool Parser::at_plain_operand() const noexcept {
    return at_literal() || (at(TokenKind::identifier) && !token().first_on_line() &&
                            behind_plain_operand.contains(tokens_[at_ + 1].kind()));
}

/// Part of primary_expression: such a one.
const ast::Expression* Parser::parse_plain_operand() {
    return at(TokenKind::identifier) ? parse_plain_name() : parse_literal(at_);
}

/// A name behind which no other name stands, as in two words for one operator, and which does not
/// begin a line, so that nothing is missing before it.
bool Parser::at_plain_variable() const noexcept {
    static constexpr TokenSet doubtful_behind{TokenKind::identifier, TokenKind::unknown};
    return at(TokenKind::identifier) && !token().first_on_line() &&
           !doubtful_behind.contains(tokens_[at_ + 1].kind());
}

/// `NTO a`
bool Parser::at_misspelt_not() const noexcept {
    return peek() == TokenKind::identifier && (at_word("NTO") || at_word("ONT")) &&
           !tokens_[next(at_)].first_on_line() &&
           operator_of_other_languages(text(next(at_)), true).strength == 0;
}

// primary_expression = constant | enumerated_value | variable | "(" expression ")"
//                    | function_name "(" param_list ")" ;
const ast::Expression* Parser::parse_primary() {
    if (at_assignment_on_new_line() || at_next_declaration())
        return parse_missing_expression();
    switch (kind()) {
    case TokenKind::identifier: return check_function_call(parse_variable());
    case TokenKind::left_parenthesis: return parse_parenthesized();
    case TokenKind::enumerated_value: return parse_enumerated_value();
    case TokenKind::direct_variable: return parse_direct_variable();
    case TokenKind::incomplete_location: {
        report_at(at_, DiagnosticId::incomplete_location);
        return parse_direct_variable();
    }
    default: break;
    }
    if (at(operator_functions) && peek() == TokenKind::left_parenthesis)
        return check_function_call(parse_operator_call());
    if (peek() == TokenKind::left_parenthesis && peek_second() != TokenKind::right_parenthesis &&
        names_type(at_)) { // `INT(x)`
        report_conversion(at_, at_ + 1, kind());
        return parse_operator_call();
    }
    if (at_operand_keyword() || (is_keyword(kind()) && used_as_name(kind())) ||
        at_keyword_for_variable())
        return parse_variable();
    return parse_missing_expression();
}

/// A function has a name and at least one argument. A call that is not closed has other faults.
const ast::Expression* Parser::check_function_call(const ast::Expression* operand) {
    const auto* call = ast::as<ast::FunctionCall>(operand);
    if (call == nullptr)
        return operand;
    if (call->function->kind == ast::NodeKind::dereferenced_variable)
        return operand; // which was reported
    if (call->function->kind != ast::NodeKind::variable_name)
        report_call_of_member(*call->function);
    else if (!call->arguments.empty())
        return operand;
    else if (tokens_[call->end_token - 1].kind() == TokenKind::right_parenthesis)
        report_node(*call, DiagnosticId::function_without_arguments);
    else if (reported_at_ == at_ && !diagnostics_.empty() &&
             diagnostics_.back().id == DiagnosticId::missing_token)
        diagnostics_.back().fixes.clear(); // arguments are missing as well
    return operand;
}

void Parser::report_call_of_member(const ast::Expression& callee) {
    report_node(callee, DiagnosticId::call_of_member,
                {callee.kind == ast::NodeKind::array_variable ? "an array element"
                                                              : "a member or a result"});
}

/// True when an operand is missing at the end of the line before, as an assignment follows, or a
/// declaration or label.
bool Parser::at_assignment_on_new_line() const noexcept {
    if (!token().first_on_line() || at_ == 0 ||
        (!at(TokenKind::identifier) && !at(TokenKind::direct_variable)))
        return false;
    if (peek() == TokenKind::colon)
        return true;
    static constexpr TokenSet inside_variable{TokenKind::dot, TokenKind::identifier,
                                              TokenKind::caret, TokenKind::part_selector};
    std::uint32_t depth = 0; // of brackets
    std::uint32_t steps = 0;
    for (std::uint32_t i = next(at_);
         steps < furthest_on_line && i < count_ && !tokens_[i].first_on_line();
         i = next(i), ++steps) {
        const TokenKind here = tokens_[i].kind();
        if (here == TokenKind::left_bracket)
            ++depth;
        else if (here == TokenKind::right_bracket && depth > 0)
            --depth;
        else if (depth == 0 && !inside_variable.contains(here))
            return here == TokenKind::assign && (!in_condition_ || statement_ends(i));
    }
    return false;
}

/// True when nothing before the next `;` belongs to a condition around token `i`.
bool Parser::statement_ends(std::uint32_t i) const noexcept {
    if (open_.empty() || open_.back().closer == TokenKind::kw_end_transition)
        return false;
    std::uint32_t depth = 0; // of parentheses
    for (std::uint32_t steps = 0; steps < furthest_on_line; i = next(i), ++steps) {
        const TokenKind here = tokens_[i].kind();
        if (here == TokenKind::semicolon)
            return tokens_[next(i)].kind() != TokenKind::kw_end_repeat;
        if (part_words.contains(here) || statement_closers.contains(here) || i == count_ ||
            (here == TokenKind::right_parenthesis && depth-- == 0))
            return false;
        depth += here == TokenKind::left_parenthesis ? 1 : 0;
    }
    return false;
}

/// In place of expression: there is none.
const ast::Expression* Parser::parse_missing_expression() {
    if (at_next_declaration()) {
        report_unfinished(DiagnosticId::missing_expression, {describe(at_)});
        return make_missing<ast::ErrorExpression>();
    }
    if (report_missing(DiagnosticId::missing_expression, {describe(at_)}) &&
        !token().first_on_line() && !at_end())
        diagnostics_.back().range = token().range();
    return make_missing<ast::ErrorExpression>();
}

/// In place of expression: passes over one that is nested too deep.
const ast::Expression* Parser::parse_too_deep_expression() {
    auto* error = make<ast::ErrorExpression>();
    while (at(TokenKind::minus) || at(TokenKind::plus) || at(TokenKind::kw_not))
        advance();
    if (at(TokenKind::left_parenthesis) || at(TokenKind::left_bracket) || at_expression_start())
        skip_balanced();
    return finish(error);
}

/// True at a keyword that is a type's name, and not meant as the name of a variable.
bool Parser::names_type(std::uint32_t index) const noexcept {
    const TokenKind here = tokens_[index].kind();
    return is_elementary_type_name(here) && !used_as_name(here);
}

/// About a type's name in an expression: what converts is a function (2.5.1.5.1).
void Parser::report_conversion(std::uint32_t first, std::uint32_t end, TokenKind type) {
    const TextRange range = token_range(first, end);
    const std::string from = type == TokenKind::kw_int ? "REAL" : "INT";
    report(DiagnosticId::unexpected_token, range,
           {"a conversion like `" + from + "_TO_" + std::string(spelling(type)) + "(...)`",
            "`" + std::string(text_.substr(range.begin, range.size())) + "`"});
}

/// In place of unary_expression: `(INT) x`, as other languages convert.
const ast::Expression* Parser::parse_cast() {
    auto* cast = make<ast::ErrorExpression>();
    const std::uint32_t type = next(at_);
    report_conversion(at_, next(type) + 1, tokens_[type].kind());
    advance_past(next(type));
    parse_unary();
    return finish(cast);
}

// Part of primary_expression: "(" expression ")"
const ast::Expression* Parser::parse_parenthesized() {
    const NestingGuard guard(*this);
    if (guard.too_deep())
        return parse_too_deep_expression();
    if (is_elementary_type_name(peek()) && peek_second() == TokenKind::right_parenthesis &&
        names_type(next(at_))) {
        const std::uint32_t behind = next(next(next(at_)));
        if (begins_operand_on_line(behind) || tokens_[behind].kind() == TokenKind::left_parenthesis)
            return parse_cast();
    }
    auto* node = make<ast::ParenthesizedExpression>();
    advance();
    node->expression = parse_condition();
    expect(TokenKind::right_parenthesis);
    return finish(node);
}

/// Part of primary_expression: `AND(a, b)` and its like, an operator that stands for the function
/// of its name (6.1 D25).
const ast::Expression* Parser::parse_operator_call() {
    return parse_selectors(take_word<ast::VariableName>());
}

/// At an operator that is also a function: true when `name :=` or `name =>` follows the
/// parenthesis.
bool Parser::formal_list_follows() const noexcept {
    const std::uint32_t name = next(next(at_));
    const TokenKind after = tokens_[next(name)].kind();
    const TokenKind here = tokens_[name].kind();
    return (here == TokenKind::identifier || execution_control.contains(here)) &&
           (after == TokenKind::assign || after == TokenKind::output_arrow);
}

// variable = direct_variable | symbolic_variable | "EN" | "ENO" ;
// multi_element_variable = array_variable | structured_variable ;
const ast::Expression* Parser::parse_variable() {
    return parse_selectors(parse_variable_name());
}

// variable_name = identifier ;
const ast::Expression* Parser::parse_variable_name() {
    if (at(TokenKind::identifier))
        return parse_plain_name();
    if (!at(execution_control) || used_as_name(kind()))
        report_reserved_word(at_);
    return take_word<ast::VariableName>();
}

/// Part of variable_name: an identifier.
const ast::Expression* Parser::parse_plain_name() {
    return take_name<ast::VariableName, NameUse::variable>();
}

// array_variable = subscripted_variable subscript_list ;
// subscripted_variable = variable_name { subscript_list | "." field_selector } ;
// record_variable = variable_name { subscript_list | "." field_selector } ;
/// What follows a variable's name: subscripts, fields, and the arguments of a call.
const ast::Expression* Parser::parse_selectors(const ast::Expression* head) {
    for (;;) {
        const bool of_result = head->kind == ast::NodeKind::function_call;
        if (of_result && (at(TokenKind::left_bracket) || at(TokenKind::dot)))
            report_at(at_, DiagnosticId::member_of_result);
        switch (kind()) {
        case TokenKind::left_bracket: head = parse_subscripts(head); break;
        case TokenKind::dot: head = parse_field(head); break;
        case TokenKind::left_parenthesis: head = parse_call(head); break;
        case TokenKind::caret:
            if (!at_dereference())
                return head;
            head = parse_dereference(head);
            break;
        case TokenKind::dot_dot:
            if (!at_doubled_dot())
                return head;
            report_unexpected("`.`").replace(token().range(), ".");
            head = parse_field(head);
            break;
        case TokenKind::minus:
            if (!at_arrow_for_dot())
                return head;
            head = parse_arrow(head);
            break;
        case TokenKind::right_bracket:
            if (peek() != TokenKind::dot || !adjoins_next() || closes_open_bracket())
                return head;
            report_unexpected("`.`");
            advance();
            break;
        default: return head;
        }
    }
}

/// At `^` behind a variable: false when it stands for an operator, as in `a ^ 2`.
bool Parser::at_dereference() const noexcept {
    const std::uint32_t behind = next(at_);
    if (tokens_[behind].kind() == TokenKind::left_parenthesis)
        return adjoins_next() && at_ > 0 && tokens_[at_ - 1].end() == token().offset();
    return !begins_operand_on_line(behind) ||
           operator_of_other_languages(text(behind), begins_operand_on_line(next(behind)))
                   .strength > 0;
}

/// In place of structured_variable: `p^`, what the reference refers to.
const ast::Expression* Parser::parse_dereference(const ast::Expression* reference) {
    if (has_no_parts(*reference))
        report_reserved_word(reference->first_token);
    else
        report_at(at_, DiagnosticId::dereference);
    auto* node = make_from<ast::DereferencedVariable>(reference);
    advance();
    node->reference = reference;
    return finish(node);
}

/// `a ^ 2`, the power of other languages.
bool Parser::at_caret_for_power() const noexcept {
    static constexpr TokenSet others{TokenKind::left_parenthesis, TokenKind::minus,
                                     TokenKind::plus};
    const std::uint32_t behind = next(at_);
    return at(TokenKind::caret) &&
           (begins_operand_on_line(behind) ||
            (others.contains(tokens_[behind].kind()) && !tokens_[behind].first_on_line()));
}

/// `a->b`
bool Parser::at_arrow_for_dot() const noexcept {
    const std::uint32_t second = next(at_);
    return at(TokenKind::minus) && peek() == TokenKind::greater &&
           peek_second() == TokenKind::identifier && adjoins_next() &&
           tokens_[second].end() == tokens_[next(second)].offset();
}

/// In place of structured_variable: `a->b`, as in C.
const ast::Expression* Parser::parse_arrow(const ast::Expression* head) {
    const TextRange arrow = token_range(at_, next(at_) + 1);
    report(DiagnosticId::foreign_operator, arrow, {"->", "."}).replace(arrow, ".");
    advance();
    return parse_field(head);
}

/// `a..b := 1`: between two names in a statement, where nothing behind them makes them the bounds
/// of a subrange.
bool Parser::at_doubled_dot() const noexcept {
    static constexpr TokenSet declarations{TokenKind::kw_end_var, TokenKind::kw_end_type,
                                           TokenKind::kw_end_struct};
    static constexpr TokenSet behind_member{TokenKind::assign, TokenKind::semicolon, TokenKind::dot,
                                            TokenKind::left_bracket, TokenKind::kw_then};
    return peek() == TokenKind::identifier && adjoins_next() && !open_.empty() &&
           !declarations.contains(open_.back().closer) && at_ > 0 &&
           tokens_[at_ - 1].end() == token().offset() &&
           (behind_member.contains(peek_second()) || operator_strength(peek_second()) > 0);
}

// subscript_list = "[" subscript { "," subscript } "]" ;
// subscript = expression ;
const ast::Expression* Parser::parse_subscripts(const ast::Expression* head) {
    const NestingGuard guard(*this);
    if (guard.too_deep())
        return parse_too_deep_expression();
    check_has_parts(*head);
    auto* node = make_from<ast::ArrayVariable>(head);
    advance();
    ListBuilder<ast::Expression> subscripts(*this);
    const bool outer = std::exchange(in_condition_, false);
    std::optional<Report> semicolons;
    do
        subscripts.add(parse_expression());
    while (!at_formal_argument_behind_comma() &&
           (accept(TokenKind::comma) || accept_missing_comma() ||
            accept_semicolon_for_comma(TokenKind::right_bracket, semicolons)));
    in_condition_ = outer;
    expect(TokenKind::right_bracket);
    node->subscripted_variable = head;
    node->subscripts = subscripts.finish();
    return finish(node);
}

/// `, PT := b`, which is no subscript.
bool Parser::at_formal_argument_behind_comma() const noexcept {
    if (!at(TokenKind::comma) || peek() != TokenKind::identifier)
        return false;
    const TokenKind behind_name = peek_second();
    return behind_name == TokenKind::assign || behind_name == TokenKind::output_arrow;
}

/// True for an operand: an assignment cannot begin with it.
bool Parser::follows_operator(std::uint32_t index) const noexcept {
    const TokenKind before = index > 0 ? tokens_[index - 1].kind() : TokenKind::unknown;
    return before == TokenKind::assign || operator_strength(before) > 0;
}

// structured_variable = record_variable "." field_selector ;
// field_selector = identifier | "EN" | "ENO" ;
const ast::Expression* Parser::parse_field(const ast::Expression* head) {
    check_has_parts(*head);
    auto* node = make_from<ast::StructuredVariable>(head);
    advance();
    node->record_variable = head;
    if (at(TokenKind::identifier) && !token().first_on_line()) {
        node->field_selector = parse_name("a name after `.`");
    } else if (at(TokenKind::integer)) {
        report_at(at_, DiagnosticId::bit_access, {"bit " + std::string(text(at_))});
        node->field_selector = parse_constant();
    } else if (at(TokenKind::part_selector)) {
        node->field_selector = parse_part_selector();
    } else if (token().first_on_line() && peek() == TokenKind::assign &&
               follows_operator(head->first_token)) {
        node->field_selector = make_missing_identifier("a name after `.`");
    } else if (at(execution_control)) {
        node->field_selector = make_identifier();
    } else if (is_keyword(kind()) && tokens_[at_ - 1].end() == token().offset()) {
        node->field_selector = take_reserved_word();
    } else {
        node->field_selector = parse_name("a name after `.`");
    }
    return finish(node);
}

/// In place of field_selector: `%X3`.
const ast::PartSelector* Parser::parse_part_selector() {
    const std::string_view words = text(at_); // `%`, a letter, and a number
    const char* part = "long word ";
    switch (fold(words[1])) {
    case 'X': part = "bit "; break;
    case 'B': part = "byte "; break;
    case 'W': part = "word "; break;
    case 'D': part = "double word "; break;
    default: break;
    }
    report_at(at_, DiagnosticId::bit_access, {part + std::string(words.substr(2))});
    return take<ast::PartSelector>();
}

/// EN and ENO have no parts, and are nothing that is called (6.1 D24).
bool Parser::has_no_parts(const ast::Expression& variable) const noexcept {
    return variable.kind == ast::NodeKind::variable_name &&
           execution_control.contains(tokens_[variable.first_token].kind());
}

void Parser::check_has_parts(const ast::Expression& variable) {
    if (has_no_parts(variable))
        report_reserved_word(variable.first_token);
}

// Part of primary_expression: "(" param_list ")"
const ast::Expression* Parser::parse_call(const ast::Expression* callee) {
    const NestingGuard guard(*this);
    if (guard.too_deep())
        return parse_too_deep_expression();
    check_has_parts(*callee);
    auto* node = make_from<ast::FunctionCall>(callee);
    node->function = callee;
    node->arguments = parse_arguments();
    return finish(node);
}

// param_list = expression { "," expression } | param_assignment { "," param_assignment } ;
Parser::Children<ast::Node> Parser::parse_arguments() {
    const bool outer = std::exchange(in_condition_, false);
    const std::size_t reports = diagnostics_.size();
    const std::uint32_t open = advance();
    ListBuilder<ast::Node> arguments(*this);
    std::optional<Report> doubled = accept_doubled_parenthesis();
    const bool unfinished = at_end_of_unfinished_call(open);
    if (!at(TokenKind::right_parenthesis) && !unfinished) {
        const ast::Node* last = nullptr;
        std::optional<Report> semicolons;
        do
            arguments.add(last = parse_argument(open));
        while (!at(TokenKind::right_parenthesis) &&
               (accept_argument_comma(open, is_formal(*last)) ||
                accept_semicolon_of_arguments(is_formal(*last), semicolons) ||
                accept_missing_comma(is_formal(*last))));
    }
    static constexpr TokenSet expected{TokenKind::right_parenthesis, TokenKind::right_bracket,
                                       TokenKind::semicolon};
    if (doubled && at(TokenKind::right_parenthesis) && peek() == TokenKind::right_parenthesis) {
        if (*doubled)
            doubled->also_remove(token().range());
        advance();
    }
    const bool head_ends = at(part_words) && !brackets_balance(); // `IF f(a THEN`
    if (at(expected) || head_ends || token().first_on_line()) {
        expect(TokenKind::right_parenthesis);
    } else {
        report_unexpected("`,` or `)`");
        skip_to(expected);
        accept(TokenKind::right_parenthesis);
    }
    in_condition_ = outer;
    const Children<ast::Node> list = arguments.finish();
    if (diagnostics_.size() == reports)
        check_arguments(list);
    return list;
}

/// `t((IN := a);`: no expression has a name with `:=` in it.
std::optional<Parser::Report> Parser::accept_doubled_parenthesis() {
    static constexpr TokenSet behind_parameter{TokenKind::assign, TokenKind::output_arrow};
    const std::uint32_t name = next(at_);
    if (!at(TokenKind::left_parenthesis) || tokens_[name].kind() != TokenKind::identifier ||
        !behind_parameter.contains(tokens_[next(name)].kind()))
        return std::nullopt;
    Report doubled = report_unexpected("an argument").remove(token().range());
    advance();
    reported_at_ = at_ - 1;
    return doubled;
}

/// Behind `(`: true at what ends the statement, or begins one on the next line, when no `)`
/// follows.
bool Parser::at_end_of_unfinished_call(std::uint32_t open) const noexcept {
    static constexpr TokenSet not_in_call = statement_words | statement_closers | unit_ends;
    if (at(TokenKind::semicolon))
        return !argument_list_closes(next(at_));
    const bool statement =
        token().first_on_line() &&
        (at(not_in_call) || (at_assignment_on_new_line() && !stands_below_call(open)));
    return statement && !argument_list_closes(at_);
}

/// A comma. When the next line assigns to something, it stands in the place of the `)`.
bool Parser::accept_argument_comma(std::uint32_t open, bool formal) {
    const TextRange comma = token().range();
    if (!accept(TokenKind::comma))
        return false;
    // A formal argument looks like an assignment, but stands further right than the statement.
    if (!at_assignment_on_new_line() || (formal && stands_right_of_line(open)) ||
        argument_list_closes(at_))
        return true;
    report_missing(DiagnosticId::missing_token, {"`)`"}).replace(comma, {});
    return false;
}

/// At an assignment on the line after the `(`: true when it stands right of the call, as its
/// arguments do. What stands right of `IF f(` may just as well be a statement.
bool Parser::stands_below_call(std::uint32_t open) const noexcept {
    return stands_right_of_line(open) && !is_keyword(tokens_[line_begin(open)].kind());
}

/// True when the token at the cursor, first on its line, stands right of where the line of another
/// one begins.
bool Parser::stands_right_of_line(std::uint32_t index) const noexcept {
    return column(at_) > column(line_begin(index));
}

/// The first token of the line of another one, or one of a very long line.
std::uint32_t Parser::line_begin(std::uint32_t index) const noexcept {
    for (std::uint32_t steps = 0;
         steps < furthest_on_line && index > 0 && !tokens_[index].first_on_line(); ++steps)
        --index;
    return index;
}

/// Between two elements of a list: something that begins another one follows directly, or behind
/// a `;`. In a list of `named` elements that is a name.
bool Parser::accept_missing_comma(bool named) {
    const bool formal = (at(TokenKind::identifier) || at(execution_control)) &&
                        (peek() == TokenKind::assign || peek() == TokenKind::output_arrow);
    const bool operand = at_expression_start() && !token().first_on_line() && !named;
    if (operand || (formal && argument_list_closes(at_))) {
        if (std::exchange(comma_assumed_at_, at_) == at_)
            return false; // the element behind the last one took nothing
        report_missing(DiagnosticId::missing_token, {"`,`"}).insert(previous_end(), ",");
        return true;
    }
    const std::uint32_t behind = next(at_);
    if (!at(TokenKind::semicolon) || tokens_[behind].first_on_line() ||
        !argument_list_closes(behind))
        return false;
    report_unexpected("`,`").replace(token().range(), ",");
    advance();
    return true;
}

/// `f(a; b; c)`: one report for all of them.
bool Parser::accept_semicolon_of_arguments(bool formal, std::optional<Report>& first) {
    if (!at(TokenKind::semicolon) || (!first && !semicolons_separate(formal)))
        return false;
    take_semicolon_for_comma(first);
    return true;
}

/// At a `;` in arguments: true when more of them, and then the `)`, follow in this line.
bool Parser::semicolons_separate(bool formal) const noexcept {
    std::uint32_t depth = 0;
    std::uint32_t i = at_;
    for (std::uint32_t steps = 0; steps < furthest_on_line; i = next(i), ++steps) {
        const TokenKind here = tokens_[i].kind();
        if (tokens_[i].first_on_line() || statement_words.contains(here) || i == count_)
            return false;
        const bool assigns = here == TokenKind::assign || here == TokenKind::output_arrow;
        const std::uint32_t behind = next(i);
        const TokenKind after_name = tokens_[next(behind)].kind();
        const bool named = after_name == TokenKind::assign || after_name == TokenKind::output_arrow;
        if ((depth == 0 && assigns && !formal) ||
            (here == TokenKind::semicolon && (named != formal || !begins_operand_on_line(behind))))
            return false;
        if (here == TokenKind::right_parenthesis && depth-- == 0)
            return true;
        depth += here == TokenKind::left_parenthesis ? 1 : 0;
    }
    return false;
}

/// True when a `)` ends what begins at token `i` before a `;` does; a list too long to be looked
/// through is taken for closed.
bool Parser::argument_list_closes(std::uint32_t i) const noexcept {
    constexpr std::uint32_t furthest = 1000; // bounds the time that a list full of mistakes takes
    std::uint32_t depth = 0;
    // Through unknown tokens as well: there may be any number of them.
    for (const std::uint32_t end = i + furthest; i < end; ++i) {
        switch (tokens_[i].kind()) {
        case TokenKind::left_parenthesis: ++depth; break;
        case TokenKind::right_parenthesis:
            if (depth-- == 0)
                return true;
            break;
        case TokenKind::semicolon:
        case TokenKind::end_of_unit: return false;
        default: break;
        }
    }
    return true;
}

// param_assignment = ( variable_name | "EN" | "ENO" ) ":=" expression
//                  | [ "NOT" ] ( variable_name | "EN" | "ENO" ) "=>" variable ;
const ast::Node* Parser::parse_argument(std::uint32_t open) {
    const TokenKind behind = peek();
    const bool negated = at(TokenKind::kw_not) && (behind == TokenKind::output_arrow ||
                                                   peek_second() == TokenKind::output_arrow);
    if (negated || behind == TokenKind::output_arrow) {
        auto* output = make<ast::OutputArgument>();
        output->negated = negated;
        if (negated)
            advance();
        output->name = parse_argument_name();
        advance();
        output->variable = parse_output_variable();
        return finish(output);
    }
    static constexpr TokenSet slips{TokenKind::equal, TokenKind::equal_equal, TokenKind::minus,
                                    TokenKind::less_equal, TokenKind::greater_equal};
    const bool slip = at(TokenKind::identifier) && slips.contains(behind);
    if (slip && at_output_slip(open)) {
        auto* output = make<ast::OutputArgument>();
        output->name = parse_argument_name();
        accept_mark_slip(mark_slip(at_));
        output->variable = parse_output_variable();
        return finish(output);
    }
    auto* input = make<ast::InputArgument>();
    if (behind == TokenKind::assign) {
        input->name = parse_argument_name();
        advance();
    } else if (at_equal_for_assign(open) || at_colon_for_assign(open)) {
        input->name = parse_argument_name();
        expect_assign();
    }
    input->value = parse_expression();
    if (input->name == nullptr && lacks_assign(*input->value, open)) {
        report_missing(DiagnosticId::missing_token, {"`:=`"}).insert(previous_end(), " :=");
        input->name = make_identifier_of(input->value->first_token);
        input->value = parse_expression();
    }
    return finish(input);
}

/// At a name with delimiters behind it that can stand for a mark: `name = > variable`, and where
/// other arguments are formal also `name >= variable`.
bool Parser::at_output_slip(std::uint32_t open) const noexcept {
    const MarkSlip slip = mark_slip(next(at_));
    return slip.meant == TokenKind::output_arrow &&
           (peek() == TokenKind::equal ||
            (begins_operand(tokens_[slip.end].kind()) && has_formal_argument(open) &&
             operator_strength(tokens_[next(slip.end)].kind()) == 0));
}

/// Two operands in a row, the first of them a name, in the list of formal arguments that begins
/// at `open`.
bool Parser::lacks_assign(const ast::Node& value, std::uint32_t open) const noexcept {
    return value.kind == ast::NodeKind::variable_name && begins_operand_on_line(at_) &&
           has_formal_argument(open);
}

/// `b = 2` or `b == 2` in the list of formal arguments that begins at `open`.
bool Parser::at_equal_for_assign(std::uint32_t open) const noexcept {
    static constexpr TokenSet look_alikes{TokenKind::equal, TokenKind::equal_equal};
    const bool in_invocation = open == invocation_ && peek() == TokenKind::equal_equal;
    return (at(TokenKind::identifier) || at(execution_control)) && look_alikes.contains(peek()) &&
           argument_list_closes(open + 1) && (in_invocation || has_formal_argument(open));
}

/// `b : = 2` or `b : 2` as an argument in the list that begins at `open`.
bool Parser::at_colon_for_assign(std::uint32_t open) const noexcept {
    static constexpr TokenSet separators{TokenKind::left_parenthesis, TokenKind::comma};
    static constexpr TokenSet marks{TokenKind::assign, TokenKind::output_arrow, TokenKind::colon};
    if ((!at(TokenKind::identifier) && !at(execution_control)) || peek() != TokenKind::colon ||
        at_ == 0 || !separators.contains(tokens_[at_ - 1].kind()))
        return false;
    const std::uint32_t colon = next(at_);
    const std::uint32_t behind = next(colon);
    const std::uint32_t operand =
        tokens_[behind].kind() == TokenKind::equal ? next(behind) : behind;
    return begins_operand(tokens_[operand].kind()) && !tokens_[operand].first_on_line() &&
           !marks.contains(tokens_[next(operand)].kind()) && argument_list_closes(open + 1);
}

/// True when `:=` or `=>` stands directly in the list that begins at `open`.
bool Parser::has_formal_argument(std::uint32_t open) const noexcept {
    constexpr std::uint32_t furthest = 1000; // bounds the time that a list full of mistakes takes
    std::uint32_t depth = 1;
    // Through unknown tokens as well: there may be any number of them.
    for (std::uint32_t i = open + 1; depth > 0 && i < count_ && i - open < furthest; ++i) {
        const TokenKind here = tokens_[i].kind();
        depth += here == TokenKind::left_parenthesis ? 1 : 0;
        depth -= here == TokenKind::right_parenthesis ? 1 : 0;
        if (depth == 1 && (here == TokenKind::assign || here == TokenKind::output_arrow))
            return true;
        if (here == TokenKind::semicolon)
            break;
    }
    return false;
}

// Part of param_assignment: ( variable_name | "EN" | "ENO" )
const ast::Identifier* Parser::parse_argument_name() {
    if (at(execution_control))
        return make_identifier();
    return parse_name("the name of a parameter");
}

/// Part of param_assignment: the variable behind `=>`.
const ast::Expression* Parser::parse_output_variable() {
    if (at(TokenKind::direct_variable))
        return parse_direct_variable();
    if (at(TokenKind::identifier) || at_operand_keyword()) {
        const ast::Expression* variable = parse_variable();
        if (!is_variable(*variable))
            report_node(*variable, DiagnosticId::unexpected_token,
                        {"a variable after `=>`", "a call"});
        return variable;
    }
    if (at_expression_start())
        report_unexpected("a variable after `=>`");
    else
        return parse_missing_expression();
    return parse_expression();
}

bool Parser::is_formal(const ast::Node& argument) noexcept {
    const auto* input = ast::as<ast::InputArgument>(&argument);
    return input == nullptr || input->name != nullptr;
}

/// Formal and non-formal arguments are not mixed (2.5.1.1, Table 19 a).
void Parser::check_arguments(Children<ast::Node> arguments) {
    for (const ast::Node* argument : arguments)
        if (is_formal(*argument) != is_formal(*arguments.front())) {
            report_node(*argument, DiagnosticId::mixed_arguments)
                .label(LabelId::first_given, arguments.front()->first_token);
            return;
        }
}

} // namespace iecfront
