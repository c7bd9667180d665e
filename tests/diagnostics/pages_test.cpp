#include "support/case_file.hpp"
#include "support/case_outcome.hpp"
#include "support/repository_files.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront {
namespace {

/// The text of each page in docs/diagnostics, by its code.
std::map<std::string, std::string> pages() {
    std::map<std::string, std::string> result;
    for (auto& file : test::repository_files({"docs/diagnostics"}, {".md"})) {
        const std::string name = file.path.substr(file.path.rfind('/') + 1);
        result[name.substr(0, name.find('.'))] = std::move(file.text);
    }
    return result;
}

/// An example of a page, read as a case: behind ```` ```iec ```` stand the lines that say how it is
/// read, with commas between. `beside CODE` is one of our own: another report that it gives.
struct Example {
    test::Case read;
    std::string beside;
};

/// The example below `heading`; nothing when there is no such heading.
std::optional<Example> example(const std::string& page, std::string_view heading) {
    const std::size_t section = page.find("\n## " + std::string(heading) + "\n");
    if (section == std::string::npos)
        return std::nullopt;
    const std::string_view fence = "```iec";
    const std::size_t settings = page.find(fence, section) + fence.size();
    const std::size_t begin = page.find('\n', settings) + 1;
    const std::string_view own = "beside ";
    Example example;
    std::string text = "=== " + std::string(heading) + "\n: tags 1.5.1\n";
    std::istringstream rest(page.substr(settings, begin - 1 - settings));
    for (std::string setting; std::getline(rest, setting, ',');) {
        setting.erase(0, setting.find_first_not_of(' '));
        if (setting.starts_with(own))
            example.beside = setting.substr(own.size());
        else
            text += ": " + setting + "\n";
    }
    text += page.substr(begin, page.find("\n```", begin) + 1 - begin);
    const test::CaseFile file = test::read_case_file("page", text);
    EXPECT_EQ(file.faults, std::vector<std::string>{}) << page.substr(0, page.find('\n'));
    example.read = file.cases.at(0);
    return example;
}

std::vector<DiagnosticId> reports(const Example& example) {
    std::vector<DiagnosticId> result;
    const SyntaxTree tree =
        parse(test::source_text_of(example.read), test::options_of(example.read));
    for (const Diagnostic& diagnostic : tree.diagnostics())
        result.push_back(diagnostic.id);
    return result;
}

// Limits of 4 GiB and 4 MiB, which no option lowers: what is beyond them fits no page.
constexpr std::string_view without_example[] = {"IEC9001", "IEC9003"};

TEST(Pages, ThereIsOneForEachDiagnosticAndNoOther) {
    auto rest = pages();
    for (const DiagnosticInfo& info : diagnostic_catalogue()) {
        const std::string code = code_string(info.id);
        ASSERT_TRUE(rest.contains(code)) << code;
        EXPECT_EQ(rest[code].substr(0, rest[code].find('\n')),
                  "# " + code + " " + std::string(info.name));
        const std::string row = info.annex_e_row == 0
                                    ? ""
                                    : " (row " + std::to_string(info.annex_e_row) + " of Annex E)";
        const std::string facts = "Class: " + std::string(to_string(info.category)) + row +
                                  ". Clause: " + std::string(info.clause) + ". Default severity: " +
                                  std::string(to_string(info.default_severity)) + ".";
        EXPECT_NE(rest[code].find(facts), std::string::npos) << code << ": " << facts;
        rest.erase(code);
    }
    for (const auto& [code, text] : rest)
        ADD_FAILURE() << "a page without a diagnostic: " << code;
}

TEST(Pages, TheWrongExampleGivesTheDiagnosticAlone) {
    for (const auto& [code, page] : pages()) {
        const bool exempt = std::ranges::find(without_example, code) != std::end(without_example);
        const std::optional<Example> wrong = example(page, "Wrong");
        EXPECT_EQ(!wrong, exempt) << code;
        if (!wrong)
            continue;
        bool found = false;
        for (const DiagnosticId id : reports(*wrong)) {
            const std::string other = code_string(id);
            found = found || other == code;
            EXPECT_TRUE(other == code || other == wrong->beside ||
                        diagnostic_info(id).default_severity == Severity::allow)
                << code << " gives " << other;
        }
        EXPECT_TRUE(found) << code;
    }
}

TEST(Pages, TheRightExampleGivesNoDiagnostic) {
    for (const auto& [code, page] : pages()) {
        const std::optional<Example> right = example(page, "Right");
        EXPECT_EQ(right.has_value(), example(page, "Wrong").has_value()) << code;
        if (!right)
            continue;
        for (const DiagnosticId id : reports(*right))
            EXPECT_EQ(SeverityPolicy().severity(id), Severity::allow)
                << code << " gives " << code_string(id);
    }
}

} // namespace
} // namespace iecfront
