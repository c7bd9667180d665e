#pragma once

#include <iecfront/export.hpp>
#include <iecfront/source/encoding.hpp>
#include <iecfront/source/text_range.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace iecfront {

/// Names each diagnostic of the catalogue (`diagnostics.def`). The numeric value is a row number,
/// not the code, and may change between versions; the code never does.
enum class DiagnosticId : std::uint16_t {
#define IECFRONT_DIAGNOSTIC(code, enumerator, class, clause, annex_e, severity, message) enumerator,
#include <iecfront/diagnostics/diagnostics.def>
};

/// What a finding is under 1.5.1.
enum class DiagnosticClass : std::uint8_t {
    violation,                ///< c) of a requirement that Annex E does not list
    error,                    ///< d) an error condition of Annex E
    extension,                ///< e), f) use of something the standard does not have
    implementation_dependent, ///< g) reliance on a feature of Annex D
    limit,                    ///< something was not examined: the determination is incomplete
};

/// How a finding is treated: the software switch of 1.5.1.
enum class Severity : std::uint8_t {
    allow,   ///< not reported
    warning, ///< reported; a violation is one all the same (`determine`)
    error,   ///< reported, and refused: even what the standard permits is a violation then
};

/// One row of the catalogue.
struct DiagnosticInfo {
    DiagnosticId id;           ///< the row
    std::uint16_t code;        ///< the number in `IEC1234`
    std::string_view name;     ///< kebab-case: `missing-semicolon`
    DiagnosticClass category;  ///< class under 1.5.1
    std::string_view clause;   ///< clause or production of the standard whose rule it states
    std::uint8_t annex_e_row;  ///< row of Annex E counted from 1; 0 when it is none
    Severity default_severity; ///< unless a `SeverityPolicy` sets another
    std::string_view message;  ///< `{0}`, `{1}` ... stand for the arguments
};

/// The row of `id`. Never fails.
[[nodiscard]] IECFRONT_API const DiagnosticInfo& diagnostic_info(DiagnosticId id) noexcept;

/// All rows, ordered by code.
[[nodiscard]] IECFRONT_API std::span<const DiagnosticInfo> diagnostic_catalogue() noexcept;

/// Finds a row by `IEC2006` or `missing-semicolon`, in any case; null when there is none.
[[nodiscard]] IECFRONT_API const DiagnosticInfo*
find_diagnostic(std::string_view code_or_name) noexcept;

/// `IEC2006`.
[[nodiscard]] IECFRONT_API std::string code_string(DiagnosticId id);

/// `violation`, `error`, `extension`, `implementation-dependent` or `limit`.
[[nodiscard]] IECFRONT_API std::string_view to_string(DiagnosticClass category) noexcept;

/// `allow`, `warning` or `error`.
[[nodiscard]] IECFRONT_API std::string_view to_string(Severity severity) noexcept;

/// What a second place in the text has to do with a diagnostic.
enum class LabelId : std::uint8_t {
#define IECFRONT_LABEL(enumerator, text) enumerator,
#include <iecfront/diagnostics/diagnostics.def>
};

/// A value for a `{n}` of a message: words of the source (its bytes as they stand there, in its
/// encoding) or of the language (ASCII), a number, or a character.
using DiagnosticArgument = std::variant<std::string, std::uint64_t, char32_t>;

/// A second place that explains a diagnostic.
struct DiagnosticLabel {
    TextRange range;      ///< the place, relative to what the diagnostic's range is
    LabelId id{};         ///< which words stand there
    std::string argument; ///< for the `{0}` of the label's text; may be empty

    friend bool operator==(const DiagnosticLabel&, const DiagnosticLabel&) = default;
};

/// Edits that very probably give what was meant, to be applied together. They do not overlap and
/// are ordered by position.
struct DiagnosticFix {
    std::vector<TextEdit> edits; ///< at least one; `apply_edits` makes them

    friend bool operator==(const DiagnosticFix&, const DiagnosticFix&) = default;
};

/// A finding, as data. All ranges are relative to the same start: in `Unit::diagnostics()` the
/// unit's, in `SyntaxTree::diagnostics()` the file's. Words are made by a renderer.
struct Diagnostic {
    DiagnosticId id{};                         ///< `diagnostic_info` gives its code and class
    TextRange range;                           ///< what is wrong; empty where something is missing
    std::vector<DiagnosticArgument> arguments; ///< for the `{0}`, `{1}` ... of the message
    std::vector<DiagnosticLabel> labels;       ///< other places that explain it; often none
    std::vector<DiagnosticFix> fixes;          ///< alternatives, the likeliest first

    friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

/// The same finding `distance` bytes further on, with all its labels and fixes.
[[nodiscard]] IECFRONT_API Diagnostic shifted(Diagnostic diagnostic, std::uint32_t distance);

/// The same finding with each offset replaced by what `map` gives for it: from a piece of text to
/// the file that holds it in another form, such as XML with its entities. `map` must not let
/// offsets change their order; it is asked for begins and ends of ranges. What the fixes put in is
/// left as it is, for the caller to write in the form of the file.
[[nodiscard]] IECFRONT_API Diagnostic
mapped(Diagnostic diagnostic, const std::function<std::uint32_t(std::uint32_t offset)>& map);

/// The message in words: the row's text with its arguments put in. The result is UTF-8 on one line;
/// what cannot be seen is spelled out (`\x1B`), and a long argument loses its middle. `encoding` is
/// that of the source.
[[nodiscard]] IECFRONT_API std::string message(const Diagnostic& diagnostic,
                                               Encoding encoding = Encoding::utf8);

/// The words of a label, in the same form.
[[nodiscard]] IECFRONT_API std::string message(const DiagnosticLabel& label,
                                               Encoding encoding = Encoding::utf8);

/// What a fix does, in words: "insert `;`", "replace `=` by `:=`", "remove `;`". `source` is the
/// text that the edits refer to, in `encoding`. The result is UTF-8 on one line.
[[nodiscard]] IECFRONT_API std::string
description(const DiagnosticFix& fix, std::string_view source, Encoding encoding = Encoding::utf8);

} // namespace iecfront
