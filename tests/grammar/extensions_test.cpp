#include "grammar/formal_syntax.hpp"
#include "grammar/markdown.hpp"
#include "grammar/reading.hpp"
#include "grammar/sentences.hpp"
#include "support/tree_faults.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

// The extensions that docs/grammar.md sets apart: what the formal syntax derives with one of them
// is read, and nothing but its use is reported.

namespace iecfront::test {
namespace {

constexpr std::uint32_t seed = 5;
constexpr std::size_t sentence_count = 1500;

[[nodiscard]] std::vector<GrammarExtension> all_extensions() {
    std::vector<std::string> faults;
    std::vector<GrammarExtension> extensions = read_extensions(formal_syntax().document, faults);
    EXPECT_EQ(faults, std::vector<std::string>{});
    return extensions;
}

/// The codes other than `code` that no known difference explains, in words.
[[nodiscard]] std::string others(const std::set<std::string>& codes, const std::string& code) {
    std::string words;
    for (const std::string& one : codes)
        if (one != code && formal_syntax().differences.find(one) == nullptr)
            words += one + " ";
    return words;
}

/// Whether all that is derived with an extension is read, and its use reported, and nothing else.
struct Outcome {
    std::string fault; ///< the first sentence in which something else is reported
    std::size_t uses = 0;
    bool all_ways = true; ///< through the productions of the extension
};

[[nodiscard]] Outcome try_derived_sentences(const GrammarExtension& extension) {
    const Grammar grammar = extended_grammar(formal_syntax().document, extension);
    EXPECT_EQ(grammar.faults, std::vector<std::string>{}) << extension.name;
    const Words words(grammar, formal_syntax().document);
    SentenceDeriver deriver(grammar, words, seed);
    Outcome outcome;
    for (std::size_t i = 0; i < sentence_count; ++i) {
        const Sentence sentence = deriver.derive(10 + i % 100);
        const SyntaxTree tree = parse(SourceText(sentence.text));
        EXPECT_EQ(tree_fault(tree, sentence.text), "") << sentence.text;
        const std::set<std::string> codes = reported_codes(tree);
        outcome.uses += codes.contains(extension.code) ? 1 : 0;
        const std::string other = others(codes, extension.code);
        if (!other.empty() && outcome.fault.empty())
            outcome.fault = other + "in\n" + sentence.text;
    }
    for (const std::string& way : deriver.missed())
        for (const Production& production : extension.productions)
            outcome.all_ways = outcome.all_ways && !way.starts_with(production.name + ":");
    return outcome;
}

/// The names in the first table of the chapter about extensions.
[[nodiscard]] std::set<std::string> limited_by_context() {
    std::set<std::string> names;
    for (const std::vector<std::string>& row : table_rows(formal_syntax().document, "Extensions"))
        names.insert(code_in(row.front()));
    return names;
}

TEST(GrammarExtensions, AreThoseOfTheCatalogue) {
    for (const GrammarExtension& extension : all_extensions()) {
        const DiagnosticInfo* const row = find_diagnostic(extension.code);
        ASSERT_NE(row, nullptr) << extension.code;
        EXPECT_EQ(row->name, extension.name);
        EXPECT_EQ(row->category, DiagnosticClass::extension);
    }
}

TEST(GrammarExtensions, AreReadAndReportedUnlessContextLimitsThem) {
    std::set<std::string> limited = limited_by_context();
    EXPECT_FALSE(limited.empty());
    for (const GrammarExtension& extension : all_extensions()) {
        const Outcome outcome = try_derived_sentences(extension);
        if (limited.erase(extension.name) != 0) {
            EXPECT_TRUE(!outcome.fault.empty() || outcome.uses == 0)
                << extension.name << " is not limited";
            continue;
        }
        EXPECT_EQ(outcome.fault, "") << extension.name;
        EXPECT_GT(outcome.uses, 0U) << extension.name;
        EXPECT_TRUE(outcome.all_ways) << extension.name;
    }
    EXPECT_TRUE(limited.empty()) << "no extension: " << *limited.begin();
}

} // namespace
} // namespace iecfront::test
