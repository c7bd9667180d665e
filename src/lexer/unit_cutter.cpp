#include "lexer/unit_cutter.hpp"

#include "lexer/block_words.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace iecfront {

namespace {

// What a word means to the cutter.
enum class Role : std::uint8_t {
    none,
    opener,           // of a library element
    closer,           // of a library element
    variables,        // opens a block of variables
    global_variables, // the same, and outside everything else a unit of its own (an extension)
    variables_end,
    end, // closes something smaller
};

[[nodiscard]] consteval std::array<Role, token_kind_count> role_table() {
    std::array<Role, token_kind_count> table{};
    const auto set = [&table](TokenKind kind, Role role) {
        table[static_cast<std::size_t>(kind)] = role;
    };
    for (const BlockWords& words : block_pairs) {
        const bool element = is_library_element(words);
        const bool variables = words.closer == TokenKind::kw_end_var;
        set(words.opener, element ? Role::opener : variables ? Role::variables : Role::none);
        set(words.closer, element ? Role::closer : Role::end);
    }
    set(TokenKind::kw_var_global, Role::global_variables);
    set(TokenKind::kw_end_var, Role::variables_end);
    return table;
}

constexpr std::array<Role, token_kind_count> roles = role_table();

[[nodiscard]] constexpr Role role_of(TokenKind kind) noexcept {
    return roles[static_cast<std::size_t>(kind)];
}

// True for what can be the name of a library element, or a keyword wrongly used for one.
[[nodiscard]] constexpr bool can_be_name(TokenKind kind) noexcept {
    return kind == TokenKind::identifier || (is_keyword(kind) && role_of(kind) == Role::none);
}

// True at what a library element begins with, and at the end.
[[nodiscard]] bool begins_unit(Token token) noexcept {
    const Role role = role_of(token.kind());
    return role == Role::opener || role == Role::global_variables ||
           token.kind() == TokenKind::end_of_unit;
}

[[nodiscard]] bool closes(TokenKind closer, TokenKind opener) noexcept {
    return std::ranges::any_of(block_pairs, [=](const BlockWords& words) {
        return words.opener == opener && words.closer == closer;
    });
}

[[nodiscard]] bool can_follow_name(TokenKind opener, Token token) noexcept {
    if (token.kind() == TokenKind::colon)
        return opener == TokenKind::kw_function;
    if (token.kind() == TokenKind::kw_with) // `PROGRAM p WITH t : q;` of a configuration
        return false;
    return token.first_on_line() || !is_delimiter(token.kind()) ||
           token.kind() == TokenKind::semicolon;
}

// The closing word of the block that a word opens or closes; end_of_unit for all other tokens.
[[nodiscard]] consteval std::array<TokenKind, token_kind_count> closer_table() {
    std::array<TokenKind, token_kind_count> table{};
    table.fill(TokenKind::end_of_unit);
    for (const BlockWords& words : block_pairs) {
        table[static_cast<std::size_t>(words.opener)] = words.closer;
        table[static_cast<std::size_t>(words.closer)] = words.closer;
    }
    return table;
}

constexpr std::array<TokenKind, token_kind_count> closers = closer_table();

[[nodiscard]] constexpr TokenKind closer_of(TokenKind kind) noexcept {
    return closers[static_cast<std::size_t>(kind)];
}

constexpr auto block_words = [] {
    std::array<bool, token_kind_count> table{};
    for (std::size_t kind = 0; kind < table.size(); ++kind)
        table[kind] = closers[kind] != TokenKind::end_of_unit;
    return table;
}();

[[nodiscard]] constexpr bool is_block_word(Token token) noexcept {
    return block_words[static_cast<std::size_t>(token.kind())];
}

// Tokens that are looked at together.
constexpr std::size_t stretch = std::numeric_limits<std::uint64_t>::digits;

// Which of some tokens, at most `stretch`, open or close a block: the lowest bit is the first.
// Eight of them in one go, so that compilers know by how much to shift.
[[nodiscard]] std::uint64_t block_words_in(std::span<const Token> tokens) noexcept {
    constexpr std::size_t step = 8;
    std::uint64_t words = 0;
    std::size_t at = 0;
    for (; tokens.size() - at >= step; at += step) {
        std::uint64_t some = 0;
        for (std::size_t i = 0; i < step; ++i)
            some |= std::uint64_t{is_block_word(tokens[at + i])} << i;
        words |= some << at;
    }
    for (; at < tokens.size(); ++at)
        words |= std::uint64_t{is_block_word(tokens[at])} << at;
    return words;
}

} // namespace

std::optional<UnitCut> UnitCutter::next(std::span<const Token> tokens, bool complete) {
    tokens_ = tokens;
    const std::size_t count = tokens.size() - (complete ? 1 : 0);
    const std::size_t end = complete ? count : count - std::min(count, cutter_lookahead);
    cut_.reset();
    while (at_ < end && !cut_)
        if (!look_at(tokens.subspan(at_, std::min(stretch, end - at_)), complete))
            return std::nullopt;
    if (!cut_ && complete && (unit_begin_ < count || !cut_any_))
        cut_before(count);
    return cut_;
}

// Goes on behind `some` tokens, the next ones, or behind the first one that makes a cut. False when
// it has to wait for more at a closing word.
bool UnitCutter::look_at(std::span<const Token> some, bool complete) {
    const std::size_t begin = at_;
    at_ += some.size();
    for (std::uint64_t words = block_words_in(some); words != 0; words &= words - 1) {
        const std::size_t i = begin + static_cast<std::size_t>(std::countr_zero(words));
        const Role role = role_of(tokens_[i].kind());
        const bool may_close = role == Role::closer || role == Role::variables_end;
        if (may_close && !complete && !sees_semicolons(i)) {
            at_ = i;
            return false;
        }
        see(i);
        if (cut_) {
            at_ = i + 1;
            return true;
        }
    }
    return true;
}

// True when the row goes on far enough behind the `;` that follow a closing word.
bool UnitCutter::sees_semicolons(std::size_t closer) const noexcept {
    const auto is_semicolon = [](Token token) { return token.kind() == TokenKind::semicolon; };
    const auto behind = std::find_if_not(tokens_.begin() + static_cast<std::ptrdiff_t>(closer) + 2,
                                         tokens_.end(), is_semicolon);
    return static_cast<std::size_t>(tokens_.end() - behind) >= cutter_lookahead / 2;
}

void UnitCutter::drop(std::size_t count) noexcept {
    at_ = std::max(at_, count) - count; // it cuts behind `;` that it has not come to
    unit_begin_ -= count;
    opener_ -= std::min(opener_, count); // of no use when nothing is open
}

// A closing word is of the unit that it ends, an opening word of the one that it begins.
void UnitCutter::see(std::size_t i) {
    const TokenKind kind = tokens_[i].kind();
    const TokenKind closer = closer_of(kind);
    if (kind == closer)
        --unclosed_[static_cast<std::size_t>(closer)];
    find_cut(i);
    if (kind != closer)
        ++unclosed_[static_cast<std::size_t>(closer)];
}

void UnitCutter::find_cut(std::size_t i) {
    const TokenKind kind = tokens_[i].kind();
    const bool nothing_open = open_ == TokenKind::end_of_unit;
    switch (role_of(kind)) {
    case Role::closer: close(i); break;
    case Role::variables: variables_open_ = !nothing_open; break;
    case Role::variables_end:
        variables_open_ = false;
        if (open_ == TokenKind::kw_var_global)
            close(i);
        break;
    case Role::global_variables:
        variables_open_ = !nothing_open;
        if (nothing_open && !is_misused_name(i)) {
            open(i);
            if (follows_unknown_head(i)) {
                open_ = TokenKind::kw_configuration;
                variables_open_ = true;
            }
        }
        break;
    case Role::opener:
        if (nothing_open ? !opens_declaration(i) : !is_declaration_head(i))
            break;
        if (!nothing_open)
            cut_before(i);
        open(i);
        break;
    default: break;
    }
}

void UnitCutter::open(std::size_t i) {
    open_ = tokens_[i].kind();
    opener_ = i;
}

// Any closing word ends what is open, or what was left over before it. Whether it is the right one
// is the parser's to say. But in a block of variables, that of another declaration is taken for
// END_VAR.
void UnitCutter::close(std::size_t i) {
    if (variables_open_ && !closes(tokens_[i].kind(), open_)) {
        variables_open_ = false;
        return;
    }
    if (is_stray_closer(i))
        return;
    if (is_in_two_words(i))
        ++i;
    ++i;
    if (!begins_stray_text(i))
        while (at(i).kind() == TokenKind::semicolon)
            ++i;
    cut_before(i);
}

// `END_TYPE : INT;`, `b : END_TYPE INT;` and `b : INT := END_TYPE;`: what stands around it in its
// line goes on.
bool UnitCutter::is_stray_closer(std::size_t i) const noexcept {
    const Token next = at(i + 1);
    if (next.first_on_line() || begins_unit(next) || is_in_two_words(i))
        return false;
    if (is_delimiter(next.kind()) && next.kind() != TokenKind::semicolon)
        return !at(i + 2).first_on_line() && !begins_unit(at(i + 2));
    const bool behind_name = open_ != TokenKind::end_of_unit && i == opener_ + 2;
    if (i == unit_begin_ || tokens_[i].first_on_line() || behind_name)
        return false;
    const TokenKind before = tokens_[i - 1].kind();
    const Role role = role_of(before);
    if (next.kind() == TokenKind::semicolon)
        return is_delimiter(before) && before != TokenKind::semicolon &&
               before != TokenKind::right_parenthesis && !begins_unit(at(i + 2));
    return before != TokenKind::semicolon && role != Role::end && role != Role::variables_end;
}

// True at a `;` on a line of its own that neither a declaration nor the end follows: it stands in
// what is left of a declaration without its opening word.
bool UnitCutter::begins_stray_text(std::size_t i) const noexcept {
    const Token next = at(i + 1);
    return at(i).kind() == TokenKind::semicolon && at(i).first_on_line() &&
           next.kind() != TokenKind::semicolon && !begins_unit(next);
}

// `END_FUNCTION BLOCK`, with nothing else behind it in its line.
bool UnitCutter::is_in_two_words(std::size_t i) const noexcept {
    const Token third = at(i + 2);
    return tokens_[i].kind() == TokenKind::kw_end_function &&
           at(i + 1).kind() == TokenKind::identifier && !at(i + 1).first_on_line() &&
           (third.first_on_line() || third.kind() == TokenKind::semicolon ||
            third.kind() == TokenKind::end_of_unit);
}

void UnitCutter::cut_before(std::size_t i) {
    const std::size_t opener = open_ == TokenKind::end_of_unit ? i : opener_;
    bool balanced = true;
    for (const BlockWords& words : block_pairs)
        balanced =
            std::exchange(unclosed_[static_cast<std::size_t>(words.closer)], 0) == 0 && balanced;
    cut_ = UnitCut{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(opener), balanced};
    cut_any_ = true;
    unit_begin_ = i;
    open_ = TokenKind::end_of_unit;
    variables_open_ = false;
}

// `TYPE : INT;`, `step.TYPE := 1`, `f(PROGRAM, 1)`: no declaration goes on like this.
bool UnitCutter::is_misused_name(std::size_t i) const noexcept {
    return is_delimiter(at(i + 1).kind());
}

// `CONFIGURATON name` before global variables: it is open until it is closed, or another one
// begins.
bool UnitCutter::follows_unknown_head(std::size_t i) const noexcept {
    return i == unit_begin_ + 2 && at(i - 2).kind() == TokenKind::identifier &&
           at(i - 1).kind() == TokenKind::identifier && !at(i - 1).first_on_line();
}

// While nothing is open, an opener begins a declaration. Behind text that belongs to nothing, which
// can be prose that has such words in it, it must be a head; one word before it is passed over.
bool UnitCutter::opens_declaration(std::size_t i) const noexcept {
    if (is_misused_name(i))
        return false;
    const bool behind_one_word = i == unit_begin_ + 1;
    return i == unit_begin_ ||
           ((behind_one_word || begins_declaration(i)) && goes_on_as_head(i) && !is_prose(i));
}

// `PROGRAM that does`: what follows the name begins no statement. FUNCTION_BLOCK is no word of
// prose.
bool UnitCutter::is_prose(std::size_t i) const noexcept {
    const Token second = at(i + 2);
    const Token third = at(i + 3);
    return tokens_[i].kind() != TokenKind::kw_type &&
           tokens_[i].kind() != TokenKind::kw_function_block &&
           second.kind() == TokenKind::identifier && !second.first_on_line() &&
           third.kind() != TokenKind::assign && third.kind() != TokenKind::left_parenthesis;
}

// While something is open, an opener begins a new unit (and leaves the old one unclosed) only where
// it is the head of a declaration and nothing else.
bool UnitCutter::is_declaration_head(std::size_t i) const noexcept {
    const TokenKind opener = tokens_[i].kind();
    if (is_misused_name(i) || !begins_declaration(i))
        return false;
    if (opener == TokenKind::kw_program && open_ == TokenKind::kw_configuration &&
        is_program_configuration(i))
        return false;
    return goes_on_as_head(i);
}

// True when the opener is followed by a name, and that by what can follow it.
bool UnitCutter::goes_on_as_head(std::size_t i) const noexcept {
    const TokenKind opener = tokens_[i].kind();
    const Token name = at(i + 1);
    if (opener == TokenKind::kw_type) // the name may stand on the next line
        return name.kind() == TokenKind::kw_end_type ||
               (can_be_name(name.kind()) && at(i + 2).kind() == TokenKind::colon);
    return can_be_name(name.kind()) && !name.first_on_line() && can_follow_name(opener, at(i + 2));
}

bool UnitCutter::begins_declaration(std::size_t i) const noexcept {
    if (tokens_[i].first_on_line())
        return true;
    // The first token is first on its line. One word before it may be a misspelt closing word, but
    // not `END_`, of which the opener itself is the rest.
    const bool word = i > unit_begin_ + 1 && tokens_[i - 1].kind() == TokenKind::identifier &&
                      !tokens_[i - 1].malformed() &&
                      tokens_[i].kind() != TokenKind::kw_type; // which could be a name
    const TokenKind before = tokens_[i - (word ? 2 : 1)].kind();
    return before == TokenKind::semicolon || role_of(before) == Role::closer ||
           role_of(before) == Role::variables_end || role_of(before) == Role::end;
}

// PROGRAM may stand inside a configuration: `PROGRAM [RETAIN | NON_RETAIN] name [WITH task] : type`
// (B.1.7). That one goes on in its line, and with no block of variables.
bool UnitCutter::is_program_configuration(std::size_t i) const noexcept {
    const TokenKind qualifier = at(i + 1).kind();
    if (qualifier == TokenKind::kw_retain || qualifier == TokenKind::kw_non_retain)
        ++i;
    const Token next = at(i + 2);
    if (next.kind() == TokenKind::colon || next.kind() == TokenKind::kw_with)
        return true;
    const Role role = role_of(next.kind());
    return !next.first_on_line() && role != Role::variables && role != Role::global_variables;
}

std::vector<UnitCut> cut_units(std::span<const Token> tokens) {
    UnitCutter cutter;
    std::vector<UnitCut> cuts;
    while (const std::optional<UnitCut> cut = cutter.next(tokens, true))
        cuts.push_back(*cut);
    return cuts;
}

} // namespace iecfront
