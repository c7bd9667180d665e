#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <utility>

namespace iecfront {

Parser::Parser(std::string_view text, std::span<Token> tokens, std::span<const Diagnostic> lexical,
               std::uint32_t opener, ParserArena& arena, const ParseOptions& options,
               std::pmr::memory_resource& scratch)
    : text_(text),
      tokens_(tokens.data()),
      count_(static_cast<std::uint32_t>(tokens.size()) - 1),
      lexical_(lexical),
      opener_(opener),
      arena_(arena),
      options_(options),
      pending_(&scratch),
      open_(&scratch) {
    constexpr std::size_t usual_depth = 8; // of blocks
    open_.reserve(usual_depth);
    move_to(tokens_[0].kind() == TokenKind::unknown ? next(0) : 0);
}

// ---- tokens -------------------------------------------------------------------------------------

bool Parser::at_word(std::string_view word) const noexcept {
    return at(TokenKind::identifier) && names_equal(text(at_), word);
}

bool Parser::adjoins_next() const noexcept {
    return !at_end() && tokens_[at_].end() == tokens_[at_ + 1].offset();
}

bool Parser::on_same_line(std::uint32_t first, std::uint32_t second) const noexcept {
    for (std::uint32_t i = first + 1; i <= second; ++i)
        if (tokens_[i].first_on_line())
            return false;
    return true;
}

std::uint32_t Parser::column(std::uint32_t index) const noexcept {
    const std::uint32_t offset = tokens_[index].offset();
    std::uint32_t begin = offset;
    const char* const text = text_.data();
    while (begin > 0 && text[begin - 1] != '\n' && text[begin - 1] != '\r')
        --begin;
    return offset - begin;
}

/// True when the closing bracket at the cursor has its opening one earlier in this statement or
/// declaration.
bool Parser::closes_open_bracket() const noexcept {
    constexpr std::uint32_t furthest = 200; // bounds the time that a run of brackets takes
    const TokenKind opener =
        at(TokenKind::right_bracket) ? TokenKind::left_bracket : TokenKind::left_parenthesis;
    std::uint32_t closed = 0;
    for (std::uint32_t i = at_; i > 0 && at_ - i < furthest; --i) {
        const TokenKind before = tokens_[i - 1].kind();
        if (before == TokenKind::semicolon)
            return false;
        if (before == kind())
            ++closed;
        else if (before == opener && closed-- == 0)
            return true;
    }
    return false;
}

/// True inside brackets of a statement, instruction or declaration that are all closed further on.
bool Parser::brackets_balance() const noexcept {
    constexpr std::uint32_t furthest = 200; // bounds the time that a text full of mistakes takes
    static constexpr TokenSet openers{TokenKind::left_parenthesis, TokenKind::left_bracket};
    std::int32_t open = 0;
    for (std::uint32_t i = at_; i > 0 && at_ - i < furthest; --i) {
        const TokenKind before = tokens_[i - 1].kind();
        if (before == TokenKind::semicolon || (in_instructions_ && begins_line(i)))
            break;
        open += openers.contains(before) ? 1 : closing_brackets.contains(before) ? -1 : 0;
    }
    if (open <= 0)
        return false;
    for (std::uint32_t i = at_; i != count_ && i - at_ < furthest && open > 0; i = next(i)) {
        const TokenKind here = tokens_[i].kind();
        if (here == TokenKind::semicolon || (in_instructions_ && begins_line(i)))
            break;
        open += openers.contains(here) ? 1 : closing_brackets.contains(here) ? -1 : 0;
    }
    return open <= 0;
}

/// Where it does not stand at the cursor.
bool Parser::expect_missing(TokenKind expected) {
    const std::string words(spelling(expected));
    const bool intruder = peek() == expected && !at_end() && !is_keyword(kind()) &&
                          !at(TokenKind::semicolon) && on_same_line(at_, next(at_)) &&
                          !at_next_declaration();
    if (intruder) {
        Report unexpected = report_unexpected("`" + words + "`");
        if (!at(closing_brackets) && !begins_operand(kind())) // else an operator may be missing
            unexpected.remove(token().range());
        advance();
        return accept(expected);
    }
    if (closing_brackets.contains(expected) && !at(closing_brackets) && !at_next_declaration() &&
        brackets_balance()) {
        report_unexpected("an operator or `" + words + "`");
        skip_to(closing_brackets | TokenSet{TokenKind::semicolon});
        return accept(expected);
    }
    if (at(closing_brackets) && closing_brackets.contains(expected) && !closes_open_bracket()) {
        report_at(at_, DiagnosticId::unexpected_token, {"`" + words + "`", describe(at_)})
            .replace(token().range(), words);
        advance();
        return true;
    }
    const bool word = is_keyword(expected);
    const bool again =
        reported_at_ == at_ && closing_brackets.contains(expected) && !diagnostics_.empty() &&
        diagnostics_.back().id == DiagnosticId::missing_token && !diagnostics_.back().fixes.empty();
    if (again) { // one report for all brackets that are missing in one place
        TextEdit& edit = diagnostics_.back().fixes.front().edits.back();
        if (edit.range.end == previous_end())
            edit.replacement += words;
    }
    report_missing(DiagnosticId::missing_token, {"`" + words + "`"})
        .insert(previous_end(), word ? " " + words : words);
    return false;
}

// ---- nodes --------------------------------------------------------------------------------------

/// There is no more room: takes from the reserve.
void* Parser::allocate_from_reserve(std::size_t size, std::size_t alignment) {
    open_reserve();
    return arena_.allocate(size, alignment);
}

/// Gives the unit up. All that follows is unknown, so that the next step leads to its end, while
/// the current token stays what it is for who has looked at it.
void Parser::open_reserve() {
    arena_.open_reserve();
    for (std::uint32_t i = at_ + 1; i < count_; ++i)
        tokens_[i] = Token(TokenKind::unknown, tokens_[i].offset(), tokens_[i].length());
}

void Parser::make_room_for_pending() {
    pending_room_ = 2 * pending_count_ + 64;
    pending_.resize(pending_room_);
}

bool Parser::NestingGuard::report() const {
    if (!std::exchange(parser_.nesting_reported_, true))
        parser_.report(DiagnosticId::nesting_too_deep, parser_.token().range(),
                       {std::uint64_t{parser_.options_.maximum_nesting}});
    else if (parser_.presumed_body_)
        parser_.ask_presumed_body();
    return true;
}

// ---- reports ------------------------------------------------------------------------------------

Parser::Report& Parser::Report::label(LabelId id, std::uint32_t token) {
    if (index_)
        parser_.diagnostics_[*index_].labels.push_back(
            {parser_.tokens_[token].range(), id, std::string(parser_.text(token))});
    return *this;
}

Parser::Report& Parser::Report::replace(TextRange range, std::string words) {
    if (index_)
        parser_.diagnostics_[*index_].fixes.push_back(
            {{{range, parser_.spaced(std::move(words), range)}}});
    return *this;
}

Parser::Report& Parser::Report::insert(std::uint32_t offset, std::string words) {
    return replace({offset, offset}, std::move(words));
}

Parser::Report& Parser::Report::remove(TextRange range) {
    return replace(parser_.with_blank(range), {});
}

Parser::Report& Parser::Report::also_remove(TextRange range) {
    if (!index_)
        return *this;
    std::vector<TextEdit>& edits = parser_.diagnostics_[*index_].fixes.back().edits;
    range = parser_.with_blank(range);
    range.begin = std::max(range.begin, edits.back().range.end); // the blank may be taken already
    edits.push_back({range, {}});
    return *this;
}

Parser::Report& Parser::Report::also_insert(std::uint32_t offset, std::string words) {
    if (index_)
        parser_.diagnostics_[*index_].fixes.back().edits.push_back(
            {{offset, offset}, std::move(words)});
    return *this;
}

/// `words` for what stands at `range`: they must not run into their neighbours.
std::string Parser::spaced(std::string words, TextRange range) const {
    const auto part_of_word = [](char c) {
        c = fold(c);
        return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    if (words.empty())
        return words;
    if (range.end < text_.size() && part_of_word(words.back()) && part_of_word(text_[range.end]))
        words += ' ';
    if (range.begin > 0 && part_of_word(words.front()) && part_of_word(text_[range.begin - 1]))
        words.insert(0, 1, ' ');
    return words;
}

/// With the blank before it when another one stands behind it: no two blanks are left.
TextRange Parser::with_blank(TextRange range) const noexcept {
    const auto blank = [this](std::uint32_t offset) {
        return offset < text_.size() && (text_[offset] == ' ' || text_[offset] == '\t');
    };
    const bool starts_line = range.begin == 0 || text_[range.begin - 1] == '\n';
    if (blank(range.end) && starts_line)
        ++range.end;
    else if (blank(range.end) && blank(range.begin - 1))
        --range.begin;
    return range;
}

bool Parser::holds(const std::vector<Diagnostic>& reports, const Diagnostic& report) noexcept {
    return std::any_of(reports.begin(), reports.end(), [&](const Diagnostic& one) {
        return one.id == report.id && one.range == report.range &&
               one.labels.size() >= report.labels.size();
    });
}

DiagnosticArgument Parser::copied(const Argument& argument) {
    if (const auto* const words = std::get_if<std::string_view>(&argument))
        return std::string(*words);
    if (const auto* const number = std::get_if<std::uint64_t>(&argument))
        return *number;
    return std::get<char32_t>(argument);
}

Parser::Report Parser::report(DiagnosticId id, TextRange range, Arguments arguments) {
    Diagnostic& diagnostic = diagnostics_.emplace_back(Diagnostic{id, range, {}, {}, {}});
    for (const Argument& argument : arguments)
        diagnostic.arguments.push_back(copied(argument));
    // An empty list of statements may still be taken for a part of another mistake.
    if (expected_ != nullptr && !stopped_at_ && id != DiagnosticId::empty_statement_list &&
        !holds(*expected_, diagnostics_.back())) {
        stopped_at_ = at_;
        move_to_end();
    }
    if (diagnostics_.size() > options_.maximum_unit_memory / ParseOptions::memory_of_finding &&
        !arena_.full()) {
        arena_.refuse();
        open_reserve();
    }
    if (presumed_body_)
        ask_presumed_body();
    return {*this, diagnostics_.size() - 1};
}

Parser::Report Parser::report_at(std::uint32_t token, DiagnosticId id, Arguments arguments) {
    if (std::exchange(reported_at_, token) == token || follows_unknown(token) ||
        tokens_[token].malformed())
        return {*this, std::nullopt};
    return report(id, tokens_[token].range(), arguments);
}

Parser::Report Parser::report_node(const ast::Node& node, DiagnosticId id, Arguments arguments) {
    return report(id, token_range(node.first_token, node.end_token), arguments);
}

Parser::Report Parser::report_missing(DiagnosticId id, Arguments arguments) {
    if (std::exchange(reported_at_, at_) == at_ || follows_unclosed() || follows_unknown(at_))
        return {*this, std::nullopt};
    return report(id, {previous_end(), previous_end()}, arguments);
}

void Parser::report_unfinished(DiagnosticId id, Arguments arguments) {
    const bool joins = reported_at_ == at_ && !diagnostics_.empty() &&
                       diagnostics_.back().range.begin == previous_end();
    if (joins)
        diagnostics_.back().fixes.clear();
    report_missing(id, arguments);
}

/// True behind a comment, pragma or string that nothing closes: it has taken the rest of its line,
/// and what is missing at the cursor with it.
bool Parser::follows_unclosed() const {
    const std::uint32_t from = end_ > 0 ? tokens_[end_ - 1].offset() : 0;
    auto found = std::ranges::lower_bound(lexical_, from, {},
                                          [](const Diagnostic& one) { return one.range.begin; });
    for (; found != lexical_.end() && found->range.begin < token().offset(); ++found)
        if (found->id == DiagnosticId::unterminated_comment ||
            found->id == DiagnosticId::unterminated_pragma ||
            found->id == DiagnosticId::unterminated_string)
            return true;
    return false;
}

Parser::Report Parser::report_unexpected(std::string_view what) {
    Report unexpected = report_at(at_, DiagnosticId::unexpected_token, {what, describe(at_)});
    const std::uint32_t behind = next(at_);
    if (at(closing_brackets) && !begins_operand_on_line(behind) &&
        !is_elementary_type_name(tokens_[behind].kind()))
        unexpected.remove(token().range());
    return unexpected;
}

std::uint32_t Parser::previous_end() const noexcept {
    return end_ > 0 ? tokens_[end_ - 1].end() : token().offset();
}

std::string Parser::quoted(std::uint32_t index) const {
    return "`" + std::string(text(index)) + "`";
}

std::string Parser::describe(std::uint32_t index) const {
    return index == count_ ? std::string(spelling(TokenKind::end_of_unit)) : quoted(index);
}

TextRange Parser::token_range(std::uint32_t first, std::uint32_t end) const noexcept {
    if (first == end) {
        const std::uint32_t offset = first > 0 ? tokens_[first - 1].end() : tokens_[0].offset();
        return {offset, offset};
    }
    return {tokens_[first].offset(), tokens_[end - 1].end()};
}

// ---- names --------------------------------------------------------------------------------------

const ast::Identifier* Parser::make_identifier() {
    return take_word<ast::Identifier>();
}

const ast::Identifier* Parser::make_missing_identifier(std::string_view what) {
    if (at_next_declaration()) {
        report_unfinished(DiagnosticId::missing_name, {what, describe(at_)});
        return make_missing<ast::Identifier>();
    }
    report_at(at_, DiagnosticId::missing_name, {what, describe(at_)});
    return make_missing<ast::Identifier>();
}

// identifier = ( letter | "_" ( letter | digit ) ) { [ "_" ] ( letter | digit ) } ;
/// A name that is used.
const ast::Identifier* Parser::parse_name(std::string_view what) {
    if (at(TokenKind::identifier))
        return take_name<ast::Identifier, NameUse::other>();
    static constexpr TokenSet behind_parameter{TokenKind::assign, TokenKind::output_arrow};
    if (is_keyword(kind()) && !at_next_declaration() &&
        (used_as_name(kind()) || at_operand_keyword() || behind_parameter.contains(peek())))
        return take_reserved_word();
    return make_missing_identifier(what);
}

/// Part of identifier: one that is declared.
const ast::Identifier* Parser::parse_declared_name(std::string_view what) {
    // A keyword is taken for a name when what follows can only follow a name.
    static constexpr TokenSet after_name{TokenKind::colon,
                                         TokenKind::comma,
                                         TokenKind::kw_at,
                                         TokenKind::left_parenthesis,
                                         TokenKind::assign,
                                         TokenKind::semicolon,
                                         TokenKind::kw_on,
                                         TokenKind::kw_with,
                                         TokenKind::right_parenthesis};
    if (at(TokenKind::identifier))
        return take_name<ast::Identifier, NameUse::declaration>();
    const bool alone = at_operand_keyword() && tokens_[next(at_)].first_on_line();
    if (is_keyword(kind()) && (after_name.contains(peek()) || alone))
        return take_reserved_word();
    return make_missing_identifier(what);
}

const ast::Node* Parser::check_name(const ast::Node* name, std::uint32_t hash, NameUse use) {
    check_standard_name(name->first_token, hash, use);
    return name;
}

// function_name = standard_function_name | derived_function_name ;
// function_block_type_name = standard_function_block_name | derived_function_block_name ;
/// Annex C reserves the names of standard functions for calls, and those of standard function
/// blocks for types. Once a unit: what follows the first report is the same mistake.
void Parser::check_name_of_standard(TextRange range, std::uint32_t hash, NameUse use) {
    const std::string_view name(text_.data() + range.begin, range.size());
    const StandardName standard = find_standard_name(name, hash);
    if (use == NameUse::variable)
        use = at(TokenKind::left_parenthesis) ? NameUse::call : NameUse::other;
    const bool function = standard == StandardName::function;
    if (standard == StandardName::none || use == (function ? NameUse::call : NameUse::type) ||
        std::find(standard_names_.begin(), standard_names_.end(), hash) != standard_names_.end())
        return;
    const bool lacks_parenthesis =
        function && use == NameUse::other && begins_operand_on_line(at_); // `MAX a, b)`
    if (lacks_parenthesis)
        return;
    standard_names_.push_back(hash);
    const char* const but = use == NameUse::declaration ? "cannot be given to anything else"
                            : function                  ? "can only be called as one"
                            : use == NameUse::call      ? "cannot be called: declare an instance"
                                                        : "can only be a type";
    report(DiagnosticId::standard_name_as_name, range,
           {name, function ? "function" : "function block", but});
}

bool Parser::used_as_name(TokenKind kind) const noexcept {
    return std::any_of(reserved_words_.begin(), reserved_words_.end(),
                       [kind](const ReservedWord& word) { return word.kind == kind; });
}

const ast::Identifier* Parser::take_reserved_word() {
    report_reserved_word(at_);
    return make_identifier();
}

/// True at a keyword of statements that what stands around it makes a variable: `TO := 1;`,
/// `IF.x := 1;` and `x := TO;`.
bool Parser::at_keyword_for_variable() {
    static constexpr TokenSet words{TokenKind::kw_if,    TokenKind::kw_case,   TokenKind::kw_for,
                                    TokenKind::kw_while, TokenKind::kw_repeat, TokenKind::kw_return,
                                    TokenKind::kw_exit,  TokenKind::kw_then,   TokenKind::kw_do,
                                    TokenKind::kw_of,    TokenKind::kw_to,     TokenKind::kw_by};
    static constexpr TokenSet before_operand{TokenKind::assign, TokenKind::left_parenthesis,
                                             TokenKind::comma};
    static constexpr TokenSet behind_operand{TokenKind::semicolon, TokenKind::right_parenthesis,
                                             TokenKind::comma};
    static constexpr TokenSet behind_variable =
        behind_operand | TokenSet{TokenKind::assign, TokenKind::dot};
    if (!words.contains(kind()) || !behind_variable.contains(peek()))
        return false;
    const bool operand = at_ > 0 && before_operand.contains(tokens_[at_ - 1].kind()) &&
                         !token().first_on_line() && behind_operand.contains(peek());
    return (operand || peek() == TokenKind::assign || peek() == TokenKind::dot) &&
           !opens_block(kind());
}

/// The first use is reported, and its fix renames every use in the unit.
void Parser::report_reserved_word(std::uint32_t token) {
    const TokenKind keyword = tokens_[token].kind();
    const TextRange range = tokens_[token].range();
    for (const ReservedWord& word : reserved_words_)
        if (word.kind == keyword) {
            std::vector<DiagnosticFix>& fixes = diagnostics_[word.diagnostic].fixes;
            if (fixes.empty()) // taken back, as more is wrong there
                return;
            std::vector<TextEdit>& edits = fixes.front().edits;
            if (edits.back().range != range) {
                edits.push_back({range, std::string(text(token)) + word.suffix});
                count_as_name(keyword);
            }
            return;
        }
    count_as_name(keyword);
    const std::string words(text(token));
    const std::string suffix = free_suffix(words);
    const Report first =
        report(contextual_keywords.contains(keyword) ? DiagnosticId::contextual_keyword_as_name
                                                     : DiagnosticId::reserved_word_as_name,
               range, {words});
    diagnostics_[first.index()].fixes.push_back({{{range, words + suffix}}});
    reserved_words_.push_back({keyword, first.index(), suffix});
}

/// `_1`, or another number when the unit has a name like that already.
std::string Parser::free_suffix(std::string_view word) const {
    constexpr char last = '9'; // bounds the time that a text with all of them takes
    std::string suffix = "_1";
    const auto taken = [&](const Token& token) {
        return token.kind() == TokenKind::identifier &&
               token.length() == word.size() + suffix.size() &&
               names_equal(text_.substr(token.offset(), token.length()),
                           std::string(word) + suffix);
    };
    while (suffix.back() < last && std::any_of(tokens_, tokens_ + count_, taken))
        ++suffix.back();
    return suffix;
}

} // namespace iecfront
