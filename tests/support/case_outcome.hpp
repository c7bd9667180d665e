#pragma once

#include "support/case_file.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/parser/parse.hpp>
#include <iecfront/source/source_text.hpp>

#include <set>
#include <string>

namespace iecfront::test {

/// What the library makes of a case.
struct CaseOutcome {
    std::string diagnostics; ///< text of the section `diagnostics`
    std::string tree;        ///< text of the section `tree`
    std::string fixed;       ///< text of the section `fixed`
    std::set<DiagnosticId> reported;
    bool rejected = false;      ///< something was reported as an error
    bool fixable = false;       ///< there are faults of syntax, and all have a fix
    bool fixes_overlap = false; ///< so that not all could be applied
    std::string left_in_fixed;  ///< faults of syntax that the fixed source has
};

/// How the source of `one` is read.
[[nodiscard]] SourceText source_text_of(const Case& one);
[[nodiscard]] ParseOptions options_of(const Case& one);
/// The same for a text made of that of the case, which can be larger than it may be.
[[nodiscard]] ParseOptions options_of_changed(const Case& one);

[[nodiscard]] CaseOutcome run_case(const Case& one);

} // namespace iecfront::test
