#include "lexer/block_words.hpp"
#include "parser/misspelling.hpp"
#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace iecfront {
namespace {

constexpr TokenSet closers = library_element_closers | statement_closers | other_closers;

constexpr TokenSet block_words =
    closers | block_openers |
    TokenSet{TokenKind::kw_else, TokenKind::kw_elsif, TokenKind::kw_until, TokenKind::end_of_unit};

// What can follow a name, or the first of several, in a declaration of variables.
constexpr TokenSet after_names{TokenKind::colon, TokenKind::comma, TokenKind::kw_at};

/// `END_INITIAL_STEP` for END_STEP, `END_VAR_INPUT` for END_VAR.
bool is_made_of_opener(std::string_view word, TokenKind closer) noexcept {
    return names_equal(word.substr(0, 4), "END_") &&
           std::any_of(std::begin(block_pairs), std::end(block_pairs),
                       [&](const BlockWords& words) {
                           return words.closer == closer &&
                                  names_equal(word.substr(4), spelling(words.opener));
                       });
}

/// `END_LOOP`, `IF_END`, `WEND` and what else ends a statement in other languages.
bool ends_statement_elsewhere(std::string_view word) noexcept {
    static constexpr std::array<std::string_view, 11> words = {
        "WEND",      "FI",   "OD",     "ESAC",     "ENDLOOP", "ENDDO",
        "ENDSWITCH", "NEXT", "IF_END", "CASE_END", "LOOP_END"};
    return names_equal(word.substr(0, 4), "END_") ||
           std::any_of(words.begin(), words.end(),
                       [word](std::string_view one) { return names_equal(one, word); });
}

/// What makes a name in the line before it the beginning of a statement.
bool goes_on_behind_name(TokenKind after) noexcept {
    static constexpr TokenSet marks{TokenKind::assign,       TokenKind::left_parenthesis,
                                    TokenKind::left_bracket, TokenKind::dot,
                                    TokenKind::equal,        TokenKind::caret};
    return marks.contains(after);
}

} // namespace

// ---- blocks and their closing words -------------------------------------------------------------

bool Parser::is_open(TokenKind closer) const noexcept {
    return std::any_of(open_.rbegin(), open_.rend(),
                       [closer](const OpenBlock& block) { return block.closer == closer; });
}

/// All balances are counted in one pass, when the first one is asked for.
void Parser::find_balances() noexcept {
    balances_known_ = true;
    std::array<std::int32_t, token_kind_count> tokens{};
    for (std::uint32_t i = 0; i < count_; ++i)
        ++tokens[static_cast<std::size_t>(tokens_[i].kind())];
    for (const BlockWords& words : block_pairs) {
        std::int32_t& closed = tokens[static_cast<std::size_t>(words.closer)];
        unclosed_[static_cast<std::size_t>(words.closer)] +=
            tokens[static_cast<std::size_t>(words.opener)] - std::exchange(closed, 0);
    }
    balanced_ = std::ranges::all_of(block_pairs, [this](const BlockWords& words) {
        return unclosed_[static_cast<std::size_t>(words.closer)] == 0;
    });
}

void Parser::change_unclosed(TokenKind closer, std::int32_t by) noexcept {
    if (by == 0)
        return;
    if (!balances_known_)
        find_balances();
    unclosed_[static_cast<std::size_t>(closer)] += by;
    balanced_ = false; // until the end, for so much is wrong in few units
}

TokenKind Parser::closer_of(TokenKind opener) noexcept {
    return std::find_if(std::begin(block_pairs), std::end(block_pairs),
                        [opener](const BlockWords& words) { return words.opener == opener; })
        ->closer;
}

/// A keyword that is meant as a name opens and closes nothing.
void Parser::count_as_name(TokenKind word) {
    for (const BlockWords& words : block_pairs)
        if (words.opener == word)
            change_unclosed(words.closer, -1);
    if (closers.contains(word))
        change_unclosed(word, 1);
}

/// True for an opening word when no block is left open: each of them opens one.
bool Parser::opens_block(TokenKind word) {
    return std::any_of(std::begin(block_pairs), std::end(block_pairs),
                       [&](const BlockWords& words) {
                           return words.opener == word && unclosed(words.closer) <= 0;
                       });
}

/// True when the closing word at the cursor fits the innermost block, but by its column belongs to
/// one further out, and that one would otherwise stay open: the innermost is the unclosed one.
bool Parser::closes_outer_block() const noexcept {
    if (open_.size() < 2 || !token().first_on_line())
        return false;
    const OpenBlock& inner = open_.back();
    if (!tokens_[inner.opener].first_on_line() || column(at_) == column(inner.opener))
        return false;
    return std::any_of(open_.begin(), open_.end() - 1, [&](const OpenBlock& block) {
        return block.closer == inner.closer && tokens_[block.opener].first_on_line() &&
               column(block.opener) == column(at_);
    });
}

/// An identifier like `ENDIF`, `END_FI`, `END_FB` or `END_INITIAL_STEP`, or `END` alone, in the
/// place of the closing word; also that word in two.
bool Parser::at_misspelt_closer() const noexcept {
    if (open_.empty() || (!at(TokenKind::identifier) && !at(TokenKind::kw_end_function)))
        return false;
    static constexpr TokenSet after_name{
        TokenKind::colon,        TokenKind::assign,           TokenKind::dot,
        TokenKind::left_bracket, TokenKind::left_parenthesis, TokenKind::caret};
    static constexpr TokenSet in_declaration{TokenKind::colon, TokenKind::comma}; // on any line
    const Token behind = tokens_[next(at_)];
    if (in_declaration.contains(behind.kind()) ||
        (after_name.contains(behind.kind()) && !behind.first_on_line()))
        return false;
    const std::string_view closer = spelling(open_.back().closer);
    if (at_split_word(closer))
        return true;
    const std::string_view word = text(at_);
    if (word.size() < 2 || !at(TokenKind::identifier))
        return false;
    const TokenKind after = peek();
    const bool alone = after == TokenKind::semicolon || tokens_[next(at_)].first_on_line() ||
                       after == TokenKind::end_of_unit || chart_openers.contains(after) ||
                       closers.contains(after);
    if (names_equal(word, "END")) // in a chart no name stands alone
        return after == TokenKind::semicolon || after == TokenKind::end_of_unit ||
               (alone && !after_name.contains(after) &&
                chart_closers.contains(open_.back().closer));
    const bool of_element = library_element_closers.contains(open_.back().closer) &&
                            names_equal(word.substr(0, 3), "END");
    const bool of_statement = statement_closers.contains(open_.back().closer) &&
                              ends_statement_elsewhere(word) && !goes_on_behind_name(after);
    return alone && (is_misspelling(word, closer) || is_abbreviation(word, closer) ||
                     of_statement || is_made_of_opener(word, open_.back().closer) ||
                     (of_element && ends_library_element(at_)));
}

/// Where the second word of `END IF` or `END-IF` stands.
std::uint32_t Parser::second_of_split_word() const noexcept {
    const std::uint32_t behind = next(at_);
    const bool hyphen = tokens_[behind].kind() == TokenKind::minus && adjoins_next() &&
                        tokens_[behind].end() == tokens_[next(behind)].offset();
    return hyphen ? next(behind) : behind;
}

/// `END IF`, `END-IF`, `END _IF` or `END_FUNCTION BLOCK`; of `END_ IF` the lexer makes one token.
bool Parser::at_split_word(std::string_view closer) const noexcept {
    if (!names_equal(text(at_).substr(0, 3), "END")) // as nearly all words, which are read here
        return false;
    const std::uint32_t second = second_of_split_word();
    const std::string_view rest = text(second);
    if (tokens_[second].first_on_line())
        return false;
    if (at(TokenKind::kw_end_function))
        return closer == spelling(TokenKind::kw_end_function_block) && names_equal(rest, "BLOCK");
    return names_equal(text(at_), "END") &&
           (names_equal(rest, closer.substr(4)) || names_equal(rest, closer.substr(3)));
}

/// A closing word of which nothing is open and one too many is there, while the innermost block
/// lacks its own: that is what it is meant for. For a library element it stands at the very end.
bool Parser::at_foreign_closer() {
    if (open_.empty() || !at(closers) || is_open(kind()))
        return false;
    const TokenKind innermost = open_.back().closer;
    return unclosed(kind()) < 0 && unclosed(innermost) > 0 &&
           (!library_element_closers.contains(innermost) || peek() == TokenKind::end_of_unit);
}

/// A closing word of another kind that can only be meant to close the innermost block: it closes
/// nothing else, or stands in the column of this block's opener.
bool Parser::at_mismatched_closer() {
    if (open_.empty() || !at(closers))
        return false;
    if (at_foreign_closer())
        return true;
    const OpenBlock& inner = open_.back();
    if (at(TokenKind::kw_end_resource) && inner.closer == TokenKind::kw_end_configuration)
        return true;
    if (library_element_closers.contains(inner.closer))
        return library_element_closers.contains(kind());
    if (library_element_closers.contains(kind()))
        return inner.closer == TokenKind::kw_end_var && unclosed(kind()) < 0;
    const auto outer = std::find_if(open_.rbegin(), open_.rend(), [this](const OpenBlock& block) {
        return block.closer == kind();
    });
    if (outer == open_.rend())
        return true;
    return token().first_on_line() && tokens_[inner.opener].first_on_line() &&
           column(at_) == column(inner.opener) && column(at_) != column(outer->opener);
}

void Parser::report_missing_closer(std::string_view terminator) {
    const OpenBlock& block = open_.back();
    const std::string closer(spelling(block.closer));
    if (at(TokenKind::semicolon))
        terminator = "";
    if (join_missing_closer(closer + std::string(terminator)))
        return;
    std::string gap = "\n";
    if (reported_at_ == at_ && !diagnostics_.empty() &&
        diagnostics_.back().id == DiagnosticId::empty_statement_list) {
        reported_at_ = no_token;
        diagnostics_.pop_back(); // it lacks both, which is one mistake
        gap = " ; ";
    }
    report_missing(DiagnosticId::missing_closing_word, {closer, text(block.opener)})
        .label(LabelId::opened_here, block.opener)
        .insert(previous_end(), gap + closer + std::string(terminator));
    change_unclosed(block.closer, -1);
    closer_assumed_ = true;
}

/// When several blocks end in one place, or the text ends in the middle of something that was
/// reported, it is one mistake: what is missing is added to that report.
bool Parser::join_missing_closer(const std::string& words) {
    const bool at_same_place = reported_at_ == at_ || at_end();
    if (!at_same_place || diagnostics_.empty())
        return false;
    Diagnostic& last = diagnostics_.back();
    const bool of_closer = last.id == DiagnosticId::missing_closing_word;
    const bool unfinished = at_end() && last.range.end >= previous_end();
    const bool of_semicolon =
        last.id == DiagnosticId::missing_semicolon || last.id == DiagnosticId::semicolon_left_out;
    if (last.id == DiagnosticId::empty_statement_list || last.range.end < previous_end() ||
        (!of_closer && !of_semicolon && !unfinished))
        return false;
    if (last.id == DiagnosticId::semicolon_left_out) {
        last.id = DiagnosticId::missing_semicolon; // there is more that is missing
        last.arguments.clear();
    }
    const OpenBlock& block = open_.back();
    last.labels.push_back({tokens_[block.opener].range(),
                           of_closer ? LabelId::opened_here : LabelId::not_closed,
                           std::string(text(block.opener))});
    if (!last.fixes.empty() && last.fixes.front().edits.back().range.end == previous_end())
        last.fixes.front().edits.back().replacement += '\n' + words;
    change_unclosed(block.closer, -1);
    closer_assumed_ = true;
    return true;
}

void Parser::close_block(std::string_view terminator) {
    closer_assumed_ = false;
    if (at(open_.back().closer) && (balanced() || !closes_outer_block()))
        advance();
    else
        close_doubtful_block(terminator);
    open_.pop_back();
}

/// What stands there may be meant for the closing word, or for that of another block.
void Parser::close_doubtful_block(std::string_view terminator) {
    const OpenBlock block = open_.back();
    const std::string_view closer = spelling(block.closer);
    if (at(block.closer)) {
        if (unclosed(block.closer) > 0)
            report_missing_closer(terminator);
        else
            advance();
    } else if (at_misspelt_closer()) {
        const std::uint32_t first = at_;
        if (at_split_word(closer))
            for (const std::uint32_t second = second_of_split_word(); at_ < second;)
                advance();
        const TextRange words = token_range(first, at_ + 1);
        if (!tokens_[first].malformed()) // else it was reported
            report(DiagnosticId::misspelt_word, words,
                   {text_.substr(words.begin, words.size()), closer})
                .replace(words, std::string(closer));
        advance();
        change_unclosed(block.closer, -1);
    } else if (at_mismatched_closer() || at_unknown_closer_for_innermost()) {
        report_at(at_, DiagnosticId::mismatched_closing_word,
                  {text(at_), text(block.opener), closer})
            .label(LabelId::opened_here, block.opener)
            .replace(token().range(), std::string(closer));
        change_unclosed(block.closer, -1);
        change_unclosed(kind(), 1);
        advance();
    } else {
        report_missing_closer(terminator);
    }
}

// ---- skipping -----------------------------------------------------------------------------------

bool Parser::at_declaration_start() const noexcept {
    if (!at(TokenKind::identifier) && !is_keyword(kind()))
        return false;
    const TokenKind after = peek();
    return after == TokenKind::colon || after == TokenKind::kw_at ||
           (after == TokenKind::comma && (token().first_on_line() || is_keyword(kind())));
}

bool Parser::begins_type(std::uint32_t index) const noexcept {
    static constexpr TokenSet starts{TokenKind::identifier, TokenKind::left_parenthesis,
                                     TokenKind::kw_array, TokenKind::kw_struct};
    const TokenKind kind = tokens_[index].kind();
    return starts.contains(kind) || is_elementary_type_name(kind) || is_generic_type_name(kind);
}

/// Inside a declaration, at the next one: its names are first on their line. It is never a type, a
/// bound, an operand or an element of a list, but `a : 1` and `a : Red,` are meant for `a := 1`.
bool Parser::at_next_declaration() const noexcept {
    if (!token().first_on_line() || open_.empty())
        return false;
    if (!at(TokenKind::identifier))
        return at_next_configuration_part();
    static constexpr TokenSet of_declarations{TokenKind::kw_end_var, TokenKind::kw_end_struct,
                                              TokenKind::kw_end_type};
    const OpenBlock& block = open_.back();
    const TokenKind opener = tokens_[block.opener].kind();
    if (!of_declarations.contains(block.closer) || opener == TokenKind::kw_var_access)
        return false; // `a :` and a path on the next line, with its own `:`
    const bool paths = opener == TokenKind::kw_var_config;
    std::uint32_t behind = next(at_);
    for (std::uint32_t steps = 0; steps < furthest_on_line; ++steps) {
        const TokenKind separator = tokens_[behind].kind();
        const std::uint32_t name = next(behind);
        if (separator != TokenKind::comma && !(paths && separator == TokenKind::dot))
            break;
        if (tokens_[name].kind() != TokenKind::identifier || tokens_[name].first_on_line())
            return false;
        behind = next(name);
    }
    if (tokens_[behind].kind() == TokenKind::kw_at)
        return true;
    static constexpr TokenSet behind_value{TokenKind::comma, TokenKind::right_parenthesis};
    const std::uint32_t type = next(behind);
    return tokens_[behind].kind() == TokenKind::colon && begins_type(type) &&
           !(tokens_[type].kind() == TokenKind::identifier &&
             behind_value.contains(tokens_[next(type)].kind()));
}

/// The same in a configuration or resource, at RESOURCE, TASK or PROGRAM with a name behind it.
bool Parser::at_next_configuration_part() const noexcept {
    static constexpr TokenSet parts{TokenKind::kw_resource, TokenKind::kw_task,
                                    TokenKind::kw_program};
    static constexpr TokenSet behind_part{TokenKind::identifier, TokenKind::kw_retain,
                                          TokenKind::kw_non_retain};
    const TokenKind closer = open_.back().closer;
    return at(parts) && behind_part.contains(peek()) &&
           (closer == TokenKind::kw_end_resource || closer == TokenKind::kw_end_configuration);
}

bool Parser::at_statement_start() const noexcept {
    if (at(statement_words))
        return true;
    if (at(TokenKind::direct_variable))
        return peek() == TokenKind::assign;
    if (!at(TokenKind::identifier) && !at(execution_control))
        return false;
    static constexpr TokenSet after_name{TokenKind::assign, TokenKind::left_parenthesis,
                                         TokenKind::left_bracket, TokenKind::dot, TokenKind::caret};
    return after_name.contains(peek());
}

/// Passes over one token, or over a bracket with all that stands in it. Never over a word that has
/// a part in the structure of a body.
void Parser::skip_balanced() {
    std::uint32_t depth = 0;
    do {
        if (at(TokenKind::left_parenthesis) || at(TokenKind::left_bracket))
            ++depth;
        else if (at(TokenKind::right_parenthesis) || at(TokenKind::right_bracket))
            depth -= depth > 0 ? 1 : 0;
        advance();
    } while (depth > 0 && !at(block_words) && !at(TokenKind::semicolon) && !at(statement_words));
}

void Parser::skip_to(const TokenSet& stop) {
    while (!at(stop) && !at(block_words))
        skip_balanced();
}

/// Passes over what cannot be read up to the `;`, or to where the next statement begins.
const ast::ErrorStatement* Parser::skip_statement() {
    auto* error = make<ast::ErrorStatement>();
    bool first = true;
    while (!at(TokenKind::semicolon) && !at(block_words) && !at_misspelt_closer()) {
        if (!first && (at(statement_words) || (token().first_on_line() && at_statement_start())))
            break;
        first = false;
        skip_balanced();
    }
    return finish(error);
}

void Parser::skip_declaration() {
    static constexpr TokenSet stop{TokenKind::semicolon, TokenKind::kw_struct};
    while (!at(stop) && !at(block_words) && !at(statement_words)) {
        if (token().first_on_line() && at_declaration_start())
            break;
        skip_balanced();
    }
}

/// A delimiter that cannot follow a statement or declaration.
bool Parser::at_semicolon_look_alike() const noexcept {
    static constexpr TokenSet look_alikes =
        closing_brackets | TokenSet{TokenKind::comma, TokenKind::colon, TokenKind::dot};
    return at(look_alikes);
}

bool Parser::accept_semicolon_look_alike() {
    if (!at_semicolon_look_alike() || token().first_on_line() ||
        !tokens_[next(at_)].first_on_line())
        return false;
    accept_as(TokenKind::semicolon);
    return true;
}

/// At a word of a statement, or a closing word of which nothing is open, in a line of declarations:
/// where the declaration ends that it stands in. Else the cursor's place.
std::uint32_t Parser::end_of_declaration_with_stray_word() {
    static constexpr TokenSet words =
        statement_words | closers |
        TokenSet{TokenKind::kw_else, TokenKind::kw_elsif, TokenKind::kw_until};
    const OpenBlock& block = open_.back();
    const bool ends_block = token().first_on_line() && unclosed(block.closer) > 0;
    const bool variables = block.closer != TokenKind::kw_end_var && at(block_openers);
    const bool closes_too_early = !token().first_on_line() && unclosed(kind()) < 0 && at_ > 0 &&
                                  tokens_[at_ - 1].kind() != TokenKind::semicolon;
    if ((!at(words) && !variables && !at_stray_struct()) ||
        (is_open(kind()) && !closes_too_early) || ends_block)
        return at_;
    std::uint32_t end = next(at_);
    for (std::uint32_t steps = 0; !tokens_[end].first_on_line() && steps < furthest_on_line;
         ++steps) {
        const bool last = tokens_[end].kind() == TokenKind::semicolon;
        end = next(end);
        if (last)
            break;
    }
    const TokenKind after_name = tokens_[next(end)].kind();
    const bool paths = tokens_[block.opener].kind() == TokenKind::kw_var_config;
    const bool declaration =
        tokens_[end].kind() == TokenKind::identifier &&
        (after_names.contains(after_name) || (paths && after_name == TokenKind::dot));
    return declaration || tokens_[end].kind() == block.closer ? end : at_;
}

/// Passes over the rest of a declaration with such a word in it. Without the word it may be whole.
void Parser::skip_stray_word_in_declaration(std::uint32_t end) {
    static constexpr TokenSet goes_on{TokenKind::assign, TokenKind::semicolon};
    Report unexpected = report_unexpected("`;`");
    if (goes_on.contains(peek()))
        unexpected.remove(token().range());
    else if (next(at_) == end)
        unexpected.replace(token().range(), ";");
    for (; at_ < end && !at_end(); advance())
        count_as_name(kind());
}

/// `CASE x : INT;`: a word that does not belong there, and a declaration behind it.
void Parser::drop_word_before_declaration(std::string_view what) {
    if (at(TokenKind::identifier) || peek() != TokenKind::identifier ||
        !after_names.contains(peek_second()) || end_of_declaration_with_stray_word() == at_)
        return;
    report_at(at_, DiagnosticId::not_a_declaration, {what, describe(at_)}).remove(token().range());
    count_as_name(kind());
    advance();
}

void Parser::report_no_semicolon_of_declaration() {
    if (const std::uint32_t end = end_of_declaration_with_stray_word(); end > at_) {
        skip_stray_word_in_declaration(end);
        return;
    }
    if (closer_assumed_ && at(block_words))
        return;
    const bool missing = at(block_words) || at_misspelt_closer() || at(statement_words) ||
                         token().first_on_line() || at_declaration_start();
    if (missing) {
        report_missing_semicolon();
        return;
    }
    report_unexpected("`;`");
    skip_declaration();
    accept(TokenKind::semicolon);
}

/// Behind END_STRUCT and before a closing word, dialects do without the `;`.
void Parser::report_left_out_semicolon() {
    const bool behind = end_ > 0 && tokens_[end_ - 1].kind() == TokenKind::kw_end_struct;
    if (behind || (at(closers) && is_open(kind()))) {
        const std::uint32_t word = behind ? end_ - 1 : at_;
        report_missing(DiagnosticId::semicolon_left_out, {behind ? "behind" : "before", text(word)})
            .insert(previous_end(), ";");
        return;
    }
    report_missing(DiagnosticId::missing_semicolon).insert(previous_end(), ";");
}

/// What is missing before the `;`, and was reported here, takes the `;` along.
void Parser::report_missing_semicolon() {
    const bool together = reported_at_ == at_ && !diagnostics_.empty() &&
                          diagnostics_.back().id == DiagnosticId::missing_token;
    if (!together) {
        report_left_out_semicolon();
        return;
    }
    for (DiagnosticFix& fix : diagnostics_.back().fixes)
        if (fix.edits.back().range.end == previous_end())
            fix.edits.back().replacement += ';';
}

} // namespace iecfront
