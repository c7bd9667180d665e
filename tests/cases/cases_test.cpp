#include "support/case_file.hpp"
#include "support/case_outcome.hpp"
#include "support/invariants.hpp"
#include "support/line_diff.hpp"

#include <iecfront/ast/dump.hpp>
#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/parser/parse.hpp>
#include <iecfront/source/encoding.hpp>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <string_view>

// Runs the case files, tests/cases/<group>/<topic>.txt, each of them as one test. With
// UPDATE_EXPECT=1 in the environment the expectations in the source tree are rewritten instead.

namespace iecfront::test {
namespace {

[[nodiscard]] bool updating() {
    const char* const update = std::getenv("UPDATE_EXPECT");
    return update != nullptr && std::string_view(update) == "1";
}

/// Checks one case, and reports at the line of its title.
class Checker {
public:
    Checker(const CaseFile& file, const Case& one) : file_(file), case_(one) {}

    void check(const CaseOutcome& outcome) {
        check_header();
        if (!updating())
            check_sections(outcome);
        check_fixes(outcome);
    }

private:
    void fail(std::string_view what, std::string_view details = {}) {
        const std::string path = std::string(IECFRONT_SOURCE_DIR) + '/' + file_.path;
        ADD_FAILURE_AT(path.c_str(), static_cast<int>(case_.line))
            << case_.title << ": " << what << '\n'
            << details;
    }

    void check_header() {
        if (case_.tags.empty())
            fail("the case has no tags");
        if (!case_.encoding.empty() && !encoding_from_string(case_.encoding))
            fail("the encoding is not known");
        for (const std::string& what : case_.report)
            if (SeverityPolicy policy; !policy.set(what, Severity::warning))
                fail("`: report " + what + "` names nothing");
    }

    void check_sections(const CaseOutcome& outcome) {
        compare("diagnostics", outcome.diagnostics);
        if (case_.find("tree") != nullptr)
            compare("tree", outcome.tree);
        if (case_.find("fixed") != nullptr)
            compare("fixed", outcome.fixed);
    }

    void compare(std::string_view section, std::string_view actual) {
        const std::string expected = trimmed(case_.expected(section));
        const std::string found = trimmed(actual);
        if (expected != found)
            fail(std::string(section) + " differ (- expected, + found)",
                 line_diff(expected, found));
    }

    void check_fixes(const CaseOutcome& outcome) {
        const bool leaves =
            outcome.fixable && (outcome.fixes_overlap || !outcome.left_in_fixed.empty());
        if (leaves && !case_.fixes_leave)
            fail(outcome.fixes_overlap ? "the fixes overlap" : "the fixes leave faults",
                 outcome.left_in_fixed + "in\n" + outcome.fixed);
        if (!leaves && case_.fixes_leave)
            fail("`: fixes-leave` is not needed");
        if (case_.fixes_leave && case_.fixes_leave->empty())
            fail("`: fixes-leave` needs a reason");
    }

    const CaseFile& file_;
    const Case& case_;
};

void update(CaseFile file) {
    const std::string before = write_case_file(file);
    for (Case& one : file.cases) {
        const CaseOutcome outcome = run_case(one);
        one.set_diagnostics(outcome.diagnostics);
        one.replace("tree", trimmed(outcome.tree));
        one.replace("fixed", trimmed(outcome.fixed));
    }
    const std::string after = write_case_file(file);
    if (after != before)
        std::ofstream(std::string(IECFRONT_SOURCE_DIR) + '/' + file.path, std::ios::binary)
            << after;
}

/// `tests/cases/st/expressions.txt` as `st_expressions`.
[[nodiscard]] std::string test_name(const CaseFile& file) {
    constexpr std::string_view folder = "tests/cases/";
    std::string name = file.path.substr(folder.size());
    name.erase(name.rfind('.'));
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0)
            c = '_';
    return name;
}

class Cases : public testing::TestWithParam<CaseFile> {};

TEST_P(Cases, AreAsExpected) {
    const CaseFile& file = GetParam();
    for (const std::string& fault : file.faults)
        ADD_FAILURE() << fault;
    if (HasFailure())
        return;
    if (updating())
        update(file);
    for (const Case& one : file.cases)
        Checker(file, one).check(run_case(one));
}

TEST_P(Cases, HoldWhatMustAlwaysHold) {
    for (const Case& one : GetParam().cases)
        expect_invariants(source_text_of(one), options_of(one));
}

/// True when what stands behind `tree` is a declaration of its own.
[[nodiscard]] bool is_closed(const SyntaxTree& tree) {
    const Unit& last = *tree.slots().back().unit;
    if (last.depends_on_rest() || last.tokens().empty())
        return false;
    switch (last.tokens().back().kind()) {
    case TokenKind::kw_end_type:
    case TokenKind::kw_end_function:
    case TokenKind::kw_end_function_block:
    case TokenKind::kw_end_program:
    case TokenKind::kw_end_configuration: return true;
    default: return false;
    }
}

/// B.0: what is wrong in a declaration stays in it. The one before it and, where it is closed, the
/// one behind it are read as if they stood alone.
TEST_P(Cases, KeepTheirFaultsToThemselves) {
    const std::string good =
        "FUNCTION good : INT\nVAR_INPUT a : INT; END_VAR\n    good := a;\nEND_FUNCTION";
    const SyntaxTree alone = parse(SourceText(good));
    const Unit& expected = *alone.slots().front().unit;
    const auto expect_good = [&](const SyntaxTree::Slot& slot, const Case& one) {
        const Unit& unit = *slot.unit;
        const std::size_t begin = unit.text().find(expected.text());
        ASSERT_NE(begin, std::string_view::npos) << one.title;
        for (const Diagnostic& found : unit.diagnostics()) // else it is about what is around it
            EXPECT_TRUE(found.range.begin < begin ||
                        found.range.begin >= begin + expected.text().size())
                << one.title;
        EXPECT_EQ(s_expression(unit, *unit.root().elements.front()),
                  s_expression(expected, *expected.root().elements.front()))
            << one.title;
    };
    for (const Case& one : GetParam().cases) {
        const std::string source = "\n" + one.source();
        expect_good(parse(SourceText(good + source)).slots().front(), one);
        if (is_closed(parse(SourceText(source))))
            expect_good(parse(SourceText(source + "\n" + good)).slots().back(), one);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Cases, testing::ValuesIn(all_case_files()),
                         [](const auto& one) { return test_name(one.param); });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Cases);

} // namespace

/// What googletest prints for the parameter of a test.
void PrintTo(const CaseFile& file, std::ostream* out) {
    *out << file.path;
}

} // namespace iecfront::test
