#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <cstdlib>

namespace iecfront {
namespace {

// Operators of IL that are operators of ST as well, and can begin a line there, too.
constexpr TokenSet common_operators{TokenKind::kw_and, TokenKind::kw_or,  TokenKind::kw_xor,
                                    TokenKind::kw_mod, TokenKind::kw_not, TokenKind::ampersand};

// Words that say something of a body's language, or end it, wherever they stand.
constexpr TokenSet telling_words =
    unit_ends | statement_closers | other_closers | chart_openers | chart_closers | statement_words;

// How many parentheses are open behind a token, where `depth` are before it.
[[nodiscard]] constexpr std::uint32_t depth_behind(TokenKind kind, std::uint32_t depth) noexcept {
    switch (kind) {
    case TokenKind::left_parenthesis: return depth + 1;
    case TokenKind::right_parenthesis: return depth - (depth > 0 ? 1 : 0);
    case TokenKind::semicolon: return 0;
    default: return depth;
    }
}

} // namespace

/// A name or a literal.
bool Parser::begins_operand(TokenKind kind) noexcept {
    static constexpr TokenSet operands =
        TokenSet::range(TokenKind::integer, TokenKind::date_and_time) |
        TokenSet{TokenKind::identifier, TokenKind::enumerated_value, TokenKind::direct_variable,
                 TokenKind::kw_true,    TokenKind::kw_false,         TokenKind::kw_en,
                 TokenKind::kw_eno};
    return operands.contains(kind);
}

/// True when the word at token `index`, which can begin a step, transition or action, does so.
bool Parser::is_chart_element_head(std::uint32_t index) const noexcept {
    const std::uint32_t second = next(index);
    const std::uint32_t third = next(second);
    const TokenKind name = tokens_[second].kind();
    const TokenKind after = tokens_[third].kind();
    if (name == TokenKind::identifier)
        return after != TokenKind::assign && after != TokenKind::semicolon;
    if (tokens_[index].kind() == TokenKind::kw_initial_step && name == TokenKind::colon)
        return true; // the name is missing
    if (tokens_[index].kind() == TokenKind::kw_transition)
        return name == TokenKind::kw_from ||
               (name == TokenKind::left_parenthesis && names_equal(text(third), "PRIORITY"));
    return is_keyword(name) && after == TokenKind::colon;
}

/// True when the line ends in the parentheses behind the operator: `ADD( a`.
bool Parser::begins_deferred_operation(std::uint32_t index) const noexcept {
    const std::uint32_t open = next(index);
    if (tokens_[open].kind() != TokenKind::left_parenthesis || tokens_[open].first_on_line())
        return false;
    const std::uint32_t operand = next(open);
    return !tokens_[operand].first_on_line() && begins_operand(tokens_[operand].kind()) &&
           tokens_[next(operand)].first_on_line();
}

/// How the line that begins at token `index` reads. What tells an instruction are two operands in a
/// row, which ST never has. `application` is what a `;` makes a statement: a name and an operand, a
/// deferred operation, and an operator of both languages that begins the body. What may as well
/// continue an expression counts behind another instruction only.
Parser::LineKind Parser::line_kind(std::uint32_t index, LineKind before) const noexcept {
    const bool assignment = tokens_[index].kind() == TokenKind::identifier &&
                            tokens_[index + 1].kind() == TokenKind::assign &&
                            !tokens_[index + 1].first_on_line();
    if (assignment) // as most lines are
        return LineKind::other;
    const bool labelled = tokens_[index].kind() == TokenKind::identifier &&
                          tokens_[next(index)].kind() == TokenKind::colon;
    if (labelled)
        index = next(next(index));
    if (labelled && tokens_[index].first_on_line())
        return before;
    const std::uint32_t second = next(index);
    const bool alone =
        tokens_[second].first_on_line() || tokens_[second].kind() == TokenKind::semicolon;
    const bool assigns = tokens_[next(second)].kind() == TokenKind::equal &&
                         names_equal(text(second), "REF"); // `r REF= x`
    const bool operand = !alone && !assigns && begins_operand(tokens_[second].kind());
    const bool sign = tokens_[second].kind() == TokenKind::minus && !alone;
    const bool common = common_operators.contains(tokens_[index].kind());
    if (!common && tokens_[index].kind() != TokenKind::identifier)
        return LineKind::other;
    const bool operation = !common && il_operator(index) != nullptr;
    if (common && index == at_)
        return LineKind::application;
    const std::uint32_t third = next(second);
    if (common && operand && !tokens_[third].first_on_line() &&
        operator_strength(tokens_[third].kind()) > 0)
        return LineKind::other; // `AND a OR b` goes on with an expression
    if (common || (operation && (alone || sign)))
        return before == LineKind::other ? LineKind::other : LineKind::operation;
    if (operation && operand)
        return LineKind::operation;
    const bool deferred = operation && begins_deferred_operation(index);
    return operand || deferred ? LineKind::application : LineKind::other;
}

/// True for the second half of `&N`, which is two tokens.
bool Parser::ends_operator(std::uint32_t index) const noexcept {
    return index > at_ && tokens_[index - 1].kind() == TokenKind::ampersand &&
           tokens_[index - 1].end() == tokens_[index].offset() && names_equal(text(index), "N");
}

/// Counts what speaks for each language in a body.
class Parser::BodySurvey {
public:
    /// Of the body that begins at the current token.
    BodySurvey(Parser& parser, TokenKind closer)
        : parser_(parser),
          begin_(parser.at_),
          closer_(closer),
          misspelt_(parser.misspelt_chart_word() != TokenKind::end_of_unit),
          begins_chart_(parser.begins_chart_element(begin_) || misspelt_),
          chart_words_(misspelt_ ? 1 : 0) {}

    [[nodiscard]] BodyLanguage language();

private:
    [[nodiscard]] std::uint32_t furthest() const noexcept;
    void survey();
    [[nodiscard]] bool count_at(std::uint32_t& i);
    [[nodiscard]] std::uint32_t next_telling(std::uint32_t index) noexcept;
    [[nodiscard]] std::uint32_t next_beside_statement(std::uint32_t index) noexcept;
    [[nodiscard]] bool tells_by_line(std::uint32_t index) const noexcept {
        return parser_.tokens_[index].first_on_line() && kind(index) != TokenKind::unknown;
    }
    [[nodiscard]] bool is_decided() const noexcept;
    void count_chart_word(std::uint32_t& index) noexcept;
    void begin_line(std::uint32_t index) noexcept;
    void count_token(std::uint32_t index) noexcept;
    [[nodiscard]] bool is_call(std::uint32_t open) const noexcept;
    void count_statement(bool counts) noexcept;
    [[nodiscard]] TokenKind kind(std::uint32_t index) const noexcept {
        return parser_.tokens_[index].kind();
    }

    Parser& parser_;
    const std::uint32_t begin_;
    const TokenKind closer_;
    const bool misspelt_; // the first word is very probably one of a chart
    const bool begins_chart_;
    std::int32_t chart_words_;
    std::int32_t instructions_ = 0;
    std::int32_t statements_ = 0;
    std::uint32_t depth_ = 0; // of parentheses
    LineKind line_ = LineKind::operation;
    bool behind_instruction_ = false;
    bool statement_on_line_ = false;
    bool closing_words_ = false;
};

/// Enough to be sure: to count all of each body takes a twentieth of the time of parsing.
bool Parser::BodySurvey::is_decided() const noexcept {
    // More than a stretch of the other language has that somebody left at the begin of a body.
    constexpr std::int32_t decisive_lead = 20;
    constexpr std::int32_t decisive_chart = 3; // more than one element has
    return std::abs(instructions_ - statements_) >= decisive_lead || chart_words_ >= decisive_chart;
}

/// The closing word of the chart element that begins at token `index` when no other stands before
/// it, and else `index`.
std::uint32_t Parser::chart_element_end(std::uint32_t index) const noexcept {
    static constexpr TokenSet words = chart_openers | chart_closers | unit_ends;
    std::uint32_t i = next(index);
    while (!words.contains(tokens_[i].kind()))
        i = next(i);
    return tokens_[i].kind() == closer_of(tokens_[index].kind()) ? i : index;
}

/// What stands in an element of a chart says nothing of the body.
void Parser::BodySurvey::count_chart_word(std::uint32_t& index) noexcept {
    ++chart_words_;
    if (chart_closers.contains(kind(index)))
        return;
    const std::uint32_t end = parser_.chart_element_end(index);
    chart_words_ += end != index ? 1 : 0;
    index = end;
}

void Parser::BodySurvey::begin_line(std::uint32_t index) noexcept {
    behind_instruction_ = index != begin_ && line_ == LineKind::operation;
    line_ = parser_.line_kind(index, line_);
    instructions_ += line_ == LineKind::other ? 0 : 1;
    statement_on_line_ = false;
}

/// As many statements as stand on one line are as much as one instruction.
void Parser::BodySurvey::count_statement(bool counts) noexcept {
    if (!counts || statement_on_line_)
        return;
    ++statements_;
    statement_on_line_ = true;
}

/// True at the parenthesis of a call of ST. Behind that of an IL call the line ends.
bool Parser::BodySurvey::is_call(std::uint32_t open) const noexcept {
    return line_ == LineKind::other && !behind_instruction_ && depth_ == 0 && open > begin_ &&
           kind(open - 1) == TokenKind::identifier && parser_.il_operator(open - 1) == nullptr &&
           !parser_.ends_operator(open - 1) && !parser_.tokens_[parser_.next(open)].first_on_line();
}

void Parser::BodySurvey::count_token(std::uint32_t index) noexcept {
    const TokenKind here = kind(index);
    switch (here) {
    case TokenKind::left_parenthesis: count_statement(is_call(index)); break;
    case TokenKind::right_parenthesis: break;
    case TokenKind::assign:
    case TokenKind::equal: count_statement(line_ == LineKind::other && depth_ == 0); break;
    case TokenKind::semicolon:
        count_statement(line_ != LineKind::operation);
        instructions_ -= line_ == LineKind::application ? 1 : 0;
        line_ = line_ == LineKind::application ? LineKind::other : line_;
        break;
    default:
        count_statement(statement_words.contains(here));
        closing_words_ = closing_words_ || statement_closers.contains(here);
    }
    depth_ = depth_behind(here, depth_);
}

/// The next token behind `index`, which is not the end, that says something of the language: one of
/// some kinds, or the first on its line.
std::uint32_t Parser::BodySurvey::next_telling(std::uint32_t index) noexcept {
    static constexpr TokenSet telling =
        telling_words | TokenSet{TokenKind::left_parenthesis, TokenKind::right_parenthesis,
                                 TokenKind::assign, TokenKind::equal, TokenKind::semicolon};
    if (statement_on_line_ && line_ == LineKind::other)
        return next_beside_statement(index);
    do
        ++index;
    while (!telling.contains(kind(index)) && !tells_by_line(index));
    return index;
}

/// The same in a line that counts as a statement, of which only words tell more. The parentheses
/// that are passed are counted.
std::uint32_t Parser::BodySurvey::next_beside_statement(std::uint32_t index) noexcept {
    while (!telling_words.contains(kind(++index)) && !tells_by_line(index))
        depth_ = depth_behind(kind(index), depth_);
    return index;
}

/// How far it looks. Where bodies have no ends, each survey could go on to the end of the unit: all
/// of them together look at each token so many times, and then at what is nearest.
std::uint32_t Parser::BodySurvey::furthest() const noexcept {
    constexpr std::uint64_t times = 20;
    constexpr std::uint32_t nearest = 100;
    return parser_.surveyed_ < times * parser_.count_ ? parser_.count_ : begin_ + nearest;
}

void Parser::BodySurvey::survey() {
    const std::uint32_t last = furthest();
    std::uint32_t i = begin_;
    while (i < last && count_at(i))
        i = next_telling(i);
    parser_.surveyed_ += i - begin_;
}

/// Counts what begins at `i`, and of a chart element goes to its end. False where the body ends, or
/// is known.
bool Parser::BodySurvey::count_at(std::uint32_t& i) {
    if (unit_ends.contains(kind(i)) || kind(i) == closer_ || is_decided())
        return false;
    if (chart_closers.contains(kind(i)) || parser_.begins_chart_element(i)) {
        if (closer_ == TokenKind::kw_end_action && !begins_chart_ && parser_.unclosed(closer_) > 0)
            return false; // it may be this one that is not closed
        count_chart_word(i);
        return true;
    }
    const bool begins_line = i == begin_ || parser_.tokens_[i].first_on_line();
    if (begins_line && kind(i) != TokenKind::right_parenthesis)
        begin_line(i);
    count_token(i);
    return true;
}

BodyLanguage Parser::BodySurvey::language() {
    survey();
    // Two elements make a chart, whatever stands around them.
    if (chart_words_ > 2 || chart_words_ + (begins_chart_ ? 1 : 0) > statements_ + instructions_)
        return BodyLanguage::sequential_function_chart;
    if (instructions_ == 0 && statements_ == 0 && !closing_words_)
        return BodyLanguage::instruction_list;
    return instructions_ > statements_ ? BodyLanguage::instruction_list
                                       : BodyLanguage::structured_text;
}

/// The language of the body that begins here (6.2 A28). Each line speaks for one language, and the
/// majority decides, so that one mistake never turns a whole body into another language.
BodyLanguage Parser::body_language() {
    return BodySurvey(*this, open_.back().closer).language();
}

/// Surveys the presumed body, as something in it is reported. When it is no Structured Text, what
/// follows is left unread.
void Parser::ask_presumed_body() {
    const std::uint32_t here = at_;
    move_to(presumed_body_->begin);
    const BodyLanguage language = BodySurvey(*this, presumed_body_->closer).language();
    move_to(here);
    presumed_body_.reset();
    if (language == BodyLanguage::structured_text)
        return;
    misjudged_ = true;
    move_to_end();
}

} // namespace iecfront
