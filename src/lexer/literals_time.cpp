#include "lexer/literal_scanners.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace iecfront::literals {

namespace {

// The digits of a fraction, cut to a number of places and to a product with an integer.
struct Fraction {
    std::uint64_t product = 0;
    bool inexact = false; // something was cut
};

// 0.`digits` times `factor` times ten to the power of `places`, in whole numbers. The factor is
// below 2^32, so that any number of digits can be worked off from the right with a carry.
Fraction scaled_fraction(std::string_view digits, std::uint64_t factor, std::size_t places) {
    std::string plain = without_underscores(digits);
    plain.resize(std::max(plain.size(), places), '0');
    Fraction result;
    std::uint64_t carry = 0;
    for (std::size_t i = plain.size(); i > places; --i) {
        const std::uint64_t sum = digit_value(plain[i - 1]) * factor + carry;
        result.inexact = result.inexact || sum % 10 != 0;
        carry = sum / 10;
    }
    const std::string_view leading = std::string_view(plain).substr(0, places);
    result.product = magnitude_of(leading, 10).value * factor + carry;
    return result;
}

// The digits behind the first `places` ones.
TextRange behind_places(const LiteralReader& reader, TextRange digits, std::size_t places) {
    std::size_t seen = 0;
    while (digits.begin < digits.end) {
        if (reader.text()[digits.begin] != '_' && seen++ == places)
            break;
        ++digits.begin;
    }
    return digits;
}

// [ "." integer ]; the point without digits is reported.
TextRange scan_fraction(LiteralReader& reader, const DigitRules& rules) {
    if (!reader.accept('.'))
        return reader.here();
    const TextRange digits = reader.digits(rules);
    if (digits.empty())
        reader.faults().report(DiagnosticId::missing_digits, reader.here(), {std::string(".")},
                               {insertion(reader.at(), "0")});
    return digits;
}

// ---- durations ---------------------------------------------------------------------------------

struct DurationUnit {
    std::string_view name;
    std::uint64_t nanoseconds; // `factor` times ten to the power of `power`
    std::uint64_t factor;
    std::size_t power;
    std::uint64_t highest; // unless it comes first
    bool third_edition = false;
};

constexpr std::array<DurationUnit, 7> units = {{
    {"d", 86'400'000'000'000, 864, 11, std::numeric_limits<std::uint64_t>::max()},
    {"h", 3'600'000'000'000, 36, 11, 23},
    {"m", 60'000'000'000, 6, 10, 59},
    {"s", 1'000'000'000, 1, 9, 59},
    {"ms", 1'000'000, 1, 6, 999},
    {"us", 1'000, 1, 3, 999, true},
    {"ns", 1, 1, 0, 999, true},
}};

class DurationScanner {
public:
    explicit DurationScanner(LiteralReader& reader) noexcept : reader_(reader) {}

    DurationValue scan();

private:
    void sign();
    [[nodiscard]] bool begins_with_value() const noexcept;
    bool part();
    [[nodiscard]] bool inner_sign();
    [[nodiscard]] bool smaller_unit_follows() const noexcept;
    bool number();
    void report_missing_number(std::uint32_t begin);
    [[nodiscard]] std::size_t unit(TextRange letters);
    [[nodiscard]] bool in_order(std::size_t unit, TextRange letters);
    void check_overflow(const DurationUnit& unit, TextRange letters);
    void separator();
    void add(const DurationUnit& unit);
    void add_product(std::uint64_t count, std::uint64_t unit) noexcept;
    [[nodiscard]] DurationValue value();

    LiteralReader& reader_;
    bool negative_ = false;
    std::uint32_t begin_ = 0; // behind `#`
    TextRange whole_;
    TextRange fraction_; // empty when the part has none
    std::array<TextRange, units.size()> given_{};
    std::size_t parts_ = 0;
    std::size_t previous_ = 0; // unit of the part before
    std::uint64_t total_ = 0;
    bool overflow_ = false;
    TextRange lost_; // digits below one nanosecond
};

DurationValue DurationScanner::scan() {
    if (!reader_.accept_prefix(TokenKind::kw_time) || holds_gap(reader_.text())) {
        reader_.faults().reject();
        return {};
    }
    begin_ = reader_.at();
    sign();
    if (!begins_with_value()) {
        reader_.faults().report(DiagnosticId::duration_without_value, reader_.to_end());
        return {};
    }
    while (!reader_.at_end())
        if (!part())
            return {};
    return value();
}

void DurationScanner::sign() {
    const std::uint32_t begin = reader_.at();
    negative_ = reader_.accept('-');
    if (!negative_ && reader_.accept('+'))
        reader_.faults().report(DiagnosticId::duration_plus_sign, reader_.from(begin), {},
                                {removal(reader_.from(begin))});
}

bool DurationScanner::begins_with_value() const noexcept {
    const std::string_view rest = reader_.rest();
    const std::size_t behind = rest.find_first_not_of("_.");
    return behind != std::string_view::npos && is_digit(rest[behind]);
}

// One number with its unit. False when the rest is guesswork.
bool DurationScanner::part() {
    const TextRange fraction_before = fraction_;
    if (!inner_sign() || !number())
        return false;
    const TextRange letters = reader_.letters();
    const std::size_t found = unit(letters);
    if (found == units.size() || !in_order(found, letters))
        return false;
    if (!fraction_before.empty()) {
        const TextRange with_point = {fraction_before.begin - 1, fraction_before.end};
        reader_.faults().report(DiagnosticId::duration_fraction_not_last, with_point);
    }
    if (parts_ > 0)
        check_overflow(units[found], letters);
    add(units[found]);
    given_[found] = letters;
    previous_ = found;
    ++parts_;
    separator();
    return true;
}

// `T#1h-5m`: a difference, or one duration? Of `+` there is no doubt. `T#5m+1h` can only be two
// durations: false then.
bool DurationScanner::inner_sign() {
    if (parts_ == 0 || !is_sign(reader_.peek()))
        return true;
    const std::string sign(1, reader_.peek());
    const TextRange range{reader_.at(), reader_.at() + 1};
    reader_.move_to(range.end);
    const bool one = smaller_unit_follows();
    std::vector<DiagnosticFix> fixes;
    if (!one)
        fixes.push_back(replacement(range, ' ' + sign + ' ' + reader_.words({0, begin_})));
    else if (sign == "+")
        fixes.push_back(removal(range));
    reader_.faults().report(DiagnosticId::sign_inside_duration, range, {}, std::move(fixes));
    return one;
}

bool DurationScanner::smaller_unit_follows() const noexcept {
    std::string_view name = reader_.rest();
    name.remove_prefix(std::min(name.find_first_not_of("0123456789_."), name.size()));
    const auto end = std::find_if_not(name.begin(), name.end(), is_ascii_letter);
    name = name.substr(0, static_cast<std::size_t>(end - name.begin()));
    return std::none_of(units.begin(), units.begin() + previous_ + 1,
                        [&](const DurationUnit& unit) { return names_equal(unit.name, name); });
}

// fixed_point; false when there is none.
bool DurationScanner::number() {
    const std::uint32_t begin = reader_.at();
    whole_ = reader_.digits(duration_digits);
    if (whole_.empty()) {
        report_missing_number(begin);
        if (reader_.peek() != '.')
            return false;
    }
    fraction_ = scan_fraction(reader_, duration_digits);
    return true;
}

void DurationScanner::report_missing_number(std::uint32_t begin) {
    // What stands before: `T#`, a unit, or an underscore behind it.
    TextRange before = {0, begin};
    if (parts_ > 0)
        before.begin = reader_.text()[begin - 1] == '_' ? begin - 1 : given_[previous_].begin;
    std::vector<DiagnosticFix> fixes;
    if (reader_.peek() == '.')
        fixes.push_back(insertion(reader_.at(), "0"));
    reader_.faults().report(DiagnosticId::missing_digits, reader_.here(), {reader_.words(before)},
                            std::move(fixes));
}

// The index of the unit, or their number when it is none.
std::size_t DurationScanner::unit(TextRange letters) {
    const std::string_view name = reader_.view(letters);
    const auto found = std::find_if(units.begin(), units.end(), [&](const DurationUnit& unit) {
        return names_equal(unit.name, name);
    });
    if (letters.empty()) {
        const TextRange number = {whole_.begin, std::max(whole_.end, fraction_.end)};
        reader_.faults().report(DiagnosticId::duration_without_unit, number,
                                {reader_.words(number)});
    } else if (found == units.end()) {
        reader_.faults().report(DiagnosticId::unknown_duration_unit, letters,
                                {reader_.words(letters)});
    } else if (found->third_edition && (parts_ == 0 || !units[previous_].third_edition)) {
        reader_.faults().report(DiagnosticId::third_edition_literal, letters,
                                {reader_.words(letters), std::string("unit")});
    }
    return static_cast<std::size_t>(found - units.begin());
}

bool DurationScanner::in_order(std::size_t unit, TextRange letters) {
    LiteralFaults& faults = reader_.faults();
    if (!given_[unit].empty()) {
        faults.report(DiagnosticId::repeated_duration_unit, letters, {reader_.words(letters)});
        faults.add_label({given_[unit], LabelId::first_given, {}});
        return false;
    }
    if (parts_ == 0 || previous_ < unit)
        return true;
    faults.report(DiagnosticId::duration_unit_order, letters,
                  {reader_.words(letters), reader_.words(given_[previous_])});
    return false;
}

void DurationScanner::check_overflow(const DurationUnit& unit, TextRange letters) {
    if (magnitude_of(reader_.view(whole_), 10).value > unit.highest)
        reader_.faults().report(DiagnosticId::duration_unit_overflow, whole_,
                                {reader_.words(letters), unit.highest});
}

// [ "_" ] between two parts.
void DurationScanner::separator() {
    TextRange range = reader_.underscores();
    if (!reader_.at_end() && !range.empty())
        ++range.begin;
    if (!range.empty())
        reader_.faults().report(DiagnosticId::duration_underscore, range, {}, {removal(range)});
}

void DurationScanner::add(const DurationUnit& unit) {
    const Magnitude whole = magnitude_of(reader_.view(whole_), 10);
    overflow_ = overflow_ || whole.overflow;
    add_product(whole.value, unit.nanoseconds);
    if (fraction_.empty())
        return;
    const Fraction fraction = scaled_fraction(reader_.view(fraction_), unit.factor, unit.power);
    add_product(fraction.product, 1);
    if (fraction.inexact)
        lost_ = behind_places(reader_, fraction_, unit.power);
}

void DurationScanner::add_product(std::uint64_t count, std::uint64_t unit) noexcept {
    constexpr std::uint64_t highest = std::numeric_limits<std::uint64_t>::max();
    if (count > (highest - total_) / unit)
        overflow_ = true;
    else
        total_ += count * unit;
}

DurationValue DurationScanner::value() {
    constexpr auto highest = std::numeric_limits<std::int64_t>::max();
    const std::uint64_t limit = static_cast<std::uint64_t>(highest) + (negative_ ? 1 : 0);
    DurationValue value;
    value.overflow = overflow_ || total_ > limit;
    value.inexact = !lost_.empty();
    const std::uint64_t magnitude = value.overflow ? limit : total_;
    value.nanoseconds = static_cast<std::int64_t>(negative_ ? 0 - magnitude : magnitude);
    LiteralFaults& faults = reader_.faults();
    if (!faults.has_value())
        return value; // what was reported may have been what made it large
    if (value.overflow)
        faults.report(DiagnosticId::duration_out_of_range, {begin_, reader_.end()},
                      {std::string("64 bits of nanoseconds, about 292 years")});
    else if (value.inexact)
        faults.report(DiagnosticId::too_fine_fraction, lost_);
    return value;
}

// ---- dates and times of day --------------------------------------------------------------------

constexpr std::array<std::string_view, 12> month_names = {
    "January", "February", "March",     "April",   "May",      "June",
    "July",    "August",   "September", "October", "November", "December"};

constexpr bool is_leap_year(std::uint64_t year) noexcept {
    return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

constexpr std::uint64_t days_in(std::uint64_t year, std::uint64_t month) noexcept {
    if (month == 2)
        return is_leap_year(year) ? 29 : 28;
    return month == 4 || month == 6 || month == 9 || month == 11 ? 30 : 31;
}

class CalendarScanner {
public:
    // `form` is an example of what stands behind the prefix.
    CalendarScanner(LiteralReader& reader, std::string_view form) noexcept
        : reader_(reader), form_(form) {}

    [[nodiscard]] bool prefix(TokenKind type, TokenKind long_type) noexcept;
    // False when the form is wrong, and the rest guesswork.
    bool date(DateValue& value);
    bool time_of_day(TimeOfDayValue& value);
    bool accept_before_time();
    void finish(DiagnosticId fault);

private:
    struct Field {
        TextRange range;
        std::uint64_t value = 0;
    };

    bool field(Field& field, DiagnosticId fault);
    bool accept(char separator, DiagnosticId fault);
    char dash_behind(const Field& year);
    bool day_field(Field& day);
    void check_year(const Field& year);
    void check_day(const Field& year, const Field& month, const Field& day);
    void check_time(const Field& field, std::uint64_t highest, DiagnosticId fault);
    std::uint32_t nanosecond();
    [[nodiscard]] std::string form() const;
    void report_form(DiagnosticId fault);

    LiteralReader& reader_;
    std::string_view form_;
};

bool CalendarScanner::prefix(TokenKind type, TokenKind long_type) noexcept {
    const bool found = reader_.accept_prefix(type, long_type) && !holds_gap(reader_.text());
    if (!found)
        reader_.faults().reject();
    return found;
}

bool CalendarScanner::date(DateValue& value) {
    constexpr DiagnosticId fault = DiagnosticId::malformed_date;
    Field year;
    Field month;
    Field day;
    if (!field(year, fault))
        return false;
    const char dash = dash_behind(year);
    if (!accept(dash, fault) || !field(month, fault) || !accept(dash, fault) || !day_field(day))
        return false;
    check_year(year);
    check_day(year, month, day);
    value = {static_cast<std::uint16_t>(year.value), static_cast<std::uint8_t>(month.value),
             static_cast<std::uint8_t>(day.value)};
    return true;
}

// What stands in both places of `-`: `/` and `.` are reported as one mistake.
char CalendarScanner::dash_behind(const Field& year) {
    const std::string_view rest = reader_.rest();
    const char found = reader_.peek();
    const std::size_t month_end = rest.find_first_not_of("0123456789", 1);
    const bool twice = (found == '/' || found == '.') && year.range.size() == 4 &&
                       month_end != rest.npos && rest[month_end] == found;
    if (!twice)
        return '-';
    const TextRange first{reader_.at(), reader_.at() + 1};
    const auto second_begin = static_cast<std::uint32_t>(reader_.at() + month_end);
    const TextRange second{second_begin, second_begin + 1};
    const DiagnosticFix fix{{TextEdit{first, "-"}, TextEdit{second, "-"}}};
    reader_.faults().report(DiagnosticId::malformed_date, first, {form()}, {fix});
    return found;
}

// An underscore before the time, `25_15:36:55`, stands for the dash.
bool CalendarScanner::day_field(Field& day) {
    constexpr std::string_view digits = "0123456789";
    const std::string_view rest = reader_.rest();
    const std::size_t day_end = std::min(rest.find_first_not_of(digits), rest.size());
    const std::size_t behind = rest.find_first_not_of(digits, day_end + 1);
    if (day_end == 0 || !rest.substr(day_end).starts_with('_') || behind == rest.npos ||
        rest[behind] != ':')
        return field(day, DiagnosticId::malformed_date);
    const std::uint32_t begin = reader_.at();
    reader_.move_to(begin + static_cast<std::uint32_t>(day_end));
    day.range = reader_.from(begin);
    day.value = magnitude_of(reader_.view(day.range), 10).value;
    return true;
}

// The `-` before a time of day, or what other notations have in its place.
bool CalendarScanner::accept_before_time() {
    const TextRange here{reader_.at(), reader_.at() + 1};
    const std::string_view rest = reader_.rest();
    if (rest.size() < 2 || !is_digit(rest[1]) || (rest[0] != '_' && fold(rest[0]) != 'T'))
        return accept('-', DiagnosticId::malformed_time_of_day);
    reader_.move_to(here.end);
    reader_.faults().report(DiagnosticId::malformed_time_of_day, here, {form()},
                            {replacement(here, "-")});
    return true;
}

bool CalendarScanner::time_of_day(TimeOfDayValue& value) {
    constexpr DiagnosticId fault = DiagnosticId::malformed_time_of_day;
    Field hour;
    Field minute;
    Field second;
    if (!field(hour, fault) || !accept(':', fault) || !field(minute, fault) ||
        !accept(':', fault) || !field(second, fault))
        return false;
    check_time(hour, 23, DiagnosticId::hour_out_of_range);
    check_time(minute, 59, DiagnosticId::minute_out_of_range);
    check_time(second, 59, DiagnosticId::second_out_of_range);
    value = {static_cast<std::uint8_t>(hour.value), static_cast<std::uint8_t>(minute.value),
             static_cast<std::uint8_t>(second.value), nanosecond()};
    return true;
}

bool CalendarScanner::accept(char separator, DiagnosticId fault) {
    const bool found = reader_.accept(separator);
    if (!found)
        report_form(fault);
    return found;
}

void CalendarScanner::finish(DiagnosticId fault) {
    if (!reader_.at_end())
        report_form(fault);
}

bool CalendarScanner::field(Field& field, DiagnosticId fault) {
    field.range = reader_.digits(decimal_digits);
    field.value = magnitude_of(reader_.view(field.range), 10).value;
    if (field.range.empty())
        report_form(fault);
    return !field.range.empty();
}

void CalendarScanner::check_year(const Field& year) {
    if (year.value >= 1 && year.value <= 9999)
        return;
    reader_.faults().report(DiagnosticId::year_out_of_range, year.range,
                            {reader_.words(year.range)});
    reader_.faults().reject(); // a limit, but there is no room for the year in the value
}

void CalendarScanner::check_day(const Field& year, const Field& month, const Field& day) {
    LiteralFaults& faults = reader_.faults();
    if (month.value < 1 || month.value > 12) {
        faults.report(DiagnosticId::month_out_of_range, month.range, {reader_.words(month.range)});
        return;
    }
    if (day.value >= 1 && day.value <= days_in(year.value, month.value))
        return;
    std::string name(month_names[static_cast<std::size_t>(month.value - 1)]);
    if (month.value == 2)
        name += ' ' + reader_.words(year.range);
    faults.report(DiagnosticId::day_out_of_range, day.range, {reader_.words(day.range), name});
}

void CalendarScanner::check_time(const Field& field, std::uint64_t highest, DiagnosticId fault) {
    if (field.value > highest)
        reader_.faults().report(fault, field.range);
}

std::uint32_t CalendarScanner::nanosecond() {
    constexpr std::size_t places = 9;
    const TextRange digits = scan_fraction(reader_, decimal_digits);
    const Fraction fraction = scaled_fraction(reader_.view(digits), 1, places);
    if (fraction.inexact)
        reader_.faults().report(DiagnosticId::too_fine_fraction,
                                behind_places(reader_, digits, places));
    return static_cast<std::uint32_t>(fraction.product);
}

std::string CalendarScanner::form() const {
    const std::string_view text = reader_.text();
    return std::string(text.substr(0, text.find('#') + 1)) + std::string(form_);
}

void CalendarScanner::report_form(DiagnosticId fault) {
    reader_.faults().report(fault, reader_.to_end(), {form()});
}

// Runs a scanner for its value alone.
template<class Value, class Scan>
std::optional<Value> value_of(std::string_view text, Scan scan) {
    LiteralFaults faults;
    const Value value = scan(text, Encoding::utf8, faults);
    return faults.has_value() ? std::optional(value) : std::nullopt;
}

} // namespace

DurationValue scan_duration(std::string_view text, Encoding encoding, LiteralFaults& faults) {
    LiteralReader reader(text, encoding, faults);
    return DurationScanner(reader).scan();
}

DateValue scan_date(std::string_view text, Encoding encoding, LiteralFaults& faults) {
    LiteralReader reader(text, encoding, faults);
    CalendarScanner scanner(reader, "1984-06-25");
    DateValue value;
    if (scanner.prefix(TokenKind::kw_date, TokenKind::kw_date) && scanner.date(value))
        scanner.finish(DiagnosticId::malformed_date);
    return value;
}

TimeOfDayValue scan_time_of_day(std::string_view text, Encoding encoding, LiteralFaults& faults) {
    LiteralReader reader(text, encoding, faults);
    CalendarScanner scanner(reader, "15:36:55.36");
    TimeOfDayValue value;
    if (scanner.prefix(TokenKind::kw_tod, TokenKind::kw_time_of_day) && scanner.time_of_day(value))
        scanner.finish(DiagnosticId::malformed_time_of_day);
    return value;
}

DateAndTimeValue scan_date_and_time(std::string_view text, Encoding encoding,
                                    LiteralFaults& faults) {
    LiteralReader reader(text, encoding, faults);
    CalendarScanner scanner(reader, "1984-06-25-15:36:55.36");
    DateAndTimeValue value;
    if (scanner.prefix(TokenKind::kw_dt, TokenKind::kw_date_and_time) && scanner.date(value.date) &&
        scanner.accept_before_time() && scanner.time_of_day(value.time))
        scanner.finish(DiagnosticId::malformed_time_of_day);
    return value;
}

} // namespace iecfront::literals

namespace iecfront {

using namespace literals;

std::optional<DurationValue> duration_value(std::string_view text) {
    return value_of<DurationValue>(text, scan_duration);
}

std::optional<DateValue> date_value(std::string_view text) {
    return value_of<DateValue>(text, scan_date);
}

std::optional<TimeOfDayValue> time_of_day_value(std::string_view text) {
    return value_of<TimeOfDayValue>(text, scan_time_of_day);
}

std::optional<DateAndTimeValue> date_and_time_value(std::string_view text) {
    return value_of<DateAndTimeValue>(text, scan_date_and_time);
}

} // namespace iecfront
