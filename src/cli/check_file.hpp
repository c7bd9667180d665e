#pragma once

#include "cli/input.hpp"
#include "cli/options.hpp"

#include <iecfront/diagnostics/render_text.hpp>
#include <iecfront/diagnostics/severity.hpp>

#include <cstddef>
#include <set>
#include <string>

namespace iecfront::cli {

/// How files are checked.
struct CheckSettings {
    Options options;
    SeverityPolicy policy;
    TextStyle style;
};

/// What checking a file, or several, gives.
struct Findings {
    std::size_t files = 0; ///< that could be read
    std::size_t errors = 0;
    std::size_t warnings = 0;
    std::set<DiagnosticId> limits;   ///< that were hit, reported or not
    std::set<DiagnosticId> reported; ///< each that is found and not allowed
    Determination determination = Determination::no_violations;

    /// Puts what was found elsewhere to this.
    void add(const Findings& other);
};

/// A file, checked.
struct FileReport {
    std::string problem; ///< why it could not be read; empty when it could
    std::string text;    ///< its diagnostics: text, or objects of JSON or SARIF with commas between
    Findings findings;
};

/// Reads and checks a file. Never throws.
[[nodiscard]] FileReport check_file(const Input& input, const CheckSettings& settings) noexcept;

/// "1 file", "2 files".
[[nodiscard]] std::string counted(std::size_t count, const std::string& noun);

} // namespace iecfront::cli
