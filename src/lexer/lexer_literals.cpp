#include "lexer/keywords.hpp"
#include "lexer/lexer.hpp"
#include "lexer/lookahead.hpp"
#include "lexer/plain_literals.hpp"

#include <iecfront/lexer/literals.hpp>
#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/standard_names.hpp>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace iecfront {

namespace {

// What the word before a `#` begins; `enumerated_value` when it is no prefix of the language.
[[nodiscard]] TokenKind kind_of_prefix(std::string_view prefix) noexcept {
    const TokenKind word = keyword_kind(prefix);
    switch (word) {
    case TokenKind::kw_time: return TokenKind::duration;
    case TokenKind::kw_date: return TokenKind::date;
    case TokenKind::kw_tod:
    case TokenKind::kw_time_of_day: return TokenKind::time_of_day;
    case TokenKind::kw_dt:
    case TokenKind::kw_date_and_time: return TokenKind::date_and_time;
    case TokenKind::kw_string: return TokenKind::single_byte_string;
    case TokenKind::kw_wstring: return TokenKind::double_byte_string;
    default: break;
    }
    if (names_equal(prefix, "T"))
        return TokenKind::duration;
    if (names_equal(prefix, "D"))
        return TokenKind::date;
    return is_elementary_type_name(word) ? TokenKind::typed_literal : TokenKind::enumerated_value;
}

// Prefixes that the third edition has for literals: known in order to be named. To this edition
// they are names of types like any other, and so can stand before an enumerated value.
struct ThirdEditionPrefix {
    std::string_view word;
    TokenKind kind;
};
constexpr std::array third_edition_prefixes = {
    ThirdEditionPrefix{"LTIME", TokenKind::duration},
    ThirdEditionPrefix{"LT", TokenKind::duration},
    ThirdEditionPrefix{"LDATE", TokenKind::date},
    ThirdEditionPrefix{"LD", TokenKind::date},
    ThirdEditionPrefix{"LTIME_OF_DAY", TokenKind::time_of_day},
    ThirdEditionPrefix{"LTOD", TokenKind::time_of_day},
    ThirdEditionPrefix{"LDATE_AND_TIME", TokenKind::date_and_time},
    ThirdEditionPrefix{"LDT", TokenKind::date_and_time},
    ThirdEditionPrefix{"CHAR", TokenKind::single_byte_string},
    ThirdEditionPrefix{"WCHAR", TokenKind::double_byte_string},
};

// The kind of literal that the prefix begins in the third edition; `typed_literal` for none.
[[nodiscard]] TokenKind third_edition_kind(std::string_view prefix) noexcept {
    for (const ThirdEditionPrefix& row : third_edition_prefixes)
        if (names_equal(prefix, row.word))
            return row.kind;
    return TokenKind::typed_literal;
}

[[nodiscard]] bool is_string(TokenKind kind) noexcept {
    return kind == TokenKind::single_byte_string || kind == TokenKind::double_byte_string;
}

[[nodiscard]] bool is_hexadecimal_digit(char c) noexcept {
    return is_digit(c) || (fold(c) >= 'A' && fold(c) <= 'F');
}

} // namespace

// True when `body`, behind white space, is so evidently the value for the prefix that they make one
// literal.
bool Lexer::can_begin_value(TokenKind kind, std::string_view prefix, const char* body) const {
    if (is_string(kind))
        return is_quote(*body);
    if (begins_number(body))
        return true;
    const TokenKind word = keyword_kind(view(body, extents_.word_end(body)));
    return names_equal(prefix, "BOOL") &&
           (word == TokenKind::kw_true || word == TokenKind::kw_false);
}

// `type#value` with a type that has a name of its own.
bool Lexer::find_of_named_type(std::string_view prefix, const char* body, Found& found) const {
    const bool spaced = !found.gaps.empty();
    if (is_word_start(*body) || (!is_ascii(*body) && extents_.foreign_letter_size(body) != 0)) {
        found.end = extents_.word_end(body);
        if (!spaced && *found.end == '#' &&
            kind_of_prefix(view(body, found.end)) != TokenKind::enumerated_value) { // `a#T#5s`
            found.of_named_type = true;
            return find_prefixed(body, found.end, found) && found.gaps.empty();
        }
        return !spaced || keyword_kind(view(body, found.end)) == TokenKind::identifier;
    }
    if (!begins_number(body) && (spaced || !is_quote(*body)))
        return false;
    found.kind = third_edition_kind(prefix);
    found.of_named_type = true;
    found.end = extents_.literal_end(found.kind, body);
    return true;
}

// `16#FF`, with or without white space.
bool Lexer::find_based(const char* begin, const char* prefix_end, const char* body,
                       Found& found) const {
    found.kind = TokenKind::based_integer;
    found.end = extents_.literal_end(found.kind, body);
    if (found.gaps.empty())
        return true;
    if (view(begin, prefix_end) != "16")
        return is_digit(*body);
    const std::string_view digits = view(body, extents_.word_end(body));
    return is_hexadecimal_digit(*body) && keyword_kind(digits) == TokenKind::identifier &&
           std::ranges::all_of(digits, [](char c) { return is_hexadecimal_digit(c) || c == '_'; });
}

// Looks for a literal with the prefix from `begin` to `prefix_end`, which a `#` follows, perhaps
// behind blanks. False when there is none.
bool Lexer::find_prefixed(const char* begin, const char* prefix_end, Found& found) const {
    const char* const sign = Extents::gap_end(prefix_end);
    const char* const body = Extents::gap_end(sign + 1);
    if (body != prefix_end + 1)
        found.gaps = gaps_of({range(prefix_end, sign), range(sign + 1, body)});
    if (is_digit(*begin) && find_based(begin, prefix_end, body, found))
        return true;
    const std::string_view prefix = view(begin, prefix_end);
    found.kind = is_digit(*begin) ? TokenKind::based_integer : kind_of_prefix(prefix);
    if (found.kind == TokenKind::enumerated_value) {
        return find_of_named_type(prefix, body, found);
    }
    if (!found.gaps.empty() && found.kind != TokenKind::based_integer &&
        can_begin_value(found.kind, prefix, body)) {
        found.end = extents_.literal_end(found.kind, body);
        return true;
    }
    // Without white space that can be overlooked, whatever follows the `#` directly is the value.
    found.gaps.clear();
    if (sign != prefix_end)
        return false;
    if (is_string(found.kind) && !is_quote(sign[1]))
        found.kind = TokenKind::typed_literal;
    found.end = extents_.literal_end(found.kind, sign + 1);
    return true;
}

const char* Lexer::prefixed(const char* begin, const char* prefix_end) {
    Found found{};
    if (find_prefixed(begin, prefix_end, found))
        return found_literal(begin, prefix_end, found);
    return plain_word(begin, prefix_end); // and the `#` is reported when it is met
}

const char* Lexer::found_literal(const char* begin, const char* prefix_end, const Found& found) {
    if (!found.gaps.empty())
        return spaced_literal(found.kind, begin, found.end, found.gaps);
    if (found.kind == TokenKind::enumerated_value) {
        const bool first_well_formed = check_word(begin, prefix_end);
        const bool well_formed = check_word(prefix_end + 1, found.end) && first_well_formed;
        emit_any(found.kind, begin, found.end, !well_formed);
        return found.end;
    }
    if (!found.of_named_type)
        return literal(found.kind, begin, found.end);
    report_type_of_literal(begin, prefix_end, found.end);
    emit_any(found.kind, begin, found.end);
    return found.end;
}

// What is wrong with a value that is typed with a name other than an elementary type's.
void Lexer::report_type_of_literal(const char* begin, const char* prefix_end, const char* end) {
    const std::string_view type = view(begin, prefix_end);
    const TokenKind word = keyword_kind(type);
    const StandardName standard = standard_name(type);
    DiagnosticId fault = DiagnosticId::literal_of_derived_type;
    if (is_generic_type_name(word))
        fault = DiagnosticId::literal_of_generic_type;
    else if (third_edition_kind(type) != TokenKind::typed_literal)
        fault = DiagnosticId::third_edition_literal;
    else if (word != TokenKind::identifier)
        fault = DiagnosticId::reserved_word_as_name;
    else if (standard != StandardName::none)
        fault = DiagnosticId::standard_name_as_name;
    const bool of_name = fault == DiagnosticId::reserved_word_as_name ||
                         fault == DiagnosticId::standard_name_as_name;
    Diagnostic& diagnostic = report(fault, range(begin, of_name ? prefix_end : end));
    diagnostic.arguments.emplace_back(std::string(type));
    if (fault == DiagnosticId::third_edition_literal)
        diagnostic.arguments.emplace_back(std::string("prefix"));
    if (fault == DiagnosticId::standard_name_as_name) {
        diagnostic.arguments.emplace_back(
            std::string(standard == StandardName::function ? "function" : "function block"));
        diagnostic.arguments.emplace_back(std::string("cannot be the type of a literal"));
    }
}

const char* Lexer::spaced_literal(TokenKind kind, const char* begin, const char* end, Gaps gaps) {
    const TextRange first = gaps.front().range;
    const std::string_view gap = text_.substr(first.begin, first.size());
    const std::size_t opening = gap.find_first_of("({");
    const bool remark = opening != std::string_view::npos;
    Diagnostic& diagnostic = report(
        remark ? DiagnosticId::comment_in_literal : DiagnosticId::white_space_in_literal, first);
    if (remark) {
        const auto size = static_cast<std::uint32_t>(gap.find_last_not_of(" \t") + 1);
        diagnostic.range = {first.begin + static_cast<std::uint32_t>(opening), first.begin + size};
        diagnostic.arguments.emplace_back(gap[opening] == '{' ? "pragma" : "comment");
    }
    const bool location =
        kind == TokenKind::direct_variable || kind == TokenKind::incomplete_location;
    diagnostic.arguments.emplace_back(location ? "a directly represented variable"
                                      : kind == TokenKind::enumerated_value ? "an enumerated value"
                                                                            : "a literal");
    diagnostic.fixes.push_back({std::move(gaps)});
    emit_any(kind, begin, end, true);
    return end;
}

Lexer::Gaps Lexer::gaps_of(std::initializer_list<TextRange> ranges) {
    Gaps gaps;
    for (const TextRange gap : ranges)
        if (!gap.empty())
            gaps.push_back({gap, {}});
    return gaps;
}

// The gaps that were reported inside a literal which goes on: all of them are one mistake.
Lexer::Gaps Lexer::take_back_gaps(Token literal) {
    if (result_.diagnostics.empty())
        return {};
    Diagnostic& last = result_.diagnostics.back();
    const bool of_gap = last.id == DiagnosticId::white_space_in_literal ||
                        last.id == DiagnosticId::comment_in_literal;
    if (!of_gap || last.range.begin < literal.offset())
        return {};
    Gaps gaps = std::move(last.fixes.front().edits);
    result_.diagnostics.pop_back();
    return gaps;
}

// `T#5 s`, `D#1984 - 06 - 25`, `DT#1984-06-25 15:36:55`: the longest text from `begin` on that is a
// literal without a fault once its gaps are closed. Null when there is none behind `end`.
const char* Lexer::literal_with_gaps(TokenKind kind, const char* begin, const char* end) {
    if (is_string(kind))
        return nullptr;
    std::string whole(begin, end);
    Gaps gaps;
    std::size_t gaps_inside = 0;
    const char* found = nullptr;
    for (const char* p = end; whole.size() < longest_tried;) {
        const char* const piece = Extents::gap_end(p);
        const bool separator = is_sign(*piece) || *piece == '.' || *piece == ':';
        const char* const piece_end = extents_.word_end(piece + (separator ? 1 : 0));
        if (piece_end == piece)
            break;
        if (piece != p) {
            const bool time = kind == TokenKind::date_and_time && is_digit(*piece) &&
                              std::ranges::count(whole, '-') == 2;
            gaps.push_back({range(p, piece), time ? "-" : ""});
            whole += gaps.back().replacement;
        }
        whole.append(piece, piece_end);
        p = piece_end;
        if (check_literal(kind, whole, encoding_).empty()) {
            found = p;
            gaps_inside = gaps.size();
        }
    }
    if (found == nullptr || gaps_inside == 0)
        return nullptr;
    // Another literal begins in `1. 2.5` and `1. 16#F`, and a statement in `T#5 s := 1`.
    if (*found == '#' || (*found == '.' && is_digit(found[1])) || *Extents::gap_end(found) == ':')
        return nullptr;
    gaps.resize(gaps_inside);
    return spaced_literal(kind, begin, found, std::move(gaps));
}

const char* Lexer::literal(TokenKind kind, const char* begin, const char* end) {
    if (static_cast<std::size_t>(end - begin) > Token::maximum_length) {
        emit_pieces(begin, end);
        return end;
    }
    if (is_plain_literal(kind, view(begin, end))) {
        emit(kind, begin, end);
        return end;
    }
    std::vector<Diagnostic> faults = check_literal(kind, view(begin, end), encoding_);
    const bool malformed = std::ranges::any_of(faults, [](const Diagnostic& fault) {
        const DiagnosticClass category = diagnostic_info(fault.id).category;
        return category == DiagnosticClass::violation || category == DiagnosticClass::error;
    });
    if (!faults.empty()) { // of a part, perhaps, or of more than the literal
        if (const char* const whole_end = literal_with_gaps(kind, begin, end))
            return whole_end;
        if (const char* const number_end = number_before_keyword(kind, begin, end))
            return number_end;
    }
    for (Diagnostic& fault : faults)
        result_.diagnostics.push_back(shifted(std::move(fault), offset(begin)));
    emit(kind, begin, end, malformed);
    return end;
}

// A `#` that belongs to nothing directly before it: perhaps blanks keep it from its prefix.
const char* Lexer::number_sign(const char* begin) {
    if (has_tokens() && can_be_prefix(last_token())) {
        const Token prefix = last_token();
        const char* const prefix_end = begin_ + prefix.end();
        Found found{};
        if (prefix_end != begin && Extents::gap_end(prefix_end) == begin &&
            find_prefixed(begin_ + prefix.offset(), prefix_end, found)) {
            take_back();
            return found_literal(begin_ + prefix.offset(), prefix_end, found);
        }
    }
    report(DiagnosticId::stray_number_sign, range(begin, begin + 1));
    emit(TokenKind::unknown, begin, begin + 1, true);
    return begin + 1;
}

bool Lexer::can_be_prefix(Token token) const {
    const TokenKind kind = token.kind();
    return !token.malformed() && (kind == TokenKind::identifier || kind == TokenKind::integer ||
                                  is_elementary_type_name(kind));
}

// `16#FF` and `INT#5` with a pound sign for the `#`: feature 3b of Table 1, which is not supported.
// Null when that would make no literal.
const char* Lexer::with_pound_sign(const char* begin, const char* end) {
    constexpr char32_t pound_sign = 0x00A3;
    const char* const sign = std::find_if_not(begin, end, is_ascii);
    if (sign == end || view(begin, end).size() > longest_tried)
        return nullptr;
    const DecodedCharacter character = extents_.decode(sign);
    const TokenKind kind =
        is_digit(*begin) ? TokenKind::based_integer : kind_of_prefix(view(begin, sign));
    if (!character.valid || character.code_point != pound_sign ||
        kind == TokenKind::enumerated_value)
        return nullptr;
    const char* const body = sign + character.size;
    const std::string meant = std::string(begin, sign) + '#' + std::string(body, end);
    if (!check_literal(kind, meant, encoding_).empty())
        return nullptr;
    Diagnostic& diagnostic = report(DiagnosticId::unexpected_character, range(sign, body));
    diagnostic.arguments.emplace_back(pound_sign);
    add_replacement(diagnostic, range(sign, body), "#");
    emit_any(kind, begin, end, true);
    return end;
}

} // namespace iecfront
