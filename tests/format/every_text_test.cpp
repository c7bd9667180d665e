#include "format/format_faults.hpp"
#include "grammar/formal_syntax.hpp"
#include "grammar/sentences.hpp"
#include "support/case_file.hpp"
#include "support/case_outcome.hpp"
#include "support/repository_files.hpp"

#include <iecfront/ast/attached_comments.hpp>
#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/visitor.hpp>

#include <gtest/gtest.h>

// What holds for every layout and every written text, whatever is in it: over all cases, with
// faults and without, all examples, and sentences that the grammar derives.

namespace iecfront::test {
namespace {

constexpr std::uint32_t seed = 3;
constexpr std::size_t sentence_count = 2000;

void expect_no_fault(const SourceText& source, const ParseOptions& options = {}) {
    EXPECT_EQ(format_fault(source, options), "") << source.bytes();
    EXPECT_EQ(write_fault(source, options), "") << source.bytes();
}

// The layout without room, so that each line is broken wherever it can be.
void expect_no_fault_in_narrow_lines(const SourceText& source, const ParseOptions& options = {}) {
    FormatOptions layout;
    layout.line_length = 20;
    layout.indent_width = 2;
    EXPECT_EQ(format_fault(source, options, layout), "") << source.bytes();
}

void expect_no_fault_without_comments(const SourceText& source, const ParseOptions& options = {}) {
    WriteOptions writing;
    writing.comments = CommentHandling::leave_out;
    EXPECT_EQ(write_fault(source, options, writing), "") << source.bytes();
}

void expect_no_fault_anywhere(const SourceText& source, const ParseOptions& options = {}) {
    expect_no_fault(source, options);
    expect_no_fault_in_narrow_lines(source, options);
    expect_no_fault_without_comments(source, options);
}

TEST(Cases, AreFormattedAndWritten) {
    for (const CaseFile& file : all_case_files())
        for (const Case& one : file.cases) {
            SCOPED_TRACE(file.path + ": " + one.title);
            expect_no_fault_anywhere(source_text_of(one), options_of_changed(one));
        }
}

TEST(Examples, AreFormattedAndWritten) {
    for (const RepositoryFile& file : example_programs()) {
        SCOPED_TRACE(file.path);
        expect_no_fault_anywhere(SourceText(file.text));
    }
}

/// Without the white space before its further lines, which move with the first one.
[[nodiscard]] std::string without_indent(std::string_view comment) {
    std::string text;
    bool at_begin = false;
    for (const char c : comment) {
        at_begin = c == '\n' || (at_begin && c == ' ');
        if (!at_begin || c == '\n')
            text += c;
    }
    return text;
}

/// The comments that speak of each declaration and statement.
[[nodiscard]] std::vector<std::string> attached(const SyntaxTree& tree) {
    std::vector<std::string> comments;
    for (const SyntaxTree::Slot& slot : tree.slots())
        ast::walk(slot.unit->root(), [&](const ast::Node& node) {
            if (!ast::is<ast::Statement>(node.kind) &&
                node.kind != ast::NodeKind::variable_declaration)
                return ast::Walk::into;
            const AttachedComments found = attached_comments(*slot.unit, node);
            comments.emplace_back();
            for (const Trivia& trivia : found.before)
                comments.back() += "above: " + without_indent(slot.unit->text(trivia.range)) + '\n';
            for (const Trivia& trivia : found.behind)
                comments.back() +=
                    "behind: " + without_indent(slot.unit->text(trivia.range)) + '\n';
            return ast::Walk::into;
        });
    return comments;
}

TEST(Examples, KeepTheirCommentsWithWhatTheySpeakOf) {
    for (const RepositoryFile& file : example_programs()) {
        const SyntaxTree tree = parse(SourceText(file.text));
        FormatOptions layout;
        layout.line_length = 60;
        layout.indent_width = 3;
        EXPECT_EQ(attached(tree), attached(parse(SourceText(format(tree, layout))))) << file.path;
    }
}

// One shows keywords in lower case, and one indentation by tabs.
TEST(Examples, HaveTheAgreedLayout) {
    for (const RepositoryFile& file : example_programs()) {
        FormatOptions layout;
        if (file.path == "examples/st/pid_loop.st")
            layout.keyword_case = KeywordCase::lower;
        if (file.path != "examples/st/conveyor_sorting.st") {
            EXPECT_EQ(format(parse(SourceText(file.text)), layout), file.text) << file.path;
        }
    }
}

TEST(Sentences, AreFormattedAndWritten) {
    const FormalSyntax& syntax = formal_syntax();
    SentenceDeriver deriver(syntax.grammar, syntax.words, seed);
    for (std::size_t i = 0; i < sentence_count; ++i)
        expect_no_fault_anywhere(SourceText(deriver.derive(10 + i % 100).text));
}

} // namespace
} // namespace iecfront::test
