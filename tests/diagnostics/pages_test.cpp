#include "support/repository_files.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
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

/// What stands between the fences below `heading`; empty when there is no such heading.
std::string block(const std::string& page, std::string_view heading) {
    const std::size_t section = page.find("\n## " + std::string(heading) + "\n");
    if (section == std::string::npos)
        return {};
    const std::string_view fence = "```iec\n";
    const std::size_t begin = page.find(fence, section) + fence.size();
    return page.substr(begin, page.find("\n```", begin) + 1 - begin);
}

std::vector<std::string> codes(const std::string& text) {
    std::vector<std::string> result;
    for (const Diagnostic& diagnostic : parse(SourceText(text)).diagnostics())
        result.push_back(code_string(diagnostic.id));
    return result;
}

// Diagnostics whose cause cannot be written on a page of ASCII text, or would fill it.
constexpr std::string_view without_example[] = {"IEC1001", "IEC1003", "IEC1406", "IEC1407",
                                                "IEC1409", "IEC9001", "IEC9002", "IEC9003",
                                                "IEC9009", "IEC9010"};

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
        const std::string wrong = block(page, "Wrong");
        EXPECT_EQ(wrong.empty(), exempt) << code;
        if (exempt)
            continue;
        const auto found = codes(wrong);
        EXPECT_FALSE(found.empty()) << code;
        for (const std::string& other : found)
            EXPECT_TRUE(other == code ||
                        find_diagnostic(other)->default_severity == Severity::allow)
                << code << " gives " << other;
    }
}

TEST(Pages, TheRightExampleGivesNoDiagnostic) {
    for (const auto& [code, page] : pages())
        for (const Diagnostic& found : parse(SourceText(block(page, "Right"))).diagnostics())
            EXPECT_EQ(SeverityPolicy().severity(found.id), Severity::allow)
                << code << " gives " << code_string(found.id);
}

} // namespace
} // namespace iecfront
