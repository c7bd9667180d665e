#include "support/invariants.hpp"
#include "support/repository_files.hpp"

#include <gtest/gtest.h>

// Puts the example programs, which are larger than cases, through the invariants.

namespace iecfront::test {
namespace {

class Programs : public testing::TestWithParam<RepositoryFile> {};

TEST_P(Programs, KeepTheInvariants) {
    expect_invariants(SourceText(GetParam().text, GetParam().path));
}

[[nodiscard]] std::string test_name(const RepositoryFile& file) {
    std::string name = file.path.substr(file.path.rfind('/') + 1);
    name.erase(name.rfind('.'));
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Programs,
                         testing::ValuesIn(repository_files({"examples"}, {".st", ".il"})),
                         [](const auto& one) { return test_name(one.param); });

} // namespace
} // namespace iecfront::test
