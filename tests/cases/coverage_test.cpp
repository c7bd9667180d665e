#include "support/case_file.hpp"
#include "support/case_outcome.hpp"
#include "support/repository_files.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

// Holds the cases together to what they have to cover: every diagnostic, and the tags that
// required_tags.txt lists.

namespace iecfront::test {
namespace {

/// A diagnostic that no case can produce, and what tests it instead.
struct Exemption {
    DiagnosticId id;
    std::string_view reason;
};

constexpr std::array exemptions = {
    Exemption{DiagnosticId::source_too_large, "needs 4 GiB: tests/source/source_text_test.cpp"},
    Exemption{DiagnosticId::text_too_long, "needs 4 MiB: tests/lexer/lexer_test.cpp"},
};

/// What all cases together cover.
struct Coverage {
    std::set<DiagnosticId> reported;
    std::set<std::string> accepted; ///< tags of cases in which no error is reported
    std::set<std::string> rejected; ///< tags of the others
};

[[nodiscard]] const Coverage& coverage() {
    static const Coverage all = [] {
        Coverage result;
        for (const CaseFile& file : all_case_files()) {
            for (const Case& one : file.cases) {
                const CaseOutcome outcome = run_case(one);
                result.reported.insert(outcome.reported.begin(), outcome.reported.end());
                auto& tags = outcome.rejected ? result.rejected : result.accepted;
                tags.insert(one.tags.begin(), one.tags.end());
            }
        }
        return result;
    }();
    return all;
}

[[nodiscard]] const Exemption* exemption_of(DiagnosticId id) {
    const auto* found = std::find_if(exemptions.begin(), exemptions.end(),
                                     [&](const Exemption& one) { return one.id == id; });
    return found == exemptions.end() ? nullptr : found;
}

TEST(CaseCoverage, EveryDiagnosticIsProducedByACase) {
    for (const DiagnosticInfo& info : diagnostic_catalogue()) {
        const bool produced = coverage().reported.contains(info.id);
        const Exemption* exemption = exemption_of(info.id);
        if (exemption == nullptr)
            EXPECT_TRUE(produced) << code_string(info.id) << ' ' << info.name;
        else
            EXPECT_FALSE(produced) << code_string(info.id) << " needs no exemption any more";
    }
}

/// A line of required_tags.txt.
struct RequiredTag {
    std::string tag;
    bool accept = false;
    bool reject = false;
};

[[nodiscard]] std::vector<RequiredTag> required_tags() {
    std::vector<RequiredTag> tags;
    for (const RepositoryFile& file : repository_files({"tests/cases"}, {"/required_tags.txt"})) {
        for (const std::string_view line : lines_of(file.text)) {
            if (line.empty() || line.starts_with('#'))
                continue;
            std::istringstream words{std::string(line)};
            RequiredTag tag;
            words >> tag.tag;
            for (std::string word; words >> word;) {
                EXPECT_TRUE(word == "accept" || word == "reject") << line;
                (word == "accept" ? tag.accept : tag.reject) = true;
            }
            EXPECT_TRUE(tag.accept || tag.reject) << line;
            tags.push_back(tag);
        }
    }
    return tags;
}

TEST(CaseCoverage, RequiredTagsAreThere) {
    ASSERT_FALSE(required_tags().empty());
    for (const RequiredTag& required : required_tags()) {
        if (required.accept) {
            EXPECT_TRUE(coverage().accepted.contains(required.tag))
                << "no accepting case has the tag " << required.tag;
        }
        if (required.reject) {
            EXPECT_TRUE(coverage().rejected.contains(required.tag))
                << "no rejecting case has the tag " << required.tag;
        }
    }
}

TEST(CaseCoverage, RequiredTagsAreListedOnce) {
    std::set<std::string> seen;
    for (const RequiredTag& required : required_tags())
        EXPECT_TRUE(seen.insert(required.tag).second) << required.tag;
}

} // namespace
} // namespace iecfront::test
