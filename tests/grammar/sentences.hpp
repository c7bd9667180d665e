#pragma once

#include "grammar/ebnf.hpp"
#include "grammar/words.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// A text that a grammar derives.
struct Sentence {
    std::string text;
    /// The productions of the bodies in it, in source order: `statement_list`, ...
    std::vector<std::string> bodies;
};

/// Derives sentences at random, and sees to it that each way to go is gone in some of them.
class SentenceDeriver {
public:
    /// The same seed gives the same sentences.
    SentenceDeriver(const Grammar& grammar, const Words& words, std::uint32_t seed);

    /// Goes where `numbers` says, and nowhere for the sake of going there.
    void follow(std::function<std::uint32_t()> numbers);

    /// What the start symbol, the first production, derives: about `size` tokens, or a few more.
    [[nodiscard]] Sentence derive(std::size_t size);

    /// The ways that no sentence went: `name: part`, for each alternative, option and repetition.
    [[nodiscard]] std::vector<std::string> missed() const;

private:
    void measure();
    [[nodiscard]] std::size_t least_size_of(const Expression& expression, bool lexical) const;

    void derive_tokens(const Expression& expression, std::size_t size);
    void derive_name(const Expression& name, std::size_t size);
    void derive_body(const Expression& languages, std::size_t size);
    void derive_il_function_name(const Expression& name, std::size_t size);
    [[nodiscard]] std::string lexical_text(std::size_t production);
    void derive_characters(const Expression& expression, std::string& text, std::size_t size);
    void derive_identifier(std::size_t production, std::string& text);
    void put(std::string token);
    [[nodiscard]] std::string separator(bool needed);
    [[nodiscard]] std::string_view example_of(std::string_view description);
    [[nodiscard]] std::string terminal_text(std::string_view terminal);

    [[nodiscard]] std::size_t choose(const Expression& alternatives, std::size_t size);
    [[nodiscard]] bool choose_some(const Expression& optional, std::size_t size);
    [[nodiscard]] std::size_t share_of(std::size_t size);
    [[nodiscard]] std::size_t random(std::size_t below) { return random_() % below; }

    const Grammar& grammar_;
    const Words& words_;
    std::function<std::uint32_t()> random_;
    bool evenly_ = true;                  // goes each way
    std::vector<std::size_t> least_size_; // of each expression: in tokens, or in characters
    /// How often each way of an expression was gone: an alternative is a way; options and
    /// repetitions have two, without and with their part.
    std::vector<std::vector<std::size_t>> ways_;
    std::map<std::size_t, std::vector<std::string>> pool_; // texts of lexical productions

    Sentence sentence_;
    std::size_t tokens_ = 0; // put so far
    bool by_line_ = false;
};

} // namespace iecfront::test
