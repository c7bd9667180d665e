#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/export.hpp>

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string_view>

namespace iecfront {

/// Who is told what: the software switch that 1.5.1 permits. A setting for one diagnostic wins over
/// one for its class, and a class's over the catalogue's default. A value; copy it freely.
class IECFRONT_API SeverityPolicy {
public:
    /// The severity that `id` is reported with.
    [[nodiscard]] Severity severity(DiagnosticId id) const noexcept;

    /// Sets the severity of one diagnostic, whatever that of its class.
    void set(DiagnosticId id, Severity severity);
    /// Sets the severity of a class, for all its diagnostics that have none set of their own.
    void set(DiagnosticClass category, Severity severity);

    /// Sets by what a user types: a code (`IEC2006`), a name (`missing-semicolon`) or a class
    /// (`extension`), in any case. False, and nothing set, when there is no such thing.
    [[nodiscard]] bool set(std::string_view what, Severity severity);

    /// What 1.5.2 demands of a complying program: no extension, and no reliance on an
    /// implementation-dependent feature, is let pass.
    [[nodiscard]] static SeverityPolicy strict();

private:
    static constexpr std::size_t class_count = 5;
    std::array<std::optional<Severity>, class_count> by_class_;
    std::map<DiagnosticId, Severity> by_id_;
};

/// What 1.5.1 c) lets a system say of a text.
enum class Determination : std::uint8_t {
    no_violations, ///< all of it was examined, and nothing was found
    violations,    ///< something was found that the standard forbids, or that the user refuses
    incomplete,    ///< no violation was found, but not everything was examined
};

/// `no-violations`, `violations` or `incomplete`.
[[nodiscard]] IECFRONT_API std::string_view to_string(Determination determination) noexcept;

/// What this version never examines, in words, one line each: rules of meaning, for now. While it
/// is not empty, no text is ever determined to have *no violations*.
[[nodiscard]] IECFRONT_API std::span<const std::string_view> never_examined() noexcept;

/// The determination for a text with these findings. A finding of class `violation` or `error` is a
/// violation when `policy` has it reported, as an error or as a warning; use of an extension, or of
/// an implementation-dependent feature, when it is an error. A limit that was hit is none, but
/// makes the determination incomplete; so does a violation that `policy` allows, and
/// `never_examined()`.
[[nodiscard]] IECFRONT_API Determination determine(std::span<const Diagnostic> diagnostics,
                                                   const SeverityPolicy& policy) noexcept;

} // namespace iecfront
