#include "support/case_coverage.hpp"
#include "support/case_file.hpp"
#include "support/case_outcome.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/lexer/token.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace iecfront::test {
namespace {

TEST(AnnexD, ValuesAreThoseOfTheCode) {
    const AnnexDParameter* const length = find_parameter(DiagnosticId::identifier_too_long);
    ASSERT_NE(length, nullptr);
    EXPECT_TRUE(value_of(*length).starts_with("4096 bytes, all of them significant, set by "));
    EXPECT_EQ(length->number, ParseOptions().maximum_identifier_length);
    const AnnexDParameter* const literal = find_parameter(DiagnosticId::text_too_long);
    ASSERT_NE(literal, nullptr);
    EXPECT_EQ(literal->number, Token::maximum_length);
    const AnnexDParameter* const nesting = find_parameter(DiagnosticId::nesting_too_deep);
    ASSERT_NE(nesting, nullptr);
    EXPECT_EQ(nesting->number, ParseOptions().maximum_nesting);
    const AnnexDParameter* const size = find_parameter(DiagnosticId::source_too_large);
    ASSERT_NE(size, nullptr);
    EXPECT_EQ(size->number, ParseOptions().maximum_source_size);
}

TEST(AnnexD, EachLimitHasItsParameter) {
    for (const DiagnosticInfo& info : diagnostic_catalogue())
        EXPECT_EQ(find_parameter(info.id) != nullptr,
                  info.category == DiagnosticClass::limit ||
                      info.category == DiagnosticClass::implementation_dependent)
            << info.name;
    EXPECT_EQ(find_parameter(DiagnosticId::nesting_too_deep)->parameter, "length of expressions");
}

TEST(AnnexD, EveryValueIsComplete) {
    for (const AnnexDParameter& parameter : annex_d()) {
        EXPECT_EQ(value_of(parameter).find('{'), std::string::npos) << parameter.parameter;
        EXPECT_EQ(parameter.number != 0, parameter.value.find("{0}") != std::string_view::npos)
            << parameter.parameter;
    }
}

TEST(AnnexD, ALimitHasACaseAtItAndOneBeyond) {
    for (const AnnexDParameter& parameter : annex_d()) {
        if (!parameter.diagnostic || !tested_elsewhere(*parameter.diagnostic).empty())
            continue;
        const DiagnosticInfo& info = diagnostic_info(*parameter.diagnostic);
        if (info.category != DiagnosticClass::limit)
            continue;
        const std::string tag = "Annex-D." + std::string(info.name);
        EXPECT_TRUE(has_reporting_case(tag, info.id)) << "nothing beyond the limit: " << tag;
        EXPECT_TRUE(has_silent_case(tag, info.id)) << "nothing at the limit: " << tag;
    }
}

/// A limit that is an option.
struct OptionalLimit {
    DiagnosticId id;
    std::uint32_t ParseOptions::*option;
};

constexpr OptionalLimit optional_limits[] = {
    {DiagnosticId::nesting_too_deep, &ParseOptions::maximum_nesting},
    {DiagnosticId::identifier_too_long, &ParseOptions::maximum_identifier_length},
    {DiagnosticId::too_many_diagnostics, &ParseOptions::maximum_diagnostics},
    {DiagnosticId::unit_too_large, &ParseOptions::maximum_unit_memory},
};

[[nodiscard]] bool is_hit(const Case& one, const OptionalLimit& limit, int more) {
    ParseOptions options = options_of(one);
    options.*limit.option += static_cast<std::uint32_t>(more);
    const SyntaxTree tree = parse(source_text_of(one), options);
    return std::ranges::any_of(tree.diagnostics(),
                               [&](const Diagnostic& found) { return found.id == limit.id; });
}

// Some case is exactly at the limit, and some one beyond.
TEST(AnnexD, CasesOfALimitStandAtIt) {
    for (const OptionalLimit& limit : optional_limits) {
        const std::string tag = "Annex-D." + std::string(diagnostic_info(limit.id).name);
        bool at = false;
        bool beyond = false;
        for (const CaseFile& file : all_case_files())
            for (const Case& one : file.cases) {
                if (std::ranges::find(one.tags, tag) == one.tags.end())
                    continue;
                const bool hit = is_hit(one, limit, 0);
                at = at || (!hit && is_hit(one, limit, -1));
                beyond = beyond || (hit && !is_hit(one, limit, 1));
            }
        EXPECT_TRUE(at) << tag;
        EXPECT_TRUE(beyond) << tag;
    }
}

} // namespace
} // namespace iecfront::test
