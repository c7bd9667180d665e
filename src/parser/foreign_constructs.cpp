#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>

namespace iecfront {
namespace {

constexpr const char* third_edition = "the third edition";
constexpr const char* other_dialects = "other dialects";

/// What the second edition does not have, by its first word.
struct ForeignConstruct {
    std::string_view word;
    std::string_view closer; ///< empty when it ends with its line
    const char* origin;
};

constexpr std::array elements = {
    ForeignConstruct{"CLASS", "END_CLASS", third_edition},
    ForeignConstruct{"INTERFACE", "END_INTERFACE", third_edition},
    ForeignConstruct{"NAMESPACE", {}, third_edition}, // what stands in it is read
    ForeignConstruct{"END_NAMESPACE", {}, third_edition},
    ForeignConstruct{"USING", {}, third_edition},
};

constexpr std::array members = {
    ForeignConstruct{"METHOD", "END_METHOD", third_edition},
    ForeignConstruct{"PROPERTY", "END_PROPERTY", other_dialects},
};

constexpr std::array<std::string_view, 6> modifiers = {"ABSTRACT", "FINAL",    "PUBLIC",
                                                       "PRIVATE",  "INTERNAL", "PROTECTED"};

constexpr std::array<std::string_view, 2> heritage = {"EXTENDS", "IMPLEMENTS"};

template<class Rows>
[[nodiscard]] const ForeignConstruct* find(const Rows& rows, std::string_view word) noexcept {
    const auto found = std::find_if(rows.begin(), rows.end(), [word](const ForeignConstruct& row) {
        return names_equal(row.word, word);
    });
    return found == rows.end() ? nullptr : &*found;
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
    const ForeignConstruct* construct = find(elements, text(at_));
    if (construct == nullptr)
        construct = find(members, text(at_));
    if (construct == nullptr)
        return false;
    report_at(at_, DiagnosticId::foreign_construct, {quoted(at_), construct->origin});
    return true;
}

/// At METHOD or PROPERTY with a name, first on its line.
bool Parser::at_foreign_member() const noexcept {
    return at(TokenKind::identifier) && token().first_on_line() &&
           peek() == TokenKind::identifier && !tokens_[next(at_)].first_on_line() &&
           find(members, text(at_)) != nullptr;
}

/// Reports it, and passes over it up to its closing word; when there is none, over its line.
void Parser::skip_foreign_member() {
    const ForeignConstruct& construct = *find(members, text(at_));
    report(DiagnosticId::foreign_construct, token().range(), {quoted(at_), construct.origin});
    std::uint32_t end = at_;
    while (!members_unclosed_ && end != count_ && !names_equal(text(end), construct.closer))
        end = next(end);
    members_unclosed_ = members_unclosed_ || end == count_; // looked for once, not for each
    if (members_unclosed_) {
        do
            advance();
        while (!token().first_on_line() && !at_end());
        return;
    }
    while (at_ <= end)
        advance();
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

/// At `EXTENDS base` or `IMPLEMENTS interface` behind the name of a program organization unit:
/// reports it.
bool Parser::report_foreign_heritage() {
    if (!at(TokenKind::identifier) || token().first_on_line() || !is_one_of(heritage, text(at_)))
        return false;
    report_at(at_, DiagnosticId::foreign_construct, {quoted(at_), third_edition});
    return true;
}

} // namespace iecfront
