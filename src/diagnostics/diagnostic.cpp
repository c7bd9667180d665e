#include "diagnostics/visible.hpp"
#include "source/ascii.hpp"
#include "source/utf8.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace iecfront {
namespace {

// ---- the catalogue ---------------------------------------------------------------------------

constexpr std::size_t longest_name = 40;

struct NameText {
    std::array<char, longest_name> characters{};
    std::size_t size = 0;

    [[nodiscard]] constexpr std::string_view view() const noexcept {
        return {characters.data(), size};
    }
};

// `missing_semicolon` as users know it: `missing-semicolon`.
constexpr NameText user_name(std::string_view enumerator) {
    NameText name;
    for (const char c : enumerator)
        name.characters[name.size++] = c == '_' ? '-' : c; // too long: does not compile
    return name;
}

constexpr std::array names = {
#define IECFRONT_DIAGNOSTIC(code, enumerator, class, clause, annex_e, severity, message)           \
    user_name(#enumerator),
#include <iecfront/diagnostics/diagnostics.def>
};

constexpr std::array catalogue = {
#define IECFRONT_DIAGNOSTIC(code, enumerator, class, clause, annex_e, severity, message)           \
    DiagnosticInfo{DiagnosticId::enumerator,                                                       \
                   code,                                                                           \
                   names[static_cast<std::size_t>(DiagnosticId::enumerator)].view(),               \
                   DiagnosticClass::class,                                                         \
                   clause,                                                                         \
                   annex_e,                                                                        \
                   Severity::severity,                                                             \
                   message},
#include <iecfront/diagnostics/diagnostics.def>
};

constexpr std::array label_texts = {
#define IECFRONT_LABEL(enumerator, text) std::string_view(text),
#include <iecfront/diagnostics/diagnostics.def>
};

constexpr bool codes_ascend() {
    for (std::size_t i = 1; i < catalogue.size(); ++i)
        if (catalogue[i - 1].code >= catalogue[i].code)
            return false;
    return true;
}
static_assert(codes_ascend(), "a code is used twice, or the rows are not ordered by code");

constexpr bool names_are_unique() {
    for (std::size_t i = 0; i < catalogue.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (catalogue[i].name == catalogue[j].name)
                return false;
    return true;
}
static_assert(names_are_unique(), "two diagnostics have one name");

constexpr bool class_fits_code(const DiagnosticInfo& row) {
    switch (row.code / 1000) {
    case 1:
    case 2:
    case 3:
        return row.category == DiagnosticClass::violation || row.category == DiagnosticClass::error;
    case 5: return row.category == DiagnosticClass::extension;
    case 6: return row.category == DiagnosticClass::implementation_dependent;
    case 9: return row.category == DiagnosticClass::limit;
    default: return false;
    }
}

constexpr bool classes_fit() {
    for (const DiagnosticInfo& row : catalogue)
        if (!class_fits_code(row) ||
            (row.category == DiagnosticClass::error) != (row.annex_e_row != 0))
            return false;
    return true;
}
static_assert(classes_fit(), "a class does not fit its code, or its row of Annex E");

// ---- messages --------------------------------------------------------------------------------

// Longer words of the source hide the message they stand in.
constexpr std::size_t argument_width = 60;

struct ArgumentWriter {
    std::string& out;
    Encoding encoding;

    void operator()(const std::string& text) const {
        append_shortened(out, text, argument_width, encoding);
    }
    void operator()(std::uint64_t number) const { out += std::to_string(number); }
    void operator()(char32_t character) const {
        if (!is_visible(character)) {
            append_code_point_number(out, character);
            return;
        }
        out += '`';
        append_utf8(out, character);
        out += "` (";
        append_code_point_number(out, character);
        out += ')';
    }
};

// Calls `write(n)` for each `{n}` of `text` with n < `count` and copies everything else: messages
// speak of pragmas, and so hold braces of their own.
template<class Write>
std::string filled(std::string_view text, std::size_t count, Write write) {
    std::string out;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool placeholder = text[at] == '{' && at + 2 < text.size() && text[at + 2] == '}' &&
                                 text[at + 1] >= '0' && text[at + 1] <= '9';
        const std::size_t number = placeholder ? static_cast<std::size_t>(text[at + 1] - '0') : 0;
        if (!placeholder || number >= count) {
            out += text[at];
            continue;
        }
        write(out, number);
        at += 2;
    }
    return out;
}

// ---- descriptions of fixes -------------------------------------------------------------------

constexpr std::string_view blanks = " \t\r\n";

// More different edits than this are only counted.
constexpr std::size_t described_edits = 3;

[[nodiscard]] std::string_view without_outer_blanks(std::string_view text) noexcept {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// `text` in backticks, on one line and short; "a line end" or "white space" when it is just that.
void append_quoted(std::string& out, std::string_view text, Encoding encoding) {
    const std::string_view words = without_outer_blanks(text);
    if (words.empty()) {
        const bool line_end = text.find_first_of("\r\n") != std::string_view::npos;
        out += line_end ? "a line end" : "white space";
        return;
    }
    const std::string_view line = words.substr(0, words.find_first_of("\r\n"));
    out += '`';
    append_shortened(out, without_outer_blanks(line), argument_width, encoding);
    if (line.size() < words.size())
        out += " ...";
    out += '`';
}

[[nodiscard]] std::string described(std::string_view old_text, std::string_view new_text,
                                    Encoding encoding) {
    std::string out;
    if (old_text.empty()) {
        out += "insert ";
        append_quoted(out, new_text, encoding);
    } else if (new_text.empty()) {
        out += "remove ";
        append_quoted(out, old_text, encoding);
    } else {
        out += "replace ";
        append_quoted(out, old_text, encoding);
        out += " by ";
        append_quoted(out, new_text, encoding);
    }
    return out;
}

[[nodiscard]] std::string_view text_of(TextRange range, std::string_view source) noexcept {
    if (range.begin > source.size())
        return {};
    return source.substr(range.begin, range.size());
}

struct EditWords {
    std::string words;
    std::size_t places = 1;
};

// What the edits do, equal ones taken together, in the order of the source.
[[nodiscard]] std::vector<EditWords> words_of_edits(const DiagnosticFix& fix,
                                                    std::string_view source, Encoding encoding) {
    std::vector<EditWords> result;
    for (const TextEdit& edit : fix.edits) {
        std::string words = described(text_of(edit.range, source), edit.replacement, encoding);
        const auto same = std::find_if(result.begin(), result.end(), [&](const EditWords& other) {
            return other.words == words;
        });
        if (same != result.end())
            ++same->places;
        else
            result.push_back({std::move(words)});
    }
    return result;
}

} // namespace

const DiagnosticInfo& diagnostic_info(DiagnosticId id) noexcept {
    return catalogue[static_cast<std::size_t>(id)];
}

std::span<const DiagnosticInfo> diagnostic_catalogue() noexcept {
    return catalogue;
}

const DiagnosticInfo* find_diagnostic(std::string_view code_or_name) noexcept {
    for (const DiagnosticInfo& row : catalogue) {
        const std::array<char, 7> code = {'I',
                                          'E',
                                          'C',
                                          static_cast<char>('0' + row.code / 1000),
                                          static_cast<char>('0' + row.code / 100 % 10),
                                          static_cast<char>('0' + row.code / 10 % 10),
                                          static_cast<char>('0' + row.code % 10)};
        if (equal_in_any_case(row.name, code_or_name) ||
            equal_in_any_case({code.data(), code.size()}, code_or_name))
            return &row;
    }
    return nullptr;
}

std::string code_string(DiagnosticId id) {
    return "IEC" + std::to_string(diagnostic_info(id).code);
}

std::string_view to_string(DiagnosticClass category) noexcept {
    switch (category) {
    case DiagnosticClass::violation: break;
    case DiagnosticClass::error: return "error";
    case DiagnosticClass::extension: return "extension";
    case DiagnosticClass::implementation_dependent: return "implementation-dependent";
    case DiagnosticClass::limit: return "limit";
    }
    return "violation";
}

std::string_view to_string(Severity severity) noexcept {
    switch (severity) {
    case Severity::allow: return "allow";
    case Severity::warning: return "warning";
    case Severity::error: break;
    }
    return "error";
}

namespace {

template<class Move>
Diagnostic with_moved_ranges(Diagnostic diagnostic, Move move) {
    diagnostic.range = move(diagnostic.range);
    for (DiagnosticLabel& label : diagnostic.labels)
        label.range = move(label.range);
    for (DiagnosticFix& fix : diagnostic.fixes)
        for (TextEdit& edit : fix.edits)
            edit.range = move(edit.range);
    return diagnostic;
}

} // namespace

Diagnostic shifted(Diagnostic diagnostic, std::uint32_t distance) {
    return with_moved_ranges(std::move(diagnostic),
                             [distance](TextRange range) { return range.shifted(distance); });
}

Diagnostic mapped(Diagnostic diagnostic,
                  const std::function<std::uint32_t(std::uint32_t offset)>& map) {
    return with_moved_ranges(std::move(diagnostic), [&map](TextRange range) {
        return TextRange{map(range.begin), map(range.end)};
    });
}

std::string message(const Diagnostic& diagnostic, Encoding encoding) {
    return filled(diagnostic_info(diagnostic.id).message, diagnostic.arguments.size(),
                  [&](std::string& out, std::size_t n) {
                      std::visit(ArgumentWriter{out, encoding}, diagnostic.arguments[n]);
                  });
}

std::string message(const DiagnosticLabel& label, Encoding encoding) {
    return filled(label_texts[static_cast<std::size_t>(label.id)], 1,
                  [&](std::string& out, std::size_t) {
                      ArgumentWriter{out, encoding}(label.argument);
                  });
}

std::string description(const DiagnosticFix& fix, std::string_view source, Encoding encoding) {
    const std::vector<EditWords> edits = words_of_edits(fix, source, encoding);
    if (edits.size() > described_edits)
        return "make " + std::to_string(fix.edits.size()) + " edits";
    std::string out;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        if (i > 0)
            out += i + 1 == edits.size() ? " and " : ", ";
        out += edits[i].words;
        if (edits[i].places > 1)
            out += " in " + std::to_string(edits[i].places) + " places";
    }
    return out;
}

} // namespace iecfront
