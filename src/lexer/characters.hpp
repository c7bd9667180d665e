#pragma once

#include <iecfront/lexer/token.hpp>

#include <array>
#include <cstdint>

namespace iecfront {

// What the first byte of an element says about it; the lexer switches on this.
enum class CharacterClass : std::uint8_t {
    unexpected, // nothing begins with it
    zero,       // the end of the text, or an unexpected NUL
    blank,
    line_end,
    word, // letter or underscore
    digit,
    quote,
    single, // a delimiter that begins no longer one
    ampersand,
    bar,
    brace_left,
    brace_right,
    caret,
    colon,
    dot,
    equal,
    exclamation,
    greater,
    less,
    number_sign,
    parenthesis_left,
    percent,
    slash,
    star,
    non_ascii,
};

namespace characters {

[[nodiscard]] consteval std::array<CharacterClass, 256> class_table() {
    using enum CharacterClass;
    std::array<CharacterClass, 256> table{};
    const auto set = [&table](const char* bytes, CharacterClass value) {
        for (; *bytes != '\0'; ++bytes)
            table[static_cast<unsigned char>(*bytes)] = value;
    };
    set("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_", word);
    set("0123456789", digit);
    set(" \t\v\f", blank);
    set("\n\r", line_end);
    set("'\"", quote);
    set("+-),;[]", single);
    table[0] = zero;
    table['&'] = ampersand;
    table['|'] = bar;
    table['{'] = brace_left;
    table['}'] = brace_right;
    table['^'] = caret;
    table[':'] = colon;
    table['.'] = dot;
    table['='] = equal;
    table['!'] = exclamation;
    table['>'] = greater;
    table['<'] = less;
    table['#'] = number_sign;
    table['('] = parenthesis_left;
    table['%'] = percent;
    table['/'] = slash;
    table['*'] = star;
    for (unsigned byte = 0x80; byte <= 0xFF; ++byte)
        table[byte] = non_ascii;
    return table;
}

// Bits that tell while a word is scanned whether it goes on and what has to be looked at then.
inline constexpr std::uint8_t word_part = 1;       // letter, digit, underscore
inline constexpr std::uint8_t word_underscore = 2; // its place has to be checked
inline constexpr std::uint8_t word_joins = 4;      // `#` or not ASCII: more belongs to the word
inline constexpr std::uint8_t number_goes_on = 8;  // behind digits: not simply the end of them

[[nodiscard]] consteval std::array<std::uint8_t, 256> word_table() {
    std::array<std::uint8_t, 256> table{};
    const auto classes = class_table();
    for (std::size_t byte = 0; byte < table.size(); ++byte) {
        if (classes[byte] == CharacterClass::word)
            table[byte] = word_part | number_goes_on;
        else if (classes[byte] == CharacterClass::digit)
            table[byte] = word_part;
        else if (classes[byte] == CharacterClass::non_ascii)
            table[byte] = word_joins | number_goes_on;
    }
    table['_'] = word_part | word_underscore | number_goes_on;
    table['#'] = word_joins | number_goes_on;
    table['.'] = number_goes_on;
    return table;
}

[[nodiscard]] consteval std::array<TokenKind, 256> single_table() {
    std::array<TokenKind, 256> table{};
    table['+'] = TokenKind::plus;
    table['-'] = TokenKind::minus;
    table[')'] = TokenKind::right_parenthesis;
    table[','] = TokenKind::comma;
    table[';'] = TokenKind::semicolon;
    table['['] = TokenKind::left_bracket;
    table[']'] = TokenKind::right_bracket;
    return table;
}

inline constexpr std::array<CharacterClass, 256> classes = class_table();
inline constexpr std::array<std::uint8_t, 256> word_bits = word_table();
inline constexpr std::array<TokenKind, 256> singles = single_table();

} // namespace characters

[[nodiscard]] constexpr CharacterClass class_of(char c) noexcept {
    return characters::classes[static_cast<unsigned char>(c)];
}
[[nodiscard]] constexpr std::uint8_t word_bits_of(char c) noexcept {
    return characters::word_bits[static_cast<unsigned char>(c)];
}
[[nodiscard]] constexpr TokenKind single_delimiter(char c) noexcept {
    return characters::singles[static_cast<unsigned char>(c)];
}
[[nodiscard]] constexpr bool is_digit(char c) noexcept {
    return c >= '0' && c <= '9';
}
[[nodiscard]] constexpr bool is_line_end(char c) noexcept {
    return class_of(c) == CharacterClass::line_end;
}
[[nodiscard]] constexpr bool is_quote(char c) noexcept {
    return class_of(c) == CharacterClass::quote;
}
// Letter, digit or underscore.
[[nodiscard]] constexpr bool is_word_part(char c) noexcept {
    return (word_bits_of(c) & characters::word_part) != 0;
}
// Letter or underscore.
[[nodiscard]] constexpr bool is_word_start(char c) noexcept {
    return class_of(c) == CharacterClass::word;
}
[[nodiscard]] constexpr bool is_sign(char c) noexcept {
    return c == '+' || c == '-';
}
[[nodiscard]] constexpr bool is_exponent_letter(char c) noexcept {
    return c == 'e' || c == 'E';
}
[[nodiscard]] constexpr bool is_ascii(char c) noexcept {
    return static_cast<unsigned char>(c) < 0x80;
}

} // namespace iecfront
