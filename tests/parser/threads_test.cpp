#include <iecfront/ast/dump.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

// ThreadSanitizer looks at these: no state is shared but what nobody writes, the table of lines of
// a unit, which the first thread that has made one hands to all, and what of its nodes is not used.

namespace iecfront {
namespace {

constexpr int thread_count = 4;

const std::string text = "FUNCTION f : INT\n"
                         "VAR_INPUT a : INT; END_VAR\n"
                         "f := a * 16#FF + 1\n"
                         "END_FUNCTION\n"
                         "PROGRAM p\n"
                         "VAR t : TON; s : STRING := 'it$'s'; END_VAR\n"
                         "t(IN := TRUE, PT := T#1s);\n"
                         "END_PROGRAM\n";

template<class Work>
void in_threads(const Work& work) {
    std::vector<std::thread> threads;
    for (int i = 0; i < thread_count; ++i)
        threads.emplace_back([&work, i] { work(i); });
    for (std::thread& thread : threads)
        thread.join();
}

TEST(Threads, ParseTextsAtOnce) {
    const SyntaxTree alone = parse(SourceText(text));
    std::vector<char> equal(thread_count);
    in_threads(
        [&](int i) { equal[static_cast<std::size_t>(i)] = parse(SourceText(text)) == alone; });
    EXPECT_EQ(equal, std::vector<char>(thread_count, 1));
}

TEST(Threads, ReadAndEditOneTreeAtOnce) {
    const SyntaxTree tree = parse(SourceText(text));
    const std::string dump = dump_tree(tree);
    std::vector<char> equal(thread_count);
    in_threads([&](int i) {
        const auto at = static_cast<std::uint32_t>(20 * i);
        const SyntaxTree edited = tree.edited({at, at + 3}, " ; ");
        const bool changed = edited.source().bytes().substr(at, 3) == " ; ";
        equal[static_cast<std::size_t>(i)] =
            changed && dump_tree(tree) == dump && tree.diagnostics().size() == 1;
    });
    EXPECT_EQ(equal, std::vector<char>(thread_count, 1));
}

// The first one that asks makes the table for all.
TEST(Threads, AskOneUnitForItsLinesAtOnce) {
    for (int round = 0; round < 20; ++round) {
        const SyntaxTree tree = parse(SourceText(text));
        const Unit& unit = *tree.slots().front().unit;
        std::vector<const LineTable*> tables(thread_count);
        in_threads([&](int i) { tables[static_cast<std::size_t>(i)] = &unit.lines(); });
        EXPECT_EQ(tables, std::vector<const LineTable*>(thread_count, &unit.lines()));
        EXPECT_EQ(unit.lines().line_end_count(), 3U);
    }
}

// The first one that asks looks at them, while others read the tree.
TEST(Threads, AskOneUnitForItsNodesAtOnce) {
    const SourceText source("TYPE t : POINTER TO INT; END_TYPE\n"); // INT is not in the tree
    const std::string dump = dump_tree(parse(source));
    for (int round = 0; round < 20; ++round) {
        const SyntaxTree tree = parse(source);
        const Unit& unit = *tree.slots().front().unit;
        std::vector<char> equal(thread_count);
        in_threads([&](int i) {
            equal[static_cast<std::size_t>(i)] =
                i % 2 == 0 ? std::ranges::distance(unit.nodes()) == 5 : dump_tree(tree) == dump;
        });
        EXPECT_EQ(equal, std::vector<char>(thread_count, 1));
    }
}

} // namespace
} // namespace iecfront
