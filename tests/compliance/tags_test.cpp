#include "grammar/formal_syntax.hpp"
#include "support/case_coverage.hpp"
#include "support/repository_files.hpp"

#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/compliance/annex_e.hpp>
#include <iecfront/compliance/features.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>

#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <string>

// A tag of a case is known to a registry: docs/testing.md says what tags there are.

namespace iecfront::test {
namespace {

using Tags = std::set<std::string>;

/// `2.4.3.1` stands for the clauses that it is part of as well.
void add_clause(Tags& tags, std::string clause) {
    while (tags.insert(clause).second && clause.find('.') != std::string::npos)
        clause.resize(clause.rfind('.'));
}

void add_clauses(Tags& tags) {
    for (const DiagnosticInfo& info : diagnostic_catalogue())
        add_clause(tags, std::string(info.clause));
    for (const FeatureTable& table : feature_tables())
        add_clause(tags, std::string(table.clause));
    for (const AnnexDParameter& parameter : annex_d())
        add_clause(tags, std::string(parameter.subclause));
    for (const AnnexEError& error : annex_e())
        add_clause(tags, std::string(error.subclause));
    for (const char letter : std::string_view("abcdefghij"))
        tags.insert(std::string("1.5.1-") + letter);
    tags.insert("Annex-C"); // the keywords: include/iecfront/lexer/tokens.def
    // No row of a registry is of these alone.
    tags.insert({"2.5.1.2", "B.1.3.1", "B.1.3.2", "B.3.2.1"});
}

void add_features(Tags& tags) {
    for (const Feature& feature : features())
        tags.insert("table-" + std::string(feature.table) + "." + std::string(feature.number));
}

void add_annexes(Tags& tags) {
    for (const AnnexDParameter& parameter : annex_d())
        if (parameter.diagnostic)
            tags.insert("Annex-D." + std::string(diagnostic_info(*parameter.diagnostic).name));
    for (const AnnexEError& error : annex_e())
        tags.insert("Annex-E." + std::to_string(error.row));
}

// Productions, headings of Annex B, and the ids of the decisions about it.
void add_formal_syntax(Tags& tags) {
    const std::string& document = formal_syntax().document;
    for (const std::string_view mark : {"ebnf", "ebnf-unreachable", "ebnf-separator"})
        for (const Production& production : read_grammar(document, mark).productions)
            tags.insert(production.name);
    const std::regex id(R"(\n(?:\| ([DAR]\d+) \||#+ (B\.[\d.]*\d) |#+ [^\n(]*\((B\.\d+)\)\n))");
    for (std::sregex_iterator it(document.begin(), document.end(), id), end; it != end; ++it)
        for (std::size_t group = 1; group <= 3; ++group)
            if ((*it)[group].matched)
                add_clause(tags, (*it)[group]);
}

[[nodiscard]] const Tags& known_tags() {
    static const Tags all = [] {
        Tags tags = {"recovery"}; // how the parser goes on behind a fault
        add_clauses(tags);
        add_features(tags);
        add_annexes(tags);
        add_formal_syntax(tags);
        return tags;
    }();
    return all;
}

TEST(Tags, EachOneIsKnown) {
    for (const CoveredCase& one : covered_cases())
        for (const std::string& tag : one.tags)
            EXPECT_TRUE(known_tags().contains(tag))
                << one.place << ": no registry knows `" << tag << "`; see docs/testing.md";
}

TEST(Tags, EachOneThatIsRequiredIsKnown) {
    for (const RepositoryFile& file : repository_files({"tests/cases"}, {"/required_tags.txt"}))
        for (const std::string_view line : lines_of(file.text)) {
            const std::string tag(line.substr(0, line.find(' ')));
            EXPECT_TRUE(tag.empty() || tag == "#" || known_tags().contains(tag)) << tag;
        }
}

} // namespace
} // namespace iecfront::test
