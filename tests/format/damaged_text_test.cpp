#include "format/format_faults.hpp"
#include "support/repository_files.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

// Texts in which something is broken are formatted around it.

namespace iecfront::test {
namespace {

constexpr std::uint32_t seed = 5;
constexpr std::size_t damages_in_each = 60;

// The text without one of its tokens, or with one twice.
[[nodiscard]] std::string damaged(const SyntaxTree& tree, std::mt19937& random) {
    const auto& slots = tree.slots();
    const SyntaxTree::Slot& slot = slots[random() % slots.size()];
    std::string text(tree.source().bytes());
    if (slot.unit->tokens().empty())
        return text;
    const Token token = slot.unit->tokens()[random() % slot.unit->tokens().size()];
    const TextRange range = token.range().shifted(slot.offset);
    if (random() % 2 == 0)
        return text.erase(range.begin, range.size());
    return text.insert(range.end, ' ' + std::string(slot.unit->text(token)));
}

TEST(DamagedTexts, AreFormattedAndWritten) {
    std::mt19937 random(seed);
    for (const RepositoryFile& file : example_programs()) {
        const SyntaxTree tree = parse(SourceText(file.text));
        for (std::size_t i = 0; i < damages_in_each; ++i) {
            const SourceText source(damaged(tree, random));
            EXPECT_EQ(format_fault(source), "") << source.bytes();
            EXPECT_EQ(write_fault(source), "") << source.bytes();
        }
    }
}

// What is beside a fault of an example, which is formatted already, stays as it is.
TEST(DamagedTexts, StayAsTheyAreAroundTheDamage) {
    std::mt19937 random(seed);
    std::size_t unchanged = 0;
    std::size_t all = 0;
    for (const RepositoryFile& file : example_programs()) {
        if (file.path == "examples/st/conveyor_sorting.st")
            continue;
        const SyntaxTree tree = parse(SourceText(file.text));
        for (std::size_t i = 0; i < damages_in_each; ++i) {
            const std::string text = damaged(tree, random);
            FormatOptions layout;
            layout.keyword_case = KeywordCase::keep;
            unchanged += format(parse(SourceText(text)), layout) == text ? 1U : 0U;
            ++all;
        }
    }
    RecordProperty("unchanged", static_cast<int>(unchanged));
    EXPECT_GT(unchanged * 100, all * 50) << unchanged << " of " << all;
}

} // namespace
} // namespace iecfront::test
