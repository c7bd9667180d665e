#pragma once

#include "grammar/ebnf.hpp"
#include "grammar/words.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Recognisers that know nothing but a grammar: what they accept is what its productions derive.
namespace iecfront::test {

/// Finds where what an expression derives can end, for all ways to derive it. Remembers it of each
/// production, and so needs time that grows with the text and not with the number of ways.
class Recogniser {
public:
    using Position = std::uint32_t;
    using Positions = std::vector<Position>; // none twice

    Recogniser(const Recogniser&) = delete;
    Recogniser& operator=(const Recogniser&) = delete;

    /// True when a production can call itself without anything in between: such a grammar cannot
    /// be used, and gives too little.
    [[nodiscard]] bool met_left_recursion() const { return met_left_recursion_; }

protected:
    /// A text has the positions from 0 to `size`. Productions can be entered in `states` states.
    Recogniser(const Grammar& grammar, Position size, std::size_t states);
    ~Recogniser() = default;

    /// Adds to `ends`.
    void match(const Expression& expression, Position at, Positions& ends);
    void match_production(std::size_t production, std::size_t state, Position at, Positions& ends);

    /// Adds to `ends` where a terminal, description or line end can end.
    virtual void match_terminal(const Expression& terminal, Position at, Positions& ends) = 0;
    virtual void match_name(const Expression& name, Position at, Positions& ends) = 0;

    static void add(Position position, Positions& ends);

    const Grammar& grammar_;
    const Position size_;

private:
    void match_sequence(const Expression& sequence, Position at, Positions& ends);
    void match_repetition(const Expression& repeated, Position at, Positions& ends);

    std::vector<std::int32_t> places_; // in results_, for each production, state and position
    std::vector<Positions> results_;
    bool met_left_recursion_ = false;
};

/// The lexical layer: says of a piece of text whether a production derives its characters. A
/// keyword is no identifier, nor are T and D before a number sign (A4).
class LexicalRecogniser {
public:
    LexicalRecogniser(const Grammar& grammar, const Words& words)
        : grammar_(grammar), words_(words) {}

    [[nodiscard]] bool derives(std::size_t production, std::string_view text) const;
    [[nodiscard]] const Words& words() const { return words_; }

private:
    const Grammar& grammar_;
    const Words& words_;
    mutable std::map<std::pair<std::size_t, std::string>, bool, std::less<>> known_;
};

/// The layer of tokens: says whether the start symbol derives `text`. Lets the lexer of the project
/// say where tokens and lines begin, and nothing else.
[[nodiscard]] bool derives(const Grammar& grammar, const LexicalRecogniser& lexical,
                           std::string_view text);

} // namespace iecfront::test
