#include "lexer/literal_scanners.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

namespace iecfront::literals {

namespace {

// ---- elementary types ------------------------------------------------------------------------

enum class TypeClass : std::uint8_t { boolean, integer, bit_string, real, other };

TypeClass type_class_of(TokenKind type) noexcept {
    using enum TokenKind;
    if (type == kw_bool)
        return TypeClass::boolean;
    if (type >= kw_sint && type <= kw_ulint)
        return TypeClass::integer;
    if (type >= kw_byte && type <= kw_lword)
        return TypeClass::bit_string;
    return type == kw_real || type == kw_lreal ? TypeClass::real : TypeClass::other;
}

std::string_view needs_of(TokenKind type) noexcept {
    switch (type_class_of(type)) {
    case TypeClass::boolean: return "0, 1, TRUE or FALSE";
    case TypeClass::integer: return "an integer";
    case TypeClass::bit_string: return "an integer without a sign";
    case TypeClass::real: return "a real literal";
    case TypeClass::other: break;
    }
    return type == TokenKind::kw_string ? "a string in single quotes" : "a string";
}

struct IntegerRange {
    std::uint64_t low; // how far below zero
    std::uint64_t high;
};

constexpr IntegerRange signed_range(unsigned bits) noexcept {
    return {std::uint64_t{1} << (bits - 1), (std::uint64_t{1} << (bits - 1)) - 1};
}

constexpr IntegerRange unsigned_range(unsigned bits) noexcept {
    return {0, std::numeric_limits<std::uint64_t>::max() >> (64 - bits)};
}

// Table 10.
IntegerRange range_of(TokenKind type) noexcept {
    switch (type) {
    case TokenKind::kw_sint: return signed_range(8);
    case TokenKind::kw_int: return signed_range(16);
    case TokenKind::kw_dint: return signed_range(32);
    case TokenKind::kw_lint: return signed_range(64);
    case TokenKind::kw_usint:
    case TokenKind::kw_byte: return unsigned_range(8);
    case TokenKind::kw_uint:
    case TokenKind::kw_word: return unsigned_range(16);
    case TokenKind::kw_udint:
    case TokenKind::kw_dword: return unsigned_range(32);
    default: return unsigned_range(64);
    }
}

// ---- shapes ----------------------------------------------------------------------------------

enum class Shape : std::uint8_t { nothing, integer, based, real, boolean, other };

bool is_boolean_word(std::string_view text) noexcept {
    return names_equal(text, "TRUE") || names_equal(text, "FALSE");
}

// What the text is meant to be, well-formed or not; it stands behind prefix and sign.
Shape shape_of(std::string_view text) noexcept {
    if (text.empty())
        return Shape::nothing;
    std::size_t behind = 0;
    bool digits = false;
    for (; behind < text.size() && (is_digit(text[behind]) || text[behind] == '_'); ++behind)
        digits = digits || text[behind] != '_';
    const std::string_view rest = text.substr(behind);
    if (!rest.empty() && rest.front() == '.')
        return Shape::real;
    if (!digits)
        return is_boolean_word(text) ? Shape::boolean : Shape::other;
    if (!rest.empty() && rest.front() == '#')
        return Shape::based;
    return exponent_begins(rest) ? Shape::real : Shape::integer;
}

// ---- the scanner -----------------------------------------------------------------------------

class NumberScanner {
public:
    NumberScanner(LiteralReader& reader, const TypePrefix& prefix) noexcept
        : reader_(reader), prefix_(prefix) {}

    NumericValue scan();

private:
    [[nodiscard]] bool type_takes(Shape shape) const noexcept;
    void report_mismatch(Shape shape);
    void report_nothing();
    bool report_suffix();
    bool report_fraction(std::uint8_t base);

    NumericValue scan_shape(Shape shape);
    NumericValue boolean() const;
    NumericValue decimal();
    NumericValue based();
    NumericValue real();

    [[nodiscard]] bool base(std::uint8_t& base);
    void report_unknown_base(TextRange base_text);
    void report_wrong_digits(TextRange digits, std::uint8_t base);
    void report_sign(std::uint8_t base, TextRange digits);
    NumericValue integer(TextRange digits, std::uint8_t base);
    void check_range(const IntegerValue& value);

    [[nodiscard]] bool exponent();
    void report_missing_parts(bool point, std::uint32_t point_at);
    NumericValue real_of_parts();

    LiteralReader& reader_;
    TypePrefix prefix_;
    bool signed_ = false;
    bool negative_ = false;
    std::uint32_t number_ = 0; // where the number begins, its sign included
    std::uint32_t unsigned_number_ = 0;
    // Of a real literal; the exponent has its sign.
    TextRange whole_;
    TextRange fraction_;
    TextRange exponent_;
    bool negative_exponent_ = false;
    std::uint32_t mantissa_end_ = 0;
};

NumericValue NumberScanner::scan() {
    reader_.move_to(prefix_.end);
    number_ = reader_.at();
    // Without a type name a sign is a token of its own.
    if (!prefix_.name.empty() && (reader_.peek() == '-' || reader_.peek() == '+')) {
        signed_ = true;
        negative_ = reader_.peek() == '-';
        reader_.move_to(number_ + 1);
    }
    unsigned_number_ = reader_.at();
    const Shape shape = shape_of(reader_.rest());
    if (shape == Shape::nothing) {
        report_nothing();
        return {};
    }
    if (prefix_.type && !type_takes(shape)) {
        report_mismatch(shape);
        return {};
    }
    return scan_shape(shape);
}

bool NumberScanner::type_takes(Shape shape) const noexcept {
    switch (type_class_of(*prefix_.type)) {
    case TypeClass::boolean: {
        const std::string_view text = reader_.text().substr(number_);
        return text == "0" || text == "1" || is_boolean_word(text);
    }
    case TypeClass::integer: return shape == Shape::integer || shape == Shape::based;
    case TypeClass::bit_string:
        return (shape == Shape::integer && !signed_) || shape == Shape::based;
    case TypeClass::real: return shape == Shape::real;
    case TypeClass::other: break;
    }
    return false;
}

void NumberScanner::report_mismatch(Shape shape) {
    std::vector<DiagnosticFix> fixes;
    const TypeClass type = type_class_of(*prefix_.type);
    const bool plain_integer =
        shape == Shape::integer && is_digit(reader_.text().back()) &&
        reader_.rest().find_first_not_of("_0123456789") == std::string_view::npos;
    if (type == TypeClass::real && plain_integer)
        fixes.push_back(insertion(reader_.end(), ".0"));
    if (type == TypeClass::bit_string && plain_integer && !negative_)
        fixes.push_back(removal({number_, unsigned_number_}));
    report_type_mismatch(reader_, *prefix_.type, number_, std::move(fixes));
}

void NumberScanner::report_nothing() {
    LiteralFaults& faults = reader_.faults();
    // The lexer speaks of a derived type name without a value, and of no text at all.
    if (!prefix_.type) {
        faults.reject();
        return;
    }
    const TextRange before = {0, reader_.at()};
    if (type_class_of(*prefix_.type) == TypeClass::other)
        faults.report(DiagnosticId::stray_number_sign, {prefix_.end - 1, prefix_.end});
    else
        faults.report(DiagnosticId::missing_digits, reader_.here(), {reader_.words(before)});
}

// Whether something that is no part of the number follows it.
bool NumberScanner::report_suffix() {
    if (reader_.at_end())
        return false;
    const TextRange rest = reader_.to_end();
    reader_.faults().report(DiagnosticId::unknown_number_suffix, rest, {reader_.words(rest)});
    return true;
}

// Whether a based literal goes on as if it were a decimal one: `16#1.5`.
bool NumberScanner::report_fraction(std::uint8_t base) {
    if (reader_.peek() != '.')
        return false;
    reader_.faults().report(DiagnosticId::fraction_of_based_literal, reader_.to_end(),
                            {std::uint64_t{base}});
    return true;
}

NumericValue NumberScanner::scan_shape(Shape shape) {
    switch (shape) {
    case Shape::integer: return decimal();
    case Shape::based: return based();
    case Shape::real: return real();
    case Shape::boolean:
        if (!signed_)
            return boolean();
        break;
    case Shape::nothing:
    case Shape::other: break;
    }
    reader_.faults().reject();
    return {};
}

NumericValue NumberScanner::boolean() const {
    IntegerValue value;
    value.type = prefix_.name.empty() ? TokenKind::kw_bool : prefix_.type;
    value.magnitude = names_equal(reader_.rest(), "TRUE") ? 1 : 0;
    return value;
}

// ---- integers --------------------------------------------------------------------------------

NumericValue NumberScanner::decimal() {
    const TextRange digits = reader_.digits(decimal_digits);
    if (report_suffix() || !reader_.faults().has_value())
        return {};
    return integer(digits, 10);
}

NumericValue NumberScanner::based() {
    std::uint8_t base_value = 0;
    if (!base(base_value))
        return {};
    const TextRange digits = reader_.digits(based_digits);
    if (digits.empty())
        reader_.faults().report(DiagnosticId::missing_digits, reader_.here(),
                                {reader_.words(reader_.from(unsigned_number_))});
    else if (!report_fraction(base_value))
        report_suffix();
    report_wrong_digits(digits, base_value);
    if (signed_)
        report_sign(base_value, digits);
    if (!reader_.faults().has_value())
        return {};
    return integer(digits, base_value);
}

// Reads the base and its `#`. False when it is none, and the digits are anyone's guess.
bool NumberScanner::base(std::uint8_t& base) {
    const TextRange base_text = reader_.digits(decimal_digits);
    const std::string_view text = reader_.view(base_text);
    const bool known = text == "2" || text == "8" || text == "16";
    if (!known) {
        report_unknown_base(base_text);
        return false;
    }
    base = static_cast<std::uint8_t>(magnitude_of(text, 10).value);
    reader_.accept('#');
    return true;
}

void NumberScanner::report_unknown_base(TextRange base_text) {
    std::vector<DiagnosticFix> fixes;
    const std::string_view digits = reader_.rest().substr(1);
    if (reader_.view(base_text) == "10" && base_text.end == reader_.at() &&
        shape_of(digits) == Shape::integer)
        fixes.push_back(removal({base_text.begin, reader_.at() + 1}));
    reader_.faults().report(DiagnosticId::unknown_base, base_text, {reader_.words(base_text)},
                            std::move(fixes));
}

// Wrong digits that stand together are one fault.
void NumberScanner::report_wrong_digits(TextRange digits, std::uint8_t base) {
    const std::string_view text = reader_.text();
    const auto is_wrong = [&](std::uint32_t at) {
        return text[at] != '_' && digit_value(text[at]) >= base;
    };
    for (std::uint32_t at = digits.begin; at < digits.end; ++at) {
        const std::uint32_t begin = at;
        while (at < digits.end && is_wrong(at))
            ++at;
        const TextRange wrong = {begin, at};
        if (!wrong.empty())
            reader_.faults().report(DiagnosticId::digit_outside_base, wrong,
                                    {reader_.words(wrong), std::uint64_t{base}});
    }
}

void NumberScanner::report_sign(std::uint8_t base, TextRange digits) {
    const TextRange sign = {number_, unsigned_number_};
    const Magnitude magnitude = magnitude_of(reader_.view(digits), base);
    std::vector<DiagnosticFix> fixes;
    if (!negative_)
        fixes.push_back(removal(sign));
    else if (reader_.faults().has_value() && prefix_.type && magnitude.value != 0 &&
             !magnitude.overflow && magnitude.value <= range_of(*prefix_.type).low)
        fixes.push_back(
            replacement({unsigned_number_, reader_.end()}, std::to_string(magnitude.value)));
    reader_.faults().report(DiagnosticId::sign_of_based_literal, sign, {std::uint64_t{base}},
                            std::move(fixes));
}

NumericValue NumberScanner::integer(TextRange digits, std::uint8_t base) {
    const Magnitude magnitude = magnitude_of(reader_.view(digits), base);
    IntegerValue value;
    value.type = prefix_.type;
    value.base = base;
    value.magnitude = magnitude.value;
    value.overflow = magnitude.overflow;
    value.negative = negative_ && magnitude.value != 0;
    if (prefix_.type)
        check_range(value);
    else if (value.overflow)
        reader_.faults().report_in_value(DiagnosticId::integer_too_large, reader_.from(number_));
    return value;
}

void NumberScanner::check_range(const IntegerValue& value) {
    if (type_class_of(*value.type) == TypeClass::boolean)
        return;
    const IntegerRange range = range_of(*value.type);
    if (!value.overflow && value.magnitude <= (value.negative ? range.low : range.high))
        return;
    reader_.faults().report(DiagnosticId::literal_out_of_range, reader_.from(number_),
                            {std::string(spelling(*value.type)),
                             (range.low == 0 ? "" : "-") + std::to_string(range.low),
                             std::to_string(range.high)});
}

// ---- reals -----------------------------------------------------------------------------------

NumericValue NumberScanner::real() {
    whole_ = reader_.digits(decimal_digits);
    const std::uint32_t point_at = reader_.at();
    const bool point = reader_.accept('.');
    if (point)
        fraction_ = reader_.digits(decimal_digits);
    mantissa_end_ = reader_.at();
    if ((exponent_begins(reader_.rest()) && !exponent()) || report_suffix())
        return {};
    report_missing_parts(point, point_at);
    if (!reader_.faults().has_value())
        return {};
    return real_of_parts();
}

bool NumberScanner::exponent() {
    const std::uint32_t begin = reader_.at();
    reader_.move_to(begin + 1);
    negative_exponent_ = reader_.accept('-');
    if (!negative_exponent_)
        reader_.accept('+');
    const TextRange letter_and_sign = reader_.from(begin);
    exponent_ = reader_.digits(decimal_digits);
    if (exponent_.empty())
        reader_.faults().report(DiagnosticId::missing_digits, reader_.here(),
                                {reader_.words(letter_and_sign)});
    return !exponent_.empty();
}

// Digits that the grammar demands and other systems do not.
void NumberScanner::report_missing_parts(bool point, std::uint32_t point_at) {
    LiteralFaults& faults = reader_.faults();
    const TextRange point_range = {point_at, point_at + 1};
    if (!point)
        faults.report(DiagnosticId::real_without_point, reader_.from(unsigned_number_), {},
                      {insertion(mantissa_end_, ".0")});
    else if (whole_.empty() && fraction_.empty())
        faults.report(DiagnosticId::missing_digits, {point_range.end, point_range.end},
                      {std::string(".")});
    else if (whole_.empty())
        faults.report(DiagnosticId::real_without_leading_digit, point_range, {},
                      {insertion(point_range.begin, "0")});
    else if (fraction_.empty())
        faults.report(DiagnosticId::real_without_fraction, point_range, {},
                      {insertion(point_range.end, "0")});
}

// A decimal number: 0.`digits` times ten to the power of `exponent`.
struct Decimal {
    std::string digits; // the first one is not zero
    std::int64_t exponent = 0;
};

Decimal decimal_of(std::string_view whole, std::string_view fraction, std::string_view exponent,
                   bool negative_exponent) {
    // No literal has more digits than this, so that they cannot bring a larger exponent back.
    constexpr std::uint64_t highest_exponent = 1'000'000'000'000;
    Decimal decimal{without_underscores(whole), 0};
    auto exponent_value =
        static_cast<std::int64_t>(std::min(magnitude_of(exponent, 10).value, highest_exponent));
    if (negative_exponent)
        exponent_value = -exponent_value;
    exponent_value += static_cast<std::int64_t>(decimal.digits.size());
    decimal.digits += without_underscores(fraction);
    const std::size_t zeros = decimal.digits.find_first_not_of('0');
    if (zeros == std::string::npos)
        return {};
    decimal.digits.erase(0, zeros);
    decimal.exponent = exponent_value - static_cast<std::int64_t>(zeros);
    return decimal;
}

// The nearest value of `Float`; infinite when that is beyond its range.
template<class Float>
double nearest(const Decimal& decimal) {
    // Far beyond every type, which from_chars need not tell from far below.
    constexpr std::int64_t beyond = 5000;
    if (decimal.digits.empty() || decimal.exponent < -beyond)
        return 0;
    if (decimal.exponent > beyond)
        return std::numeric_limits<double>::infinity();
    const std::string text = "0." + decimal.digits + 'e' + std::to_string(decimal.exponent);
    Float value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    // What becomes of `value` then differs between libraries.
    if (result.ec == std::errc::result_out_of_range)
        return decimal.exponent > 0 ? std::numeric_limits<double>::infinity() : 0;
    return static_cast<double>(value);
}

NumericValue NumberScanner::real_of_parts() {
    const Decimal decimal = decimal_of(reader_.view(whole_), reader_.view(fraction_),
                                       reader_.view(exponent_), negative_exponent_);
    const bool single = prefix_.type == TokenKind::kw_real;
    RealValue value;
    value.type = prefix_.type;
    value.value = single ? nearest<float>(decimal) : nearest<double>(decimal);
    value.overflow = value.value > std::numeric_limits<double>::max();
    if (value.overflow)
        reader_.faults().report_in_value(DiagnosticId::real_out_of_range, reader_.from(number_),
                                         {std::string(single ? "REAL" : "LREAL")});
    if (negative_)
        value.value = -value.value;
    return value;
}

} // namespace

void report_type_mismatch(const LiteralReader& reader, TokenKind type, std::uint32_t begin,
                          std::vector<DiagnosticFix> fixes) {
    const TextRange found = {begin, reader.end()};
    reader.faults().report(
        DiagnosticId::literal_type_mismatch, found,
        {std::string(spelling(type)), std::string(needs_of(type)), reader.words(found)},
        std::move(fixes));
}

NumericValue scan_number(std::string_view text, Encoding encoding, LiteralFaults& faults) {
    const TypePrefix prefix = type_prefix_of(text);
    if (holds_gap(text) || prefix.of_time_literal()) {
        faults.reject();
        return {};
    }
    LiteralReader reader(text, encoding, faults);
    return NumberScanner(reader, prefix).scan();
}

} // namespace iecfront::literals
