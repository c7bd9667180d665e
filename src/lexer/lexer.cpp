#include "lexer/lexer.hpp"

#include "diagnostics/sort_by_place.hpp"
#include "lexer/characters.hpp"
#include "lexer/keywords.hpp"
#include "lexer/plain_literals.hpp"
#include "lexer/word_shape.hpp"
#include "source/byte_mask.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace iecfront {

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

// True where a word goes on with a `#` or a character beyond ASCII.
bool Lexer::word_goes_on(const char* end) noexcept {
    return (word_bits_of(*end) & characters::word_joins) != 0;
}

// True for digits that may not be all of a number, or too many to be sure that nothing is wrong.
bool Lexer::number_goes_on(const char* begin, const char* end) noexcept {
    return (word_bits_of(*end) & characters::number_goes_on) != 0 ||
           view(begin, end).size() > safe_digits;
}

namespace {

// What most tokens are: told by their first characters alone.
struct Piece {
    TokenKind kind;
    std::size_t size;
};

// The longer delimiter when `second` follows, else the shorter one.
[[nodiscard]] Piece either(const char* begin, char second, TokenKind longer, TokenKind shorter) {
    return begin[1] == second ? Piece{longer, 2} : Piece{shorter, 1};
}

// How many blanks stand at `begin`, as far as one look tells.
[[nodiscard]] std::ptrdiff_t size_of_indentation(const char* begin, const char* text_end) {
    constexpr std::ptrdiff_t glance = mask_size;
    return text_end - begin < glance ? 0 : std::countr_one(mask_of(begin, ' '));
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
            p += size_of_indentation(p, end_);
            continue;
        case CharacterClass::word:
            [[likely]] {
                static_assert(words::head_size == keywords::head_size);
                const WordShape shape = shape_of_word(p, end_);
                const std::string_view text = view(p, shape.end);
                if (shape.odd || word_goes_on(shape.end)) [[unlikely]] {
                    p = odd_word(p);
                    continue;
                }
                piece = {keyword_kind(text, shape.head), text.size()};
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
            piece = {TokenKind::integer, static_cast<std::size_t>(end - p)};
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
        if (*p == ' ') // mostly: where the branch is foreseen, nobody waits for the byte
            ++p;
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

LexedText lex(std::string_view text, Encoding encoding, bool at_file_start) {
    Lexer lexer(text, encoding, at_file_start);
    lexer.read(std::numeric_limits<std::size_t>::max());
    return lexer.take();
}

} // namespace iecfront
