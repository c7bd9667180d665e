#include "support/case_coverage.hpp"
#include "support/repository_files.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>

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

TEST(CaseCoverage, EveryDiagnosticIsProducedByACase) {
    for (const DiagnosticInfo& info : diagnostic_catalogue()) {
        const bool produced = is_reported(info.id);
        if (tested_elsewhere(info.id).empty())
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
            EXPECT_TRUE(has_case(required.tag, false))
                << "no accepting case has the tag " << required.tag;
        }
        if (required.reject) {
            EXPECT_TRUE(has_case(required.tag, true))
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
