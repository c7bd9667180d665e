#include "lexer/literal_reader.hpp"

#include "lexer/keywords.hpp"

#include <limits>

namespace iecfront::literals {

namespace {

bool is_letter_or_digit(char c) noexcept {
    return is_digit(c) || is_ascii_letter(c);
}

bool begins_with_digit_after_underscores(std::string_view rest) noexcept {
    const std::size_t at = rest.find_first_not_of('_');
    return at == std::string_view::npos || is_digit(rest[at]);
}

// `1_`, `1_.0` and `1.0_E3` hold a misplaced underscore, but `1_abc` a suffix.
bool takes_underscore_in_number(std::string_view rest) noexcept {
    if (rest.empty() || exponent_begins(rest))
        return true;
    return !is_ascii_letter(rest.front()) && is_ascii(rest.front());
}

bool takes_any_underscore(std::string_view) noexcept {
    return true;
}

// `T#5_s`; in `T#5_` the missing unit is the fault.
bool takes_underscore_before_unit(std::string_view rest) noexcept {
    return !rest.empty() && (is_ascii_letter(rest.front()) || rest.front() == '.');
}

} // namespace

const DigitRules decimal_digits = {is_digit, takes_underscore_in_number,
                                   DiagnosticId::misplaced_underscore};
const DigitRules based_digits = {is_letter_or_digit, takes_any_underscore,
                                 DiagnosticId::misplaced_underscore};
const DigitRules duration_digits = {is_digit, takes_underscore_before_unit,
                                    DiagnosticId::duration_underscore};

bool exponent_begins(std::string_view rest) noexcept {
    if (rest.empty() || fold(rest.front()) != 'E')
        return false;
    if (rest.size() > 1 && (rest[1] == '+' || rest[1] == '-'))
        return true;
    return begins_with_digit_after_underscores(rest.substr(1));
}

bool holds_gap(std::string_view text) noexcept {
    for (const char c : text) {
        if (c == '\'' || c == '"')
            return false;
        if (is_white_space(c) || begins_remark(c))
            return true;
    }
    return false;
}

Magnitude magnitude_of(std::string_view digits, unsigned base) noexcept {
    constexpr std::uint64_t highest = std::numeric_limits<std::uint64_t>::max();
    constexpr std::uint64_t surely_fits = highest / 64; // no base is larger, nor is a digit
    Magnitude magnitude;
    for (const char c : digits) {
        const unsigned digit = digit_value(c);
        if (digit >= base)
            continue;
        if (magnitude.value > surely_fits && magnitude.value > (highest - digit) / base)
            return {highest, true};
        magnitude.value = magnitude.value * base + digit;
    }
    return magnitude;
}

std::string without_underscores(std::string_view digits) {
    std::string result;
    for (const char c : digits)
        if (c != '_')
            result += c;
    return result;
}

DiagnosticFix insertion(std::uint32_t at, std::string_view text) {
    return replacement({at, at}, text);
}

DiagnosticFix removal(TextRange range) {
    return replacement(range, {});
}

DiagnosticFix replacement(TextRange range, std::string_view text) {
    return {{TextEdit{range, std::string(text)}}};
}

void LiteralFaults::report(DiagnosticId id, TextRange range,
                           std::vector<DiagnosticArgument> arguments,
                           std::vector<DiagnosticFix> fixes) {
    const DiagnosticClass category = diagnostic_info(id).category;
    if (category != DiagnosticClass::extension && category != DiagnosticClass::limit)
        has_value_ = false;
    if (list_ != nullptr)
        list_->push_back({id, range, std::move(arguments), {}, std::move(fixes)});
}

void LiteralFaults::report_in_value(DiagnosticId id, TextRange range,
                                    std::vector<DiagnosticArgument> arguments) {
    if (list_ != nullptr)
        list_->push_back({id, range, std::move(arguments), {}, {}});
}

void LiteralFaults::add_label(DiagnosticLabel label) {
    if (list_ != nullptr && !list_->empty())
        list_->back().labels.push_back(std::move(label));
}

bool LiteralReader::accept(char c) noexcept {
    if (at_end() || text_[at_] != c)
        return false;
    ++at_;
    return true;
}

bool LiteralReader::accept_prefix(TokenKind type, std::optional<TokenKind> long_type) noexcept {
    const TypePrefix prefix = type_prefix_of(text_);
    if (!prefix.type || (prefix.type != type && prefix.type != long_type))
        return false;
    at_ = prefix.end;
    return true;
}

TextRange LiteralReader::letters() noexcept {
    const std::uint32_t begin = at_;
    while (is_ascii_letter(peek()) || !is_ascii(peek()))
        ++at_;
    return from(begin);
}

TextRange LiteralReader::underscores() noexcept {
    const std::uint32_t begin = at_;
    at_ = underscores_end(at_);
    return from(begin);
}

TextRange LiteralReader::digits(const DigitRules& rules) {
    const std::uint32_t behind = underscores_end(at_);
    if (behind != at_ && (behind == end() || rules.takes(text_[behind]))) {
        report_underscores(rules, {at_, behind});
        at_ = behind;
    }
    TextRange digits = here();
    while (rules.takes(peek())) {
        while (rules.takes(peek()))
            ++at_;
        digits.end = at_;
        const std::uint32_t next = underscores_end(at_);
        if (next == at_)
            break;
        if (next != end() && rules.takes(text_[next])) {
            report_underscores(rules, {at_ + 1, next});
            at_ = next;
        } else if (rules.takes_underscore_before(text_.substr(next))) {
            report_underscores(rules, {at_, next});
            at_ = next;
        }
    }
    return digits;
}

TextRange LiteralReader::character(std::uint32_t at) const noexcept {
    return {at, at + decode_character(text_, at, encoding_).size};
}

void LiteralReader::report_underscores(const DigitRules& rules, TextRange range) {
    if (!range.empty())
        faults_->report(rules.misplaced, range, {}, {removal(range)});
}

std::uint32_t LiteralReader::underscores_end(std::uint32_t at) const noexcept {
    const std::size_t found = text_.find_first_not_of('_', at);
    return found == std::string_view::npos ? end() : static_cast<std::uint32_t>(found);
}

TypePrefix type_prefix_of(std::string_view text) noexcept {
    if (text.empty() || (!is_word_start(text.front()) && is_ascii(text.front())))
        return {};
    const std::size_t sign = text.find('#');
    if (sign == std::string_view::npos)
        return {};
    const std::string_view name = text.substr(0, sign);
    TypePrefix prefix{name, std::nullopt, static_cast<std::uint32_t>(sign + 1)};
    if (const TokenKind kind = keyword_kind(name); is_elementary_type_name(kind))
        prefix.type = kind;
    else if (name.size() == 1 && fold(name.front()) == 'T')
        prefix.type = TokenKind::kw_time;
    else if (name.size() == 1 && fold(name.front()) == 'D')
        prefix.type = TokenKind::kw_date;
    return prefix;
}

} // namespace iecfront::literals
