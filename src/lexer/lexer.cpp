#include "lexer/lexer.hpp"

#include "diagnostics/sort_by_place.hpp"
#include "lexer/characters.hpp"
#include "lexer/keywords.hpp"
#include "lexer/literal_scanners.hpp"
#include "lexer/meant_number.hpp"
#include "lexer/word_shape.hpp"

#include <iecfront/lexer/literals.hpp>
#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/standard_names.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace iecfront {

namespace {

// So many digits fit 64 bits: nothing can be wrong with them.
constexpr std::ptrdiff_t safe_digits = 18;

// Nobody writes a longer literal than this, but for strings: what is longer is not tried as one.
constexpr std::size_t longest_tried = 40;

} // namespace

Lexer::Lexer(std::string_view text, Encoding encoding, bool at_file_start)
    : text_(text),
      begin_(text.data()),
      end_(text.data() + text.size()),
      at_(begin_),
      line_feed_(begin_),
      comment_end_missing_from_(end_),
      c_comment_end_missing_from_(end_),
      pragma_end_missing_from_(end_),
      first_on_line_(at_file_start),
      encoding_(encoding),
      extents_(text, encoding) {
    if (at_file_start)
        at_ += byte_order_mark_size(text, encoding);
}

void Lexer::read(std::size_t count) {
    if (done_)
        return;
    // Published programs have a token in 6 to 8 bytes; the row grows where that is too few. A line
    // may go on behind the last token.
    constexpr std::size_t on_a_line = 64;
    const std::size_t likely = token_count() + static_cast<std::size_t>(end_ - at_) / 6 + 16;
    const std::size_t room = count < likely ? std::min(count + on_a_line, likely) : likely;
    if (result_.tokens.size() < room)
        grow_tokens(room - result_.tokens.size());
    at_ = read_until(count);
    sort_by_place(result_.diagnostics);
}

namespace {

// What most tokens are: told by their first characters alone.
struct Piece {
    TokenKind kind;
    std::uint32_t size;
};

// The longer delimiter when `second` follows, else the shorter one.
[[nodiscard]] Piece either(const char* begin, char second, TokenKind longer, TokenKind shorter) {
    return begin[1] == second ? Piece{longer, 2} : Piece{shorter, 1};
}

} // namespace

// Goes on from `at_`, and stops at a line end where `count` tokens are there: nothing that is put
// together from several tokens goes on behind one.
//
// What a case takes as it stands, it leaves in `piece` for the end of the loop, so that the code
// that makes most tokens is there once. For all else a function makes the tokens.
const char* Lexer::read_until(std::size_t count) {
    const char* p = at_;
    for (;;) {
        Piece piece{TokenKind::unknown, 1};
        switch (class_of(*p)) {
        case CharacterClass::blank:
            do
                ++p;
            while (*p == ' ');
            continue;
        case CharacterClass::line_end:
            first_on_line_ = true;
            ++p;
            if (token_count() >= count) [[unlikely]]
                return p;
            continue;
        case CharacterClass::word: {
            const WordShape shape = shape_of_word(p, end_);
            const std::string_view text = view(p, shape.end);
            if (shape.stray_underscores || is_odd_word(text)) [[unlikely]] {
                p = odd_word(p);
                continue;
            }
            piece = {keyword_kind(text, shape.head), static_cast<std::uint32_t>(text.size())};
            break;
        }
        case CharacterClass::digit: {
            const char* end = p + 1;
            while (is_digit(*end))
                ++end;
            if (number_goes_on(p, end)) {
                p = long_number(p);
                continue;
            }
            piece = {TokenKind::integer, static_cast<std::uint32_t>(end - p)};
            break;
        }
        case CharacterClass::quote: p = string(p); continue;
        case CharacterClass::single: piece.kind = single_delimiter(*p); break;
        case CharacterClass::ampersand:
            piece = either(p, '&', TokenKind::ampersand_ampersand, TokenKind::ampersand);
            break;
        case CharacterClass::brace_left: p = pragma(p); continue;
        case CharacterClass::brace_right: p = stray_pragma_end(p); continue;
        case CharacterClass::caret: p = caret(p); continue;
        case CharacterClass::colon:
            piece = either(p, '=', TokenKind::assign, TokenKind::colon);
            break;
        case CharacterClass::dot:
            if (!is_word_start(p[1])) {
                p = dot(p);
                continue;
            }
            piece.kind = TokenKind::dot;
            break;
        case CharacterClass::equal:
            piece = p[1] == '>' ? Piece{TokenKind::output_arrow, 2}
                                : either(p, '=', TokenKind::equal_equal, TokenKind::equal);
            break;
        case CharacterClass::greater:
            piece = either(p, '=', TokenKind::greater_equal, TokenKind::greater);
            break;
        case CharacterClass::less:
            piece = p[1] == '>' ? Piece{TokenKind::not_equal, 2}
                                : either(p, '=', TokenKind::less_equal, TokenKind::less);
            break;
        case CharacterClass::parenthesis_left:
            if (p[1] == '*' || class_of(p[1]) == CharacterClass::blank) {
                p = p[1] == '*' ? comment(p) : left_parenthesis(p);
                continue;
            }
            piece.kind = TokenKind::left_parenthesis;
            break;
        case CharacterClass::slash:
            if (p[1] == '/' || p[1] == '*') {
                p = p[1] == '/' ? line_comment(p) : c_comment(p);
                continue;
            }
            piece.kind = TokenKind::slash;
            break;
        case CharacterClass::star:
            if (p[1] == ')') {
                p = stray_comment_end(p);
                continue;
            }
            piece = either(p, '*', TokenKind::power, TokenKind::star);
            break;
        case CharacterClass::bar:
            if (p[1] != '|') {
                p = unexpected(p);
                continue;
            }
            piece = {TokenKind::bar_bar, 2};
            break;
        case CharacterClass::exclamation:
            if (p[1] != '=') {
                p = unexpected(p);
                continue;
            }
            piece = {TokenKind::exclamation_equal, 2};
            break;
        case CharacterClass::number_sign: p = number_sign(p); continue;
        case CharacterClass::percent: p = location(p); continue;
        case CharacterClass::non_ascii: p = non_ascii(p); continue;
        case CharacterClass::unexpected: p = unexpected(p); continue;
        case CharacterClass::zero:
            if (p == end_) {
                first_on_line_ = true;
                emit(TokenKind::end_of_unit, p, p);
                done_ = true;
                return p;
            }
            p = unexpected(p);
            continue;
        }
        put(piece.kind, p, p + piece.size);
        p += piece.size;
        p += *p == ' ' ? 1 : 0; // mostly there is one, which takes no branch to pass
    }
}

// ---- tokens ------------------------------------------------------------------------------------

void Lexer::emit(TokenKind kind, const char* begin, const char* end, bool malformed) {
    put(kind, begin, end, malformed);
}

void Lexer::emit_any(TokenKind kind, const char* begin, const char* end, bool malformed) {
    if (static_cast<std::size_t>(end - begin) > Token::maximum_length)
        emit_pieces(begin, end);
    else
        emit(kind, begin, end, malformed);
}

void Lexer::emit_pieces(const char* begin, const char* end) {
    // Whatever was found inside is of no use when the whole is not examined.
    while (!result_.diagnostics.empty() && result_.diagnostics.back().range.begin >= offset(begin))
        result_.diagnostics.pop_back();
    report(DiagnosticId::text_too_long, range(begin, end))
        .arguments.emplace_back(std::uint64_t{Token::maximum_length});
    while (begin != end) {
        const auto rest = static_cast<std::size_t>(end - begin);
        const char* const cut = begin + std::min<std::size_t>(rest, Token::maximum_length);
        emit(TokenKind::unknown, begin, cut, true);
        begin = cut;
    }
}

void Lexer::grow_tokens(std::size_t by) {
    const std::size_t count = token_count();
    result_.tokens.resize(result_.tokens.size() + by);
    next_token_ = result_.tokens.data() + count;
    tokens_end_ = result_.tokens.data() + result_.tokens.size();
}

void Lexer::drop(std::size_t tokens, std::size_t trivia, std::size_t diagnostics,
                 std::size_t open_ends) {
    const auto erase = [](auto& row, std::size_t count) {
        row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(count));
    };
    std::copy(result_.tokens.data() + tokens, next_token_, result_.tokens.data());
    next_token_ -= tokens;
    erase(result_.trivia, trivia);
    erase(result_.diagnostics, diagnostics);
    erase(result_.open_ends, open_ends);
}

LexedText Lexer::take() {
    result_.tokens.resize(token_count());
    return std::move(result_);
}

// Removes the last token, to read it again together with what follows it. A comment or pragma
// behind it will be a part of it.
Token Lexer::take_back() {
    const Token token = *--next_token_;
    first_on_line_ = token.first_on_line();
    while (!result_.trivia.empty() && result_.trivia.back().range.begin >= token.end())
        result_.trivia.pop_back();
    while (!result_.diagnostics.empty() && result_.diagnostics.back().range.begin >= token.end() &&
           result_.diagnostics.back().id == DiagnosticId::pragma)
        result_.diagnostics.pop_back();
    return token;
}

// ---- words -------------------------------------------------------------------------------------

namespace {

// True when every underscore of a word is followed by a letter or digit, as all have to be (2.1.2).
[[nodiscard]] bool has_single_underscores(const char* begin, const char* end) noexcept {
    for (const char* p = begin; p != end; ++p)
        if (*p == '_' && (p + 1 == end || p[1] == '_'))
            return false;
    return true;
}

} // namespace

// True for a word that ends in a `#` or a character beyond ASCII, or is longer than a token can be.
bool Lexer::is_odd_word(std::string_view word) noexcept {
    return (word_bits_of(word.data()[word.size()]) & characters::word_joins) != 0 ||
           word.size() > Token::maximum_length;
}

// A word that a `#` or a character beyond ASCII may follow, or one with a fault.
const char* Lexer::odd_word(const char* begin) {
    const char* const end = extents_.word_end(begin);
    if (*end == '#')
        return prefixed(begin, end);
    if (const char* const literal_end = with_pound_sign(begin, end))
        return literal_end;
    return plain_word(begin, end);
}

const char* Lexer::plain_word(const char* begin, const char* end) {
    const TokenKind kind = keyword_kind(view(begin, end));
    if (kind == TokenKind::identifier)
        return identifier(begin, end);
    emit(kind, begin, end);
    return end;
}

const char* Lexer::identifier(const char* begin, const char* end) {
    const bool malformed = !check_word(begin, end);
    emit_any(TokenKind::identifier, begin, end, malformed);
    return end;
}

// Reports what keeps a word from being an identifier (2.1.2). True when nothing does.
bool Lexer::check_word(const char* begin, const char* end) {
    if (!check_foreign_letters(begin, end))
        return false;
    if (has_single_underscores(begin, end))
        return true;
    check_underscores(begin, end);
    return false;
}

// `END_ IF`: true when it is reported.
bool Lexer::report_parted_keyword(const char* begin, const char* end) {
    const char* const rest = Extents::blanks_end(end);
    const char* const rest_end = extents_.word_end(rest);
    const std::string whole = std::string(view(begin, end)).append(view(rest, rest_end));
    if (rest == end || keyword_kind(whole) == TokenKind::identifier)
        return false;
    Diagnostic& diagnostic = report(DiagnosticId::misspelt_word, range(begin, rest_end));
    diagnostic.arguments = {std::string(view(begin, rest_end)), whole};
    add_replacement(diagnostic, range(begin, rest_end), whole);
    return true;
}

void Lexer::check_underscores(const char* begin, const char* end) {
    for (const char* p = begin; p != end;) {
        if (*p != '_') {
            ++p;
            continue;
        }
        const char* run = p;
        while (run != end && *run == '_')
            ++run;
        const TextRange where = range(p, run);
        if (p == begin && run == end)
            report(DiagnosticId::lone_underscore, where);
        else if (run == end) {
            if (!report_parted_keyword(begin, end))
                add_replacement(report(DiagnosticId::trailing_underscore, where), where);
        } else if (run - p > 1)
            add_replacement(report(p == begin ? DiagnosticId::leading_underscores
                                              : DiagnosticId::consecutive_underscores,
                                   where),
                            where, "_");
        p = run;
    }
}

bool Lexer::check_foreign_letters(const char* begin, const char* end) {
    const char* p = std::find_if_not(begin, end, is_ascii);
    if (p == end)
        return true;
    while (p != end && !extents_.decode(p).valid) // of broken bytes the encoding check speaks
        p = std::find_if_not(p + 1, end, is_ascii);
    if (p != end) {
        const DecodedCharacter character = extents_.decode(p);
        report(DiagnosticId::character_in_identifier, range(p, p + character.size))
            .arguments.emplace_back(character.code_point);
    }
    return false;
}

// ---- literals with a prefix --------------------------------------------------------------------

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

[[nodiscard]] bool is_quote(char c) noexcept {
    return class_of(c) == CharacterClass::quote;
}

[[nodiscard]] bool begins_number(const char* p) noexcept {
    return is_digit(is_sign(*p) ? p[1] : *p);
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

// ---- numbers -----------------------------------------------------------------------------------

// True for digits that may not be all of a number, or too many to be sure that nothing is wrong.
bool Lexer::number_goes_on(const char* begin, const char* end) noexcept {
    return (word_bits_of(*end) & characters::number_goes_on) != 0 || end - begin > safe_digits;
}

const char* Lexer::long_number(const char* begin) {
    const char* const digits_end = Extents::digits_end(begin);
    if (*digits_end == '#')
        return prefixed(begin, digits_end);
    const char* const word_end = extents_.word_end(digits_end);
    const bool behind_dot = has_tokens() && last_token().kind() == TokenKind::dot &&
                            last_token().end() == offset(begin);
    if (*digits_end == '.' && !behind_dot)
        return number_with_point(begin, digits_end);
    if (is_exponent_letter(*digits_end) && !behind_dot)
        return number_with_exponent(begin, digits_end);
    return word_end == digits_end ? integer(begin, digits_end) : digit_first_word(begin, word_end);
}

const char* Lexer::integer(const char* begin, const char* end) {
    if (end - begin > safe_digits || std::find(begin, end, '_') != end)
        return literal(TokenKind::integer, begin, end);
    emit(TokenKind::integer, begin, end);
    return end;
}

namespace {

// Digits that are no number of their own: `1. 5`, but not `1. 2.5`.
[[nodiscard]] bool is_fraction(const char* p) noexcept {
    const char* const end = Extents::digits_end(p);
    return is_digit(*p) && *end != '#' && (*end != '.' || end[1] == '.');
}

// Digits on both sides and nothing else, of a size that every real type holds.
[[nodiscard]] bool is_plain_real(const char* begin, const char* point, const char* end) noexcept {
    return end - begin <= safe_digits && end != point + 1 && std::all_of(begin, point, is_digit) &&
           std::all_of(point + 1, end, is_digit);
}

[[nodiscard]] bool is_lone_dot(const char* p) noexcept {
    return *p == '.' && p[1] != '.';
}

} // namespace

const char* Lexer::number_with_point(const char* begin, const char* point) {
    if (point[1] == '.' || is_lone_dot(Extents::blanks_end(point + 1))) // `1..3` and `1. .3`
        return integer(begin, point);
    const char* end = point + 1;
    if (Extents::point_begins_fraction(point))
        end = extents_.real_end(point);
    // `1. 5`, `1.0 E3` and `1.0E 3`: the rest of the number behind blanks.
    const char* const rest = Extents::gap_end(end);
    if (rest != end) {
        const Gaps gaps = gaps_of({range(end, rest)});
        if (end == point + 1 && is_fraction(rest))
            return spaced_literal(TokenKind::real, begin, extents_.real_end(rest - 1), gaps);
        if (const char* const exponent = Extents::exponent_end(rest);
            exponent != nullptr && end != point + 1 && !is_word_part(*exponent))
            return spaced_literal(TokenKind::real, begin, exponent, gaps);
        if (end != point + 1 && is_exponent_letter(end[-1]) && begins_number(rest))
            return spaced_literal(TokenKind::real, begin,
                                  Extents::digits_end(is_sign(*rest) ? rest + 1 : rest), gaps);
    }
    if (lacks_duration_prefix(begin, end))
        return duration_without_prefix(begin, end);
    if (!is_plain_real(begin, point, end))
        return literal(TokenKind::real, begin, end);
    emit(TokenKind::real, begin, end);
    return end;
}

const char* Lexer::number_with_exponent(const char* begin, const char* letter) {
    const char* const exponent = Extents::exponent_end(letter);
    const char* const word_end = extents_.word_end(letter);
    if (exponent == nullptr)
        return word_end == letter + 1 ? literal(TokenKind::real, begin, word_end)
                                      : digit_first_word(begin, word_end);
    if (is_sign(letter[1]))
        return literal(TokenKind::real, begin, extents_.word_end(exponent));
    return exponent == word_end ? literal(TokenKind::real, begin, exponent)
                                : digit_first_word(begin, word_end);
}

// `5s`, `1h_30m`, `1.5s`: a duration but for its prefix. What a colon follows is declared or
// assigned to, and so meant as a name.
bool Lexer::lacks_duration_prefix(const char* begin, const char* end) const {
    if (view(begin, end).size() > longest_tried || is_digit(end[-1]) ||
        *Extents::blanks_end(end) == ':')
        return false;
    const std::string with_prefix = "T#" + std::string(begin, end);
    return check_literal(TokenKind::duration, with_prefix, encoding_).empty();
}

const char* Lexer::duration_without_prefix(const char* begin, const char* end) {
    if (has_tokens() && last_token().kind() == TokenKind::duration) {
        const char* const before_end = begin_ + last_token().end();
        if (before_end != begin && Extents::gap_end(before_end) == begin) { // `T#1m 5s`
            Gaps gaps = take_back_gaps(last_token());
            gaps.push_back({range(before_end, begin), {}});
            return spaced_literal(TokenKind::duration, begin_ + take_back().offset(), end,
                                  std::move(gaps));
        }
    }
    Diagnostic& diagnostic = report(DiagnosticId::duration_without_prefix, range(begin, end));
    add_replacement(diagnostic, range(begin, begin), "T#");
    emit_any(TokenKind::duration, begin, end, true);
    return end;
}

// `0x1F`: a based integer in the way of another language. Null when it is none.
const char* Lexer::c_style_integer(const char* begin, const char* end) {
    struct Base {
        char letter;
        const char* prefix;
        std::uint64_t base;
    };
    static constexpr std::array bases = {Base{'X', "16#", 16}, Base{'O', "8#", 8},
                                         Base{'B', "2#", 2}};
    const auto* const found = std::ranges::find(bases, fold(begin[1]), &Base::letter);
    if (*begin != '0' || found == bases.end() || end - begin > safe_digits)
        return nullptr;
    const std::string meant = found->prefix + std::string(begin + 2, end);
    if (!check_literal(TokenKind::based_integer, meant, encoding_).empty())
        return nullptr;
    const TextRange where = range(begin, begin + 2);
    Diagnostic& diagnostic = report(DiagnosticId::c_style_base, where);
    diagnostic.arguments.emplace_back(std::string(begin, begin + 2));
    diagnostic.arguments.emplace_back(found->base);
    add_replacement(diagnostic, where, found->prefix);
    emit_any(TokenKind::based_integer, begin, end, true);
    return end;
}

// `0FFh` and `16FF`, which are to be 16#FF. Null when it is none of these, or is declared or
// assigned to, and so meant as a name.
const char* Lexer::hexadecimal_of_other_language(const char* begin, const char* end) {
    if (view(begin, end).size() > longest_tried || *Extents::gap_end(end) == ':')
        return nullptr;
    const std::string meant = meant_hexadecimal(view(begin, end));
    if (meant.empty())
        return nullptr;
    const TextRange where = range(begin, end);
    Diagnostic& diagnostic = report(DiagnosticId::number_of_other_language, where);
    diagnostic.arguments.emplace_back(std::uint64_t{16});
    diagnostic.arguments.emplace_back(meant);
    add_replacement(diagnostic, where, meant);
    emit_any(TokenKind::based_integer, begin, end, true);
    return end;
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

// `3MOD 2` and `FOR i := 1TO 3 DO`: a number without a fault, and a keyword that adjoins it. Null
// when these are not what the text is made of.
const char* Lexer::number_before_keyword(TokenKind kind, const char* begin, const char* end) {
    const std::size_t size = size_before_keyword(view(begin, end));
    const char* const number_end = begin + size;
    if (size == 0 || !is_word_part(number_end[-1]) ||
        !check_literal(kind, view(begin, number_end), encoding_).empty())
        return nullptr;
    Diagnostic& diagnostic =
        report(DiagnosticId::missing_white_space, range(number_end, number_end));
    diagnostic.arguments.emplace_back(std::string(begin, number_end));
    diagnostic.arguments.emplace_back(std::string(number_end, end));
    add_replacement(diagnostic, range(number_end, number_end), " ");
    emit_any(kind, begin, number_end);
    return number_end;
}

// `2nd_pump`: meant as a name, unless it is a value that lacks its prefix.
const char* Lexer::digit_first_word(const char* begin, const char* end) {
    if (*end == '#')
        return prefixed(begin, end);
    if (lacks_duration_prefix(begin, end))
        return duration_without_prefix(begin, end);
    if (const char* const value_end = c_style_integer(begin, end))
        return value_end;
    if (const char* const value_end = hexadecimal_of_other_language(begin, end))
        return value_end;
    if (const char* const value_end = with_pound_sign(begin, end))
        return value_end;
    if (const char* const number_end = number_before_keyword(TokenKind::integer, begin, end))
        return number_end;
    if (check_foreign_letters(begin, end)) {
        const char* const digits = std::find_if_not(begin, end, is_digit);
        report(DiagnosticId::identifier_begins_with_digit, range(begin, digits));
    }
    emit_any(TokenKind::identifier, begin, end, true);
    return end;
}

// ---- strings, locations ------------------------------------------------------------------------

namespace {

// True for a string literal with no fault: closed, of printable ASCII characters, without `$`.
[[nodiscard]] bool is_plain_string(std::string_view literal) noexcept {
    return literal.size() >= 2 && literal.back() == literal.front() &&
           std::ranges::all_of(literal, [](char c) { return c >= ' ' && c <= '~' && c != '$'; });
}

// `IX1`, `Q5`, `M*` behind the `%`.
[[nodiscard]] bool is_location(const char* p) noexcept {
    const auto is_one_of = [](char c, std::string_view letters) {
        return letters.find(fold(c)) != std::string_view::npos;
    };
    if (!is_one_of(*p, "IQM"))
        return false;
    ++p;
    return *p == '*' || is_digit(*p) || (is_one_of(*p, "XBWDL") && is_digit(p[1]));
}

// By its opening quote.
[[nodiscard]] TokenKind string_kind(const char* begin) noexcept {
    return *begin == '"' ? TokenKind::double_byte_string : TokenKind::single_byte_string;
}

} // namespace

const char* Lexer::string(const char* begin) {
    const char* const end = extents_.string_end(begin);
    const TokenKind kind = string_kind(begin);
    if (const char* const whole_end = end_behind_inner_quote(end)) {
        const TextRange inner = range(end - 1, end);
        Diagnostic& diagnostic = report(DiagnosticId::quote_in_string, inner);
        diagnostic.arguments.emplace_back(std::string{'$', *begin});
        add_replacement(diagnostic, inner, std::string{'$', *begin});
        emit_any(kind, begin, whole_end, true);
        return whole_end;
    }
    if (is_plain_string(view(begin, end))) {
        emit_any(kind, begin, end);
        return end;
    }
    if (std::find(begin + 1, end, *begin) == end)
        if (const char* const other_end = unclosed_string(begin, end))
            return other_end;
    return literal(kind, begin, end);
}

namespace {

[[nodiscard]] bool is_line_end(char c) noexcept {
    return class_of(c) == CharacterClass::line_end;
}

// What stands behind a string at the end of a statement or argument.
[[nodiscard]] bool ends_operand_at(const char* p) noexcept {
    return std::string_view(";,)]").find(*Extents::blanks_end(p)) != std::string_view::npos;
}

// The quote in the line from `begin` to `end` that closes a string of the line before; null when
// there is none: what stands before it is no code, and what stands behind it ends the operand.
[[nodiscard]] const char* quote_on_next_line(const char* begin, const char* end,
                                             char quote) noexcept {
    const char* const close = std::find(begin, end, quote);
    const std::string_view before(begin, static_cast<std::size_t>(close - begin));
    const bool closes = close != end && std::count(close, end, quote) % 2 == 1 &&
                        before.find_first_of(";=$") == before.npos && ends_operand_at(close + 1);
    return closes ? close : nullptr;
}

} // namespace

// A quote that nothing closes in its line, which ends at `end`: one too many in `x := y';`, or
// that of a string which the next line closes, or one with code behind its probable end. Null when
// it is none of these.
const char* Lexer::unclosed_string(const char* begin, const char* end) {
    note_open_end(begin, std::min(end + 1, end_)); // what follows may be of other units
    if (is_stray_quote(begin)) {
        Diagnostic& diagnostic =
            report(DiagnosticId::unexpected_character, range(begin, begin + 1));
        diagnostic.arguments.emplace_back(static_cast<char32_t>(*begin));
        add_replacement(diagnostic, range(begin, begin + 1));
        emit(TokenKind::unknown, begin, begin + 1, true);
        return begin + 1;
    }
    const char* const code = begin + 1 + literals::length_before_code(view(begin + 1, end));
    if (code != end)
        return literal(string_kind(begin), begin, code);
    const char* const next = end + (*end == '\r' && end[1] == '\n' ? 2 : 1);
    if (!is_line_end(*end) || view(begin, end).find(';') != std::string_view::npos)
        return nullptr;
    const char* const next_end = std::find_if(next, end_, is_line_end);
    result_.open_ends.back().looked_to = offset(next_end) + 1;
    const char* const close = quote_on_next_line(next, next_end, *begin);
    if (close == nullptr || static_cast<std::size_t>(close - begin) >= Token::maximum_length)
        return nullptr;
    Diagnostic& diagnostic = report(DiagnosticId::unterminated_string, range(begin, begin + 1));
    diagnostic.arguments.emplace_back(std::string{'`', *begin, '`'});
    add_replacement(diagnostic, range(end, Extents::blanks_end(next)), "$N");
    emit(string_kind(begin), begin, close + 1, true);
    return close + 1;
}

// Directly behind an operand, and before what can follow one.
bool Lexer::is_stray_quote(const char* begin) const {
    return has_tokens() && last_token().end() == offset(begin) &&
           !is_keyword(last_token().kind()) && ends_operand(last_token(), begin) &&
           ends_operand_at(begin + 1);
}

// The end of `'it's'`, when a word that is no keyword adjoins the string that ends at `end`, and
// the next quote on the line begins no other string; else null.
const char* Lexer::end_behind_inner_quote(const char* end) {
    constexpr std::ptrdiff_t furthest = 1000; // bounds the time that a line full of quotes takes
    const char quote = end[-1];
    if (!is_quote(quote) || !is_word_start(*end) ||
        keyword_kind(view(end, extents_.word_end(end))) != TokenKind::identifier)
        return nullptr;
    const char* const whole_end = extents_.string_end(end - 1);
    const char* p = whole_end; // up to where the line is looked at
    bool whole = whole_end[-1] == quote;
    for (; whole && p != end_ && !is_line_end(*p); ++p) {
        whole = p - end <= furthest;
        if (whole && *p == quote) {
            p = extents_.string_end(p) - 1;
            whole = *p == quote;
        }
    }
    note_open_end(end, p); // the rest of the line may be of other units
    return whole ? whole_end : nullptr;
}

// `%X3` behind the point of `x.%X3`. Null when it is none.
const char* Lexer::part_selector(const char* begin) {
    constexpr std::string_view sizes = "XBWDL";
    if (!has_tokens() || last_token().kind() != TokenKind::dot ||
        sizes.find(fold(begin[1])) == std::string_view::npos || !is_digit(begin[2]))
        return nullptr;
    const char* const end = std::find_if_not(begin + 2, end_, is_digit);
    emit_any(TokenKind::part_selector, begin, end);
    return end;
}

const char* Lexer::location(const char* begin) {
    if (const char* const behind = operator_of_other_language(begin))
        return behind;
    if (const char* const part_end = part_selector(begin))
        return part_end;
    const char* const end = extents_.location_end(begin + 1);
    const char* const rest = Extents::gap_end(end);
    const TextRange gap = range(end, rest);
    const std::string_view letters = view(begin + 1, end);
    const TokenKind kind = letters.find('*') != std::string_view::npos
                               ? TokenKind::incomplete_location
                               : TokenKind::direct_variable;
    if (rest == end)
        return literal(kind, begin, end);
    if (letters.empty() && is_location(rest)) {
        const char* const rest_end = extents_.location_end(rest);
        return spaced_literal(rest_end[-1] == '*' ? TokenKind::incomplete_location : kind, begin,
                              rest_end, gaps_of({gap}));
    }
    // `%IX 1.0`: only behind what is a complete prefix, for digits to follow.
    if (!letters.empty() && letters.size() <= 2 && is_digit(*rest) &&
        std::ranges::all_of(letters, is_word_start))
        return spaced_literal(kind, begin, extents_.address_end(rest), gaps_of({gap}));
    return literal(kind, begin, end);
}

// ---- delimiters that need a look around --------------------------------------------------------

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

const char* Lexer::stray_comment_end(const char* begin) {
    const TextRange where = range(begin, begin + 2);
    add_replacement(report(DiagnosticId::stray_comment_end, where), where);
    emit(TokenKind::unknown, begin, begin + 2, true);
    return begin + 2;
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

// ---- comments and pragmas ----------------------------------------------------------------------

// The line end at or behind `begin`, or the end of the text. Places asked for must grow.
const char* Lexer::line_end(const char* begin) {
    // A line may be the whole of a file, and have many comments.
    if (line_begin_ <= begin && begin <= line_end_)
        return line_end_;
    const auto find = [](const char* first, const char* last, char c) {
        const void* const found = std::memchr(first, c, static_cast<std::size_t>(last - first));
        return found != nullptr ? static_cast<const char*>(found) : last;
    };
    // Looked up once for a text whose lines end in CR only.
    if (line_feed_ < begin || line_feed_ == begin_)
        line_feed_ = find(begin, end_, '\n');
    line_begin_ = begin;
    return line_end_ = find(begin, line_feed_, '\r');
}

void Lexer::note_open_end(const char* begin, const char* last) {
    result_.open_ends.push_back({offset(begin), offset(last) + 1});
}

// Reports what nothing closes, at its opening, and gives it its first line: so the rest of the file
// is still read.
const char* Lexer::end_of_first_line(const char* begin, DiagnosticId fault,
                                     std::string_view opening, std::string_view closing) {
    report(fault, range(begin, begin + opening.size()))
        .arguments.emplace_back(std::string(closing));
    note_open_end(begin, end_);
    return line_end(begin);
}

namespace {

// True for words that structure a program: a line with one of them is no prose.
[[nodiscard]] bool is_word_of_structure(std::string_view word, TokenKind kind) noexcept {
    static constexpr std::array openers{TokenKind::kw_type,           TokenKind::kw_function,
                                        TokenKind::kw_function_block, TokenKind::kw_program,
                                        TokenKind::kw_configuration,  TokenKind::kw_resource};
    const std::string_view closing = "END_";
    const std::string_view block = "VAR";
    return names_equal(word.substr(0, closing.size()), closing) ||
           names_equal(word.substr(0, block.size()), block) ||
           std::ranges::find(openers, kind) != openers.end();
}

// `Author: somebody`. Behind a label of code stands an operator, mostly in capitals, or a
// statement.
[[nodiscard]] bool is_entry_of_head(std::string_view line) noexcept {
    const auto take_word = [&line] {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        const auto end = std::ranges::find_if_not(line, is_word_part);
        const auto word = line.substr(0, static_cast<std::size_t>(end - line.begin()));
        line.remove_prefix(word.size());
        return word;
    };
    const bool ends_statement = line.find(';') != line.npos;
    const std::string_view entry = take_word();
    const std::size_t colon = line.find_first_not_of(" \t");
    if (ends_statement || entry.empty() || is_digit(entry.front()) ||
        keyword_kind(entry) == TokenKind::kw_else || colon == line.npos || line[colon] != ':')
        return false;
    line.remove_prefix(colon + 1);
    const std::string_view word = take_word();
    const auto is_small = [](char c) { return fold(c) != c || is_digit(c); };
    return keyword_kind(word) == TokenKind::identifier && std::ranges::any_of(word, is_small);
}

// A rule of dashes, or an empty line, which prose may go on behind.
[[nodiscard]] bool has_no_words(std::string_view line) noexcept {
    constexpr std::string_view code = ";'\"(){}/";
    return std::ranges::none_of(line, [code](char c) {
        return is_word_part(c) || !is_ascii(c) || code.find(c) != code.npos;
    });
}

// True when the line has three words in a row that are no keywords, or two of which the first is
// too long for an operator of Instruction List: so is prose, and so is hardly any code.
[[nodiscard]] bool looks_like_prose(std::string_view line) noexcept {
    constexpr std::size_t longest_operator = 5; // JMPCN
    for (const std::string_view mark : {":=", "=>", "(*", "/*", "//"})
        if (line.find(mark) != std::string_view::npos)
            return false;
    if (is_entry_of_head(line))
        return true;
    std::size_t words = 0; // in a row
    bool first_is_long = false;
    bool prose = false;
    for (std::size_t i = 0; i < line.size();) {
        if (!is_word_part(line[i]) && is_ascii(line[i])) {
            words = line[i] == ' ' || line[i] == '\t' ? words : 0;
            ++i;
            continue;
        }
        const std::size_t begin = i;
        while (i < line.size() && (is_word_part(line[i]) || !is_ascii(line[i])))
            ++i;
        const std::string_view word = line.substr(begin, i - begin);
        const TokenKind kind = keyword_kind(word);
        if (is_word_of_structure(word, kind))
            return false;
        const bool plain =
            is_digit(word.front()) ? words > 0 : kind == TokenKind::identifier; // `Version 1.2`
        words = plain ? words + 1 : 0;
        first_is_long = words == 1 ? word.size() > longest_operator : first_is_long;
        prose = prose || words == 3 || (words == 2 && first_is_long);
    }
    return prose;
}

// True when some line of the stretch ends in `;`, or is a closing word, as in code and not in
// prose.
[[nodiscard]] bool looks_like_code(std::string_view stretch) noexcept {
    for (std::size_t at = 0; (at = stretch.find("END_", at)) != std::string_view::npos;) {
        const std::size_t before = stretch.substr(0, at).find_last_not_of(" \t");
        const std::size_t behind = stretch.find_first_of(" \t;\r\n", at);
        const std::size_t next = stretch.find_first_not_of(" \t;", behind);
        const bool first =
            before == std::string_view::npos || stretch[before] == '\n' || stretch[before] == '\r';
        const bool last =
            next == std::string_view::npos || stretch[next] == '\n' || stretch[next] == '\r';
        if (first && last && keyword_kind(stretch.substr(at, behind - at)) != TokenKind::identifier)
            return true;
        at = behind; // another one in the same word begins no word
    }
    for (std::size_t at = stretch.find(';'); at != std::string_view::npos;
         at = stretch.find(';', at + 1)) {
        const std::size_t next = stretch.find_first_not_of(" \t", at + 1);
        if (next == std::string_view::npos || stretch[next] == '\n' || stretch[next] == '\r')
            return true;
    }
    return false;
}

// `FUNCTION f : INT`, `PROGRAM p`, `TYPE`: nothing but the head of a library element.
[[nodiscard]] bool is_head(std::string_view line) noexcept {
    const auto skip_blanks = [&line] {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    };
    const auto take_word = [&] {
        skip_blanks();
        const auto end = std::ranges::find_if_not(line, is_word_part);
        const auto word = line.substr(0, static_cast<std::size_t>(end - line.begin()));
        line.remove_prefix(word.size());
        skip_blanks();
        return word;
    };
    const auto begins_with = [&line](std::string_view mark) { return line.starts_with(mark); };
    static constexpr std::array marks{":", ";", "(*", "//", "VAR"};
    switch (keyword_kind(take_word())) {
    case TokenKind::kw_type:
        return line.empty() || begins_with("(*") || (!take_word().empty() && begins_with(":"));
    case TokenKind::kw_function:
    case TokenKind::kw_function_block:
    case TokenKind::kw_program:
    case TokenKind::kw_configuration: {
        const std::string_view name = take_word();
        return !name.empty() && keyword_kind(name) == TokenKind::identifier &&
               (line.empty() || std::ranges::any_of(marks, begins_with));
    }
    default: return false;
    }
}

// How much of the lines in `rest` stands before the head of a library element, when none of it
// looks like code or opens a comment; npos otherwise. So no line is looked at for two comments.
[[nodiscard]] std::size_t size_of_prose_before_head(std::string_view rest) noexcept {
    std::size_t size = 0;
    std::size_t at = 0;
    while (at < rest.size()) {
        const std::size_t end = std::min(rest.find_first_of("\r\n", at), rest.size());
        const std::string_view line = rest.substr(at, end - at);
        if (is_head(line))
            return size;
        for (const std::string_view mark : {":=", "(*", "/*"})
            if (line.find(mark) != line.npos)
                return std::string_view::npos;
        if (looks_like_code(line))
            return std::string_view::npos;
        size = line.find_first_not_of(" \t") != line.npos ? end : size;
        at = end + 1;
    }
    return std::string_view::npos;
}

} // namespace

// The same for a comment, which also gets the lines of prose that follow.
const char* Lexer::end_of_prose(const char* begin, std::string_view opening,
                                std::string_view closing) {
    const char* end =
        end_of_first_line(begin, DiagnosticId::unterminated_comment, opening, closing);
    const std::size_t before_head = size_of_prose_before_head(view(end, end_));
    if (before_head != std::string_view::npos)
        return end + before_head;
    const char* line_feed = line_feed_;
    for (const char* p = end; p != end_;) {
        const char* const line = p + (p[0] == '\r' && p[1] == '\n' ? 2 : 1);
        p = line_end(line);
        if (looks_like_prose(view(line, p))) {
            end = p;
            line_feed = line_feed_;
        } else if (!has_no_words(view(line, p))) {
            break;
        }
    }
    line_feed_ = line_feed; // what follows is read from `end` on
    return end;
}

namespace {

// The first `(*` in the stretch; null when there is none.
[[nodiscard]] const char* find_comment_begin(const char* begin, const char* end) noexcept {
    for (const char* p = begin; p + 1 < end; ++p) {
        p = static_cast<const char*>(std::memchr(p, '(', static_cast<std::size_t>(end - 1 - p)));
        if (p == nullptr)
            return nullptr;
        if (p[1] == '*')
            return p;
    }
    return nullptr;
}

} // namespace

// The `)` of the first `*)` from `begin` on; null when there is none. Places asked for must grow.
const char* Lexer::find_comment_end(const char* begin) {
    if (comment_end_ != nullptr && begin < comment_end_)
        return comment_end_;
    for (const char* p = begin; p < end_;) {
        p = static_cast<const char*>(std::memchr(p, '*', static_cast<std::size_t>(end_ - p)));
        if (p == nullptr)
            break;
        while (*p == '*')
            ++p;
        if (*p == ')')
            return comment_end_ = p;
    }
    return nullptr;
}

// A `(`, or `( *` where a comment begins that a `*)` ends and no other one.
const char* Lexer::left_parenthesis(const char* begin) {
    const char* const blanks = begin + 1;
    const char* const star = Extents::blanks_end(blanks);
    if (star == blanks || *star != '*' || star[1] == ')')
        return delimiter(TokenKind::left_parenthesis, begin, 1);
    constexpr std::ptrdiff_t furthest = 2000; // bounds the time that many of them take
    const char* closing = nullptr;
    if (star < comment_end_missing_from_)
        closing = find_comment_end(star + 1);
    if (closing == nullptr)
        comment_end_missing_from_ = std::min(comment_end_missing_from_, star);
    if (closing == nullptr || closing - star > furthest ||
        find_comment_begin(star, closing) != nullptr) {
        const bool far = closing == nullptr || closing - star > furthest;
        note_open_end(begin, far ? star + std::min(furthest, end_ - star) : closing);
        return delimiter(TokenKind::left_parenthesis, begin, 1);
    }
    report_gap(range(blanks, star), "(*");
    add_trivia(TriviaKind::comment, begin, closing + 1);
    return closing + 1;
}

const char* Lexer::comment(const char* begin) {
    const char* closing = nullptr;
    if (begin + 2 < comment_end_missing_from_)
        closing = find_comment_end(begin + 2);
    const char* end = nullptr;
    if (closing == nullptr) {
        comment_end_missing_from_ = std::min(comment_end_missing_from_, begin + 2);
        end = end_of_prose(begin, "(*", "*)");
    } else {
        const char* const inner = find_comment_begin(begin + 2, closing);
        end = inner == nullptr ? closing + 1 : end_of_nested_comment(begin, inner, closing);
    }
    add_trivia(TriviaKind::comment, begin, end);
    return end;
}

// When a comment that holds another opening nests in balance, all of it was meant as comment.
// Otherwise it ends at its first `*)`, as the standard has it; but when there is code before the
// inner opening, it is the outer comment that lacks its end.
const char* Lexer::end_of_nested_comment(const char* begin, const char* inner,
                                         const char* closing) {
    if (!marks_.built())
        marks_.build(text_, offset(begin));
    const auto balanced_end = marks_.balanced_end(offset(begin));
    const char* const first_line_end = line_end(begin);
    const bool code_follows =
        first_line_end < inner &&
        (looks_like_code(view(first_line_end, inner)) ||
         size_of_prose_before_head(view(first_line_end, inner)) != std::string_view::npos);
    if (!balanced_end && code_follows)
        return end_of_prose(begin, "(*", "*)");
    report(DiagnosticId::nested_comment, range(inner, inner + 2))
        .labels.push_back({range(begin, begin + 2), LabelId::comment_begin, {}});
    if (balanced_end)
        return begin_ + *balanced_end;
    note_open_end(begin, end_);
    return closing + 1;
}

const char* Lexer::line_comment(const char* begin) {
    const char* const end = line_end(begin);
    report(DiagnosticId::line_comment, range(begin, end));
    add_trivia(TriviaKind::line_comment, begin, end);
    return end;
}

const char* Lexer::c_comment(const char* begin) {
    std::size_t closing = std::string_view::npos;
    if (begin + 2 < c_comment_end_missing_from_)
        closing = text_.find("*/", offset(begin) + std::size_t{2});
    const char* end = nullptr;
    if (closing == std::string_view::npos) {
        c_comment_end_missing_from_ = std::min(c_comment_end_missing_from_, begin + 2);
        end = end_of_prose(begin, "/*", "*/");
    } else {
        end = begin_ + closing + 2;
        report(DiagnosticId::c_comment, range(begin, end));
    }
    add_trivia(TriviaKind::c_comment, begin, end);
    return end;
}

// The end of `{1, {2}}` where a value belongs: in the lists of other languages braces nest. Null
// for anything else in braces.
const char* Lexer::end_of_nested_braces(const char* begin) {
    constexpr std::size_t furthest = 1000; // bounds the time that many of them take
    if (!has_tokens() || last_token().kind() != TokenKind::assign)
        return nullptr;
    const std::string_view rest = text_.substr(offset(begin), furthest);
    std::size_t depth = 0;
    bool nested = false;
    std::size_t i = 0;
    for (; i < rest.size() && rest[i] != ';'; ++i) {
        depth += rest[i] == '{' ? 1 : 0;
        nested = nested || depth > 1;
        if (rest[i] == '}' && --depth == 0)
            break;
    }
    const bool closed = i < rest.size() && rest[i] == '}';
    if (closed && nested && ends_operand_at(begin + i + 1))
        return begin + i + 1;
    if (nested) // text behind the unit may close it
        note_open_end(begin, closed ? Extents::blanks_end(begin + i + 1) : begin + i);
    return nullptr;
}

const char* Lexer::pragma(const char* begin) {
    std::size_t closing = std::string_view::npos;
    if (begin < pragma_end_missing_from_)
        closing = text_.find('}', offset(begin));
    const char* end = nullptr;
    if (closing == std::string_view::npos) {
        pragma_end_missing_from_ = std::min(pragma_end_missing_from_, begin);
        end = end_of_first_line(begin, DiagnosticId::unterminated_pragma, "{", "}");
    } else {
        const char* const nested_end = end_of_nested_braces(begin);
        end = nested_end != nullptr ? nested_end : begin_ + closing + 1;
        report(DiagnosticId::pragma, range(begin, end));
    }
    add_trivia(TriviaKind::pragma, begin, end);
    return end;
}

const char* Lexer::stray_pragma_end(const char* begin) {
    const TextRange where = range(begin, begin + 1);
    add_replacement(report(DiagnosticId::stray_pragma_end, where), where);
    emit(TokenKind::unknown, begin, begin + 1, true);
    return begin + 1;
}

// ---- characters --------------------------------------------------------------------------------

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

LexedText lex(std::string_view text, Encoding encoding, bool at_file_start) {
    Lexer lexer(text, encoding, at_file_start);
    lexer.read(std::numeric_limits<std::size_t>::max());
    return lexer.take();
}

} // namespace iecfront
