#include "benchmark/counted_memory.hpp"
#include "benchmark/generator.hpp"

#include <iecfront/parser/parse.hpp>

#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace iecfront::bench {
namespace {

struct TreeMemory {
    double live;  // bytes that the tree holds,
    double peak;  // that there were at a time,
    double units; // that its units say they hold
};

[[nodiscard]] double memory_of_units(const SyntaxTree& tree) {
    std::size_t bytes = 0;
    for (const SyntaxTree::Slot& slot : tree.slots())
        bytes += slot.unit->memory_bytes();
    return static_cast<double>(bytes);
}

[[nodiscard]] TreeMemory memory_of_tree(std::string text, const ParseOptions& options = {}) {
    const SourceText source(std::move(text), "memory.st");
    start_counting_memory();
    const SyntaxTree tree = parse(source, options);
    const MemoryCounts counts = stop_counting_memory();
    return {static_cast<double>(counts.live), static_cast<double>(counts.peak),
            memory_of_units(tree)};
}

// The goals of docs/performance.md.
TEST(Memory, TreeOfALargeTextTakesAFewTimesItsSize) {
    for (const std::size_t size : {1'000'000U, 3'000'000U}) {
        const std::string text = generate_source(size, 1);
        const TreeMemory memory = memory_of_tree(text);
        const auto bytes = static_cast<double>(text.size());
        EXPECT_LE(memory.live, 3.5 * bytes) << size;
        EXPECT_LE(memory.peak + bytes, 5 * bytes) << size;
    }
}

// What docs/security.md says of texts in which each byte is a fault.
TEST(Memory, FaultsTakeABoundedMultipleOfTheText) {
    for (const std::string_view fault : {"%", "#", ",", ":", "\xE4", "; :="}) {
        std::string text = "PROGRAM p x := ";
        while (text.size() < 265'000) // a little more than a power of two
            text += fault;
        EXPECT_LE(memory_of_tree(text).peak, 460.0 * static_cast<double>(text.size())) << fault;
    }
}

// A list of instructions takes more than is expected of so many tokens.
[[nodiscard]] std::string instructions(std::size_t count) {
    std::string text = "PROGRAM p\nVAR x : BOOL; END_VAR\nLD x\n";
    for (std::size_t i = 0; i < count; ++i)
        text += "NOT\n";
    return text + "END_PROGRAM\n";
}

// Of the blocks that units share, little is left unused: whatever their sizes, and however few.
TEST(Memory, TreeHoldsLittleMoreThanItsUnits) {
    for (const std::size_t size : {300U, 20'000U, 200'000U, 300'000U, 600'000U, 1'000'000U}) {
        const TreeMemory memory = memory_of_tree(generate_source(size, 2));
        EXPECT_LE(memory.live, 1.3 * memory.units + 1'000) << size;
    }
    for (const std::size_t count : {10U, 1000U, 2'000U, 3'000U, 4'000U, 10'000U, 100'000U}) {
        const std::string unit = instructions(count);
        std::string text;
        while (text.size() < 1'000'000)
            text += unit + generate_source(300, 3);
        const TreeMemory memory = memory_of_tree(text);
        EXPECT_LE(memory.live, 1.3 * memory.units) << count;
    }
}

// Units of a large text take no memory of their own but for what a `Unit` is.
TEST(Memory, UnitsOfALargeTextShareBlocks) {
    const SourceText source(generate_source(3'000'000, 6), "memory.st");
    start_counting_memory();
    const SyntaxTree tree = parse(source);
    const MemoryCounts counts = stop_counting_memory();
    EXPECT_LT(counts.allocations, 3 * tree.slots().size() / 2);
}

// What is not kept does not stay in the blocks either, nor are these given up for units that take
// much while they are read.
TEST(Memory, UnitsThatAreRefusedOrNestDeepCostNoBlocks) {
    const std::string small = "PROGRAM p END_PROGRAM\n";
    ParseOptions options;
    options.maximum_unit_memory = 100'000;
    options.maximum_nesting = 2000;
    for (const std::string& large :
         {instructions(2'000), instructions(8'000),
          "PROGRAM p x := " + std::string(1'000, '(') + " END_PROGRAM\n"}) {
        std::string text;
        while (text.size() < 2'000'000)
            text += small + large;
        const TreeMemory memory = memory_of_tree(text, options);
        EXPECT_LE(memory.live, 1.4 * memory.units + 600'000) << large.substr(0, 80);
    }
}

// What is edited keeps nothing of the text and of the tree before.
TEST(Memory, EditedUnitsHoldTheirOwn) {
    start_counting_memory();
    SyntaxTree tree = parse(SourceText(generate_source(600'000, 4), "memory.st"));
    for (std::size_t i = 0; i < tree.slots().size(); ++i) {
        const SyntaxTree::Slot& slot = tree.slots()[i];
        const std::uint32_t end =
            slot.offset + static_cast<std::uint32_t>(slot.unit->text().size());
        tree = tree.edited({end - 1, end - 1}, " ");
    }
    const MemoryCounts counts = stop_counting_memory();
    EXPECT_LE(static_cast<double>(counts.live), 1.1 * (memory_of_units(tree) + tree.size()));
}

// Nor does one of many that an edit puts in.
TEST(Memory, UnitOfManyThatAreEditedHoldsItsOwn) {
    const std::string text = generate_source(600'000, 5);
    start_counting_memory();
    const std::shared_ptr<const Unit> unit =
        parse(SourceText("", "memory.st")).edited({0, 0}, text).slots()[1].unit;
    const MemoryCounts counts = stop_counting_memory();
    const auto own = static_cast<double>(unit->memory_bytes() + unit->text().size());
    EXPECT_LE(static_cast<double>(counts.live), 1.1 * own);
}

} // namespace
} // namespace iecfront::bench
