#include "support/case_coverage.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/lexer/token.hpp>

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace iecfront::test {
namespace {

[[nodiscard]] const AnnexDParameter* find_parameter(DiagnosticId id) {
    const auto found = std::ranges::find(annex_d(), id, &AnnexDParameter::diagnostic);
    return found == annex_d().end() ? nullptr : &*found;
}

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

} // namespace
} // namespace iecfront::test
