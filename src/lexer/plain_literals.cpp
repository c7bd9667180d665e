#include "lexer/plain_literals.hpp"

#include "lexer/literal_reader.hpp"

#include <algorithm>

namespace iecfront {

namespace {

[[nodiscard]] std::size_t count_digits(std::string_view text) noexcept {
    std::size_t count = 0;
    while (count < text.size() && is_digit(text[count]))
        ++count;
    return count;
}

// Digits of the base, and single underscores between them.
[[nodiscard]] bool are_plain_digits(std::string_view text, unsigned base) noexcept {
    bool behind_digit = false;
    for (const char c : text) {
        const bool digit = literals::digit_value(c) < base;
        if (!digit && (c != '_' || !behind_digit))
            return false;
        behind_digit = digit;
    }
    return behind_digit;
}

// integer (B.1.2.1)
[[nodiscard]] bool is_plain_integer(std::string_view text) noexcept {
    return text.size() <= safe_digits && are_plain_digits(text, 10);
}

// `16#FF`, `2#1010_0101` (B.1.2.1)
[[nodiscard]] bool is_plain_based_integer(std::string_view text) noexcept {
    constexpr std::size_t longest = 16; // digits of the highest base that fit 64 bits
    const std::size_t sign = text.find('#');
    if (sign == text.npos)
        return false;
    const std::string_view base_text = text.substr(0, sign);
    const unsigned base = base_text == "16" ? 16 : base_text == "8" ? 8 : base_text == "2" ? 2 : 0;
    return base != 0 && text.size() <= sign + 1 + longest &&
           are_plain_digits(text.substr(sign + 1), base);
}

// `1.5`, `2.5E-3` (B.1.2.1)
[[nodiscard]] bool is_plain_real(std::string_view text) noexcept {
    const std::size_t whole = count_digits(text);
    if (whole == 0 || whole == text.size() || text[whole] != '.' || text.size() > safe_digits)
        return false;
    const std::size_t fraction = count_digits(text.substr(whole + 1));
    std::string_view exponent = text.substr(whole + 1 + fraction);
    if (fraction == 0 || exponent.empty())
        return fraction != 0;
    exponent.remove_prefix(exponent.size() > 1 && is_sign(exponent[1]) ? 2 : 1);
    return is_exponent_letter(text[whole + 1 + fraction]) && exponent.size() == 1 &&
           is_digit(exponent.front());
}

// The size of `T#` or `TIME#`; 0 for anything else.
[[nodiscard]] std::size_t size_of_duration_prefix(std::string_view text) noexcept {
    constexpr std::string_view long_prefix = "TIME#";
    if (text.size() > 1 && text[1] == '#')
        return fold(text[0]) == 'T' ? 2 : 0;
    return names_equal(text.substr(0, long_prefix.size()), long_prefix) ? long_prefix.size() : 0;
}

// `T#5s` and `TIME#250ms` (B.1.2.3.1): one number of few digits with its unit.
[[nodiscard]] bool is_plain_duration(std::string_view text) noexcept {
    constexpr std::size_t longest = 5; // digits; 99,999 days are in range
    constexpr std::string_view units = "DHMS";
    const std::size_t prefix = size_of_duration_prefix(text);
    const std::string_view number = text.substr(prefix);
    const std::size_t digits = count_digits(number);
    if (prefix == 0 || digits == 0 || digits > longest || digits == number.size())
        return false;
    const char unit = fold(number[digits]);
    const bool two_letters = unit == 'M' && fold(number.back()) == 'S';
    return units.find(unit) != units.npos && number.size() - digits == (two_letters ? 2 : 1);
}

// `%IX1.7`, `%QW12` and `%M5` (B.1.4.1).
[[nodiscard]] bool is_plain_direct_variable(std::string_view text) noexcept {
    constexpr std::string_view locations = "IQM";
    constexpr std::string_view sizes = "XBWDL";
    if (text.size() < 3 || locations.find(fold(text[1])) == locations.npos)
        return false;
    std::size_t at = sizes.find(fold(text[2])) == sizes.npos ? 2 : 3;
    for (;; ++at) {
        const std::size_t digits = count_digits(text.substr(at));
        at += digits;
        if (digits == 0 || digits > safe_digits)
            return false;
        if (at == text.size())
            return true;
        if (text[at] != '.')
            return false;
    }
}

// Closed, of printable ASCII characters, without `$` (B.1.2.2).
[[nodiscard]] bool is_plain_string(std::string_view text) noexcept {
    return text.size() >= 2 && is_quote(text.front()) && // not `STRING#'a'`
           text.find(text.front(), 1) == text.size() - 1 &&
           std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '$'; });
}

} // namespace

bool is_plain_literal(TokenKind kind, std::string_view text) noexcept {
    switch (kind) {
    case TokenKind::integer: return is_plain_integer(text);
    case TokenKind::real: return is_plain_real(text);
    case TokenKind::based_integer: return is_plain_based_integer(text);
    case TokenKind::duration: return is_plain_duration(text);
    case TokenKind::direct_variable: return is_plain_direct_variable(text);
    case TokenKind::single_byte_string:
    case TokenKind::double_byte_string: return is_plain_string(text);
    default: return false;
    }
}

} // namespace iecfront
