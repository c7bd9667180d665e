#include "support/literal_faults.hpp"

#include "support/lexed.hpp"
#include "support/literal_invariants.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace iecfront::tests {

namespace {

std::string applied(std::string_view text, const std::vector<TextEdit>& edits) {
    std::string result;
    std::uint32_t at = 0;
    for (const TextEdit& edit : edits) {
        result += text.substr(at, edit.range.begin - at);
        result += edit.replacement;
        at = edit.range.end;
    }
    return result + std::string(text.substr(at));
}

bool contains(const std::vector<Diagnostic>& faults, DiagnosticId id) {
    return std::any_of(faults.begin(), faults.end(),
                       [&](const Diagnostic& fault) { return fault.id == id; });
}

// A malformed literal that is deliberately not what `expect_lexed_alike` demands.
struct LexedOtherwise {
    std::string_view text;
    std::string_view tokens;
    std::string_view faults;
    std::string_view why;
};

constexpr std::array lexed_otherwise = {
    LexedOtherwise{"12ab", "identifier!(12ab)", "1105@0..2", "rather a name than a number"},
    LexedOtherwise{"12_ab", "identifier!(12_ab)", "1105@0..2", "rather a name than a number"},
    LexedOtherwise{"%IX1*", "direct_variable(%IX1) star(*)", "", "`%IX1*2` is a product"},
};

// The lexer makes one token of the whole literal, and reports what the literal's own check does.
void expect_lexed_alike(const LiteralCase& literal) {
    const auto* const otherwise =
        std::ranges::find(lexed_otherwise, literal.text, &LexedOtherwise::text);
    if (otherwise != lexed_otherwise.end()) {
        EXPECT_EQ(test::tokens(literal.text), otherwise->tokens) << otherwise->why;
        EXPECT_EQ(test::faults(literal.text), otherwise->faults) << otherwise->why;
        return;
    }
    const std::string tokens = test::tokens(literal.text);
    const std::string whole = "(" + std::string(literal.text) + ")";
    EXPECT_TRUE(tokens.ends_with(whole) && tokens.find('(') == tokens.size() - whole.size())
        << tokens;
    EXPECT_EQ(test::faults(literal.text), literal.faults);
}

} // namespace

std::string faults_of(TokenKind kind, std::string_view text, Encoding encoding) {
    std::string result;
    for (const Diagnostic& fault : check_literal(kind, text, encoding)) {
        if (!result.empty())
            result += ' ';
        result += std::to_string(diagnostic_info(fault.id).code) + '@' +
                  std::to_string(fault.range.begin) + ".." + std::to_string(fault.range.end);
    }
    return result;
}

bool has_value(TokenKind kind, std::string_view text, Encoding encoding) {
    return test::has_value(kind, text, encoding);
}

std::string with_fixes(TokenKind kind, std::string_view text, Encoding encoding) {
    return applied(text, test::first_fixes(check_literal(kind, text, encoding)));
}

void expect_invariants(TokenKind kind, std::string_view text, Encoding encoding) {
    EXPECT_EQ(test::literal_fault(kind, text, encoding), "") << text;
}

void expect_faults(const LiteralCase& literal) {
    SCOPED_TRACE(testing::Message() << literal);
    expect_invariants(literal.kind, literal.text);
    EXPECT_EQ(faults_of(literal.kind, literal.text), literal.faults);
    expect_lexed_alike(literal);
    const std::string fixed = with_fixes(literal.kind, literal.text);
    EXPECT_EQ(fixed, literal.fixed.empty() ? literal.text : literal.fixed);
    const auto after = check_literal(literal.kind, fixed, Encoding::utf8);
    for (const Diagnostic& fault : check_literal(literal.kind, literal.text, Encoding::utf8)) {
        EXPECT_FALSE(!fault.fixes.empty() && contains(after, fault.id)) << fixed;
    }
}

} // namespace iecfront::tests
