#include "builder/assembly.hpp"
#include "lexer/keywords.hpp"

#include <iecfront/builder/constants.hpp>
#include <iecfront/source/encoding.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

namespace iecfront::build {
namespace {

[[nodiscard]] std::string hex_digits(std::uint64_t value, std::size_t digits) {
    constexpr std::string_view hex = "0123456789ABCDEF";
    std::string out(digits, '0');
    for (std::size_t i = digits; i-- > 0; value >>= 4U)
        out[i] = hex[value & 0xFU];
    return out;
}

// With zeros before it.
[[nodiscard]] std::string decimal(std::uint64_t value, std::size_t digits = 1) {
    const std::string out = std::to_string(value);
    return out.size() < digits ? std::string(digits - out.size(), '0') + out : out;
}

[[nodiscard]] std::string in_base(std::uint64_t value, unsigned base) {
    std::array<char, 64> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, static_cast<int>(base));
    std::string out(digits.data(), end.ptr);
    for (char& c : out)
        c = fold(c);
    return base == 10 ? out : std::to_string(base) + '#' + out;
}

// `INT#`, or nothing for a constant without a type.
[[nodiscard]] std::string prefix(std::string_view type) {
    return type.empty() ? std::string() : std::string(type) + '#';
}

[[nodiscard]] bool is_integer_type(TokenKind kind) noexcept {
    return kind >= TokenKind::kw_sint && kind <= TokenKind::kw_ulint;
}

// A number of so many units, with what is left of it as `fraction` in units of 1/10^`digits`.
[[nodiscard]] std::string fixed_point(std::uint64_t units, std::uint64_t fraction,
                                      std::size_t digits) {
    std::string out = decimal(units);
    if (fraction == 0)
        return out;
    out += '.' + decimal(fraction, digits);
    return out.substr(0, out.find_last_not_of('0') + 1);
}

[[nodiscard]] std::string daytime(const TimeOfDayValue& value) {
    return decimal(value.hour, 2) + ':' + decimal(value.minute, 2) + ':' +
           (value.second < 10 ? "0" : "") + fixed_point(value.second, value.nanosecond, 9);
}

[[nodiscard]] std::string date_literal(const DateValue& value) {
    return decimal(value.year, 4) + '-' + decimal(value.month, 2) + '-' + decimal(value.day, 2);
}

// The letter of `$L` and its like (Table 6); nothing for another character.
[[nodiscard]] char escape_letter(char32_t character) noexcept {
    switch (character) {
    case U'\n': return 'L';
    case U'\f': return 'P';
    case U'\r': return 'R';
    case U'\t': return 'T';
    default: return '\0';
    }
}

void append_character(std::string& out, char32_t character, char quote, std::size_t digits) {
    const char letter = escape_letter(character);
    if (letter != '\0')
        (out += '$') += letter;
    else if (character < U' ' || character > U'~')
        (out += '$') += hex_digits(character, digits);
    else if (character == U'$' || character == static_cast<char32_t>(quote))
        (out += '$') += static_cast<char>(character);
    else
        out += static_cast<char>(character);
}

} // namespace

Part<ast::IntegerLiteral> integer_literal(std::int64_t value, std::string_view type) {
    const bool negative = value < 0;
    const auto magnitude =
        negative ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    Assembly assembly;
    if (type.empty())
        return std::move(assembly.text(negative ? "-" : "").literal(decimal(magnitude)))
            .finish<ast::IntegerLiteral>();
    assembly.require(is_integer_type(keyword_kind(type)), quoted(type) + " is no integer type");
    assembly.literal(prefix(type) + (negative ? "-" : "") + decimal(magnitude));
    return std::move(assembly).finish<ast::IntegerLiteral>();
}

Part<ast::IntegerLiteral> based_integer_literal(std::uint64_t value, unsigned base,
                                                std::string_view type) {
    Assembly assembly;
    if (base != 2 && base != 8 && base != 10 && base != 16)
        return std::move(assembly.require(false, "bases are 2, 8, 10 and 16"))
            .finish<ast::IntegerLiteral>();
    assembly.require(type.empty() || is_integer_type(keyword_kind(type)),
                     quoted(type) + " is no integer type");
    return std::move(assembly.literal(prefix(type) + in_base(value, base)))
        .finish<ast::IntegerLiteral>();
}

Part<ast::RealLiteral> real_literal(double value, std::string_view type) {
    Assembly assembly;
    const TokenKind kind = keyword_kind(type);
    assembly.require(type.empty() || kind == TokenKind::kw_real || kind == TokenKind::kw_lreal,
                     quoted(type) + " is no real type");
    if (!std::isfinite(value))
        return std::move(assembly.require(false, "a real literal is finite"))
            .finish<ast::RealLiteral>();
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), std::fabs(value));
    std::string text(digits.data(), end.ptr);
    const std::size_t exponent = text.find('e');
    if (exponent != std::string::npos)
        text[exponent] = 'E';
    if (text.find('.') == std::string::npos)
        text.insert(std::min(exponent, text.size()), ".0");
    const std::string_view sign = std::signbit(value) ? "-" : "";
    if (type.empty())
        assembly.text(sign).literal(text);
    else
        assembly.literal(prefix(type).append(sign) + text);
    return std::move(assembly).finish<ast::RealLiteral>();
}

Part<ast::BitStringLiteral> bit_string_literal(std::uint64_t value, std::string_view type) {
    std::size_t digits = 0;
    switch (keyword_kind(type)) {
    case TokenKind::kw_byte: digits = 2; break;
    case TokenKind::kw_word: digits = 4; break;
    case TokenKind::kw_dword: digits = 8; break;
    case TokenKind::kw_lword: digits = 16; break;
    default: break;
    }
    Assembly assembly;
    assembly.require(digits != 0, quoted(type) + " is none of BYTE, WORD, DWORD and LWORD")
        .require(digits == 16 || value >> (4 * digits) == 0, "the value is beyond its type")
        .text(prefix(type))
        .text("16#")
        .text(hex_digits(value, digits));
    return std::move(assembly).finish<ast::BitStringLiteral>();
}

Part<ast::BooleanLiteral> boolean_literal(bool value) {
    return std::move(Assembly().text(value ? "TRUE" : "FALSE")).finish<ast::BooleanLiteral>();
}

Part<ast::CharacterString> character_string(std::string_view value, StringWidth width) {
    const bool double_byte = width == StringWidth::double_byte;
    const char quote = double_byte ? '"' : '\'';
    const char32_t last = double_byte ? U'\uFFFF' : U'\u00FF';
    Assembly assembly;
    std::string text(1, quote);
    for (std::size_t i = 0; i < value.size();) {
        const DecodedCharacter character = decode_character(value, i, Encoding::utf8);
        assembly.require(character.valid, "the value of a string is not UTF-8")
            .require(character.code_point <= last, "a character is beyond those of its string");
        append_character(text, character.code_point, quote, double_byte ? 4 : 2);
        i += character.size;
    }
    return std::move(assembly.text(text += quote)).finish<ast::CharacterString>();
}

Part<ast::Duration> duration(std::chrono::nanoseconds value) {
    struct Field {
        std::uint64_t nanoseconds;
        std::string_view letter;
    };
    constexpr std::array<Field, 4> fields{{{86'400'000'000'000U, "d"},
                                           {3'600'000'000'000U, "h"},
                                           {60'000'000'000U, "m"},
                                           {1'000'000'000U, "s"}}};
    const bool negative = value.count() < 0;
    const auto count = static_cast<std::uint64_t>(value.count());
    std::uint64_t rest = negative ? 0 - count : count;
    std::string text = negative ? "T#-" : "T#";
    const std::size_t empty = text.size();
    for (const Field& field : fields) {
        if (rest >= field.nanoseconds)
            text.append(decimal(rest / field.nanoseconds)).append(field.letter);
        rest %= field.nanoseconds;
    }
    constexpr std::uint64_t millisecond = 1'000'000;
    if (rest > 0)
        text += fixed_point(rest / millisecond, rest % millisecond, 6) + "ms";
    else if (text.size() == empty)
        text += "0s";
    return std::move(Assembly().literal(text)).finish<ast::Duration>();
}

Part<ast::TimeOfDay> time_of_day(const TimeOfDayValue& value) {
    return std::move(Assembly().literal("TOD#" + daytime(value))).finish<ast::TimeOfDay>();
}

Part<ast::Date> date(const DateValue& value) {
    return std::move(Assembly().literal("D#" + date_literal(value))).finish<ast::Date>();
}

Part<ast::DateAndTime> date_and_time(const DateAndTimeValue& value) {
    return std::move(
               Assembly().literal("DT#" + date_literal(value.date) + '-' + daytime(value.time)))
        .finish<ast::DateAndTime>();
}

} // namespace iecfront::build
