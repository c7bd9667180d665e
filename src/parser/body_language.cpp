#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>

namespace iecfront {
namespace {

constexpr TokenSet chart_words{TokenKind::kw_initial_step, TokenKind::kw_step,
                               TokenKind::kw_transition, TokenKind::kw_action};

constexpr TokenSet statement_words{TokenKind::kw_if,    TokenKind::kw_case,   TokenKind::kw_for,
                                   TokenKind::kw_while, TokenKind::kw_repeat, TokenKind::kw_return,
                                   TokenKind::kw_exit};

constexpr TokenSet ends{TokenKind::kw_end_function,      TokenKind::kw_end_function_block,
                        TokenKind::kw_end_program,       TokenKind::kw_end_type,
                        TokenKind::kw_end_configuration, TokenKind::end_of_unit};

// il_simple_operator, il_expr_operator, il_call_operator, il_return_operator, il_jump_operator, but
// for those that are keywords (B.2.2).
constexpr std::array<std::string_view, 40> il_operators{
    "LD", "LDN", "ST",   "STN", "S",    "R",     "S1",  "R1",   "CLK",   "CU",  "CD",   "PV",
    "IN", "PT",  "ANDN", "ORN", "XORN", "ADD",   "SUB", "MUL",  "DIV",   "GT",  "GE",   "EQ",
    "LT", "LE",  "NE",   "CAL", "CALC", "CALCN", "RET", "RETC", "RETCN", "JMP", "JMPC", "JMPCN"};

bool is_il_operator(std::string_view word) noexcept {
    return std::any_of(il_operators.begin(), il_operators.end(), [word](std::string_view op) {
        return !op.empty() && names_equal(word, op);
    });
}

// What stands behind the first name of an ST statement, never behind an IL operator.
constexpr TokenSet after_variable{TokenKind::assign,       TokenKind::equal, TokenKind::dot,
                                  TokenKind::left_bracket, TokenKind::comma, TokenKind::semicolon};

} // namespace

/// True when the line that begins at token `index` reads as an IL instruction.
bool Parser::begins_instruction(std::uint32_t index) const noexcept {
    if (tokens_[index].kind() == TokenKind::identifier &&
        tokens_[next(index)].kind() == TokenKind::colon) { // label
        index = next(next(index));
        if (tokens_[index].first_on_line())
            return true;
    }
    static constexpr TokenSet operators{TokenKind::kw_and, TokenKind::kw_or,  TokenKind::kw_xor,
                                        TokenKind::kw_mod, TokenKind::kw_not, TokenKind::ampersand};
    if (operators.contains(tokens_[index].kind()))
        return true;
    return tokens_[index].kind() == TokenKind::identifier && is_il_operator(text(index)) &&
           !after_variable.contains(tokens_[next(index)].kind());
}

/// The language of the body that begins here (6.2 A28). Lines speak for IL, each `;` for ST, and
/// the majority decides, so that one mistake never turns a whole body into another language.
ast::BodyLanguage Parser::body_language() const noexcept {
    const TokenKind after = peek();
    if (at(chart_words) &&
        (after == TokenKind::identifier || after == TokenKind::kw_from ||
         after == TokenKind::left_parenthesis) &&
        peek_second() != TokenKind::assign)
        return ast::BodyLanguage::sequential_function_chart;
    if (at(statement_words) || after_variable.contains(after))
        return ast::BodyLanguage::structured_text;
    std::uint32_t instructions = 0;
    std::uint32_t statements = 0;
    bool operator_line = false; // the line of an instruction can hold a stray `;`
    for (std::uint32_t i = at_; !ends.contains(tokens_[i].kind()); i = next(i)) {
        if (i == at_ || tokens_[i].first_on_line()) {
            operator_line = begins_instruction(i);
            instructions += operator_line ? 1 : 0;
        }
        const bool assigns = tokens_[i].kind() == TokenKind::assign;
        statements += (tokens_[i].kind() == TokenKind::semicolon && !operator_line) ||
                              (statement_words.contains(tokens_[i].kind()))
                          ? 1
                          : 0;
        operator_line = operator_line && !assigns;
    }
    return instructions > statements ? ast::BodyLanguage::instruction_list
                                     : ast::BodyLanguage::structured_text;
}

} // namespace iecfront
