#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

namespace iecfront {
namespace {

constexpr TokenSet numbers{TokenKind::integer, TokenKind::real};

// The kind of a typed literal is that of the type before its `#`.
ast::NodeKind typed_literal_kind(std::string_view text) noexcept {
    const std::string_view type = text.substr(0, text.find('#'));
    for (const std::string_view name : {"BYTE", "WORD", "DWORD", "LWORD"})
        if (names_equal(type, name))
            return ast::NodeKind::bit_string_literal;
    if (names_equal(type, "REAL") || names_equal(type, "LREAL"))
        return ast::NodeKind::real_literal;
    return names_equal(type, "BOOL") ? ast::NodeKind::boolean_literal
                                     : ast::NodeKind::integer_literal;
}

} // namespace

/// True at `+` or `-` with a decimal number directly behind it: the sign is part of the constant.
bool Parser::at_signed_number() const noexcept {
    return (at(TokenKind::minus) || at(TokenKind::plus)) && numbers.contains(peek()) &&
           adjoins_next();
}

// constant = numeric_literal | character_string | time_literal | bit_string_literal
//          | boolean_literal ;
const ast::Expression* Parser::parse_constant() {
    const std::uint32_t first = at_;
    if (at(TokenKind::minus) || at(TokenKind::plus))
        advance();
    return parse_literal(first);
}

/// Part of constant: the literal behind its sign, which is the token `first` or not there.
const ast::Expression* Parser::parse_literal(std::uint32_t first) {
    if (at(TokenKind::integer)) // as nearly all are
        return take_literal<ast::IntegerLiteral>(first);
    switch (kind()) {
    case TokenKind::real: return take_literal<ast::RealLiteral>(first);
    case TokenKind::single_byte_string:
    case TokenKind::double_byte_string: return take_literal<ast::CharacterString>(first);
    case TokenKind::duration: return take_literal<ast::Duration>(first);
    case TokenKind::time_of_day: return take_literal<ast::TimeOfDay>(first);
    case TokenKind::date: return take_literal<ast::Date>(first);
    case TokenKind::date_and_time: return take_literal<ast::DateAndTime>(first);
    case TokenKind::kw_true:
    case TokenKind::kw_false: return take_literal<ast::BooleanLiteral>(first);
    case TokenKind::typed_literal: return parse_typed_literal(first);
    default: return take_literal<ast::IntegerLiteral>(first);
    }
}

/// Part of constant: the same of a literal with a type.
const ast::Expression* Parser::parse_typed_literal(std::uint32_t first) {
    switch (typed_literal_kind(text(at_))) {
    case ast::NodeKind::real_literal: return take_literal<ast::RealLiteral>(first);
    case ast::NodeKind::bit_string_literal: return take_literal<ast::BitStringLiteral>(first);
    case ast::NodeKind::boolean_literal: return take_literal<ast::BooleanLiteral>(first);
    default: return take_literal<ast::IntegerLiteral>(first);
    }
}

/// signed_integer = [ "+" | "-" ] integer ;
bool Parser::is_signed_integer(const ast::Expression& expression) const noexcept {
    const auto* literal = ast::as<ast::IntegerLiteral>(&expression);
    return literal != nullptr && tokens_[literal->literal_token].kind() == TokenKind::integer;
}

/// True at `- 5` and at nothing longer, so that no expression can be meant.
bool Parser::at_sign_apart_from_number() const noexcept {
    static constexpr TokenSet after{TokenKind::dot_dot,       TokenKind::comma,
                                    TokenKind::semicolon,     TokenKind::right_parenthesis,
                                    TokenKind::right_bracket, TokenKind::end_of_unit};
    return (at(TokenKind::minus) || at(TokenKind::plus)) && numbers.contains(peek()) &&
           !adjoins_next() && after.contains(peek_second());
}

/// In place of constant: white space stands between sign and number.
const ast::Expression* Parser::parse_constant_behind_gap() {
    const TextRange gap{token().end(), tokens_[next(at_)].offset()};
    report(DiagnosticId::sign_apart_from_number, gap).remove(gap);
    return parse_constant();
}

/// True when an expression holds a fault that is reported: what else it is does not matter then.
bool Parser::is_faulty(const ast::Expression& expression, std::size_t reports) const noexcept {
    bool malformed = false;
    for (std::uint32_t i = expression.first_token; i < expression.end_token; ++i)
        malformed = malformed || tokens_[i].malformed();
    return malformed || diagnostics_.size() != reports;
}

/// Part of subrange, subrange_spec_init: where the standard has a `signed_integer` only. Other
/// numbers and expressions are an extension.
const ast::Expression* Parser::parse_constant_expression(std::string_view what) {
    if (at_sign_apart_from_number() && peek() == TokenKind::integer)
        return parse_constant_behind_gap();
    const std::uint32_t first = at_;
    const std::size_t reports = diagnostics_.size();
    const ast::Expression* expression = parse_expression();
    if (expression->missing || is_signed_integer(*expression) ||
        expression->kind == ast::NodeKind::error_expression || is_faulty(*expression, reports))
        return expression;
    const bool other_constant = ast::is<ast::Constant>(expression->kind) &&
                                expression->kind != ast::NodeKind::integer_literal &&
                                expression->kind != ast::NodeKind::bit_string_literal;
    if (other_constant)
        report_node(*expression, DiagnosticId::unexpected_token, {"an integer", quoted(first)});
    else
        report_not_plain(*expression, what);
    return expression;
}

/// A constant in a notation, or an expression, that the standard does not have in this place.
void Parser::report_not_plain(const ast::Expression& expression, std::string_view what) {
    const TokenKind first = tokens_[expression.first_token].kind();
    const bool constant = ast::is<ast::Constant>(expression.kind);
    const char* found = !constant                           ? "an expression"
                        : first == TokenKind::based_integer ? "a number with a base"
                        : first == TokenKind::typed_literal ? "a number with a type"
                                                            : "a number with a sign";
    report_node(expression, DiagnosticId::constant_expression, {what, found});
}

// integer = digit { [ "_" ] digit } ;
/// Other numbers and expressions are an extension.
const ast::Expression* Parser::parse_integer(std::string_view what) {
    const bool sign = at(TokenKind::minus) || at(TokenKind::plus);
    const ast::Expression* expression = parse_constant_expression(what);
    if (sign && is_signed_integer(*expression))
        report_not_plain(*expression, what);
    return expression;
}

} // namespace iecfront
