#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace iecfront {
namespace {

// Operators of IL that are operators of ST as well, and can begin a line there, too.
constexpr TokenSet common_operators{TokenKind::kw_and, TokenKind::kw_or,  TokenKind::kw_xor,
                                    TokenKind::kw_mod, TokenKind::kw_not, TokenKind::ampersand};

// il_simple_operator, il_expr_operator, il_call_operator, il_return_operator, il_jump_operator, but
// for those that are keywords (B.2.2).
constexpr std::array<std::string_view, 36> il_operators{
    "LD", "LDN", "ST",   "STN", "S",    "R",     "S1",  "R1",   "CLK",   "CU",  "CD",   "PV",
    "IN", "PT",  "ANDN", "ORN", "XORN", "ADD",   "SUB", "MUL",  "DIV",   "GT",  "GE",   "EQ",
    "LT", "LE",  "NE",   "CAL", "CALC", "CALCN", "RET", "RETC", "RETCN", "JMP", "JMPC", "JMPCN"};

bool is_il_operator(std::string_view word) noexcept {
    return std::any_of(il_operators.begin(), il_operators.end(),
                       [word](std::string_view op) { return names_equal(word, op); });
}

} // namespace

/// A name or a literal.
bool Parser::begins_operand(TokenKind kind) noexcept {
    static constexpr TokenSet words{TokenKind::identifier,      TokenKind::enumerated_value,
                                    TokenKind::direct_variable, TokenKind::kw_true,
                                    TokenKind::kw_false,        TokenKind::kw_en,
                                    TokenKind::kw_eno};
    return words.contains(kind) ||
           TokenSet::range(TokenKind::integer, TokenKind::date_and_time).contains(kind);
}

/// True when a step, transition or action begins at token `index`.
bool Parser::begins_chart_element(std::uint32_t index) const noexcept {
    if (!chart_openers.contains(tokens_[index].kind()))
        return false;
    const std::uint32_t second = next(index);
    const std::uint32_t third = next(second);
    const TokenKind name = tokens_[second].kind();
    const TokenKind after = tokens_[third].kind();
    if (name == TokenKind::identifier)
        return after != TokenKind::assign;
    if (tokens_[index].kind() == TokenKind::kw_initial_step && name == TokenKind::colon)
        return true; // the name is missing
    if (tokens_[index].kind() == TokenKind::kw_transition)
        return name == TokenKind::kw_from ||
               (name == TokenKind::left_parenthesis && names_equal(text(third), "PRIORITY"));
    return is_keyword(name) && after == TokenKind::colon;
}

/// True when the line ends in the parentheses behind the operator: `ADD( a`.
bool Parser::begins_deferred_operation(std::uint32_t index) const noexcept {
    const std::uint32_t open = next(index);
    if (tokens_[open].kind() != TokenKind::left_parenthesis || tokens_[open].first_on_line())
        return false;
    const std::uint32_t operand = next(open);
    return !tokens_[operand].first_on_line() && begins_operand(tokens_[operand].kind()) &&
           tokens_[next(operand)].first_on_line();
}

/// How the line that begins at token `index` reads. What tells an instruction are two operands in a
/// row, which ST never has. `application` is what a `;` makes a statement: a name and an operand, a
/// deferred operation, and an operator of both languages that begins the body. What may as well
/// continue an expression counts behind another instruction only.
Parser::LineKind Parser::line_kind(std::uint32_t index, LineKind before) const noexcept {
    const bool labelled = tokens_[index].kind() == TokenKind::identifier &&
                          tokens_[next(index)].kind() == TokenKind::colon;
    if (labelled)
        index = next(next(index));
    if (labelled && tokens_[index].first_on_line())
        return before;
    const std::uint32_t second = next(index);
    const bool alone =
        tokens_[second].first_on_line() || tokens_[second].kind() == TokenKind::semicolon;
    const bool operand = !alone && begins_operand(tokens_[second].kind());
    const bool sign = tokens_[second].kind() == TokenKind::minus && !alone;
    const bool common = common_operators.contains(tokens_[index].kind());
    if (!common && tokens_[index].kind() != TokenKind::identifier)
        return LineKind::other;
    const bool il_operator = !common && is_il_operator(text(index));
    if (common && index == at_)
        return LineKind::application;
    if (common || (il_operator && (alone || sign)))
        return before == LineKind::other ? LineKind::other : LineKind::operation;
    if (il_operator && operand)
        return LineKind::operation;
    const bool deferred = il_operator && begins_deferred_operation(index);
    return operand || deferred ? LineKind::application : LineKind::other;
}

/// True for the second half of `&N`, which is two tokens.
bool Parser::ends_operator(std::uint32_t index) const noexcept {
    return index > at_ && tokens_[index - 1].kind() == TokenKind::ampersand &&
           tokens_[index - 1].end() == tokens_[index].offset() && names_equal(text(index), "N");
}

/// The language of the body that begins here (6.2 A28). Each line that reads as an instruction
/// speaks for IL, each `;`, `:=` and statement for ST, and the majority decides, so that one
/// mistake never turns a whole body into another language.
BodyLanguage Parser::body_language() const noexcept {
    // More than a stretch of the other language has that somebody left at the begin of a body. To
    // count all of each body takes a twentieth of the time of parsing.
    constexpr std::int32_t decisive_lead = 50;
    if (begins_chart_element(at_))
        return BodyLanguage::sequential_function_chart;
    std::int32_t instructions = 0;
    std::int32_t statements = 0;
    std::int32_t chart_words = misspelt_chart_word() == TokenKind::end_of_unit ? 0 : 1;
    std::uint32_t depth = 0; // of parentheses
    LineKind line = LineKind::operation;
    bool behind_instruction = false;
    bool closing_words = false;
    for (std::uint32_t i = at_; !unit_ends.contains(tokens_[i].kind()); i = next(i)) {
        const TokenKind here = tokens_[i].kind();
        if (here == open_.back().closer || std::abs(instructions - statements) >= decisive_lead)
            break;
        if ((i == at_ || tokens_[i].first_on_line()) && here != TokenKind::right_parenthesis) {
            behind_instruction = i != at_ && line == LineKind::operation;
            line = line_kind(i, line);
            instructions += line == LineKind::other ? 0 : 1;
        }
        if (chart_closers.contains(here) || begins_chart_element(i)) {
            if (open_.back().closer == TokenKind::kw_end_action)
                break; // the action is not closed
            if (++chart_words == 2)
                return BodyLanguage::sequential_function_chart;
        }
        closing_words = closing_words || statement_closers.contains(here);
        const bool call = line == LineKind::other && !behind_instruction && depth == 0 && i > at_ &&
                          tokens_[i - 1].kind() == TokenKind::identifier &&
                          !is_il_operator(text(i - 1)) && !ends_operator(i - 1);
        switch (here) {
        case TokenKind::left_parenthesis:
            // Behind the parenthesis of an IL call the line ends.
            statements += call && !tokens_[next(i)].first_on_line() ? 1 : 0;
            ++depth;
            break;
        case TokenKind::right_parenthesis: depth -= depth > 0 ? 1 : 0; break;
        case TokenKind::assign:
        case TokenKind::equal: statements += line == LineKind::other && depth == 0 ? 1 : 0; break;
        case TokenKind::semicolon:
            depth = 0;
            statements += line == LineKind::operation ? 0 : 1;
            instructions -= line == LineKind::application ? 1 : 0;
            line = line == LineKind::application ? LineKind::other : line;
            break;
        default: statements += statement_words.contains(here) ? 1 : 0;
        }
    }
    if (chart_words > statements + instructions)
        return BodyLanguage::sequential_function_chart;
    if (instructions == 0 && statements == 0 && !closing_words)
        return BodyLanguage::instruction_list;
    return instructions > statements ? BodyLanguage::instruction_list
                                     : BodyLanguage::structured_text;
}

} // namespace iecfront
