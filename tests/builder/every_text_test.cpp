#include "builder/rebuild.hpp"
#include "grammar/formal_syntax.hpp"
#include "grammar/sentences.hpp"
#include "support/case_file.hpp"
#include "support/case_outcome.hpp"
#include "support/repository_files.hpp"

#include <iecfront/ast/visitor.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <set>

// Whatever stands in a text of the standard can be built: over all cases without findings, all
// examples, and sentences that the grammar derives.

namespace iecfront::test {
namespace {

constexpr std::uint32_t seed = 5;
constexpr std::size_t sentence_count = 5000;

void note_kinds(const SyntaxTree& tree, std::set<ast::NodeKind>& kinds) {
    for (const SyntaxTree::Slot& slot : tree.slots())
        ast::walk(slot.unit->root(), [&](const ast::Node& node) {
            kinds.insert(node.kind);
            return ast::Walk::into;
        });
}

TEST(Cases, AreBuilt) {
    std::size_t built = 0;
    for (const CaseFile& file : all_case_files())
        for (const Case& one : file.cases) {
            const SyntaxTree tree = parse(source_text_of(one), options_of(one));
            if (!tree.diagnostics().empty() || tree.encoding() != Encoding::utf8)
                continue;
            EXPECT_EQ(rebuild_fault(tree), "") << file.path << ": " << one.title;
            ++built;
        }
    EXPECT_GT(built, 200U);
}

TEST(Examples, AreBuilt) {
    for (const RepositoryFile& file : example_programs()) {
        const SyntaxTree tree = parse(SourceText(file.text));
        if (tree.diagnostics().empty()) {
            EXPECT_EQ(rebuild_fault(tree), "") << file.path;
        }
    }
}

// Kinds that no text of the standard has.
[[nodiscard]] bool is_beyond_the_standard(ast::NodeKind kind) {
    switch (kind) {
    case ast::NodeKind::skipped_text:
    case ast::NodeKind::continue_statement:
    case ast::NodeKind::dereferenced_variable:
    case ast::NodeKind::part_selector:
    case ast::NodeKind::expression_statement: return true;
    default:
        return to_string(kind).starts_with("error_") || kind == ast::NodeKind::il_error_operation;
    }
}

TEST(Sentences, AreBuiltAndHaveAllKindsOfNode) {
    const FormalSyntax& syntax = formal_syntax();
    SentenceDeriver deriver(syntax.grammar, syntax.words, seed);
    std::set<ast::NodeKind> kinds;
    std::size_t built = 0;
    for (std::size_t i = 0; i < sentence_count; ++i) {
        const SyntaxTree tree = parse(SourceText(deriver.derive(10 + i % 150).text));
        if (!tree.diagnostics().empty()) // a rule of meaning
            continue;
        ASSERT_EQ(rebuild_fault(tree), "") << tree.source().bytes();
        note_kinds(tree, kinds);
        ++built;
    }
    EXPECT_GT(built, sentence_count / 3);
    for (std::size_t i = 0; i < ast::node_kind_count; ++i) {
        const auto kind = static_cast<ast::NodeKind>(i);
        EXPECT_TRUE(kinds.contains(kind) || is_beyond_the_standard(kind)) << to_string(kind);
    }
}

} // namespace
} // namespace iecfront::test
