#include "support/case_coverage.hpp"
#include "support/case_file.hpp"
#include "support/case_outcome.hpp"

#include <iecfront/ast/visitor.hpp>
#include <iecfront/compliance/extensions.hpp>
#include <iecfront/diagnostics/render_text.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace iecfront::test {
namespace {

TEST(Extensions, EachHasACaseThatReportsIt) {
    for (const Extension& extension : extensions())
        EXPECT_TRUE(is_reported(extension.diagnostic))
            << diagnostic_info(extension.diagnostic).name;
}

TEST(Extensions, EachIsSetByItsName) {
    for (const Extension& extension : extensions()) {
        SeverityPolicy policy;
        const DiagnosticInfo& row = diagnostic_info(extension.diagnostic);
        EXPECT_EQ(policy.severity(extension.diagnostic), row.default_severity);
        for (const Severity severity : {Severity::allow, Severity::warning, Severity::error}) {
            EXPECT_TRUE(policy.set(diagnostic_info(extension.diagnostic).name, severity));
            EXPECT_EQ(policy.severity(extension.diagnostic), severity);
        }
    }
}

// Of each extension, the cases in which nothing else is reported.
[[nodiscard]] std::map<DiagnosticId, std::vector<SyntaxTree>> uses_alone() {
    std::map<DiagnosticId, std::vector<SyntaxTree>> uses;
    for (const CaseFile& file : all_case_files())
        for (const Case& one : file.cases) {
            SyntaxTree tree = parse(source_text_of(one), options_of(one));
            std::set<DiagnosticId> found;
            for (const Diagnostic& diagnostic : tree.diagnostics())
                found.insert(diagnostic.id);
            if (found.size() > 1)
                found.erase(DiagnosticId::function_without_input); // silent by default
            if (found.size() == 1)
                uses[*found.begin()].push_back(std::move(tree));
        }
    return uses;
}

// A node of something that may be left out is missing, but no error.
[[nodiscard]] bool has_error_nodes(const SyntaxTree& tree) {
    using ast::NodeKind;
    static constexpr NodeKind kinds[] = {NodeKind::error_declaration,  NodeKind::error_expression,
                                         NodeKind::error_statement,    NodeKind::error_type,
                                         NodeKind::il_error_operation, NodeKind::skipped_text};
    bool found = false;
    for (const SyntaxTree::Slot& slot : tree.slots())
        ast::walk(slot.unit->root(), [&](const ast::Node& node) {
            found =
                found || (!node.missing && std::ranges::find(kinds, node.kind) != std::end(kinds));
            return ast::Walk::into;
        });
    return found;
}

// Of these it is known what they are, and their text is kept.
constexpr DiagnosticId only_recognised[] = {DiagnosticId::foreign_construct,
                                            DiagnosticId::pointer_type};

// 1.5.1 e) and f)
TEST(Extensions, EachIsRejectedWarnedOfAndTaken) {
    const auto uses = uses_alone();
    for (const Extension& extension : extensions()) {
        const DiagnosticInfo& row = diagnostic_info(extension.diagnostic);
        const auto found = uses.find(extension.diagnostic);
        if (found == uses.end()) {
            ADD_FAILURE() << "no case has nothing but " << row.name;
            continue;
        }
        bool whole = false;
        for (const SyntaxTree& tree : found->second) {
            const std::vector<Diagnostic> reports = tree.diagnostics();
            SeverityPolicy policy;
            const auto text = [&] { return render_text(reports, tree.source(), policy); };
            policy.set(extension.diagnostic, Severity::error);
            EXPECT_EQ(determine(reports, policy), Determination::violations) << row.name;
            EXPECT_NE(text().find(": error " + code_string(row.id)), std::string::npos);
            EXPECT_NE(text().find("`--allow " + std::string(row.name) + "` takes this extension"),
                      std::string::npos)
                << row.name;
            policy.set(extension.diagnostic, Severity::warning);
            EXPECT_NE(text().find(": warning " + code_string(row.id)), std::string::npos);
            EXPECT_EQ(determine(reports, policy) == Determination::violations,
                      row.category == DiagnosticClass::error)
                << row.name;
            policy.set(extension.diagnostic, Severity::allow);
            EXPECT_EQ(text().find(code_string(row.id)), std::string::npos);
            EXPECT_NE(determine(reports, policy), Determination::violations) << row.name;
            whole = whole || !has_error_nodes(tree);
        }
        EXPECT_TRUE(whole ||
                    std::ranges::find(only_recognised, row.id) != std::end(only_recognised))
            << row.name;
    }
}

TEST(Extensions, AreFoundByTheirDiagnostic) {
    for (const Extension& extension : extensions())
        EXPECT_EQ(find_extension(extension.diagnostic), &extension);
    EXPECT_EQ(find_extension(DiagnosticId::missing_semicolon), nullptr);
}

} // namespace
} // namespace iecfront::test
