#include "ast/tree_builder.hpp"

#include <iecfront/ast/visitor.hpp>

#include <gtest/gtest.h>

using namespace iecfront;
using namespace iecfront::ast;
using iecfront::test::assignment;
using iecfront::test::chain;
using iecfront::test::chain_text;
using iecfront::test::nested;
using iecfront::test::nested_text;
using iecfront::test::TreeBuilder;

namespace {

using Words = std::vector<std::string>;

class WalkTest : public ::testing::Test {
protected:
    TreeBuilder builder{"x := a + b"};
    const AssignmentStatement* statement = assignment(builder);
    std::shared_ptr<const Unit> unit = builder.unit({statement});
    Words seen;

    void note(const char* what, const Node& node) {
        seen.push_back(what + std::string(unit->text(node)));
    }
};

TEST_F(WalkTest, EntersAndLeavesInSourceOrder) {
    const bool finished = walk(
        *statement,
        [&](const Node& node) {
            note("", node);
            return Walk::into;
        },
        [&](const Node& node) { note("/", node); });
    EXPECT_TRUE(finished);
    EXPECT_EQ(seen, Words({"x := a + b", "x", "/x", "a + b", "a", "/a", "b", "/b", "/a + b",
                           "/x := a + b"}));
}

TEST_F(WalkTest, GoesOver) {
    const bool finished = walk(
        *statement,
        [&](const Node& node) {
            note("", node);
            return is<BinaryExpression>(node.kind) ? Walk::over : Walk::into;
        },
        [&](const Node& node) { note("/", node); });
    EXPECT_TRUE(finished);
    EXPECT_EQ(seen, Words({"x := a + b", "x", "/x", "a + b", "/a + b", "/x := a + b"}));
}

TEST_F(WalkTest, Stops) {
    const bool finished = walk(*statement, [&](const Node& node) {
        note("", node);
        return unit->text(node) == "a" ? Walk::stop : Walk::into;
    });
    EXPECT_FALSE(finished);
    EXPECT_EQ(seen, Words({"x := a + b", "x", "a + b", "a"}));
}

std::uint32_t count_nodes(const Node& root) {
    std::uint32_t count = 0;
    walk(root, [&](const Node&) {
        ++count;
        return Walk::into;
    });
    return count;
}

TEST(Walk, NeedsNoStackForDeepTrees) {
    constexpr std::uint32_t size = 1'000'000;
    TreeBuilder chained(chain_text(size));
    EXPECT_EQ(count_nodes(*chain(chained, size)), 2 * size - 1);
    TreeBuilder deep(nested_text(size));
    EXPECT_EQ(count_nodes(*nested(deep, size)), size + 1);
}

// One `visit`, no `leave`, and no using-declaration.
struct Names : Visitor<Names> {
    Walk visit(const VariableName&) {
        ++count;
        return Walk::into;
    }
    int count = 0;
};

// Only `leave`.
struct Leavers : Visitor<Leavers> {
    void leave(const VariableName&) { ++names; }
    void leave(const Node&) { ++others; }
    int names = 0;
    int others = 0;
};

// A struct, a category above it, and everything else.
struct Categories : Visitor<Categories> {
    Walk visit(const Node&) { return add('n'); }
    Walk visit(const Expression&) { return add('e'); }
    Walk visit(const BinaryExpression&) { return add('b'); }
    Walk add(char letter) {
        seen += letter;
        return Walk::into;
    }
    std::string seen;
};

struct FirstName : Visitor<FirstName> {
    Walk visit(const VariableName& name) {
        found = &name;
        return Walk::stop;
    }
    const VariableName* found = nullptr;
};

struct NotInSums : Visitor<NotInSums> {
    Walk visit(const BinaryExpression&) { return Walk::over; }
    void leave(const BinaryExpression&) { ++sums; }
    void leave(const VariableName&) { ++names; }
    int sums = 0;
    int names = 0;
};

TEST_F(WalkTest, AVisitorNeedsOneVisit) {
    Names names;
    EXPECT_TRUE(names.traverse(unit->root()));
    EXPECT_EQ(names.count, 3);
}

TEST_F(WalkTest, AVisitorMayOnlyLeave) {
    Leavers leavers;
    EXPECT_TRUE(leavers.traverse(*statement));
    EXPECT_EQ(leavers.names, 3);
    EXPECT_EQ(leavers.others, 2);
}

TEST_F(WalkTest, TheMostSpecificVisitIsCalled) {
    Categories categories;
    EXPECT_TRUE(categories.traverse(*statement));
    EXPECT_EQ(categories.seen, "nebee");
}

TEST_F(WalkTest, AVisitorStops) {
    FirstName first;
    EXPECT_FALSE(first.traverse(*statement));
    EXPECT_EQ(first.found, statement->variable);
}

TEST_F(WalkTest, WhatIsGoneOverIsLeft) {
    NotInSums visitor;
    EXPECT_TRUE(visitor.traverse(*statement));
    EXPECT_EQ(visitor.sums, 1);
    EXPECT_EQ(visitor.names, 1);
}

} // namespace
