#include "builder/assembly.hpp"

#include "lexer/lexer.hpp"

#include <algorithm>

namespace iecfront::build {
namespace {

constexpr std::string_view indent = "    ";

// The only token of `text`; nothing when there are others, or something is wrong with it.
[[nodiscard]] std::optional<TokenKind> single_token(std::string_view text) {
    const std::string terminated(text);
    const LexedText lexed = lex(terminated, Encoding::utf8);
    if (lexed.tokens.size() != 2 || !lexed.diagnostics.empty() || !lexed.trivia.empty() ||
        lexed.tokens[0].length() != text.size())
        return std::nullopt;
    return lexed.tokens[0].kind();
}

[[nodiscard]] bool is_name(std::string_view text, NameKind names) {
    const std::optional<TokenKind> kind = single_token(text);
    if (!kind)
        return false;
    switch (*kind) {
    case TokenKind::identifier: return true;
    case TokenKind::kw_en:
    case TokenKind::kw_eno: return names == NameKind::variable;
    case TokenKind::kw_and:
    case TokenKind::kw_or:
    case TokenKind::kw_xor:
    case TokenKind::kw_not:
    case TokenKind::kw_mod: return names == NameKind::function;
    default: return false;
    }
}

[[nodiscard]] bool begins_with_number(std::string_view text) noexcept {
    return !text.empty() &&
           (text[0] == '-' || text[0] == '+' || (text[0] >= '0' && text[0] <= '9'));
}

} // namespace

std::uint8_t strength_of(ast::BinaryOperator op) noexcept {
    switch (op) {
    case ast::BinaryOperator::logical_or: return 0;
    case ast::BinaryOperator::exclusive_or: return 1;
    case ast::BinaryOperator::logical_and: return 2;
    case ast::BinaryOperator::equal:
    case ast::BinaryOperator::not_equal: return 3;
    case ast::BinaryOperator::less:
    case ast::BinaryOperator::greater:
    case ast::BinaryOperator::less_equal:
    case ast::BinaryOperator::greater_equal: return 4;
    case ast::BinaryOperator::add:
    case ast::BinaryOperator::subtract: return 5;
    case ast::BinaryOperator::multiply:
    case ast::BinaryOperator::divide:
    case ast::BinaryOperator::modulo: return 6;
    case ast::BinaryOperator::power: break;
    }
    return 7;
}

std::string quoted(std::string_view text) {
    return '`' + std::string(text) + '`';
}

bool has_semicolon(ast::NodeKind kind) noexcept {
    switch (kind) {
    case ast::NodeKind::type_declaration:
    case ast::NodeKind::structure_element_declaration:
    case ast::NodeKind::variable_declaration:
    case ast::NodeKind::access_declaration:
    case ast::NodeKind::instance_specific_init:
    case ast::NodeKind::action_association:
    case ast::NodeKind::task_configuration:
    case ast::NodeKind::program_configuration: return true;
    default: return ast::is<ast::Statement>(kind);
    }
}

std::string_view keyword_of(ast::BlockQualifier qualifier) noexcept {
    switch (qualifier) {
    case ast::BlockQualifier::none: return "";
    case ast::BlockQualifier::constant: return " CONSTANT";
    case ast::BlockQualifier::retain: return " RETAIN";
    case ast::BlockQualifier::non_retain: break;
    }
    return " NON_RETAIN";
}

std::string moved_in(std::string_view text, std::string_view blanks) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        out += text[i];
        if (text[i] == '\n' && i + 1 < text.size() && text[i + 1] != '\n')
            out += blanks;
    }
    return out;
}

Assembly& Assembly::text(std::string_view text) {
    text_ += text;
    return *this;
}

Assembly& Assembly::name(std::string_view name, NameKind kind) {
    if (!is_name(name, kind))
        require(false, quoted(name) + " is no identifier");
    return text(name);
}

Assembly& Assembly::names(const std::vector<std::string_view>& names, std::string_view separator) {
    require(!names.empty(), "a list of names is empty");
    for (std::size_t i = 0; i < names.size(); ++i)
        text(i > 0 ? separator : std::string_view()).name(names[i], NameKind::variable);
    return *this;
}

Assembly& Assembly::enumerated_value(std::string_view value, std::string_view type) {
    if (type.empty())
        return name(value);
    name(type).text("#").name(value);
    const std::string typed = std::string(type) + "#" + std::string(value);
    if (single_token(typed) != TokenKind::enumerated_value) // `D#a` begins a date
        require(false, quoted(typed) + " is no enumerated value");
    return *this;
}

Assembly& Assembly::literal(std::string_view text) {
    if (!single_token(text))
        require(false, quoted(text) + " is no literal");
    return this->text(text);
}

Assembly& Assembly::part(const AnyPart& part) {
    return require(part.fault().empty(), part.fault()).text(part.text());
}

Assembly& Assembly::operand(const AnyPart& part, std::uint8_t least) {
    const bool holds = part.strength_ >= least;
    return text(holds ? "" : "(").part(part).text(holds ? "" : ")");
}

Assembly& Assembly::operand(const AnyPart& part, ast::UnaryOperator op) {
    const bool adjoins = op == ast::UnaryOperator::minus && begins_with_number(part.text());
    return text(adjoins ? " " : "").operand(part, strength::primary);
}

Assembly& Assembly::variable(const AnyPart& part) {
    return this->part(part).require(part.strength_ == strength::primary,
                                    quoted(part.text()) + " is no variable");
}

Assembly& Assembly::indented(const AnyPart& part, std::string_view behind) {
    require(part.fault().empty(), part.fault());
    const std::string text = '\n' + part.text();
    return this->text(moved_in(text, indent)).text(behind);
}

Assembly& Assembly::require(bool right, std::string_view fault) {
    if (!right && fault_.empty())
        fault_ = fault;
    return *this;
}

} // namespace iecfront::build
