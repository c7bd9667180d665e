#pragma once

#include <iecfront/builder/part.hpp>
#include <iecfront/lexer/literals.hpp>

#include <chrono>
#include <cstdint>
#include <string_view>

/// Constants (B.1.2). What is computed from the text of each is the value it is made of.
namespace iecfront::build {

/// `12`, `-5`; `UINT#12` with the name of an integer type as `type`.
[[nodiscard]] IECFRONT_API Part<ast::IntegerLiteral> integer_literal(std::int64_t value,
                                                                     std::string_view type = {});

/// `2#101`, `8#17`, `16#FF`, by `base`; 10 gives the plain number. `type` as above.
[[nodiscard]] IECFRONT_API Part<ast::IntegerLiteral>
based_integer_literal(std::uint64_t value, unsigned base, std::string_view type = {});

/// `1.5`, `1.0E-7`: the shortest that reads back as `value`, which is finite. `type` is REAL, LREAL
/// or nothing.
[[nodiscard]] IECFRONT_API Part<ast::RealLiteral> real_literal(double value,
                                                               std::string_view type = {});

/// `WORD#16#00FF`. `type` is BYTE, WORD, DWORD or LWORD, and has room for `value`.
[[nodiscard]] IECFRONT_API Part<ast::BitStringLiteral> bit_string_literal(std::uint64_t value,
                                                                          std::string_view type);

/// `TRUE` or `FALSE`.
[[nodiscard]] IECFRONT_API Part<ast::BooleanLiteral> boolean_literal(bool value);

/// How many bytes a character of a string has (2.2.2).
enum class StringWidth : std::uint8_t {
    single_byte, ///< STRING, `'a'`: characters up to U+00FF
    double_byte, ///< WSTRING, `"a"`: characters up to U+FFFF
};

/// `'it$'s'`: the characters of `value`, which is UTF-8. What cannot stand in ISO 646 or in a
/// string becomes a `$` combination.
[[nodiscard]] IECFRONT_API Part<ast::CharacterString>
character_string(std::string_view value, StringWidth width = StringWidth::single_byte);

/// `T#1h30m`: the parts that are not zero, the smallest with a fraction of milliseconds.
[[nodiscard]] IECFRONT_API Part<ast::Duration> duration(std::chrono::nanoseconds value);

/// `TOD#15:36:55.36`; each field in its range.
[[nodiscard]] IECFRONT_API Part<ast::TimeOfDay> time_of_day(const TimeOfDayValue& value);
/// `D#1984-06-25`; a day that there is.
[[nodiscard]] IECFRONT_API Part<ast::Date> date(const DateValue& value);
/// `DT#1984-06-25-15:36:55.36`.
[[nodiscard]] IECFRONT_API Part<ast::DateAndTime> date_and_time(const DateAndTimeValue& value);

} // namespace iecfront::build
