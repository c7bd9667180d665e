#include "lexer/block_words.hpp"
#include "lexer/keywords.hpp"
#include "lexer/lexer.hpp"
#include "lexer/lookahead.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace iecfront {

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

namespace {

template<std::size_t Size>
[[nodiscard]] bool holds(const std::array<TokenKind, Size>& kinds, TokenKind kind) noexcept {
    return std::ranges::find(kinds, kind) != kinds.end();
}

// Units begin with these, or end behind them; global variables outside of everything are one, too.
// What is put together from several tokens holds none, so that no unit depends on another one.
[[nodiscard]] bool parts_units(TokenKind kind) noexcept {
    return std::ranges::any_of(block_pairs, [kind](const BlockWords& words) {
        return (is_library_element(words) || words.opener == TokenKind::kw_var_global) &&
               (words.opener == kind || words.closer == kind);
    });
}

// True when the line of token `at` begins in the row, and no unit before `at` on it: a `;` at its
// begin may go with a unit that ends on the line before.
[[nodiscard]] bool is_line_of_one_unit(std::span<const Token> row, std::size_t at) noexcept {
    while (!row[at].first_on_line() && at > 0 && !parts_units(row[at - 1].kind()))
        --at;
    return row[at].first_on_line() && row[at].kind() != TokenKind::semicolon;
}

// True at a `(`, token `at`, that is first on its line, when no expression goes on with it.
[[nodiscard]] bool begins_line_as_comment(std::span<const Token> row, std::size_t at) noexcept {
    using enum TokenKind;
    constexpr std::array before_expression = {kw_if, kw_elsif, kw_while, kw_until, kw_case, kw_to,
                                              kw_by, kw_and,   kw_or,    kw_xor,   kw_mod,  kw_not};
    constexpr std::array before_name = {kw_program, kw_function_block, kw_configuration,
                                        kw_end_function};
    if (at == 0) // behind what ends a unit
        return true;
    const TokenKind before = row[at - 1].kind();
    if (before == identifier) { // `PROGRAM p`, `END_FUNCTION BLOCK`, `LD a`
        if (at < 2 || row[at - 1].first_on_line())
            return false;
        const TokenKind first = row[at - 2].kind();
        return holds(before_name, first) ||
               (first == identifier && is_line_of_one_unit(row, at - 1));
    }
    return before == semicolon || (is_keyword(before) && !holds(before_expression, before));
}

// The same at one inside a line, which ends there: it stands behind a statement, a declaration or a
// word that neither a name nor an expression follows.
[[nodiscard]] bool ends_line_as_comment(std::span<const Token> row, std::size_t at) noexcept {
    using enum TokenKind;
    constexpr std::array heads = {kw_then,     kw_else,       kw_do,         kw_of,
                                  kw_repeat,   kw_struct,     kw_var,        kw_var_input,
                                  kw_var_temp, kw_var_output, kw_var_in_out, kw_var_external,
                                  kw_constant, kw_retain,     kw_end_if,     kw_end_case,
                                  kw_end_for,  kw_end_while,  kw_end_repeat, kw_end_struct};
    if (at >= 1 && holds(heads, row[at - 1].kind()))
        return true;
    if (at < 2 || row[at - 1].kind() != semicolon || row[at - 1].first_on_line() ||
        row[at - 2].kind() == semicolon)
        return false;
    // It could be all of the name of a unit that ends there: `END_FUNCTION BLOCK;`.
    const bool name = row[at - 2].kind() == identifier && row[at - 2].first_on_line();
    return !name && is_line_of_one_unit(row, at);
}

} // namespace

// The `(` on this line with which a comment is meant to begin that ends at `end`, though its `*` is
// missing. Inside a line it is the last on it: a comment before something goes with what follows,
// which can be another unit.
std::optional<Token> Lexer::comment_begin_without_star(const char* end) const {
    constexpr std::size_t furthest = 100; // bounds the time that many of them take
    if (first_on_line_)
        return std::nullopt;
    const std::span<const Token> row(result_.tokens.data(), token_count());
    const char* const behind = Extents::blanks_end(end);
    const bool last = behind == end_ || class_of(*behind) == CharacterClass::line_end;
    std::size_t closed = 0; // parentheses
    for (std::size_t at = row.size(); at > 0 && row.size() - at < furthest;) {
        const Token token = row[--at];
        if (parts_units(token.kind()))
            return std::nullopt;
        closed += token.kind() == TokenKind::right_parenthesis ? 1 : 0;
        const bool opens = token.kind() == TokenKind::left_parenthesis;
        if (opens && (token.first_on_line() ? begins_line_as_comment(row, at)
                                            : last && ends_line_as_comment(row, at))) {
            const bool other_behind =
                !result_.trivia.empty() && result_.trivia.back().range.begin > token.offset();
            return other_behind ? std::nullopt : std::optional(token);
        }
        if (token.first_on_line() || (opens && closed == 0))
            return std::nullopt;
        closed -= opens ? 1 : 0;
    }
    return std::nullopt;
}

const char* Lexer::stray_comment_end(const char* begin) {
    const TextRange where = range(begin, begin + 2);
    const char* const end = begin + 2;
    const std::optional<Token> opening = comment_begin_without_star(end);
    if (!opening) {
        add_replacement(report(DiagnosticId::stray_comment_end, where), where);
        emit(TokenKind::unknown, begin, end, true);
        return end;
    }
    const TextRange parenthesis = opening->range();
    while (last_token().offset() != parenthesis.begin)
        take_back();
    take_back();
    while (!result_.diagnostics.empty() &&
           result_.diagnostics.back().range.begin >= parenthesis.begin)
        result_.diagnostics.pop_back();
    add_replacement(report(DiagnosticId::comment_without_star, parenthesis),
                    {parenthesis.end, parenthesis.end}, "*");
    add_trivia(TriviaKind::comment, begin_ + parenthesis.begin, end);
    return end;
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

} // namespace iecfront
