#include "ast/tree_builder.hpp"

#include <iecfront/ast/unit.hpp>

#include <gtest/gtest.h>

using namespace iecfront;
using namespace iecfront::ast;
using iecfront::test::assignment;
using iecfront::test::TreeBuilder;

namespace {

TEST(Unit, RangeOfANodeIsThatOfItsTokens) {
    TreeBuilder builder(" x := a\n+ b ");
    const auto* statement = assignment(builder);
    const auto unit = builder.unit({statement});
    EXPECT_EQ(unit->range(*statement), (TextRange{1, 11}));
    EXPECT_EQ(unit->text(*statement), "x := a\n+ b");
    EXPECT_EQ(unit->text(*statement->variable), "x");
    EXPECT_EQ(unit->range(unit->root()), (TextRange{1, 11}));
}

TEST(Unit, ANodeWithoutTokensStandsBehindTheTokenBeforeIt) {
    TreeBuilder builder("  aa  bb ");
    const auto* first = builder.node<Identifier>(0, 0);
    const auto* middle = builder.node<Identifier>(1, 1);
    const auto* last = builder.node<Identifier>(2, 2);
    const auto unit = builder.unit();
    EXPECT_EQ(unit->range(*first), (TextRange{0, 0}));
    EXPECT_EQ(unit->range(*middle), (TextRange{4, 4}));
    EXPECT_EQ(unit->range(*last), (TextRange{8, 8}));
}

TEST(Unit, AnEmptyStatementStandsAtItsSemicolon) {
    TreeBuilder builder("a\n;");
    const auto* statement = builder.node<EmptyStatement>(1, 1);
    EXPECT_EQ(builder.unit()->range(*statement), (TextRange{2, 2}));
}

TEST(Unit, KnowsItsLinesAndBuffer) {
    const auto buffer = std::make_shared<const std::string>("a\nb\r\nc");
    const auto unit = TreeBuilder(buffer).unit();
    EXPECT_EQ(unit->line_end_count(), 2U);
    EXPECT_EQ(unit->lines().line_end_count(), 2U);
    EXPECT_EQ(unit->lines().line_start(2), 5U);
    EXPECT_EQ(unit->buffer(), buffer);
}

TEST(Unit, AnEmptyOneHasARoot) {
    const auto unit = TreeBuilder("").unit();
    EXPECT_EQ(unit->range(unit->root()), (TextRange{0, 0}));
    EXPECT_TRUE(unit->root().elements.empty());
}

TEST(Unit, CountsItsMemory) {
    const auto small = TreeBuilder("a").unit();
    EXPECT_GE(small->memory_bytes(), sizeof(Unit));
    TreeBuilder builder("a\nb");
    Diagnostic diagnostic;
    diagnostic.arguments.emplace_back(std::string(1000, 'x'));
    diagnostic.labels.push_back({{}, {}, std::string(1000, 'y')});
    diagnostic.fixes.push_back({{{{}, std::string(1000, 'z')}}});
    builder.add(diagnostic);
    const auto large = builder.unit();
    EXPECT_GE(large->memory_bytes(), small->memory_bytes() + 3000);
    const std::size_t before = large->memory_bytes();
    EXPECT_EQ(large->lines().line_end_count(), 1U);
    EXPECT_EQ(large->memory_bytes(), before + sizeof(LineTable) + sizeof(std::uint32_t));
}

TEST(UnitEquality, SeesTextNodesAndDiagnostics) {
    const auto built = [](std::string text, bool wrong, bool statement) {
        TreeBuilder builder(std::move(text));
        if (wrong)
            builder.add(Diagnostic{});
        return statement ? builder.unit({assignment(builder)}) : builder.unit();
    };
    const auto unit = built("x := a + b", false, true);
    EXPECT_TRUE(*unit == *built("x := a + b", false, true));
    EXPECT_FALSE(*unit == *built("x := a - b", false, true));
    EXPECT_FALSE(*unit == *built("x := a + b", true, true));
    EXPECT_FALSE(*unit == *built("x := a + b", false, false));
}

} // namespace
