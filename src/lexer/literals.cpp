#include "lexer/literal_scanners.hpp"

#include <algorithm>

namespace iecfront::literals {

namespace {

std::optional<IntegerValue> as_integer(const NumericValue& value) {
    const auto* integer = std::get_if<IntegerValue>(&value);
    return integer == nullptr ? std::nullopt : std::optional(*integer);
}

std::optional<RealValue> as_real(const NumericValue& value) {
    const auto* real = std::get_if<RealValue>(&value);
    return real == nullptr ? std::nullopt : std::optional(*real);
}

NumericValue number_value(std::string_view text) {
    LiteralFaults faults;
    NumericValue value = scan_number(text, Encoding::utf8, faults);
    return faults.has_value() ? value : NumericValue();
}

bool begins_with_quote(std::string_view text) noexcept {
    return !text.empty() && (text.front() == '\'' || text.front() == '"');
}

// The type names before `#` that literals of other kinds of tokens begin with, too.
void check_typed(std::string_view text, Encoding encoding, LiteralFaults& faults) {
    const TypePrefix prefix = type_prefix_of(text);
    switch (prefix.type.value_or(TokenKind::identifier)) {
    case TokenKind::kw_time: scan_duration(text, encoding, faults); return;
    case TokenKind::kw_date: scan_date(text, encoding, faults); return;
    case TokenKind::kw_tod:
    case TokenKind::kw_time_of_day: scan_time_of_day(text, encoding, faults); return;
    case TokenKind::kw_dt:
    case TokenKind::kw_date_and_time: scan_date_and_time(text, encoding, faults); return;
    default: break;
    }
    if (begins_with_quote(text.substr(prefix.end)))
        scan_string(text, encoding, faults, nullptr);
    else
        static_cast<void>(scan_number(text, encoding, faults));
}

void check(TokenKind kind, std::string_view text, Encoding encoding, LiteralFaults& faults) {
    switch (kind) {
    case TokenKind::integer:
    case TokenKind::based_integer:
    case TokenKind::real: static_cast<void>(scan_number(text, encoding, faults)); break;
    case TokenKind::typed_literal: check_typed(text, encoding, faults); break;
    case TokenKind::single_byte_string:
    case TokenKind::double_byte_string: scan_string(text, encoding, faults, nullptr); break;
    case TokenKind::duration: scan_duration(text, encoding, faults); break;
    case TokenKind::time_of_day: scan_time_of_day(text, encoding, faults); break;
    case TokenKind::date: scan_date(text, encoding, faults); break;
    case TokenKind::date_and_time: scan_date_and_time(text, encoding, faults); break;
    case TokenKind::direct_variable:
    case TokenKind::incomplete_location: scan_direct_variable(text, encoding, faults); break;
    default: break;
    }
}

std::string_view without_blanks_around(std::string_view text) noexcept {
    while (!text.empty() && is_white_space(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_white_space(text.back()))
        text.remove_suffix(1);
    return text;
}

// Names around a `#` may have white space, comments and pragmas between them and it, by mistake.
std::string_view first_word(std::string_view text) noexcept {
    return without_blanks_around(text.substr(0, text.find_first_of("({")));
}

std::string_view last_word(std::string_view text) noexcept {
    const std::size_t behind = text.find_last_of("#)}");
    return without_blanks_around(text.substr(behind + 1));
}

} // namespace

} // namespace iecfront::literals

namespace iecfront {

using namespace literals;

std::optional<IntegerValue> integer_value(std::string_view text) {
    return as_integer(number_value(text));
}

std::optional<RealValue> real_value(std::string_view text) {
    return as_real(number_value(text));
}

EnumeratedValueName split_enumerated_value(std::string_view text) noexcept {
    const std::size_t sign = text.find('#');
    if (sign == std::string_view::npos)
        return {{}, without_blanks_around(text)};
    return {first_word(text.substr(0, sign)), last_word(text)};
}

std::vector<Diagnostic> check_literal(TokenKind kind, std::string_view text, Encoding encoding) {
    std::vector<Diagnostic> list;
    LiteralFaults faults(list);
    check(kind, text, encoding, faults);
    // Some are known only when what stands behind them has been read.
    std::stable_sort(list.begin(), list.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return a.range.begin < b.range.begin;
    });
    return list;
}

} // namespace iecfront
