#include "parser/misspelling.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace iecfront {
namespace {

constexpr std::size_t longest_keyword = 24;

struct Letters {
    std::array<char, longest_keyword> data{};
    std::size_t size = 0;
    bool too_long = false;
};

Letters letters_of(std::string_view word) noexcept {
    Letters letters;
    for (const char c : word) {
        if (c == '_')
            continue;
        if (letters.size == longest_keyword) {
            letters.too_long = true;
            break;
        }
        letters.data[letters.size++] = fold(c);
    }
    return letters;
}

// Damerau-Levenshtein distance of neighbours (optimal string alignment).
std::size_t distance(const Letters& a, const Letters& b) noexcept {
    // Nothing of it is read before it is written.
    std::array<std::array<std::size_t, longest_keyword + 1>, longest_keyword + 1> d;
    for (std::size_t i = 0; i <= a.size; ++i)
        d[i][0] = i;
    for (std::size_t j = 0; j <= b.size; ++j)
        d[0][j] = j;
    for (std::size_t i = 1; i <= a.size; ++i)
        for (std::size_t j = 1; j <= b.size; ++j) {
            const std::size_t change = a.data[i - 1] == b.data[j - 1] ? 0 : 1;
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
            if (i > 1 && j > 1 && a.data[i - 1] == b.data[j - 2] && a.data[i - 2] == b.data[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size][b.size];
}

// The letters that a word has in any case, a bit each. A wrong letter changes two bits at most.
std::uint32_t letter_set(std::string_view word) noexcept {
    constexpr std::uint32_t underscore = 1U << ('_' % 32);
    std::uint32_t set = 0;
    for (const char c : word)
        set |= 1U << (static_cast<unsigned char>(c) % 32);
    return set & ~underscore;
}

} // namespace

std::optional<std::size_t> misspelt_letters(std::string_view word,
                                            std::string_view meant) noexcept {
    constexpr std::size_t most_allowed = 2;
    if (names_equal(word, meant))
        return 0;
    const auto different_letters =
        static_cast<std::size_t>(std::popcount(letter_set(word) ^ letter_set(meant)));
    if (different_letters > 2 * most_allowed) // nearly always
        return std::nullopt;
    const Letters a = letters_of(word);
    const Letters b = letters_of(meant);
    if (a.too_long || b.too_long)
        return std::nullopt;
    const std::size_t allowed = b.size < 6 ? 1 : most_allowed;
    const std::size_t difference = a.size < b.size ? b.size - a.size : a.size - b.size;
    if (difference > allowed || different_letters > 2 * allowed)
        return std::nullopt;
    const std::size_t wrong = distance(a, b);
    return wrong <= allowed ? std::optional(wrong) : std::nullopt;
}

bool is_abbreviation(std::string_view word, std::string_view meant) noexcept {
    constexpr std::size_t shortest = 5; // END and two letters
    const Letters a = letters_of(word);
    if (a.too_long || a.size < shortest)
        return false;
    Letters initials = letters_of(meant.substr(0, 3));
    for (std::size_t i = 3; i + 1 < meant.size(); ++i)
        if (meant[i] == '_')
            initials.data[initials.size++] = fold(meant[i + 1]);
    const auto begins_with_word = [&a](const Letters& letters) {
        return letters.size >= a.size &&
               std::equal(a.data.begin(), a.data.begin() + a.size, letters.data.begin());
    };
    return begins_with_word(letters_of(meant)) || begins_with_word(initials);
}

bool is_beginning(std::string_view word, std::string_view meant) noexcept {
    constexpr std::size_t shortest = 5;
    return word.size() >= shortest && names_equal(word, meant.substr(0, word.size()));
}

bool is_misspelling(std::string_view word, std::string_view meant) noexcept {
    return misspelt_letters(word, meant).has_value();
}

} // namespace iecfront
