#pragma once

#include "lexer/literal_reader.hpp"

#include <iecfront/lexer/literals.hpp>

#include <variant>
#include <vector>

// One scanner for each class of literals: it reports the faults and gives the value, which means
// something only as long as `LiteralFaults::has_value()`. A text of another class is rejected in
// silence.
namespace iecfront::literals {

using NumericValue = std::variant<std::monostate, IntegerValue, RealValue>;

// Numeric, bit string and Boolean literals, with a type name of any class before `#`.
[[nodiscard]] NumericValue scan_number(std::string_view text, Encoding encoding,
                                       LiteralFaults& faults);

// Only looks for faults when `elements` is null. Gives `StringValue::double_byte`.
bool scan_string(std::string_view text, Encoding encoding, LiteralFaults& faults,
                 std::vector<StringElement>* elements);

// How much of `content`, the rest of a line behind an opening quote that nothing closes, stands in
// the string: all of it, unless there is code behind the string's probable end.
[[nodiscard]] std::size_t length_before_code(std::string_view content) noexcept;

DurationValue scan_duration(std::string_view text, Encoding encoding, LiteralFaults& faults);
DateValue scan_date(std::string_view text, Encoding encoding, LiteralFaults& faults);
TimeOfDayValue scan_time_of_day(std::string_view text, Encoding encoding, LiteralFaults& faults);
DateAndTimeValue scan_date_and_time(std::string_view text, Encoding encoding,
                                    LiteralFaults& faults);
DirectVariableValue scan_direct_variable(std::string_view text, Encoding encoding,
                                         LiteralFaults& faults);

// A literal that its type name cannot have: from `begin` to the end of the text.
void report_type_mismatch(const LiteralReader& reader, TokenKind type, std::uint32_t begin,
                          std::vector<DiagnosticFix> fixes = {});

} // namespace iecfront::literals
