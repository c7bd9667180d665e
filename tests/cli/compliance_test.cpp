#include "cli/command.hpp"
#include "support/repository_files.hpp"

#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/compliance/annex_e.hpp>
#include <iecfront/compliance/extensions.hpp>
#include <iecfront/compliance/features.hpp>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace iecfront::test {
namespace {

using ComplianceCommand = CommandTest;

const std::string statement_path = std::string(IECFRONT_SOURCE_DIR) + "/docs/compliance.md";

// With UPDATE_EXPECT=1 in the environment the page is written anew.
TEST_F(ComplianceCommand, PrintsThePageOfTheDocuments) {
    const Outcome outcome = run({"compliance", "--format", "markdown"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const char* const update = std::getenv("UPDATE_EXPECT");
    if (update != nullptr && std::string_view(update) == "1") {
        std::ofstream(statement_path, std::ios::binary) << outcome.out;
        return;
    }
    std::ifstream page(statement_path, std::ios::binary);
    EXPECT_EQ(outcome.out, std::string(std::istreambuf_iterator<char>(page), {}))
        << "UPDATE_EXPECT=1 writes docs/compliance.md anew";
}

TEST_F(ComplianceCommand, PrintsJson) {
    const JsonValue json = run_json({"compliance", "--format=json"});
    EXPECT_EQ(json.names(), "product standard requirements features neverExamined annexD annexE "
                            "extensions dialects");
    EXPECT_EQ(json["product"].text, "iecfront " IECFRONT_VERSION);
    EXPECT_EQ(json["requirements"].items.size(), 10U);
    EXPECT_EQ(json["features"].items.size(), features().size());
    EXPECT_EQ(json["annexD"].items.size(), annex_d().size());
    EXPECT_EQ(json["annexE"].items.size(), annex_e().size());
    EXPECT_EQ(json["extensions"].items.size(), extensions().size());
}

TEST_F(ComplianceCommand, PrintsText) {
    const Outcome outcome = run({"compliance"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.out.starts_with("Compliance with IEC 61131-3:2003\n====="));
    for (const std::string_view line : lines_of(outcome.out))
        EXPECT_LE(line.size(), 180U) << line;
}

TEST_F(ComplianceCommand, ReadsNoFiles) {
    EXPECT_EQ(run({"compliance", "a.st"}).status, 2);
    EXPECT_EQ(run({"compliance", "--format", "sarif"}).status, 2);
}

} // namespace
} // namespace iecfront::test
