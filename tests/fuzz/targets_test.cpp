#include "fuzz/targets.hpp"
#include "support/case_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

// What the fuzz targets found once, and what they begin with.

namespace iecfront::test {
namespace {

namespace fs = std::filesystem;

[[nodiscard]] std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class Targets : public testing::TestWithParam<FuzzTarget> {};

// Each fifth is enough here: all of them are what fuzzing begins with.
TEST_P(Targets, FindNothingInCases) {
    std::size_t number = 0;
    for (const CaseFile& file : all_case_files())
        for (const Case& one : file.cases)
            if (number++ % 5 == 0) {
                EXPECT_EQ(GetParam().fault(one.source()), "") << file.path << ": " << one.title;
            }
}

TEST_P(Targets, FindNothingInNothing) {
    EXPECT_EQ(GetParam().fault(""), "");
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Targets,
                         testing::ValuesIn(fuzz_targets().begin(), fuzz_targets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

// tests/fuzz/findings/<target>/<what it is>
TEST(Findings, AreFoundNoMore) {
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(IECFRONT_SOURCE_DIR) / "tests/fuzz/findings")) {
        if (entry.is_directory())
            continue;
        const std::string name = entry.path().parent_path().filename().string();
        const auto target = std::ranges::find(fuzz_targets(), name, &FuzzTarget::name);
        ASSERT_NE(target, fuzz_targets().end()) << name << " is no target";
        EXPECT_EQ(target->fault(content(entry.path())), "") << entry.path();
    }
}

} // namespace
} // namespace iecfront::test
