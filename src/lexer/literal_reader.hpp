#pragma once

#include "lexer/characters.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/token.hpp>
#include <iecfront/source/encoding.hpp>
#include <iecfront/source/text_range.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// What the scanners of all classes of literals share.
namespace iecfront::literals {

[[nodiscard]] constexpr bool is_ascii_letter(char c) noexcept {
    return fold(c) >= 'A' && fold(c) <= 'Z';
}

// The value of a letter or digit as a digit of any base up to 36; 36 for everything else.
[[nodiscard]] constexpr unsigned digit_value(char c) noexcept {
    if (is_digit(c))
        return static_cast<unsigned>(c - '0');
    return is_ascii_letter(c) ? static_cast<unsigned>(fold(c) - 'A') + 10U : 36U;
}

// True when `rest` begins like the exponent of a real literal: `E3`, `E+`, `E_3`, or an `E` with
// nothing behind it.
[[nodiscard]] bool exponent_begins(std::string_view rest) noexcept;

[[nodiscard]] constexpr bool is_white_space(char c) noexcept {
    return c == ' ' || (c >= '\t' && c <= '\r');
}
// `(` of a comment or `{` of a pragma: neither stands in a literal otherwise.
[[nodiscard]] constexpr bool begins_remark(char c) noexcept {
    return c == '(' || c == '{';
}
// True when white space, a comment or a pragma stands outside quotes: no literal can hold it, and
// the lexer has said so (2.1.4).
[[nodiscard]] bool holds_gap(std::string_view text) noexcept;

// The digits as one number; `_` and whatever is no digit of the base is passed over.
struct Magnitude {
    std::uint64_t value = 0; // 2^64-1 when it overflows
    bool overflow = false;
};
[[nodiscard]] Magnitude magnitude_of(std::string_view digits, unsigned base) noexcept;

[[nodiscard]] std::string without_underscores(std::string_view digits);

[[nodiscard]] DiagnosticFix insertion(std::uint32_t at, std::string_view text);
[[nodiscard]] DiagnosticFix removal(TextRange range);
[[nodiscard]] DiagnosticFix replacement(TextRange range, std::string_view text);

// Takes the faults of one literal. Each scanner runs in two ways: to list the faults, or to learn
// the value, when only whether there is one matters.
class LiteralFaults {
public:
    // Only remembers whether there is a value.
    LiteralFaults() = default;
    explicit LiteralFaults(std::vector<Diagnostic>& list) noexcept : list_(&list) {}

    // After a violation the literal has no value; an extension or a limit leaves it.
    void report(DiagnosticId id, TextRange range, std::vector<DiagnosticArgument> arguments = {},
                std::vector<DiagnosticFix> fixes = {});
    // A fault that the value itself tells of, by `overflow`.
    void report_in_value(DiagnosticId id, TextRange range,
                         std::vector<DiagnosticArgument> arguments = {});
    // Explains the fault that was reported last.
    void add_label(DiagnosticLabel label);
    // No value, and nothing to report: not such a literal, or the lexer has spoken.
    void reject() noexcept { has_value_ = false; }

    [[nodiscard]] bool has_value() const noexcept { return has_value_; }

private:
    std::vector<Diagnostic>* list_ = nullptr;
    bool has_value_ = true;
};

// How digits with underscores are read where a number stands.
struct DigitRules {
    bool (*takes)(char) noexcept;
    // Whether an underscore that stands between the last digit and `rest` is a misplaced one of
    // this number; otherwise it belongs to whatever comes next.
    bool (*takes_underscore_before)(std::string_view rest) noexcept;
    DiagnosticId misplaced;
};
extern const DigitRules decimal_digits; // integer (B.1.2.1)
extern const DigitRules based_digits;   // any letter and digit: the wrong ones are sorted out later
extern const DigitRules duration_digits; // before a unit

// What stands before the first `#`.
struct TypePrefix {
    std::string_view name; // empty when there is none
    // Of an elementary type, also `T` and `D`; nothing for the name of a derived type.
    std::optional<TokenKind> type;
    std::uint32_t end = 0; // behind the `#`

    [[nodiscard]] bool of_time_literal() const noexcept {
        return type && *type >= TokenKind::kw_time && *type <= TokenKind::kw_dt;
    }
};
[[nodiscard]] TypePrefix type_prefix_of(std::string_view text) noexcept;

// Walks over the text of one literal.
class LiteralReader {
public:
    LiteralReader(std::string_view text, Encoding encoding, LiteralFaults& faults) noexcept
        : text_(text), encoding_(encoding), faults_(&faults) {}

    [[nodiscard]] LiteralFaults& faults() const noexcept { return *faults_; }
    [[nodiscard]] std::string_view text() const noexcept { return text_; }
    [[nodiscard]] Encoding encoding() const noexcept { return encoding_; }

    [[nodiscard]] std::uint32_t at() const noexcept { return at_; }
    [[nodiscard]] std::uint32_t end() const noexcept {
        return static_cast<std::uint32_t>(text_.size());
    }
    [[nodiscard]] bool at_end() const noexcept { return at_ == end(); }
    // Zero at the end; a zero byte in the text is nothing that a literal can hold either.
    [[nodiscard]] char peek() const noexcept { return at_end() ? '\0' : text_[at_]; }
    [[nodiscard]] std::string_view rest() const noexcept { return text_.substr(at_); }
    [[nodiscard]] std::string_view view(TextRange range) const noexcept {
        return text_.substr(range.begin, range.size());
    }
    [[nodiscard]] std::string words(TextRange range) const { return std::string(view(range)); }
    [[nodiscard]] TextRange here() const noexcept { return {at_, at_}; }
    [[nodiscard]] TextRange from(std::uint32_t begin) const noexcept { return {begin, at_}; }
    [[nodiscard]] TextRange to_end() const noexcept { return {at_, end()}; }

    void move_to(std::uint32_t at) noexcept { at_ = at; }
    bool accept(char c) noexcept;
    // Moves behind the prefix of a time literal: of either type, or of the first one.
    bool accept_prefix(TokenKind type, std::optional<TokenKind> long_type = {}) noexcept;
    TextRange letters() noexcept;
    TextRange underscores() noexcept;
    // digit { [ "_" ] digit }, from the first digit to behind the last; empty when there is none.
    // Misplaced underscores are reported and passed over.
    TextRange digits(const DigitRules& rules);

    // The character at `at`, with all its bytes.
    [[nodiscard]] TextRange character(std::uint32_t at) const noexcept;

private:
    void report_underscores(const DigitRules& rules, TextRange range);
    [[nodiscard]] std::uint32_t underscores_end(std::uint32_t at) const noexcept;

    std::string_view text_;
    Encoding encoding_;
    LiteralFaults* faults_;
    std::uint32_t at_ = 0;
};

} // namespace iecfront::literals
