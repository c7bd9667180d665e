#include "lexer/literal_scanners.hpp"

namespace iecfront::literals {

namespace {

bool is_size_prefix(char letter) noexcept {
    return std::string_view("XBWDL").find(fold(letter)) != std::string_view::npos;
}

class LocationScanner {
public:
    explicit LocationScanner(LiteralReader& reader) noexcept : reader_(reader) {}

    DirectVariableValue scan();

private:
    [[nodiscard]] bool location();
    [[nodiscard]] bool incomplete();
    void size();
    void hierarchy();
    [[nodiscard]] bool number();
    void report_missing_number();

    LiteralReader& reader_;
    DirectVariableValue value_;
};

DirectVariableValue LocationScanner::scan() {
    if (!reader_.accept('%') || holds_gap(reader_.text())) {
        reader_.faults().reject();
        return {};
    }
    if (location() && !incomplete()) {
        size();
        hierarchy();
    }
    return std::move(value_);
}

// "I" | "Q" | "M"
bool LocationScanner::location() {
    value_.location = fold(reader_.peek());
    if (!reader_.at_end() &&
        std::string_view("IQM").find(value_.location) != std::string_view::npos) {
        reader_.move_to(reader_.at() + 1);
        return true;
    }
    const TextRange found = reader_.at_end() ? reader_.here() : reader_.character(reader_.at());
    reader_.faults().report(DiagnosticId::unknown_location_prefix, found);
    return false;
}

// `%I*`, with nothing before the asterisk and nothing behind it.
bool LocationScanner::incomplete() {
    const std::size_t asterisk = reader_.text().find('*');
    if (asterisk == std::string_view::npos)
        return false;
    value_.incomplete = true;
    const TextRange before = {reader_.at(), static_cast<std::uint32_t>(asterisk)};
    const TextRange behind = {before.end + 1, reader_.end()};
    for (const TextRange extra : {before, behind})
        if (!extra.empty())
            reader_.faults().report(DiagnosticId::size_with_asterisk, extra,
                                    {std::string(1, value_.location)}, {removal(extra)});
    return true;
}

void LocationScanner::size() {
    const TextRange letters = reader_.letters();
    if (letters.empty())
        return;
    if (letters.size() == 1 && is_size_prefix(reader_.view(letters).front()))
        value_.size = fold(reader_.view(letters).front());
    else
        reader_.faults().report(DiagnosticId::unknown_size_prefix, letters,
                                {reader_.words(letters)});
}

// integer { "." integer }
void LocationScanner::hierarchy() {
    do {
        if (!number())
            return;
    } while (reader_.accept('.'));
    if (reader_.at_end())
        return;
    const TextRange rest = reader_.to_end();
    reader_.faults().report(DiagnosticId::unknown_number_suffix, rest, {reader_.words(rest)});
}

bool LocationScanner::number() {
    const TextRange digits = reader_.digits(decimal_digits);
    if (digits.empty()) {
        report_missing_number();
        return false;
    }
    const Magnitude magnitude = magnitude_of(reader_.view(digits), 10);
    if (magnitude.overflow)
        reader_.faults().report(DiagnosticId::integer_too_large, digits);
    value_.hierarchy.push_back(magnitude.value);
    return true;
}

void LocationScanner::report_missing_number() {
    const std::uint32_t at = reader_.at();
    const bool behind_point = !value_.hierarchy.empty();
    const TextRange before = behind_point ? TextRange{at - 1, at} : TextRange{0, at};
    std::vector<DiagnosticFix> fixes;
    if (behind_point && reader_.peek() == '.')
        fixes.push_back(removal({at, at + 1}));
    reader_.faults().report(DiagnosticId::missing_location_number, reader_.here(),
                            {reader_.words(before)}, std::move(fixes));
}

} // namespace

DirectVariableValue scan_direct_variable(std::string_view text, Encoding encoding,
                                         LiteralFaults& faults) {
    LiteralReader reader(text, encoding, faults);
    return LocationScanner(reader).scan();
}

} // namespace iecfront::literals

namespace iecfront {

using namespace literals;

std::optional<DirectVariableValue> direct_variable_value(std::string_view text) {
    LiteralFaults faults;
    DirectVariableValue value = scan_direct_variable(text, Encoding::utf8, faults);
    if (!faults.has_value())
        return std::nullopt;
    return value;
}

} // namespace iecfront
