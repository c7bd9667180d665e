#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/export.hpp>
#include <iecfront/lexer/token.hpp>
#include <iecfront/source/encoding.hpp>
#include <iecfront/source/text_range.hpp>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

/// The values of literals (2.2), computed from their spelling when somebody asks. Each function
/// takes the exact text of one token and gives nothing when it is malformed, or beyond its type
/// without an `overflow` to tell so (`SINT#200`). Ranges count from the start of that text.
namespace iecfront {

/// An integer, bit string or Boolean literal: `-12`, `16#FF`, `UINT#5`, `BOOL#TRUE` (B.1.2.1).
struct IntegerValue {
    /// The keyword before the `#`: kw_int, kw_byte ...; kw_bool for `TRUE`. Nothing when there is
    /// none, and for another name, as in `MyInt#5` or `LD#5`: only the text has that.
    std::optional<TokenKind> type;
    bool negative = false;       ///< only `INT#-5`; the sign of an untyped one is a token before
    std::uint8_t base = 10;      ///< 2, 8, 10 or 16
    bool overflow = false;       ///< above 2^64-1: `magnitude` is then 2^64-1
    std::uint64_t magnitude = 0; ///< without its sign; 1 for `TRUE`
};

/// A real literal: `3.14`, `LREAL#1.0E-3` (B.1.2.1).
struct RealValue {
    std::optional<TokenKind> type; ///< kw_real or kw_lreal
    bool overflow = false; ///< beyond its type (LREAL when it has none); `value` is infinite
    double value = 0;      ///< correctly rounded to its type
};

/// A duration, `T#...` or `TIME#...` (B.1.2.3.1).
struct DurationValue {
    bool overflow = false;        ///< beyond 64 bits; `nanoseconds` is the nearest end of the range
    bool inexact = false;         ///< digits finer than one nanosecond were cut
    std::int64_t nanoseconds = 0; ///< negative for `T#-...`
};

/// Calendar fields, as written and checked against the Gregorian calendar (B.1.2.3.2).
struct DateValue {
    std::uint16_t year = 1; ///< 1 to 9999
    std::uint8_t month = 1; ///< 1 to 12
    std::uint8_t day = 1;   ///< 1 to the last of the month

    friend constexpr auto operator<=>(const DateValue&, const DateValue&) noexcept = default;
};
/// A time of day as written: each field in its range, no leap seconds (B.1.2.3.2).
struct TimeOfDayValue {
    std::uint8_t hour = 0;        ///< 0 to 23
    std::uint8_t minute = 0;      ///< 0 to 59
    std::uint8_t second = 0;      ///< 0 to 59
    std::uint32_t nanosecond = 0; ///< of the fraction of the second; finer digits are cut

    friend constexpr auto operator<=>(const TimeOfDayValue&,
                                      const TimeOfDayValue&) noexcept = default;
};
/// A date and a time of day (B.1.2.3.2).
struct DateAndTimeValue {
    DateValue date;
    TimeOfDayValue time;

    friend constexpr auto operator<=>(const DateAndTimeValue&,
                                      const DateAndTimeValue&) noexcept = default;
};

/// One code of a string, and where it comes from: one character or one `$` combination.
struct StringElement {
    std::uint16_t code = 0; ///< U+0000..U+00FF in a single-byte string
    TextRange source;       ///< bytes of the literal, from its start
};

/// A character string (B.1.2.2). `$N` is one character, LF.
struct StringValue {
    bool double_byte = false;            ///< 16-bit codes: `"..."` or `WSTRING#...`
    std::vector<StringElement> elements; ///< one for each character of the value, in order
};

/// A directly represented variable or incomplete location (B.1.4.1).
struct DirectVariableValue {
    char location = 'M';                  ///< `I`, `Q` or `M`
    char size = 'X';                      ///< `X` (also when not written), `B`, `W`, `D` or `L`
    bool incomplete = false;              ///< `%I*`
    std::vector<std::uint64_t> hierarchy; ///< the numbers, highest level first (2.4.1.1)
};

/// The value of a literal of each class; nothing when the text is none of the class, or malformed.
/// `encoding` is that of the text, which matters for strings only.
[[nodiscard]] IECFRONT_API std::optional<IntegerValue> integer_value(std::string_view text);
[[nodiscard]] IECFRONT_API std::optional<RealValue> real_value(std::string_view text);
[[nodiscard]] IECFRONT_API std::optional<DurationValue> duration_value(std::string_view text);
[[nodiscard]] IECFRONT_API std::optional<DateValue> date_value(std::string_view text);
[[nodiscard]] IECFRONT_API std::optional<TimeOfDayValue> time_of_day_value(std::string_view text);
[[nodiscard]] IECFRONT_API std::optional<DateAndTimeValue>
date_and_time_value(std::string_view text);
[[nodiscard]] IECFRONT_API std::optional<StringValue> string_value(std::string_view text,
                                                                   Encoding encoding);
[[nodiscard]] IECFRONT_API std::optional<DirectVariableValue>
direct_variable_value(std::string_view text);

/// The two names of an enumerated value `type#value`; `type` is empty for an unqualified one.
struct EnumeratedValueName {
    std::string_view type;  ///< before the `#`
    std::string_view value; ///< behind it
};
/// Cuts the text of one token at its `#`. The views are into `text`.
[[nodiscard]] IECFRONT_API EnumeratedValueName
split_enumerated_value(std::string_view text) noexcept;

/// Every fault of a literal, as the lexer reports them; ranges count from the start of `text`.
/// `kind` is the kind of its token. Empty when it is well-formed.
[[nodiscard]] IECFRONT_API std::vector<Diagnostic>
check_literal(TokenKind kind, std::string_view text, Encoding encoding);

} // namespace iecfront
