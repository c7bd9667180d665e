#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// A row of a table below "Known differences" in docs/grammar.md.
struct KnownDifference {
    std::string id;
    std::string source;          ///< shows it
    std::set<std::string> codes; ///< of what is reported
    std::string state;
    std::string reason;
};

struct KnownDifferences {
    std::vector<KnownDifference> reported;

    explicit KnownDifferences(std::string_view document);

    /// The first row that has this code; null when none has.
    [[nodiscard]] const KnownDifference* find(std::string_view code) const;
};

} // namespace iecfront::test
