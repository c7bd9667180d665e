#include "grammar/sentences.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace iecfront::test {
namespace {

using Kind = Expression::Kind;

constexpr std::size_t endless = std::numeric_limits<std::size_t>::max() / 4;

/// Lexical productions are derived this often; after that their texts are used again, which saves
/// the recogniser work.
constexpr std::size_t pool_size = 400;

struct Example {
    std::string_view description;
    std::vector<std::string_view> texts;
};

/// What stands for a terminal that is described in words.
[[nodiscard]] const std::vector<std::string_view>& examples_of(std::string_view description) {
    static const std::vector<Example> examples{
        {"any printable character but the dollar sign and the two quotes",
         {"a", "Z", "0", " ", "(*", "*)", "{", ";", "#", "%", "//", "\xC3\x84"}},
        {"the name of a type conversion",
         {"INT_TO_REAL", "BOOL_TO_STRING", "WORD_BCD_TO_UINT", "UINT_TO_BCD_WORD"}},
        {"the typed form of one of these names", {"ADD_INT", "SHL_WORD", "LIMIT_TIME", "EQ_DATE"}},
    };
    static const std::vector<std::string_view> none{""};
    const auto found = std::find_if(examples.begin(), examples.end(), [&](const Example& one) {
        return one.description == description;
    });
    return found == examples.end() ? none : found->texts;
}

/// True when two tokens would be read as others if nothing stood between them.
[[nodiscard]] bool would_join(std::string_view left, std::string_view right) {
    if (left.empty() || right.empty())
        return false;
    const auto makes_word = [](char c) { return is_word_character(c) || c == '#'; };
    if (makes_word(left.back()) && makes_word(right.front()))
        return true;
    if (left == "&") // `&N` is an operator of its own
        return is_word_character(right.front()) || right.front() == '&';
    static constexpr std::array<std::string_view, 14> joined{
        ":=", "=>", "==", "<>", "<=", ">=", "**", "*)", "(*", "/*", "//", "..", "*=", "||"};
    const std::array<char, 2> pair{left.back(), right.front()};
    return std::find(joined.begin(), joined.end(), std::string_view(pair.data(), 2)) !=
           joined.end();
}

[[nodiscard]] bool is_choice(Kind kind) {
    return kind == Kind::alternatives || kind == Kind::option || kind == Kind::repetition;
}

} // namespace

SentenceDeriver::SentenceDeriver(const Grammar& grammar, const Words& words, std::uint32_t seed)
    : grammar_(grammar),
      words_(words),
      random_(std::mt19937(seed)),
      least_size_(grammar.expression_count),
      ways_(grammar.expression_count) {
    for (const Production& production : grammar.productions)
        for_each_expression(production.body, [&](const Expression& one) {
            least_size_[one.number] = endless;
            if (is_choice(one.kind))
                ways_[one.number].resize(one.kind == Kind::alternatives ? one.parts.size() : 2);
        });
    measure();
}

void SentenceDeriver::follow(std::function<std::uint32_t()> numbers) {
    random_ = std::move(numbers);
    evenly_ = false;
    pool_.clear();
}

// ---- sizes
// ---------------------------------------------------------------------------------------

/// Computes the least sizes, again and again until nothing gets any smaller.
void SentenceDeriver::measure() {
    for (bool changed = true; changed;) {
        changed = false;
        for (const Production& production : grammar_.productions)
            for_each_expression(production.body, [&](const Expression& one) {
                const std::size_t size = least_size_of(one, production.lexical());
                changed = changed || size < least_size_[one.number];
                least_size_[one.number] = size;
            });
    }
}

/// In characters inside of lexical productions, in tokens elsewhere.
std::size_t SentenceDeriver::least_size_of(const Expression& expression, bool lexical) const {
    std::size_t size = expression.kind == Kind::alternatives ? endless : 0;
    switch (expression.kind) {
    case Kind::terminal:
    case Kind::described: return 1;
    case Kind::name: {
        const Production& production = grammar_.productions[expression.production];
        return !lexical && production.lexical() ? 1 : least_size_[production.body.number];
    }
    case Kind::sequence:
        for (const Expression& part : expression.parts)
            size = std::min(size + least_size_[part.number], endless);
        return size;
    case Kind::alternatives:
        for (const Expression& part : expression.parts)
            size = std::min(size, least_size_[part.number]);
        return size;
    default: return 0;
    }
}

// ---- choices
// -------------------------------------------------------------------------------------

/// What one of a row may take of what is left for all: now and then a part only, so that something
/// is left for the others.
std::size_t SentenceDeriver::share_of(std::size_t size) {
    return random(3) == 0 ? random(size + 1) : size;
}

/// A way that fits into `size`: one that was never taken, else the one taken least, or any.
std::size_t SentenceDeriver::choose(const Expression& alternatives, std::size_t size) {
    std::vector<std::size_t>& taken = ways_[alternatives.number];
    const std::size_t limit = std::max(size, least_size_[alternatives.number]);
    std::vector<std::size_t> fitting;
    for (std::size_t i = 0; i < alternatives.parts.size(); ++i)
        if (least_size_[alternatives.parts[i].number] <= limit)
            fitting.push_back(i);
    std::size_t way =
        *std::min_element(fitting.begin(), fitting.end(),
                          [&](std::size_t a, std::size_t b) { return taken[a] < taken[b]; });
    if (!evenly_ || (taken[way] > 0 && random(3) > 0))
        way = fitting[random(fitting.size())];
    ++taken[way];
    return way;
}

bool SentenceDeriver::choose_some(const Expression& optional, std::size_t size) {
    std::vector<std::size_t>& taken = ways_[optional.number];
    const bool fits = least_size_[optional.parts.front().number] < size;
    const bool some = fits && ((evenly_ && taken[1] == 0) || tokens_ == 0 || random(5) < 2);
    ++taken[some ? 1 : 0];
    return some;
}

std::vector<std::string> SentenceDeriver::missed() const {
    std::vector<std::string> result;
    for (const Production& production : grammar_.productions)
        for_each_expression(production.body, [&](const Expression& one) {
            const std::vector<std::size_t>& taken = ways_[one.number];
            for (std::size_t i = 0; i < taken.size(); ++i)
                if (taken[i] == 0)
                    result.push_back(production.name + ": way " + std::to_string(i + 1) + " of " +
                                     std::to_string(taken.size()) + " in `" + production.text +
                                     "`");
        });
    return result;
}

// ---- tokens
// --------------------------------------------------------------------------------------

Sentence SentenceDeriver::derive(std::size_t size) {
    sentence_ = {};
    tokens_ = 0;
    derive_tokens(grammar_.productions.front().body, size);
    sentence_.text += "\n";
    return std::move(sentence_);
}

void SentenceDeriver::derive_tokens(const Expression& expression, std::size_t size) {
    const std::size_t end = tokens_ + size;
    const auto left = [&] { return end - std::min(end, tokens_); };
    switch (expression.kind) {
    case Kind::nothing: return;
    case Kind::terminal: return put(terminal_text(expression.text));
    case Kind::described: return put(terminal_text(example_of(expression.text)));
    case Kind::line_end: sentence_.text += "\n"; return;
    case Kind::name: return derive_name(expression, size);
    case Kind::sequence:
        for (const Expression& part : expression.parts)
            derive_tokens(part, &part == &expression.parts.back() ? left() : share_of(left()));
        return;
    case Kind::alternatives: return derive_tokens(expression.parts[choose(expression, size)], size);
    case Kind::option:
        if (choose_some(expression, size))
            derive_tokens(expression.parts.front(), size);
        return;
    case Kind::repetition:
        while (choose_some(expression, left()))
            derive_tokens(expression.parts.front(), share_of(left()));
        return;
    }
}

void SentenceDeriver::derive_name(const Expression& name, std::size_t size) {
    const Production& production = grammar_.productions[name.production];
    if (production.lexical())
        return put(lexical_text(name.production));
    const bool outside = std::exchange(by_line_, by_line_ || production.by_line());
    if (production.name == "function_body" || production.name == "function_block_body")
        derive_body(production.body, size);
    else if (production.name == "il_function_name")
        derive_il_function_name(production.body, size);
    else
        derive_tokens(production.body, size);
    by_line_ = outside;
}

void SentenceDeriver::derive_body(const Expression& languages, std::size_t size) {
    const Expression& language = languages.parts[choose(languages, size)];
    sentence_.bodies.push_back(language.text);
    if (language.text == "instruction_list") // in the line of a head not each can be told
        sentence_.text += '\n';
    derive_tokens(language, size);
}

/// A name that is no operator of B.2.2.
void SentenceDeriver::derive_il_function_name(const Expression& name, std::size_t size) {
    const std::string before = sentence_.text;
    const std::size_t tokens = tokens_;
    std::string word;
    do {
        sentence_.text = before;
        tokens_ = tokens;
        derive_tokens(name, size);
        const std::string& text = sentence_.text;
        const auto begin = std::find_if_not(text.rbegin(), text.rend(), is_word_character);
        word =
            upper_case(text.substr(text.size() - static_cast<std::size_t>(begin - text.rbegin())));
    } while (words_.il_operators.contains(word));
}

/// Puts a token behind the others, with or without something in between.
void SentenceDeriver::put(std::string token) {
    ++tokens_;
    const std::string_view text = sentence_.text;
    const bool at_line_start = text.empty() || text.back() == '\n';
    std::size_t last = text.size(); // of the token before it
    while (last > 0 && text[last - 1] != ' ' && text[last - 1] != '\n')
        --last;
    if (!at_line_start)
        sentence_.text += separator(would_join(text.substr(last), token));
    sentence_.text += token;
}

std::string SentenceDeriver::separator(bool needed) {
    static constexpr std::array<std::string_view, 6> rare{"\t",      "  ",   "(* a; ' (x) *)",
                                                          " { ; } ", "(**)", " (*\n*) "};
    if (random(20) == 0)
        return std::string(rare[random(rare.size())]);
    if (!by_line_ && random(8) == 0)
        return "\n";
    return needed || random(3) > 0 ? " " : "";
}

std::string_view SentenceDeriver::example_of(std::string_view description) {
    const auto& examples = examples_of(description);
    return examples[random(examples.size())];
}

/// The letters of a terminal match upper and lower case alike.
std::string SentenceDeriver::terminal_text(std::string_view terminal) {
    std::string text(terminal);
    if (random(8) == 0)
        for (char& c : text)
            c = c >= 'A' && c <= 'Z' && random(2) == 0 ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

// ---- characters
// ----------------------------------------------------------------------------------

std::string SentenceDeriver::lexical_text(std::size_t production) {
    std::vector<std::string>& texts = pool_[production];
    if (texts.size() >= pool_size)
        return texts[random(texts.size())];
    std::string text;
    const Production& start = grammar_.productions[production];
    if (start.name == "identifier")
        derive_identifier(production, text);
    else
        derive_characters(start.body, text, random(30));
    texts.push_back(text);
    return text;
}

void SentenceDeriver::derive_characters(const Expression& expression, std::string& text,
                                        std::size_t size) {
    const std::size_t begin = text.size();
    const auto left = [&] { return size - std::min(size, text.size() - begin); };
    switch (expression.kind) {
    case Kind::terminal:
        // Between quotes every character stands for itself alone.
        text += text.find_first_of("'\"") == std::string::npos ? terminal_text(expression.text)
                                                               : expression.text;
        return;
    case Kind::described: text += example_of(expression.text); return;
    case Kind::name:
        if (expression.text == "identifier")
            return derive_identifier(expression.production, text);
        return derive_characters(grammar_.productions[expression.production].body, text, size);
    case Kind::sequence:
        for (const Expression& part : expression.parts)
            derive_characters(part, text, left());
        return;
    case Kind::alternatives:
        return derive_characters(expression.parts[choose(expression, size)], text, size);
    case Kind::option:
        if (choose_some(expression, size))
            derive_characters(expression.parts.front(), text, size);
        return;
    case Kind::repetition:
        while (choose_some(expression, left()))
            derive_characters(expression.parts.front(), text, left());
        return;
    default: return;
    }
}

/// A name that can be given to something: no keyword, no name of a standard function or function
/// block (K6), and none that would begin a literal before a number sign (A4).
void SentenceDeriver::derive_identifier(std::size_t production, std::string& text) {
    std::string word;
    do {
        word.clear();
        derive_characters(grammar_.productions[production].body, word, random(6));
    } while (words_.is_reserved(word) || upper_case(word) == "T" || upper_case(word) == "D");
    text += word;
}

} // namespace iecfront::test
