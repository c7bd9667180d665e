#include "grammar/formal_syntax.hpp"
#include "grammar/known_differences.hpp"
#include "grammar/reading.hpp"

#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>

namespace iecfront::test {
namespace {

TEST(KnownDifferences, AreReadFromTheTables) {
    const KnownDifferences read("## Known differences\n| id | source | code | state | why |\n"
                                "| --- | --- | --- | --- | --- |\n"
                                "| K1 | `a\\nb` | IEC1307 IEC1308 | decided | so |\n");
    ASSERT_EQ(read.reported.size(), 1U);
    EXPECT_EQ(read.reported[0].source, "a\nb");
    EXPECT_EQ(read.reported[0].codes, (std::set<std::string>{"IEC1307", "IEC1308"}));
    EXPECT_EQ(read.find("IEC1308"), &read.reported[0]);
    EXPECT_EQ(read.find("IEC2008"), nullptr);
}

// A row stays only as long as its source proves it. A new row, or one that goes,
// is a decision: hence the counts.
TEST(KnownDifferences, AreShownByTheirSources) {
    const FormalSyntax& syntax = formal_syntax();
    EXPECT_EQ(syntax.differences.reported.size(), 8U);
    for (const KnownDifference& one : syntax.differences.reported) {
        EXPECT_TRUE(syntax.derives(one.source)) << one.id;
        std::set<std::string> codes;
        for (const Diagnostic& diagnostic : parse(SourceText(one.source)).diagnostics())
            codes.insert(code_string(diagnostic.id));
        EXPECT_EQ(codes, one.codes) << one.id;
    }
}

TEST(KnownDifferences, HaveAStateAndAReason) {
    for (const KnownDifference& one : formal_syntax().differences.reported) {
        EXPECT_TRUE(one.state == "decided" || one.state == "open") << one.id;
        EXPECT_FALSE(one.reason.empty()) << one.id;
    }
}

} // namespace
} // namespace iecfront::test
