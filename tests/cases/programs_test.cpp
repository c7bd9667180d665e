#include "support/edit_faults.hpp"
#include "support/invariants.hpp"
#include "support/repository_files.hpp"

#include <iecfront/diagnostics/render_text.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <gtest/gtest.h>

// Puts the example programs, which are larger than cases, through the invariants.

namespace iecfront::test {
namespace {

class Programs : public testing::TestWithParam<RepositoryFile> {};

TEST_P(Programs, KeepTheInvariants) {
    expect_invariants(SourceText(GetParam().text, GetParam().path));
}

TEST_P(Programs, AreEqualToAFreshTreeAfterHundredsOfEdits) {
    constexpr std::size_t edits = 400;
    EXPECT_EQ(random_edits_fault(SourceText(GetParam().text), {}, edits), "");
}

TEST_P(Programs, HaveNoFault) {
    const SourceText source(GetParam().text, GetParam().path);
    const std::vector<Diagnostic> found = parse(source).diagnostics();
    const auto is_fault = [](const Diagnostic& one) { return one.id != DiagnosticId::pragma; };
    const bool faulty = GetParam().path == "examples/motor.st"; // it shows what faults look like
    EXPECT_EQ(std::any_of(found.begin(), found.end(), is_fault), faulty)
        << render_text(found, source);
}

[[nodiscard]] std::string test_name(const RepositoryFile& file) {
    std::string name = file.path.substr(file.path.rfind('/') + 1);
    name.erase(name.rfind('.'));
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Programs, testing::ValuesIn(example_programs()),
                         [](const auto& one) { return test_name(one.param); });

} // namespace
} // namespace iecfront::test
