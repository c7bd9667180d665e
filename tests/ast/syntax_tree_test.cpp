#include "ast/tree_builder.hpp"

#include <iecfront/ast/syntax_tree.hpp>

#include <gtest/gtest.h>
#include <random>

using namespace iecfront;
using namespace iecfront::ast;
using iecfront::test::assignment;
using iecfront::test::TreeBuilder;

namespace {

constexpr std::array column_units = {ColumnUnit::bytes, ColumnUnit::code_points,
                                     ColumnUnit::utf16_units};

SyntaxTree tree_of(std::vector<std::shared_ptr<const Unit>> units,
                   Encoding encoding = Encoding::utf8) {
    return SyntaxTree("file.st", encoding, std::move(units), {});
}

// A tree whose units are these texts, each with a buffer of its own.
SyntaxTree tree_of_texts(const std::vector<std::string>& texts,
                         Encoding encoding = Encoding::utf8) {
    std::vector<std::shared_ptr<const Unit>> units;
    for (const std::string& text : texts)
        units.push_back(TreeBuilder(text, encoding).unit());
    return tree_of(std::move(units), encoding);
}

TEST(SyntaxTree, ASlotKnowsItsOffsetAndLine) {
    const SyntaxTree tree = tree_of_texts({"a\nb", "c\n", "d"});
    ASSERT_EQ(tree.slots().size(), 3U);
    EXPECT_EQ(tree.slots()[1].offset, 3U);
    EXPECT_EQ(tree.slots()[1].first_line, 1U);
    EXPECT_EQ(tree.slots()[2].offset, 5U);
    EXPECT_EQ(tree.slots()[2].first_line, 2U);
    EXPECT_EQ(tree.size(), 6U);
    EXPECT_EQ(tree.name(), "file.st");
}

TEST(SyntaxTree, FindsTheSlotOfAnOffset) {
    const SyntaxTree tree = tree_of_texts({"ab", "c", "de"});
    const auto slot_number = [&](std::uint32_t offset) {
        return &tree.slot_at(offset) - tree.slots().data();
    };
    EXPECT_EQ(slot_number(0), 0);
    EXPECT_EQ(slot_number(1), 0);
    EXPECT_EQ(slot_number(2), 1);
    EXPECT_EQ(slot_number(3), 2);
    EXPECT_EQ(slot_number(5), 2); // end of text
}

TEST(SyntaxTree, AnEmptyFileHasPositions) {
    const SyntaxTree tree = tree_of_texts({""});
    EXPECT_EQ(tree.position(0), (Position{1, 1}));
    EXPECT_EQ(tree.offset({1, 1}), 0U);
    EXPECT_EQ(tree.offset({5, 5}), 0U);
    EXPECT_EQ(tree.source().bytes(), "");
    EXPECT_EQ(tree.node_at(0).nodes.size(), 1U);
}

TEST(SyntaxTree, AUnitMayBeginInTheMiddleOfALine) {
    const SyntaxTree tree = tree_of_texts({"x\nab", "cd", "ef\nz"});
    EXPECT_EQ(tree.position(4), (Position{2, 3})); // c
    EXPECT_EQ(tree.position(7), (Position{2, 6})); // f
    EXPECT_EQ(tree.position(9), (Position{3, 1})); // z
    EXPECT_EQ(tree.offset({2, 6}), 7U);
    EXPECT_EQ(tree.offset({2, 99}), 8U);
    EXPECT_EQ(tree.offset({3, 1}), 9U);
    EXPECT_EQ(tree.offset({4, 1}), tree.size());
    EXPECT_EQ(tree.offset({0, 0}), 0U); // no such position
}

TEST(SyntaxTree, AByteOrderMarkCountsUnlessItBeginsTheFile) {
    const std::string mark = "\xEF\xBB\xBF";
    const SyntaxTree tree = tree_of_texts({mark + "a", mark + "b"});
    EXPECT_EQ(tree.position(3), (Position{1, 1}));
    EXPECT_EQ(tree.position(4), (Position{1, 2}));
    EXPECT_EQ(tree.position(7), (Position{1, 3}));
    EXPECT_EQ(tree.position(7, ColumnUnit::bytes), (Position{1, 8}));
    EXPECT_EQ(tree.offset({1, 2}), 4U);
    EXPECT_EQ(tree.offset({1, 3}), 7U);
}

// Cuts a random text into units at characters, but never between CR and LF.
std::vector<std::string> cut_at_random(std::mt19937& random) {
    constexpr std::array<std::string_view, 8> characters = {
        "a", "b", "\n", "\r\n", "\r", "\xC3\x84", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"};
    std::vector<std::string> units{""};
    std::string_view last;
    for (std::size_t length = random() % 40; length > 0; --length) {
        const std::string_view next = characters[random() % characters.size()];
        if (random() % 4 == 0 && !(last == "\r" && next == "\n"))
            units.emplace_back();
        units.back() += next;
        last = next;
    }
    return units;
}

// Positions through units are those of the whole text.
TEST(SyntaxTree, PositionsAreThoseOfTheWholeText) {
    std::mt19937 random(3);
    for (int round = 0; round < 2000; ++round) {
        const SyntaxTree tree = tree_of_texts(cut_at_random(random));
        const SourceText source = tree.source();
        const std::string_view text = source.bytes();
        const LineTable lines(text);
        for (const ColumnUnit unit : column_units) {
            for (std::uint32_t at = 0; at <= text.size(); ++at) {
                const std::uint32_t line = lines.line_of(at);
                const std::uint32_t start = lines.line_start(line);
                const Position expected{line + 1, column_of(text, start, at, Encoding::utf8, unit)};
                ASSERT_EQ(tree.position(at, unit), expected);
                ASSERT_EQ(tree.offset(expected, unit),
                          offset_of_column(text, start, expected.column, Encoding::utf8, unit));
            }
            for (std::uint32_t line = 0; line <= lines.line_end_count(); ++line)
                for (std::uint32_t column = 1; column < 12; ++column)
                    ASSERT_EQ(tree.offset({line + 1, column}, unit),
                              offset_of_column(text, lines.line_start(line), column, Encoding::utf8,
                                               unit));
        }
    }
}

TEST(SyntaxTree, OtherEncodingsCountTheirCharacters) {
    const SyntaxTree tree = tree_of_texts({"\xC4", "\xD6x"}, Encoding::iso_8859_1);
    EXPECT_EQ(tree.position(2), (Position{1, 3}));
    EXPECT_EQ(tree.source().encoding(), Encoding::iso_8859_1);
}

TEST(SyntaxTree, SharesTheBufferThatItsUnitsCut) {
    const auto buffer = std::make_shared<const std::string>("ab cd ef");
    const auto first = TreeBuilder(buffer, TextRange{0, 2}).unit();
    const auto second = TreeBuilder(buffer, TextRange{2, 8}).unit();
    const SourceText source = tree_of({first, second}).source();
    EXPECT_EQ(source.buffer(), buffer);
    EXPECT_EQ(source.name(), "file.st");
    EXPECT_EQ(tree_of({first}).source().bytes(), "ab"); // not all of the buffer
    EXPECT_EQ(tree_of({second, first}).source().bytes(), " cd efab");
}

TEST(SyntaxTree, JoinsUnitsOfSeveralBuffers) {
    const SourceText source = tree_of_texts({"ab", "", "c"}).source();
    EXPECT_EQ(source.bytes(), "abc");
}

TEST(SyntaxTree, ShiftsDiagnosticsToTheFile) {
    TreeBuilder first("ab");
    first.add({.id = {}, .range = {1, 2}, .arguments = {}, .labels = {}, .fixes = {}});
    TreeBuilder second("cd");
    second.add({.id = {},
                .range = {0, 1},
                .arguments = {},
                .labels = {{{1, 2}, {}, {}}},
                .fixes = {{{{{1, 1}, "x"}}}}});
    const auto diagnostics = tree_of({first.unit(), second.unit()}).diagnostics();
    ASSERT_EQ(diagnostics.size(), 2U);
    EXPECT_EQ(diagnostics[0].range, (TextRange{1, 2}));
    EXPECT_EQ(diagnostics[1].range, (TextRange{2, 3}));
    EXPECT_EQ(diagnostics[1].labels[0].range, (TextRange{3, 4}));
    EXPECT_EQ(diagnostics[1].fixes[0].edits[0].range, (TextRange{3, 3}));
}

class NodeAt : public ::testing::Test {
protected:
    static SyntaxTree build() {
        TreeBuilder builder("x  := a + b");
        return tree_of({TreeBuilder("-- ").unit(), builder.unit({assignment(builder)})});
    }
    SyntaxTree tree = build();

    // Texts of the nodes on the way, outermost first.
    std::vector<std::string_view> path(std::uint32_t offset) {
        const SyntaxTree::Path found = tree.node_at(offset);
        std::vector<std::string_view> texts;
        for (const Node* node : found.nodes)
            texts.push_back(found.slot->unit->text(*node));
        return texts;
    }
    using Texts = std::vector<std::string_view>;
};

TEST_F(NodeAt, FindsTheInnermostNode) {
    EXPECT_EQ(path(3), Texts({"x  := a + b", "x  := a + b", "x"}));
    EXPECT_EQ(path(13), Texts({"x  := a + b", "x  := a + b", "a + b", "b"}));
}

TEST_F(NodeAt, BetweenChildrenItIsTheNodeAroundThem) {
    EXPECT_EQ(path(4), Texts({"x  := a + b", "x  := a + b"})); // a space
    EXPECT_EQ(path(6), Texts({"x  := a + b", "x  := a + b"})); // of `:=`
    EXPECT_EQ(path(11), Texts({"x  := a + b", "x  := a + b", "a + b"}));
}

TEST_F(NodeAt, TheRootIsAlwaysThere) {
    EXPECT_EQ(path(2), Texts({"--"}));           // behind the last token of a unit
    EXPECT_EQ(path(14), Texts({"x  := a + b"})); // end of text
}

TEST_F(NodeAt, ANodeWithoutTextHoldsNoOffset) {
    TreeBuilder builder("x :=");
    auto* statement = builder.node<AssignmentStatement>(0, 2);
    statement->variable = builder.leaf<VariableName>(0);
    statement->expression = builder.node<ErrorExpression>(2, 2);
    tree = tree_of({builder.unit({statement})});
    EXPECT_EQ(path(3), Texts({"x :=", "x :="}));
    EXPECT_EQ(path(4), Texts({"x :="}));
}

TEST(SyntaxTreeEquality, SeesEachUnit) {
    const SyntaxTree tree = tree_of_texts({"a", "b"});
    EXPECT_TRUE(tree == tree);
    EXPECT_TRUE(tree == tree_of_texts({"a", "b"}));
    EXPECT_FALSE(tree == tree_of_texts({"a", "c"}));
    EXPECT_FALSE(tree == tree_of_texts({"a"}));
    EXPECT_FALSE(tree == tree_of_texts({"ab"}));
}

TEST(SyntaxTree, FindsTokensByOffset) {
    const SyntaxTree tree = tree_of_texts({"ab  c ", " d"});
    const auto at = [&](std::uint32_t offset) {
        const auto place = tree.token_at(offset);
        return place ? place->range().begin : 99U;
    };
    EXPECT_EQ(at(0), 0U);
    EXPECT_EQ(at(1), 0U);
    EXPECT_EQ(at(2), 99U);
    EXPECT_EQ(at(4), 4U);
    EXPECT_EQ(at(7), 7U);
    EXPECT_EQ(at(8), 99U); // end of text
    const auto before = [&](std::uint32_t offset) {
        const auto place = tree.token_before(offset);
        return place ? place->range().begin : 99U;
    };
    EXPECT_EQ(before(0), 99U);
    EXPECT_EQ(before(2), 0U);
    EXPECT_EQ(before(4), 0U);
    EXPECT_EQ(before(7), 4U);
    EXPECT_EQ(before(8), 7U);
}

} // namespace
