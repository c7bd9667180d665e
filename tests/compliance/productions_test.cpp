#include "grammar/formal_syntax.hpp"
#include "support/case_coverage.hpp"

#include <gtest/gtest.h>
#include <string>

// Which productions have cases of both kinds because of the chapter that they stand in;
// tests/cases/required_tags.txt lists what the others need.

namespace iecfront::test {
namespace {

[[nodiscard]] bool is_of_a_chart(const Production& production) {
    return production.heading.starts_with("B.1.6 ");
}

TEST(Productions, ThoseOfChartsAndInstructionsHaveAnAcceptingAndARejectingCase) {
    std::size_t count = 0;
    for (const Production& production : formal_syntax().grammar.productions) {
        if (is_of_a_chart(production) || production.by_line()) {
            ++count;
            EXPECT_TRUE(has_case(production.name, false))
                << "no accepting case: " << production.name;
            EXPECT_TRUE(has_case(production.name, true))
                << "no rejecting case: " << production.name;
        }
    }
    EXPECT_GT(count, 40U); // the headings are still what they are taken for
}

} // namespace
} // namespace iecfront::test
