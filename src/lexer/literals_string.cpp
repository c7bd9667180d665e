#include "lexer/keywords.hpp"
#include "lexer/literal_scanners.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>

namespace iecfront::literals {

namespace {

constexpr char single_quote = '\'';
constexpr char double_quote = '"';

bool is_hex_digit(char c) noexcept {
    return digit_value(c) < 16;
}

// Table 6, but for the quotes and `$$`; zero for every other letter. `$N` is one character, LF.
constexpr char control_of_letter(char letter) noexcept {
    switch (fold(letter)) {
    case 'L':
    case 'N': return '\n';
    case 'P': return '\f';
    case 'R': return '\r';
    case 'T': return '\t';
    default: return '\0';
    }
}

// How a control character is written: `$T`, or `$1B` with as many digits as the string takes.
std::string escape_of_control(char32_t control, std::uint32_t digits) {
    for (const char letter : {'L', 'P', 'R', 'T'})
        if (static_cast<char32_t>(control_of_letter(letter)) == control)
            return {'$', letter};
    constexpr std::string_view hex = "0123456789ABCDEF";
    return "$" + std::string(digits - 2, '0') + hex[control >> 4] + hex[control & 0xFU];
}

// ---- strings without an end --------------------------------------------------------------------

std::size_t without_trailing_blanks(std::string_view text, std::size_t end) noexcept {
    while (end > 0 && is_white_space(text[end - 1]))
        --end;
    return end;
}

std::size_t without_trailing_comment(std::string_view text, std::size_t end) noexcept {
    const std::string_view line = text.substr(0, end);
    const std::size_t begin = line.ends_with("*)") ? line.rfind("(*") : std::string_view::npos;
    return begin == std::string_view::npos ? end : without_trailing_blanks(text, begin);
}

// THEN, DO or OF
bool follows_expression(std::string_view word) noexcept {
    const TokenKind kind = keyword_kind(word);
    return kind == TokenKind::kw_then || kind == TokenKind::kw_do || kind == TokenKind::kw_of;
}

// Such a word behind the last blank is no part of the string.
std::size_t without_trailing_word(std::string_view content, std::size_t end) noexcept {
    const std::size_t blank = content.substr(0, end).find_last_of(" \t");
    if (blank == std::string_view::npos ||
        !follows_expression(content.substr(blank + 1, end - blank - 1)))
        return end;
    return without_trailing_blanks(content, blank);
}

// Where the quote is missing that closes `content`, the rest of a line: before what ends the
// statement, and before the parentheses that were opened before the string.
std::size_t probable_end(std::string_view content) noexcept {
    std::size_t end = without_trailing_blanks(content, content.size());
    end = without_trailing_comment(content, end);
    if (end > 0 && (content[end - 1] == ';' || content[end - 1] == ','))
        end = without_trailing_blanks(content, end - 1);
    end = without_trailing_word(content, end);
    const std::string_view before = content.substr(0, end);
    std::ptrdiff_t surplus = std::count(before.begin(), before.end(), ')') -
                             std::count(before.begin(), before.end(), '(');
    for (; end > 0 && content[end - 1] == ')' && surplus > 0; --surplus)
        end = without_trailing_blanks(content, end - 1);
    return end;
}

// True for an assignment or a closing word: what may follow a `;` in a text is neither.
bool begins_with_code(std::string_view text) noexcept {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    const auto word_end = std::find_if_not(text.begin(), text.end(), is_word_part);
    const auto length = static_cast<std::size_t>(word_end - text.begin());
    const std::size_t behind = text.find_first_not_of(" \t", length);
    return length > 0 && (names_equal(text.substr(0, std::min(length, std::size_t{4})), "END_") ||
                          (behind != text.npos && text.substr(behind).starts_with(":=")));
}

// ---- the scanner -------------------------------------------------------------------------------

class StringScanner {
public:
    StringScanner(LiteralReader& reader, std::vector<StringElement>* elements) noexcept
        : reader_(reader), elements_(elements) {}

    bool scan();

private:
    [[nodiscard]] bool prefix();
    [[nodiscard]] bool find_end();
    void report_unterminated();
    [[nodiscard]] DiagnosticFix missing_quote() const;
    void report_double_quotes();
    [[nodiscard]] bool quotes_can_be_replaced() const noexcept;

    void element();
    void add(char32_t code, TextRange source);
    void plain_character();
    void control_character(char32_t character, TextRange source);
    void report_wide(char32_t character, TextRange source);

    void escape();
    void other_quote(TextRange source);
    void hex_escape(std::uint32_t digits_end);
    void report_lower_case(TextRange digits);
    void report_incomplete_hex(TextRange source);
    void unknown_escape();

    [[nodiscard]] std::uint32_t hex_digits_end(std::uint32_t at) const noexcept;
    [[nodiscard]] char at(std::uint32_t index) const noexcept { return reader_.text()[index]; }

    LiteralReader& reader_;
    std::vector<StringElement>* elements_;
    TypePrefix prefix_;
    char quote_ = single_quote;
    bool double_byte_ = false;
    std::uint32_t open_ = 0;    // the opening quote
    std::uint32_t content_ = 0; // behind it
    std::uint32_t close_ = 0;   // the closing quote
};

bool StringScanner::scan() {
    if (!prefix())
        return false;
    if (!find_end()) {
        report_unterminated();
        return double_byte_;
    }
    if (close_ + 1 != reader_.end()) {
        reader_.faults().reject();
        return double_byte_;
    }
    if (prefix_.type && quote_ == double_quote)
        report_double_quotes();
    reader_.move_to(content_);
    while (reader_.at() < close_)
        element();
    return double_byte_;
}

// Reads up to the opening quote. False when the literal is no string.
bool StringScanner::prefix() {
    const std::size_t quote = reader_.text().find_first_of("'\"");
    if (quote == std::string_view::npos) {
        reader_.faults().reject();
        return false;
    }
    open_ = static_cast<std::uint32_t>(quote);
    content_ = open_ + 1;
    quote_ = at(open_);
    const std::string_view before = reader_.text().substr(0, open_);
    prefix_ = type_prefix_of(before);
    if (prefix_.end != open_ || prefix_.of_time_literal() || holds_gap(before)) {
        reader_.faults().reject();
        return false;
    }
    if (prefix_.type && *prefix_.type != TokenKind::kw_string &&
        *prefix_.type != TokenKind::kw_wstring) {
        report_type_mismatch(reader_, *prefix_.type, open_);
        return false;
    }
    double_byte_ = prefix_.type ? prefix_.type == TokenKind::kw_wstring : quote_ == double_quote;
    return true;
}

// Finds the closing quote: the first one that no `$` stands before.
bool StringScanner::find_end() {
    for (close_ = content_; close_ < reader_.end(); ++close_) {
        if (at(close_) == quote_)
            return true;
        if (at(close_) == '$' && close_ + 1 < reader_.end())
            ++close_;
    }
    return false;
}

// Nothing else is said: what looks like a fault of the string may be code behind its end.
void StringScanner::report_unterminated() {
    const std::string quote = {'`', quote_, '`'};
    reader_.faults().report(DiagnosticId::unterminated_string, {open_, content_}, {quote},
                            {missing_quote()});
}

DiagnosticFix StringScanner::missing_quote() const {
    const std::string_view content = reader_.text().substr(content_);
    const auto end = static_cast<std::uint32_t>(probable_end(content));
    const std::string_view code = content.substr(
        0, without_trailing_comment(content, without_trailing_blanks(content, content.size())));
    for (std::uint32_t i = 0; i < content.size(); ++i) {
        if (content[i] != '$')
            continue;
        // `'5 $';`: the dollar sign was meant as a character.
        const bool escapes_quote = i + 1 < content.size() && content[i + 1] == quote_;
        const bool last = escapes_quote && code.find('$', i + 2) == std::string_view::npos;
        if (last && probable_end(content.substr(i + 2)) == 0)
            return insertion(content_ + i, "$");
        // A quote behind this dollar sign would be escaped.
        if (i + 1 == end)
            return insertion(content_ + end, {std::array{'$', quote_}.data(), 2});
        ++i;
    }
    return insertion(content_ + end, {&quote_, 1});
}

void StringScanner::report_double_quotes() {
    std::vector<DiagnosticFix> fixes;
    const std::string_view quote(&single_quote, 1);
    if (quotes_can_be_replaced())
        fixes.push_back({{TextEdit{{open_, content_}, std::string(quote)},
                          TextEdit{{close_, close_ + 1}, std::string(quote)}}});
    reader_.faults().report(DiagnosticId::typed_string_in_double_quotes, {open_, content_},
                            {std::string(spelling(*prefix_.type))}, std::move(fixes));
}

bool StringScanner::quotes_can_be_replaced() const noexcept {
    return reader_.view({content_, close_}).find_first_of("'\"") == std::string_view::npos;
}

// ---- characters --------------------------------------------------------------------------------

void StringScanner::element() {
    if (reader_.peek() == '$')
        escape();
    else
        plain_character();
}

void StringScanner::add(char32_t code, TextRange source) {
    reader_.move_to(source.end);
    if (elements_ != nullptr)
        elements_->push_back({static_cast<std::uint16_t>(code), source});
}

void StringScanner::plain_character() {
    const std::uint32_t begin = reader_.at();
    const char byte = at(begin);
    if (byte >= ' ' && byte < '\x7F') {
        add(static_cast<unsigned char>(byte), {begin, begin + 1});
        return;
    }
    const DecodedCharacter character = decode_character(reader_.text(), begin, reader_.encoding());
    const TextRange source = {begin, std::min(begin + character.size, close_)};
    const char32_t highest = double_byte_ ? 0xFFFF : 0xFF;
    if (!character.valid)
        reader_.faults().reject(); // the lexer has reported the byte
    else if (character.code_point < 0x20 || character.code_point == 0x7F)
        control_character(character.code_point, source);
    else if (character.code_point > highest) {
        report_wide(character.code_point, source);
        return;
    }
    add(character.code_point, source);
}

void StringScanner::control_character(char32_t character, TextRange source) {
    reader_.faults().report(
        DiagnosticId::control_character_in_string, source, {character},
        {replacement(source, escape_of_control(character, double_byte_ ? 4 : 2))});
}

// Characters that stand together are one fault; the first one is named.
void StringScanner::report_wide(char32_t character, TextRange source) {
    const char32_t highest = double_byte_ ? 0xFFFF : 0xFF;
    while (source.end < close_) {
        const DecodedCharacter next =
            decode_character(reader_.text(), source.end, reader_.encoding());
        if (!next.valid || next.code_point <= highest)
            break;
        source.end += next.size;
    }
    reader_.move_to(source.end);
    reader_.faults().report(double_byte_ ? DiagnosticId::character_beyond_double_byte
                                         : DiagnosticId::character_beyond_single_byte,
                            source, {character});
}

// ---- combinations with `$` ---------------------------------------------------------------------

// There is a character behind the `$`, for it would have escaped the closing quote.
void StringScanner::escape() {
    const std::uint32_t begin = reader_.at();
    const char letter = at(begin + 1);
    const TextRange pair = {begin, begin + 2};
    const std::uint32_t digits_end = hex_digits_end(begin + 1);
    if (letter == '$' || letter == quote_)
        add(static_cast<unsigned char>(letter), pair);
    else if (letter == single_quote || letter == double_quote)
        other_quote(pair);
    else if (const char control = control_of_letter(letter); control != '\0')
        add(static_cast<unsigned char>(control), pair);
    else if (digits_end != begin + 1)
        hex_escape(digits_end);
    else
        unknown_escape();
}

void StringScanner::other_quote(TextRange source) {
    const std::string_view kind = quote_ == single_quote ? "double" : "single";
    reader_.faults().report(DiagnosticId::escape_of_other_quote, source,
                            {reader_.words(source), std::string(kind)},
                            {removal({source.begin, source.begin + 1})});
    add(static_cast<unsigned char>(at(source.begin + 1)), source);
}

void StringScanner::hex_escape(std::uint32_t digits_end) {
    const std::uint32_t begin = reader_.at();
    const TextRange digits = {begin + 1, digits_end};
    if (digits.size() < (double_byte_ ? 4U : 2U)) {
        report_incomplete_hex({begin, digits_end});
        reader_.move_to(digits_end);
        return;
    }
    report_lower_case(digits);
    const Magnitude code = magnitude_of(reader_.view(digits), 16);
    add(static_cast<char32_t>(code.value), {begin, digits_end});
}

// The productions list the digits A to F only.
void StringScanner::report_lower_case(TextRange digits) {
    const std::string_view text = reader_.view(digits);
    const auto is_lower = [](char c) { return c != fold(c); };
    const auto first = std::find_if(text.begin(), text.end(), is_lower);
    if (first == text.end())
        return;
    const auto last = std::find_if(text.rbegin(), text.rend(), is_lower);
    const auto begin = digits.begin + static_cast<std::uint32_t>(first - text.begin());
    const auto end = digits.begin + static_cast<std::uint32_t>(last.base() - text.begin());
    reader_.faults().report(DiagnosticId::lower_case_hex_escape, {begin, end}, {},
                            {replacement({begin, end}, folded(reader_.view({begin, end})))});
}

void StringScanner::report_incomplete_hex(TextRange source) {
    const std::uint32_t needed = double_byte_ ? 4 : 2;
    const std::uint32_t found = source.size() - 1;
    const DiagnosticFix dollar = insertion(source.begin, "$");
    const DiagnosticFix zeros = insertion(source.begin + 1, std::string(needed - found, '0'));
    // `"$0A"` and `'$A'` were meant as codes, but `'$5'` as the dollars of `'$$5'`.
    const bool code_meant = found > 1 || is_ascii_letter(at(source.begin + 1));
    std::vector<DiagnosticFix> fixes = {zeros, dollar};
    if (!code_meant)
        std::swap(fixes.front(), fixes.back());
    reader_.faults().report(DiagnosticId::incomplete_hex_escape, source, {std::uint64_t{needed}},
                            std::move(fixes));
}

void StringScanner::unknown_escape() {
    const std::uint32_t begin = reader_.at();
    const DecodedCharacter character =
        decode_character(reader_.text(), begin + 1, reader_.encoding());
    if (!character.valid) {
        reader_.faults().reject();
        reader_.move_to(begin + 2);
        return;
    }
    const TextRange source = {begin, std::min(begin + 1 + character.size, close_)};
    reader_.faults().report(DiagnosticId::unknown_escape, source, {reader_.words(source)},
                            {insertion(begin, "$")});
    reader_.move_to(source.end);
}

std::uint32_t StringScanner::hex_digits_end(std::uint32_t at_digit) const noexcept {
    const std::uint32_t highest = at_digit + (double_byte_ ? 4U : 2U);
    while (at_digit < std::min(highest, close_) && is_hex_digit(at(at_digit)))
        ++at_digit;
    return at_digit;
}

} // namespace

bool scan_string(std::string_view text, Encoding encoding, LiteralFaults& faults,
                 std::vector<StringElement>* elements) {
    LiteralReader reader(text, encoding, faults);
    return StringScanner(reader, elements).scan();
}

std::size_t length_before_code(std::string_view content) noexcept {
    for (std::size_t at = 0; at < content.size();) {
        const std::size_t begin = at++;
        while (is_word_part(content[begin]) && at < content.size() && is_word_part(content[at]))
            ++at;
        const std::string_view word = content.substr(begin, at - begin);
        if ((word == ";" || follows_expression(word)) && begins_with_code(content.substr(at)))
            return probable_end(content.substr(0, at));
    }
    return content.size();
}

} // namespace iecfront::literals

namespace iecfront {

using namespace literals;

std::optional<StringValue> string_value(std::string_view text, Encoding encoding) {
    LiteralFaults faults;
    StringValue value;
    value.double_byte = scan_string(text, encoding, faults, &value.elements);
    if (!faults.has_value())
        return std::nullopt;
    return value;
}

} // namespace iecfront
