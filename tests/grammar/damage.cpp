#include "grammar/damage.hpp"

#include "grammar/reading.hpp"

#include <algorithm>

namespace iecfront::test {
namespace {

/// What replaces a token when it is no terminal; some of each class of literals.
constexpr std::string_view literals[] = {
    "a",      "B7",   "5",   "-5",    "+2",        "2#1",  "1.5",    "SINT#5",     "TRUE",
    "BOOL#1", "T#1s", "'a'", "\"b\"", "Color#Red", "%IX1", "%QW2.3", "D#2000-1-1", "STRING#'b'"};

} // namespace

Damager::Damager(const Grammar& grammar, std::uint32_t seed) : random_(std::mt19937(seed)) {
    for (const Production& production : grammar.productions)
        if (!production.lexical() && production.name != "standard_function_name" &&
            production.name != "standard_function_block_name")
            for_each_expression(production.body, [&](const Expression& one) {
                if (one.kind == Expression::Kind::terminal)
                    vocabulary_.push_back(one.text);
            });
    std::sort(vocabulary_.begin(), vocabulary_.end());
    vocabulary_.erase(std::unique(vocabulary_.begin(), vocabulary_.end()), vocabulary_.end());
    vocabulary_.insert(vocabulary_.end(), std::begin(literals), std::end(literals));
}

std::string Damager::damaged(std::string_view text) {
    Pieces pieces(text);
    if (pieces.tokens.empty())
        return std::string(text);
    const std::size_t at = random(pieces.tokens.size());
    const std::size_t other = random(pieces.tokens.size());
    // A token of the same text often fits where one of the whole vocabulary never would.
    const std::string token =
        random(2) == 0 ? pieces.tokens[other] : vocabulary_[random(vocabulary_.size())];
    switch (random(6)) {
    case 0: pieces.erase(at, at + 1); break;
    case 1: pieces.tokens[at] += " " + pieces.tokens[at]; break;
    case 2:
        std::swap(pieces.tokens[at], pieces.tokens[std::min(at + 1, pieces.tokens.size() - 1)]);
        break;
    case 3: pieces.tokens[at] = " " + token + " "; break;
    case 4: pieces.tokens[at] = " " + token + " " + pieces.tokens[at]; break;
    default: std::swap(pieces.gaps[at], pieces.gaps[other]); break;
    }
    return pieces.text();
}

} // namespace iecfront::test
