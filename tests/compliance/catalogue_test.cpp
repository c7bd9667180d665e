#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/compliance/annex_e.hpp>
#include <iecfront/compliance/extensions.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>

#include <algorithm>
#include <gtest/gtest.h>

// Each diagnostic states one thing: a rule of the standard, an error condition of Annex E, the use
// of an extension, reliance on a parameter of Annex D, or a limit that Annex D lets a system have.

namespace iecfront::test {
namespace {

[[nodiscard]] bool is_of_annex_d(const DiagnosticInfo& info) {
    return std::ranges::any_of(annex_d(), [&](const AnnexDParameter& parameter) {
        return parameter.diagnostic == info.id && parameter.subclause == info.clause;
    });
}

[[nodiscard]] bool is_reported_error(const DiagnosticInfo& info) {
    return std::ranges::any_of(annex_e(), [&](const AnnexEError& error) {
        return error.row == info.annex_e_row && error.subclause == info.clause;
    });
}

TEST(Catalogue, EachDiagnosticIsOfTheRegistryOfItsClassAndOfNoOther) {
    for (const DiagnosticInfo& info : diagnostic_catalogue()) {
        const bool by_annex_d = info.category == DiagnosticClass::implementation_dependent ||
                                info.category == DiagnosticClass::limit;
        EXPECT_EQ(is_of_annex_d(info), by_annex_d) << info.name;
        EXPECT_EQ(is_reported_error(info), info.category == DiagnosticClass::error) << info.name;
        // An error of Annex E may be taken for an extension as well: nested comments.
        EXPECT_EQ(find_extension(info.id) != nullptr, info.category == DiagnosticClass::extension ||
                                                          info.id == DiagnosticId::nested_comment)
            << info.name;
        EXPECT_FALSE(info.clause.empty()) << info.name;
    }
}

} // namespace
} // namespace iecfront::test
