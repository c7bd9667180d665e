#include "lexer/meant_number.hpp"

#include "lexer/characters.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>

namespace iecfront {

namespace {

[[nodiscard]] bool is_hexadecimal(std::string_view digits) noexcept {
    return !digits.empty() && std::ranges::all_of(digits, [](char c) {
        return is_digit(c) || (fold(c) >= 'A' && fold(c) <= 'F');
    });
}

// Keywords that can follow a number (B.1.3, B.3); a name that begins with a digit and ends like one
// of them is far rarer.
constexpr std::array<std::string_view, 10> keywords_behind_numbers = {
    "MOD", "AND", "XOR", "OR", "TO", "BY", "DO", "THEN", "OF", "END_REPEAT"};

} // namespace

std::string meant_hexadecimal(std::string_view word) {
    if (word.empty())
        return {};
    std::string_view digits = word;
    if (word.front() == '$') {
        digits.remove_prefix(1);
    } else if (fold(word.back()) == 'H') {
        digits.remove_suffix(1);
        if (digits.size() > 1 && digits.front() == '0' && !is_digit(digits[1]))
            digits.remove_prefix(1); // it only made the word begin with a digit
    } else {
        constexpr std::size_t shortest = 4; // `16A` may well have a unit
        if (!word.starts_with("16") || word.size() < shortest ||
            std::ranges::all_of(word, is_digit))
            return {};
        digits.remove_prefix(2);
    }
    return is_hexadecimal(digits) ? "16#" + std::string(digits) : std::string();
}

std::size_t size_before_keyword(std::string_view text) noexcept {
    for (const std::string_view word : keywords_behind_numbers)
        if (text.size() > word.size() && names_equal(text.substr(text.size() - word.size()), word))
            return text.size() - word.size();
    return 0;
}

} // namespace iecfront
