#include "parser/repair.hpp"

#include "parser/parser.hpp"
#include "parser/token_set.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace iecfront {
namespace {

constexpr TokenKind nothing = TokenKind::unknown; // the token is passed over

// What an operand is made of, a type as well as a value.
constexpr TokenSet operands =
    TokenSet::range(TokenKind::integer, TokenKind::date_and_time) |
    TokenSet::range(TokenKind::kw_bool, TokenKind::kw_any_date) |
    TokenSet{TokenKind::identifier, TokenKind::enumerated_value, TokenKind::direct_variable,
             TokenKind::kw_true,    TokenKind::kw_false,         TokenKind::kw_en,
             TokenKind::kw_eno};
constexpr TokenSet operand_ends =
    operands | TokenSet{TokenKind::right_parenthesis, TokenKind::right_bracket};
constexpr TokenSet operand_starts =
    operands | TokenSet{TokenKind::left_parenthesis, TokenKind::left_bracket, TokenKind::minus,
                        TokenKind::plus, TokenKind::kw_not};

/// What a token can be meant to be, and what it then stands between.
struct Meaning {
    enum Neighbour : std::uint8_t { any, operand, none };
    TokenKind kind;
    Neighbour before;
    Neighbour behind;
};

/// A name stands for any type and most operands.
constexpr Meaning any_name = {TokenKind::identifier, Meaning::none, Meaning::none};

/// The likeliest first. One operator stands for all.
constexpr std::array meanings = {
    Meaning{TokenKind::semicolon, Meaning::operand, Meaning::any},
    Meaning{TokenKind::colon, Meaning::operand, Meaning::any},
    Meaning{TokenKind::assign, Meaning::operand, Meaning::operand},
    Meaning{TokenKind::comma, Meaning::operand, Meaning::operand},
    Meaning{TokenKind::equal, Meaning::operand, Meaning::operand},
    Meaning{TokenKind::dot, Meaning::operand, Meaning::operand},
};

/// A token that is a part of a construct, and what else of it stands before it in the statement, or
/// behind it.
struct PartOfConstruct {
    Meaning meaning;
    TokenKind other;
    TokenKind another;
    bool behind = false;
};
constexpr std::array parts_of_constructs = {
    PartOfConstruct{{TokenKind::kw_then, Meaning::operand, Meaning::any},
                    TokenKind::kw_if,
                    TokenKind::kw_elsif},
    PartOfConstruct{
        {TokenKind::kw_do, Meaning::operand, Meaning::any}, TokenKind::kw_for, TokenKind::kw_while},
    PartOfConstruct{{TokenKind::kw_of, Meaning::operand, Meaning::any},
                    TokenKind::kw_case,
                    TokenKind::kw_array},
    PartOfConstruct{{TokenKind::kw_to, Meaning::operand, Meaning::operand},
                    TokenKind::kw_for,
                    TokenKind::kw_for},
    PartOfConstruct{{TokenKind::dot_dot, Meaning::operand, Meaning::operand},
                    TokenKind::left_bracket,
                    TokenKind::left_parenthesis},
    PartOfConstruct{{TokenKind::right_bracket, Meaning::operand, Meaning::none},
                    TokenKind::left_bracket,
                    TokenKind::left_bracket},
    PartOfConstruct{{TokenKind::right_parenthesis, Meaning::operand, Meaning::none},
                    TokenKind::left_parenthesis,
                    TokenKind::left_parenthesis},
    PartOfConstruct{{TokenKind::left_bracket, Meaning::any, Meaning::operand},
                    TokenKind::right_bracket,
                    TokenKind::right_bracket,
                    true},
    PartOfConstruct{{TokenKind::left_parenthesis, Meaning::any, Meaning::operand},
                    TokenKind::right_parenthesis,
                    TokenKind::right_parenthesis,
                    true},
};

/// So far from a token it is looked for the rest of its construct.
constexpr std::size_t furthest_part = 20;

/// Closing words, which are tried when they are reported missing.
constexpr std::array closing_words = {TokenKind::kw_end_if,    TokenKind::kw_end_var,
                                      TokenKind::kw_end_case,  TokenKind::kw_end_for,
                                      TokenKind::kw_end_while, TokenKind::kw_end_repeat,
                                      TokenKind::kw_end_struct};

/// So many tokens apart two reports have the same cause, at most.
constexpr std::size_t nearby = 6;

/// So many times the tokens of the unit are read again, at most: it bounds the time that a long one
/// takes.
constexpr std::size_t readings = 20;

/// One fault seldom has more reports.
constexpr std::size_t most_reports = 8;

/// Reports that say that the parser found a token that it cannot use, or lacks one.
bool is_about_token(const Diagnostic& report) noexcept {
    switch (report.id) {
    case DiagnosticId::missing_closing_word:
    case DiagnosticId::stray_closing_word:
    case DiagnosticId::missing_semicolon:
    case DiagnosticId::semicolon_left_out:
    case DiagnosticId::missing_token:
    case DiagnosticId::unexpected_token:
    case DiagnosticId::missing_expression:
    case DiagnosticId::missing_name:
    case DiagnosticId::missing_type:
    case DiagnosticId::not_a_statement:
    case DiagnosticId::not_a_declaration:
    case DiagnosticId::declaration_after_body:
    case DiagnosticId::subrange_needs_two_bounds: return true;
    default: return false;
    }
}

/// Reports that say what is meant, or that a dialect is used. What a wrong token makes of a valid
/// text is no dialect.
bool is_specific(const Diagnostic& report) noexcept {
    switch (report.id) {
    case DiagnosticId::misspelt_word:
    case DiagnosticId::equal_for_assignment:
    case DiagnosticId::assignment_for_equal:
    case DiagnosticId::foreign_operator:
    case DiagnosticId::else_if:
    case DiagnosticId::white_space_in_delimiter: return true;
    case DiagnosticId::extra_semicolon:
    case DiagnosticId::semicolon_left_out:
    case DiagnosticId::empty_block:
    case DiagnosticId::mixed_block:
    case DiagnosticId::constant_expression:
    case DiagnosticId::expression_statement:
    case DiagnosticId::parentheses_without_line_end: return false;
    default: return diagnostic_info(report.id).category == DiagnosticClass::extension;
    }
}

bool is_about_closing_word(const Diagnostic& report) noexcept {
    return report.id == DiagnosticId::missing_closing_word ||
           report.id == DiagnosticId::mismatched_closing_word ||
           report.id == DiagnosticId::stray_closing_word;
}

class RepairFinder {
public:
    RepairFinder(const ParserInput& input, const std::vector<Diagnostic>& reports,
                 ParserArena& arena)
        : input_(input),
          reports_(reports),
          arena_(arena),
          tokens_(input.tokens.begin(), input.tokens.end()),
          to_read_(readings * input.tokens.size()),
          fewest_(reports.size() - 1) {}

    [[nodiscard]] std::optional<Reading> find(std::size_t kept) {
        const auto fault =
            std::find_if(reports_.begin(), reports_.end(), [](const Diagnostic& one) {
                return is_about_token(one) || is_about_closing_word(one);
            });
        if (fault == reports_.end() || !is_about_token(*fault) || !has_company(fault))
            return std::nullopt;
        // With the fault goes what is reported next.
        expected_.assign(reports_.begin(), fault);
        const auto next = std::find_if_not(fault + 1, reports_.end(), is_specific);
        for (auto report = fault + 1; report != reports_.end(); ++report)
            if (report != next)
                expected_.push_back(*report);
        const std::size_t place = token_at(fault->range.begin);
        for (const std::size_t token : {place, place - 1}) {
            attempt({token, nothing});
            if (fits(token, any_name))
                attempt({token, any_name.kind});
        }
        for (const Meaning& meant : meanings)
            if (fits(place, meant))
                attempt({place, meant.kind});
        for (const PartOfConstruct& part : parts_of_constructs)
            if (fits(place, part.meaning) && has_rest(place, part))
                attempt({place, part.meaning.kind});
        for (const TokenKind meant : closing_words)
            for (const std::size_t token : {place, place - 1})
                if (is_reported_missing(meant) && is_mark(token))
                    attempt({token, meant});
        if (!best_)
            return std::nullopt;
        arena_.rewind(kept);
        std::optional<Reading> reading = read_with(*best_);
        if (reading)
            reading->reports.push_back(report_of(*best_));
        return reading;
    }

private:
    struct Change {
        std::size_t token;
        TokenKind meant;
    };

    /// True when another report can have the same cause: it is near, or about a closing word.
    [[nodiscard]] bool has_company(std::vector<Diagnostic>::const_iterator fault) const {
        const std::size_t place = token_at(fault->range.begin);
        return std::any_of(reports_.begin(), reports_.end(), [&](const Diagnostic& other) {
            const std::size_t token = token_at(other.range.begin);
            return &other != &*fault && !is_specific(other) &&
                   ((token <= place + nearby && place <= token + nearby) ||
                    (&other > &*fault && is_about_closing_word(other)));
        });
    }

    /// Keeps the change that leaves the fewest reports.
    void attempt(const Change& change) {
        if (fewest_ == 0 || to_read_ == 0 || arena_.full() || !is_possible(change))
            return;
        const std::size_t used = arena_.used();
        const std::optional<Reading> reading = read_with(change);
        arena_.rewind(used);
        if (reading && reading->reports.size() < fewest_) {
            best_ = change;
            fewest_ = reading->reports.size();
        }
    }

    /// No name or literal: a closing word is not taken for one.
    [[nodiscard]] bool is_mark(std::size_t token) const {
        return token < tokens_.size() && !operands.contains(tokens_[token].kind());
    }

    [[nodiscard]] bool is_reported_missing(TokenKind word) const {
        return std::any_of(reports_.begin(), reports_.end(), [word](const Diagnostic& report) {
            return report.id == DiagnosticId::missing_closing_word &&
                   std::get<std::string>(report.arguments.front()) == spelling(word);
        });
    }

    /// The token at or behind a place.
    [[nodiscard]] std::size_t token_at(std::uint32_t offset) const {
        const auto at = std::find_if(tokens_.begin(), tokens_.end(),
                                     [offset](const Token& one) { return one.end() > offset; });
        return static_cast<std::size_t>(at - tokens_.begin());
    }

    [[nodiscard]] bool is_possible(const Change& change) const {
        // What the opener is decides what the unit is.
        if (change.token >= tokens_.size() - 1 || change.token == input_.opener)
            return false;
        const Token token = tokens_[change.token];
        // A `;` at the end of a line is where it belongs, or in the place of another mark.
        const bool ends_line = token.kind() == TokenKind::semicolon &&
                               tokens_[change.token + 1].first_on_line() &&
                               change.meant != TokenKind::colon &&
                               change.meant != TokenKind::comma && !is_keyword(change.meant);
        return token.kind() != change.meant && token.kind() != nothing && !token.malformed() &&
               !ends_line;
    }

    [[nodiscard]] bool fits(std::size_t index, const Meaning& meant) const {
        if (index == 0 || index >= tokens_.size() - 1)
            return false;
        const bool ends = operand_ends.contains(tokens_[index - 1].kind());
        const TokenKind behind = tokens_[index + 1].kind();
        return (meant.before == Meaning::any || ends == (meant.before == Meaning::operand)) &&
               (meant.behind != Meaning::operand || operand_starts.contains(behind)) &&
               (meant.behind != Meaning::none || !operands.contains(behind));
    }

    /// True when the rest of the construct stands in the statement around the token.
    [[nodiscard]] bool has_rest(std::size_t index, const PartOfConstruct& part) const {
        for (std::size_t i = 0; i < furthest_part; ++i) {
            if (part.behind ? index + 1 == tokens_.size() : index == 0)
                return false;
            index = part.behind ? index + 1 : index - 1;
            const TokenKind kind = tokens_[index].kind();
            if (kind == part.other || kind == part.another)
                return true;
            if (kind == part.meaning.kind || kind == TokenKind::semicolon)
                return false;
        }
        return false;
    }

    void apply(const Change& change) {
        Token& token = tokens_[change.token];
        Token& behind = tokens_[change.token + 1];
        if (change.meant == nothing && token.first_on_line())
            behind =
                Token(behind.kind(), behind.offset(), behind.length(), true, behind.malformed());
        token = Token(change.meant, token.offset(), token.length(), token.first_on_line());
    }

    /// What is read after a change; nothing when anything is reported that is not expected, or not
    /// reported that does not depend on it.
    [[nodiscard]] std::optional<Reading> read_with(const Change& change) {
        const std::array before = {tokens_[change.token], tokens_[change.token + 1]};
        apply(change);
        Parser parser(input_.text, tokens_, input_.lexical, input_.opener, arena_, input_.options);
        parser.expect_reports(expected_);
        Reading reading{parser.parse_fragment(input_.options.read_as), parser.take_diagnostics()};
        std::copy(before.begin(), before.end(),
                  tokens_.begin() + static_cast<std::ptrdiff_t>(change.token));
        to_read_ -= std::min<std::size_t>(to_read_, parser.stopped_at().value_or(tokens_.size()));
        const bool expected =
            std::all_of(reading.reports.begin(), reading.reports.end(),
                        [this](const Diagnostic& one) { return Parser::holds(expected_, one); }) &&
            std::none_of(reports_.begin(), reports_.end(), [&](const Diagnostic& one) {
                return is_specific(one) && !Parser::holds(reading.reports, one);
            });
        return expected ? std::optional(std::move(reading)) : std::nullopt;
    }

    [[nodiscard]] Diagnostic report_of(const Change& change) const {
        const Token token = input_.tokens[change.token];
        Diagnostic report{DiagnosticId::unexpected_token, token.range(), {}, {}, {}};
        report.arguments = {expected(change), quoted(token)};
        const bool exact = is_keyword(change.meant) || is_delimiter(change.meant);
        if (change.meant == nothing)
            report.fixes.push_back({{removal_of(change.token)}});
        else if (exact && change.meant != TokenKind::equal)
            report.fixes.push_back({{{token.range(), spaced(change)}}});
        return report;
    }

    [[nodiscard]] std::string quoted(const Token& token) const {
        return "`" + std::string(input_.text.substr(token.offset(), token.length())) + "`";
    }

    /// What is to stand in the place of the token.
    [[nodiscard]] std::string expected(const Change& change) const {
        if (change.meant == TokenKind::equal)
            return "an operator";
        if (change.meant == TokenKind::identifier)
            return "a name";
        if (change.meant != nothing)
            return "`" + std::string(spelling(change.meant)) + "`";
        const Token& behind = input_.tokens[change.token + 1];
        if (behind.kind() == TokenKind::end_of_unit)
            return std::string(spelling(behind.kind()));
        return quoted(behind);
    }

    [[nodiscard]] bool blank_at(std::uint32_t offset) const {
        constexpr std::string_view blanks = " \t\r\n";
        return offset >= input_.text.size() || blanks.find(input_.text[offset]) != blanks.npos;
    }
    [[nodiscard]] bool blank_before(TextRange range) const {
        return range.begin == 0 || blank_at(range.begin - 1);
    }

    /// Leaves a blank between the tokens on both sides, and only one.
    [[nodiscard]] TextEdit removal_of(std::size_t index) const {
        TextRange range = input_.tokens[index].range();
        const bool before = blank_before(range);
        if (before && range.end < input_.text.size() && input_.text[range.end] == ' ')
            ++range.end;
        return {range, before || blank_at(range.end) ? "" : " "};
    }

    /// A word must not run into its neighbours.
    [[nodiscard]] std::string spaced(const Change& change) const {
        const TextRange range = input_.tokens[change.token].range();
        std::string words(spelling(change.meant));
        if (is_keyword(change.meant) && !blank_before(range))
            words.insert(0, " ");
        if (is_keyword(change.meant) && !blank_at(range.end))
            words += ' ';
        return words;
    }

    const ParserInput& input_;
    const std::vector<Diagnostic>& reports_;
    ParserArena& arena_;
    std::vector<Diagnostic> expected_; // when the fault is repaired
    std::vector<Token> tokens_;
    std::size_t to_read_; // so many tokens, at most
    std::size_t fewest_;  // reports that are left; with one about the token they must be less
    std::optional<Change> best_;
};

} // namespace

std::optional<Reading> repair(const ParserInput& input, const std::vector<Diagnostic>& reports,
                              ParserArena& arena, std::size_t kept) {
    if (reports.size() < 2 || reports.size() > most_reports)
        return std::nullopt;
    return RepairFinder(input, reports, arena).find(kept);
}

} // namespace iecfront
