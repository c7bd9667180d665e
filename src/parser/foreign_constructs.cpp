#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>
#include <span>

namespace iecfront {
namespace {

constexpr const char* third_edition = "the third edition";
constexpr const char* other_dialects = "other dialects";

/// Words outside every declaration. What stands in a namespace is read.
constexpr std::array<std::string_view, 5> foreign_elements = {"CLASS", "INTERFACE", "NAMESPACE",
                                                              "END_NAMESPACE", "USING"};

/// A part of a program organization unit that the second edition does not have.
struct Member {
    std::string_view word;
    std::string_view closer;
    const char* origin;
};

constexpr std::array members = {
    Member{"METHOD", "END_METHOD", third_edition},
    Member{"PROPERTY", "END_PROPERTY", other_dialects},
};

constexpr std::array<std::string_view, 6> modifiers = {"ABSTRACT", "FINAL",    "PUBLIC",
                                                       "PRIVATE",  "INTERNAL", "PROTECTED"};

/// Clauses behind the name of a program organization unit.
constexpr std::array<std::string_view, 3> foreign_clauses = {"EXTENDS", "IMPLEMENTS", "USING"};

[[nodiscard]] const Member* find_member(std::string_view word) noexcept {
    const auto* const found =
        std::find_if(members.begin(), members.end(),
                     [word](const Member& row) { return names_equal(row.word, word); });
    return found == members.end() ? nullptr : found;
}

[[nodiscard]] bool is_one_of(std::span<const std::string_view> words,
                             std::string_view word) noexcept {
    return std::any_of(words.begin(), words.end(),
                       [word](std::string_view one) { return names_equal(one, word); });
}

} // namespace

/// Outside every declaration, at a word like CLASS or NAMESPACE: reports it.
bool Parser::report_foreign_element() {
    if (!at(TokenKind::identifier))
        return false;
    const Member* member = find_member(text(at_));
    if (member == nullptr && !is_one_of(foreign_elements, text(at_)))
        return false;
    report_at(at_, DiagnosticId::foreign_construct,
              {quoted(at_), member != nullptr ? member->origin : third_edition});
    return true;
}

/// Behind a foreign element, at the next one: what stands in a class or interface belongs to that.
bool Parser::at_next_foreign_element() const noexcept {
    static constexpr std::array<std::string_view, 3> closers = {"END_CLASS", "END_INTERFACE",
                                                                "END_NAMESPACE"};
    static constexpr std::array<std::string_view, 2> of_namespaces = {"NAMESPACE", "END_NAMESPACE"};
    return token().first_on_line() &&
           (is_one_of(closers, text(at_ - 1)) || is_one_of(of_namespaces, text(at_)));
}

/// At METHOD or PROPERTY with a name, first on its line.
bool Parser::at_foreign_member() const noexcept {
    return at(TokenKind::identifier) && token().first_on_line() &&
           peek() == TokenKind::identifier && !tokens_[next(at_)].first_on_line() &&
           find_member(text(at_)) != nullptr;
}

/// Reports it, and passes over it up to its closing word; when there is none, over its line.
void Parser::skip_foreign_member() {
    const Member& member = *find_member(text(at_));
    report(DiagnosticId::foreign_construct, token().range(), {quoted(at_), member.origin});
    std::uint32_t end = at_;
    while (!members_unclosed_ && end != count_ && !names_equal(text(end), member.closer))
        end = next(end);
    members_unclosed_ = members_unclosed_ || end == count_; // looked for once, not for each
    if (members_unclosed_) {
        do
            advance();
        while (!token().first_on_line() && !at_end());
        return;
    }
    advance_past(end);
    accept(TokenKind::semicolon);
}

/// `ABSTRACT`, `FINAL`, `PUBLIC` and their like before the name of a program organization unit.
void Parser::accept_foreign_modifiers() {
    while (at(TokenKind::identifier) && peek() == TokenKind::identifier &&
           !tokens_[next(at_)].first_on_line() && is_one_of(modifiers, text(at_))) {
        report_at(at_, DiagnosticId::foreign_construct, {quoted(at_), third_edition});
        advance();
    }
}

/// `EXTENDS base`, `IMPLEMENTS interface` or `USING namespace` behind the name of a program
/// organization unit, also on the next line.
bool Parser::at_foreign_clause() const noexcept {
    const std::uint32_t name = next(at_);
    return at(TokenKind::identifier) && is_one_of(foreign_clauses, text(at_)) &&
           (!token().first_on_line() ||
            (tokens_[name].kind() == TokenKind::identifier && !tokens_[name].first_on_line() &&
             tokens_[next(name)].kind() != TokenKind::assign));
}

/// One report for all foreign_clauses of the head: passes over them.
void Parser::skip_foreign_clauses() {
    report_at(at_, DiagnosticId::foreign_construct, {quoted(at_), third_edition});
    static constexpr TokenSet in_clause{TokenKind::identifier, TokenKind::dot, TokenKind::comma};
    while (at_foreign_clause()) {
        do
            advance();
        while (at(in_clause) &&
               (!token().first_on_line() || tokens_[at_ - 1].kind() == TokenKind::comma));
        while (!unit_ends.contains(peek()) && accept(TokenKind::semicolon)) {
        }
    }
}

/// `r REF= x`
bool Parser::at_reference_assignment() const noexcept {
    return at_word("REF") && peek() == TokenKind::equal && adjoins_next();
}

/// In place of assignment_statement: `r REF= x`, which makes `r` refer to `x`.
const ast::Statement* Parser::parse_reference_assignment(const ast::Expression* reference) {
    auto* error = make_from<ast::ErrorStatement>(reference);
    report(DiagnosticId::foreign_construct, token_range(at_, next(at_) + 1),
           {"`REF=`", other_dialects});
    advance();
    advance();
    parse_expression();
    return finish(error);
}

/// In place of derived_type_name: `Motion.Axis`, a name in a namespace.
const ast::TypeSpecification* Parser::parse_qualified_type_name() {
    auto* error = make<ast::ErrorType>();
    do
        advance();
    while (accept(TokenKind::dot) && at(TokenKind::identifier));
    finish(error);
    const TextRange name = token_range(error->first_token, error->end_token);
    report(DiagnosticId::foreign_construct, name,
           {"`" + std::string(text_.substr(name.begin, name.size())) + "`, a name in a namespace,",
            third_edition});
    return error;
}

/// `STRUCT OVERLAP`
void Parser::accept_foreign_overlap() {
    if (!at_word("OVERLAP") || token().first_on_line() || peek() != TokenKind::identifier)
        return;
    report_at(at_, DiagnosticId::foreign_construct, {quoted(at_), third_edition});
    advance();
}

} // namespace iecfront
