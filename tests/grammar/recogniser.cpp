#include "grammar/recogniser.hpp"

#include "lexer/lexer.hpp"

#include <algorithm>
#include <cctype>

namespace iecfront::test {
namespace {

using Kind = Expression::Kind;

constexpr std::int32_t unknown = -1;
constexpr std::int32_t under_way = -2;

} // namespace

// ---- what both layers share
// ----------------------------------------------------------------------

Recogniser::Recogniser(const Grammar& grammar, Position size, std::size_t states)
    : grammar_(grammar),
      size_(size),
      places_(grammar.productions.size() * states * (size + 1), unknown) {}

void Recogniser::add(Position position, Positions& ends) {
    if (std::find(ends.begin(), ends.end(), position) == ends.end())
        ends.push_back(position);
}

void Recogniser::match(const Expression& expression, Position at, Positions& ends) {
    switch (expression.kind) {
    case Kind::nothing: return add(at, ends);
    case Kind::terminal:
    case Kind::described:
    case Kind::line_end: return match_terminal(expression, at, ends);
    case Kind::name: return match_name(expression, at, ends);
    case Kind::sequence: return match_sequence(expression, at, ends);
    case Kind::alternatives:
        for (const Expression& part : expression.parts)
            match(part, at, ends);
        return;
    case Kind::option: add(at, ends); return match(expression.parts.front(), at, ends);
    case Kind::repetition: return match_repetition(expression.parts.front(), at, ends);
    }
}

void Recogniser::match_sequence(const Expression& sequence, Position at, Positions& ends) {
    Positions reached{at};
    for (const Expression& part : sequence.parts) {
        Positions next;
        for (const Position position : reached)
            match(part, position, next);
        reached.swap(next);
    }
    for (const Position position : reached)
        add(position, ends);
}

void Recogniser::match_repetition(const Expression& repeated, Position at, Positions& ends) {
    Positions reached{at};
    for (std::size_t i = 0; i < reached.size(); ++i) // grows
        match(repeated, Position(reached[i]), reached);
    for (const Position position : reached)
        add(position, ends);
}

void Recogniser::match_production(std::size_t production, std::size_t state, Position at,
                                  Positions& ends) {
    const std::size_t place = (state * grammar_.productions.size() + production) * (size_ + 1) + at;
    if (places_[place] == under_way)
        met_left_recursion_ = true;
    if (places_[place] == unknown) {
        places_[place] = under_way;
        Positions found;
        match(grammar_.productions[production].body, at, found);
        places_[place] = static_cast<std::int32_t>(results_.size());
        results_.push_back(std::move(found));
    }
    if (places_[place] != under_way)
        for (const Position position : results_[static_cast<std::size_t>(places_[place])])
            add(position, ends);
}

// ---- characters
// ----------------------------------------------------------------------------------

namespace {

/// The characters of one token, or of a sign and a number that adjoin.
class CharacterRecogniser : public Recogniser {
public:
    CharacterRecogniser(const Grammar& grammar, const Words& words, std::string_view text)
        : Recogniser(grammar, static_cast<Position>(text.size()), 1),
          words_(words),
          text_(text),
          quote_(std::min(text.find_first_of("'\""), text.size())) {}

    [[nodiscard]] bool derives(std::size_t production) {
        Positions ends;
        match_production(production, 0, 0, ends);
        return std::find(ends.begin(), ends.end(), size_) != ends.end();
    }

private:
    void match_terminal(const Expression& terminal, Position at, Positions& ends) override {
        if (terminal.kind == Kind::described) {
            if (const Position end = end_of_printable(at); end != at)
                add(end, ends);
            return;
        }
        const std::string_view here = text_.substr(at, terminal.text.size());
        // Between quotes every character stands for itself alone.
        const bool same =
            at > quote_ ? here == terminal.text : upper_case(here) == upper_case(terminal.text);
        if (same && !terminal.text.empty())
            add(at + static_cast<Position>(here.size()), ends);
    }

    void match_name(const Expression& name, Position at, Positions& ends) override {
        if (name.text != "identifier")
            return match_production(name.production, 0, at, ends);
        Positions words;
        match_production(name.production, 0, at, words);
        for (const Position end : words)
            if (can_be_identifier(at, end))
                add(end, ends);
    }

    [[nodiscard]] bool can_be_identifier(Position begin, Position end) const {
        const std::string_view word = text_.substr(begin, end - begin);
        const bool before_value = end < size_ && text_[end] == '#';
        return !words_.is_keyword(word) &&
               !(before_value && (upper_case(word) == "T" || upper_case(word) == "D"));
    }

    /// The end of the printable character at `at` that a string holds as it is; `at` when it is
    /// none. A character beyond ASCII is several bytes.
    [[nodiscard]] Position end_of_printable(Position at) const {
        if (at >= size_ || std::string_view("$'\"").find(text_[at]) != std::string_view::npos ||
            static_cast<unsigned char>(text_[at]) < 0x20 || text_[at] == 0x7F)
            return at;
        Position end = at + 1;
        while (end < size_ && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U)
            ++end;
        return end;
    }

    const Words& words_;
    std::string_view text_;
    std::size_t quote_; // where the first one stands
};

} // namespace

bool LexicalRecogniser::derives(std::size_t production, std::string_view text) const {
    const auto [place, is_new] = known_.try_emplace({production, std::string(text)}, false);
    if (is_new) {
        // The start itself can be the production of identifiers: enter it by name.
        const Production& start = grammar_.productions[production];
        CharacterRecogniser recogniser(grammar_, words_, text);
        place->second = recogniser.derives(production) &&
                        !(start.name == "identifier" && words_.is_keyword(text));
    }
    return place->second;
}

// ---- tokens
// --------------------------------------------------------------------------------------

namespace {

/// A token, or the line end before one.
struct Symbol {
    std::string upper; // its text in upper case; empty for a line end
    TextRange range;   // in the text
};

/// A whole comment that holds no other, or a whole pragma.
[[nodiscard]] bool is_separator(std::string_view trivia) {
    return trivia.starts_with('{')
               ? trivia.ends_with('}')
               : trivia.starts_with("(*") && trivia.find("(*", 2) == std::string_view::npos &&
                     trivia.size() >= 4 && trivia.ends_with("*)");
}

[[nodiscard]] bool is_word_part(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Two words or numbers in a row need a separator, wherever the lexer begins tokens: `3MOD`.
[[nodiscard]] bool words_are_separated(std::string_view text, const LexedText& lexed) {
    return std::ranges::adjacent_find(lexed.tokens, [text](Token first, Token second) {
               return first.end() == second.offset() && second.offset() < text.size() &&
                      is_word_part(text[first.end() - 1]) && is_word_part(text[second.offset()]);
           }) == lexed.tokens.end();
}

[[nodiscard]] std::vector<Symbol> symbols_of(std::string_view text, const LexedText& lexed) {
    std::vector<Symbol> symbols;
    for (const Token token : lexed.tokens) {
        if (token.first_on_line() && !symbols.empty())
            symbols.push_back({{}, {token.offset(), token.offset()}});
        if (token.kind() != TokenKind::end_of_unit)
            symbols.push_back(
                {upper_case(text.substr(token.offset(), token.length())), token.range()});
    }
    return symbols;
}

class TokenRecogniser : public Recogniser {
public:
    TokenRecogniser(const Grammar& grammar, const LexicalRecogniser& lexical, std::string_view text,
                    std::vector<Symbol> symbols)
        : Recogniser(grammar, static_cast<Position>(symbols.size()), 2),
          lexical_(lexical),
          text_(text),
          symbols_(std::move(symbols)) {}

    [[nodiscard]] bool derives_all() {
        Positions ends;
        match_production(0, 0, 0, ends);
        return !met_left_recursion() && std::any_of(ends.begin(), ends.end(), [&](Position end) {
            return behind_line_ends(end) == size_;
        });
    }

private:
    /// Line ends are white space everywhere but in Instruction List.
    [[nodiscard]] Position behind_line_ends(Position at) const {
        while (!by_line_ && at < size_ && symbols_[at].upper.empty())
            ++at;
        return at;
    }

    void match_terminal(const Expression& terminal, Position at, Positions& ends) override {
        if (terminal.kind == Kind::line_end) {
            if (at < size_ && symbols_[at].upper.empty())
                add(at + 1, ends);
        } else if (terminal.kind == Kind::terminal) {
            match_pieces(at, ends, [&](Position begin, Position end) {
                return end == begin + 1 ? symbols_[begin].upper == terminal.text
                                        : upper_case(text_between(begin, end)) == terminal.text;
            });
        }
        // What is described is a name that `derived_function_name` derives, too.
    }

    void match_name(const Expression& name, Position at, Positions& ends) override {
        const Production& production = grammar_.productions[name.production];
        if (production.lexical()) {
            match_pieces(at, ends, [&](Position begin, Position end) {
                return lexical_.derives(name.production, text_between(begin, end));
            });
            return;
        }
        const bool outside = by_line_;
        by_line_ = by_line_ || production.by_line();
        if (production.name == "il_function_name")
            match_il_function_name(name.production, at, ends);
        else
            match_production(name.production, by_line_ ? 1 : 0, at, ends);
        by_line_ = outside;
    }

    /// An operator of B.2.2 is none.
    void match_il_function_name(std::size_t production, Position at, Positions& ends) {
        if (at < size_ && lexical_.words().il_operators.contains(symbols_[at].upper))
            return;
        match_production(production, 1, at, ends);
    }

    /// Tries the token at `at`, and what it makes with the one that adjoins it: a sign and its
    /// number are two tokens for the lexer, and so are the parts of `&N`.
    template<class Matches>
    void match_pieces(Position at, Positions& ends, Matches matches) {
        at = behind_line_ends(at);
        if (at == size_ || symbols_[at].upper.empty())
            return;
        if (matches(at, at + 1))
            add(at + 1, ends);
        const bool adjoined = at + 1 < size_ && !symbols_[at + 1].upper.empty() &&
                              symbols_[at].range.end == symbols_[at + 1].range.begin;
        if (adjoined && matches(at, at + 2))
            add(at + 2, ends);
    }

    [[nodiscard]] std::string_view text_between(Position begin, Position end) const {
        const std::uint32_t first = symbols_[begin].range.begin;
        return text_.substr(first, symbols_[end - 1].range.end - first);
    }

    const LexicalRecogniser& lexical_;
    std::string_view text_;
    std::vector<Symbol> symbols_;
    bool by_line_ = false;
};

} // namespace

bool derives(const Grammar& grammar, const LexicalRecogniser& lexical, std::string_view text) {
    const std::string terminated(text); // a zero byte stands behind it
    const LexedText lexed = lex(terminated, Encoding::utf8);
    const bool well_separated =
        std::all_of(lexed.trivia.begin(), lexed.trivia.end(), [&](const Trivia& one) {
            return is_separator(text.substr(one.range.begin, one.range.size()));
        });
    return well_separated && words_are_separated(text, lexed) &&
           TokenRecogniser(grammar, lexical, text, symbols_of(text, lexed)).derives_all();
}

} // namespace iecfront::test
