#include "lexer/lexer.hpp"
#include "lexer/lookahead.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace iecfront {

// True when `token` can be the end of an operand, so that a point at `next` selects a part of it.
bool Lexer::ends_operand(Token token, const char* next) const {
    const TokenKind kind = token.kind();
    if (is_keyword(kind)) // meant as a name when the point adjoins: `step.5`
        return token.end() == offset(next);
    return kind == TokenKind::right_parenthesis || kind == TokenKind::right_bracket ||
           kind == TokenKind::caret || kind >= TokenKind::identifier;
}

const char* Lexer::dot(const char* begin) {
    if (begin[1] == '.')
        return delimiter(TokenKind::dot_dot, begin, 2);
    if (const char* const second = Extents::blanks_end(begin + 1); is_lone_dot(second)) {
        report_gap(range(begin + 1, second), "..");
        emit(TokenKind::dot_dot, begin, second + 1, true);
        return second + 1;
    }
    const bool third = has_tokens() && last_token().kind() == TokenKind::dot_dot &&
                       last_token().end() == offset(begin); // `1...5`
    if (!is_digit(begin[1]) || third)
        return delimiter(TokenKind::dot, begin, 1);
    if (!has_tokens() || !ends_operand(last_token(), begin))
        return literal(TokenKind::real, begin, extents_.real_end(begin));

    const Token before = last_token();
    const char* const before_end = begin_ + before.end();
    const bool spaced = before_end != begin && Extents::gap_end(before_end) == begin;
    if (before.kind() != TokenKind::integer || before.malformed() || !spaced)
        return delimiter(TokenKind::dot, begin, 1);
    take_back(); // `1 .5`
    return spaced_literal(TokenKind::real, begin_ + before.offset(), extents_.real_end(begin),
                          gaps_of({range(before_end, begin)}));
}

// `p^`, and `a ^ b` for a power. Else it has no meaning.
const char* Lexer::caret(const char* begin) {
    if (!has_tokens())
        return unexpected(begin);
    const TokenKind before = last_token().kind();
    const bool member = before == TokenKind::kw_en || before == TokenKind::kw_eno; // `t.ENO^`
    const bool operand =
        !is_keyword(before) && before != TokenKind::unknown && ends_operand(last_token(), begin);
    return member || operand ? delimiter(TokenKind::caret, begin, 1) : unexpected(begin);
}
const char* Lexer::non_ascii(const char* begin) {
    const char* const end = extents_.word_end(begin);
    const bool only_broken_bytes = std::all_of(
        begin, end, [this](const char& c) { return !is_ascii(c) && !extents_.decode(&c).valid; });
    return only_broken_bytes ? unexpected(begin) : odd_word(begin);
}

// A string in the quotes of a word processor. Null when none begins here.
const char* Lexer::typographic_string(const char* begin, const DecodedCharacter& opening) {
    struct Quotes {
        char32_t opening;
        char32_t closing;
        const char* meant;
    };
    static constexpr std::array all = {Quotes{0x2018, 0x2019, "'"}, Quotes{0x2019, 0x2019, "'"},
                                       Quotes{0x201C, 0x201D, "\""}, Quotes{0x201D, 0x201D, "\""}};
    const auto* const quotes = std::ranges::find(all, opening.code_point, &Quotes::opening);
    if (!opening.valid || quotes == all.end())
        return nullptr;
    for (const char* p = begin + opening.size;
         class_of(*p) != CharacterClass::line_end && p < end_;) {
        const DecodedCharacter here = extents_.decode(p);
        const char* const end = p + here.size;
        if (here.code_point == quotes->closing) {
            Diagnostic& diagnostic =
                report(DiagnosticId::typographic_quotes, range(begin, begin + opening.size));
            diagnostic.arguments.emplace_back(opening.code_point);
            add_replacement(diagnostic, range(begin, begin + opening.size), quotes->meant);
            diagnostic.fixes.front().edits.push_back({range(p, end), quotes->meant});
            emit_any(*quotes->meant == '"' ? TokenKind::double_byte_string
                                           : TokenKind::single_byte_string,
                     begin, end, true);
            return end;
        }
        p = end;
    }
    return nullptr;
}

namespace {

// Characters that a word processor, a web page or an East Asian input method puts in the place of
// others.
struct LookAlike {
    char32_t character;
    TokenKind kind;
    std::string_view meant;
};
constexpr std::array look_alikes = {
    LookAlike{0x00A0, TokenKind::unknown, " "},
    LookAlike{0x202F, TokenKind::unknown, " "},
    LookAlike{0x00D7, TokenKind::star, "*"},
    LookAlike{0x00F7, TokenKind::slash, "/"},
    LookAlike{0x2010, TokenKind::minus, "-"},
    LookAlike{0x2011, TokenKind::minus, "-"},
    LookAlike{0x2013, TokenKind::minus, "-"},
    LookAlike{0x2212, TokenKind::minus, "-"},
    LookAlike{0x2026, TokenKind::dot_dot, ".."},
    LookAlike{0x2260, TokenKind::not_equal, "<>"},
    LookAlike{0x2264, TokenKind::less_equal, "<="},
    LookAlike{0x2265, TokenKind::greater_equal, ">="},
    LookAlike{0x3000, TokenKind::unknown, " "},
    LookAlike{0xFF08, TokenKind::left_parenthesis, "("},
    LookAlike{0xFF09, TokenKind::right_parenthesis, ")"},
    LookAlike{0xFF0A, TokenKind::star, "*"},
    LookAlike{0xFF0B, TokenKind::plus, "+"},
    LookAlike{0xFF0C, TokenKind::comma, ","},
    LookAlike{0xFF0D, TokenKind::minus, "-"},
    LookAlike{0xFF0E, TokenKind::dot, "."},
    LookAlike{0xFF0F, TokenKind::slash, "/"},
    LookAlike{0xFF1A, TokenKind::colon, ":"},
    LookAlike{0xFF1B, TokenKind::semicolon, ";"},
    LookAlike{0xFF1C, TokenKind::less, "<"},
    LookAlike{0xFF1D, TokenKind::equal, "="},
    LookAlike{0xFF1E, TokenKind::greater, ">"},
    LookAlike{0xFF3B, TokenKind::left_bracket, "["},
    LookAlike{0xFF3D, TokenKind::right_bracket, "]"},
};

} // namespace

// Null when the character is taken for no other.
const char* Lexer::look_alike(const char* begin, const DecodedCharacter& character) {
    const auto* const found =
        std::ranges::find(look_alikes, character.code_point, &LookAlike::character);
    if (!character.valid || found == look_alikes.end())
        return nullptr;
    const char* const end = begin + character.size;
    Diagnostic& diagnostic = report(DiagnosticId::unexpected_character, range(begin, end));
    diagnostic.arguments.emplace_back(character.code_point);
    add_replacement(diagnostic, range(begin, end), std::string(found->meant));
    if (found->kind != TokenKind::colon) {
        emit(found->kind, begin, end, true);
        return end;
    }
    // `:=` with a colon of full width, and perhaps a sign that is.
    const DecodedCharacter behind = end == end_ ? DecodedCharacter{} : extents_.decode(end);
    const bool wide = behind.valid && behind.code_point == 0xFF1D;
    if (!wide && *end != '=') {
        emit(TokenKind::colon, begin, end, true);
        return end;
    }
    const char* const assign_end = wide ? end + behind.size : end + 1;
    if (wide)
        diagnostic.fixes.front().edits.push_back({range(end, assign_end), "="});
    emit(TokenKind::assign, begin, assign_end, true);
    return assign_end;
}

namespace {

struct ForeignOperator {
    char character;
    TokenKind kind;
    std::string_view meant;
};
constexpr std::array foreign_operators = {
    ForeignOperator{'!', TokenKind::kw_not, "NOT"},
    ForeignOperator{'~', TokenKind::kw_not, "NOT"},
    ForeignOperator{'|', TokenKind::kw_or, "OR"},
    ForeignOperator{'%', TokenKind::kw_mod, "MOD"},
};

} // namespace

// `!a`, `~a`, `a | b` and `a % b`, which other languages have. Null when it is none of them.
const char* Lexer::operator_of_other_language(const char* begin) {
    const auto* const found =
        std::ranges::find(foreign_operators, *begin, &ForeignOperator::character);
    const char* const behind = Extents::blanks_end(begin + 1);
    if (found == foreign_operators.end() || !has_tokens() || first_on_line_ ||
        (!is_word_start(*behind) && !is_digit(*behind) && *behind != '('))
        return nullptr;
    const bool unary = found->kind == TokenKind::kw_not;
    const bool adjoins = last_token().end() == offset(begin);
    // `%` behind blanks and before a word begins what is to be a location.
    const bool location =
        *begin == '%' && (is_location(behind) || (!adjoins && behind == begin + 1));
    if (ends_operand(last_token(), begin) == unary || location)
        return nullptr;
    const TextRange where = range(begin, begin + 1);
    Diagnostic& diagnostic = report(DiagnosticId::foreign_operator, where);
    diagnostic.arguments = {std::string(1, *begin), std::string(found->meant)};
    std::string replacement(found->meant);
    if (adjoins && last_token().kind() != TokenKind::left_parenthesis)
        replacement.insert(0, " ");
    if (behind == begin + 1 && *behind != '(')
        replacement += ' ';
    add_replacement(diagnostic, where, replacement);
    emit(found->kind, begin, begin + 1, true);
    return begin + 1;
}

// A run of characters that nothing begins with is one token with one report.
const char* Lexer::unexpected(const char* begin) {
    if (const char* const end = operator_of_other_language(begin))
        return end;
    if (begin[0] == '?' && begin[1] == '=') { // the attempt to assign a reference
        report(DiagnosticId::foreign_construct, range(begin, begin + 2)).arguments = {
            std::string("`?=`"), std::string("the third edition")};
        emit(TokenKind::assign, begin, begin + 2, true);
        return begin + 2;
    }
    if (*begin == '$')
        if (const char* const end =
                hexadecimal_of_other_language(begin, extents_.word_end(begin + 1)))
            return end;
    const DecodedCharacter first = extents_.decode(begin);
    if (const char* const end = typographic_string(begin, first))
        return end;
    if (const char* const end = look_alike(begin, first))
        return end;
    const char* p = begin;
    for (;;) {
        const CharacterClass found = class_of(*p);
        const bool belongs =
            found == CharacterClass::unexpected || (found == CharacterClass::zero && p != end_) ||
            found == CharacterClass::caret || (found == CharacterClass::bar && p[1] != '|') ||
            (found == CharacterClass::exclamation && p[1] != '=');
        if (belongs)
            ++p;
        else if (found == CharacterClass::non_ascii &&
                 (!extents_.decode(p).valid || extents_.foreign_letter_size(p) == 0))
            p += extents_.decode(p).size;
        else
            break;
    }
    if (first.valid) // of broken bytes `check_encoding` speaks
        report(DiagnosticId::unexpected_character, range(begin, p))
            .arguments.emplace_back(first.code_point);
    emit_any(TokenKind::unknown, begin, p, true);
    return p;
}

} // namespace iecfront
