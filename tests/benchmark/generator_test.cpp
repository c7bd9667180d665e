#include "benchmark/generator.hpp"

#include <iecfront/ast/visitor.hpp>
#include <iecfront/diagnostics/render_text.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <string>

namespace iecfront::bench {
namespace {

constexpr std::size_t size = 300'000;

[[nodiscard]] SyntaxTree generated_tree(std::uint64_t seed) {
    return parse(SourceText(generate_source(size, seed), "generated.st"));
}

[[nodiscard]] std::map<ast::NodeKind, std::size_t> count_kinds(const SyntaxTree& tree) {
    std::map<ast::NodeKind, std::size_t> counts;
    for (const SyntaxTree::Slot& slot : tree.slots())
        ast::walk(slot.unit->root(), [&](const ast::Node& node) {
            ++counts[node.kind];
            return ast::Walk::into;
        });
    return counts;
}

class GeneratedSource : public testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Seeds, GeneratedSource, testing::Values(1, 2, 3));

TEST_P(GeneratedSource, HasNoFinding) {
    const SourceText source(generate_source(size, GetParam()), "generated.st");
    const SyntaxTree tree = parse(source);
    EXPECT_EQ(render_text(tree.diagnostics(), source), "");
}

TEST_P(GeneratedSource, HasCommentsAndLinesAsPublishedPrograms) {
    const SyntaxTree tree = generated_tree(GetParam());
    std::size_t comments = 0;
    for (const SyntaxTree::Slot& slot : tree.slots())
        for (const Trivia& trivia : slot.unit->trivia())
            comments += trivia.range.size();
    const double share = static_cast<double>(comments) / tree.size();
    EXPECT_GE(share, 0.10);
    EXPECT_LE(share, 0.20);

    const std::string text = generate_source(size, GetParam());
    const double line =
        static_cast<double>(text.size()) / static_cast<double>(std::ranges::count(text, '\n'));
    EXPECT_NEAR(line, 35.0, 3.0);
}

TEST_P(GeneratedSource, HasUnitsOfUsualSizes) {
    const SyntaxTree tree = generated_tree(GetParam());
    EXPECT_GT(tree.slots().size(), size / 10'000);
    for (const SyntaxTree::Slot& slot : tree.slots())
        EXPECT_LE(std::ranges::count(slot.unit->text(), '\n'), 450);
}

TEST_P(GeneratedSource, HasAllElementsAndLanguages) {
    auto counts = count_kinds(generated_tree(GetParam()));
    using enum ast::NodeKind;
    for (const ast::NodeKind kind :
         {data_type_declaration, function_declaration, function_block_declaration,
          program_declaration, configuration_declaration, statement_list, instruction_list,
          sequential_function_chart})
        EXPECT_GT(counts[kind], 0U) << to_string(kind);
    EXPECT_GT(counts[assignment_statement], 10 * counts[il_simple_operation] / 4);
}

TEST(GeneratedText, IsTheSameForTheSameSeed) {
    EXPECT_EQ(generate_source(50'000, 7), generate_source(50'000, 7));
    EXPECT_NE(generate_source(50'000, 7), generate_source(50'000, 8));
}

// Figures of several machines and compilers are of the same text.
TEST(GeneratedText, IsTheSameWithEveryCompiler) {
    std::uint64_t hash = 0;
    for (const char c : generate_source(size))
        hash = hash * 31 + static_cast<unsigned char>(c);
    EXPECT_EQ(hash, 338832665169943288U);
}

TEST(GeneratedText, BeginsTheSameInEachSize) {
    EXPECT_TRUE(generate_source(100'000).starts_with(generate_source(30'000)));
}

TEST(GeneratedText, HasFunctionBlocksOfAnySize) {
    const SourceText source(generate_function_block(2000), "block.st");
    const SyntaxTree tree = parse(source);
    EXPECT_EQ(render_text(tree.diagnostics(), source), "");
    EXPECT_EQ(tree.slots().size(), 1U);
    EXPECT_GT(tree.slots()[0].unit->lines().line_end_count(), 2000U);
}

} // namespace
} // namespace iecfront::bench
