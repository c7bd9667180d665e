#include "support/literal_faults.hpp"

#include "support/lexed.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace iecfront::tests {

namespace {

// The first fix of each diagnostic, all together, by position.
std::vector<TextEdit> edits_of(const std::vector<Diagnostic>& faults) {
    std::vector<TextEdit> edits;
    for (const Diagnostic& fault : faults)
        if (!fault.fixes.empty())
            edits.insert(edits.end(), fault.fixes.front().edits.begin(),
                         fault.fixes.front().edits.end());
    std::stable_sort(edits.begin(), edits.end(), [](const TextEdit& a, const TextEdit& b) {
        return a.range.begin < b.range.begin;
    });
    return edits;
}

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

bool takes_value(const Diagnostic& fault) {
    const DiagnosticClass category = diagnostic_info(fault.id).category;
    return category == DiagnosticClass::violation && fault.id != DiagnosticId::integer_too_large &&
           fault.id != DiagnosticId::real_out_of_range;
}

bool contains(const std::vector<Diagnostic>& faults, DiagnosticId id) {
    return std::any_of(faults.begin(), faults.end(),
                       [&](const Diagnostic& fault) { return fault.id == id; });
}

bool is_inside(TextRange range, std::string_view text) {
    return range.begin <= range.end && range.end <= text.size();
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

std::string with_fixes(TokenKind kind, std::string_view text, Encoding encoding) {
    return applied(text, edits_of(check_literal(kind, text, encoding)));
}

bool has_value(TokenKind kind, std::string_view text, Encoding encoding) {
    switch (kind) {
    case TokenKind::single_byte_string:
    case TokenKind::double_byte_string: return string_value(text, encoding).has_value();
    case TokenKind::duration: return duration_value(text).has_value();
    case TokenKind::date: return date_value(text).has_value();
    case TokenKind::time_of_day: return time_of_day_value(text).has_value();
    case TokenKind::date_and_time: return date_and_time_value(text).has_value();
    case TokenKind::direct_variable:
    case TokenKind::incomplete_location: return direct_variable_value(text).has_value();
    case TokenKind::typed_literal:
        if (string_value(text, encoding) || duration_value(text) || date_value(text) ||
            time_of_day_value(text) || date_and_time_value(text))
            return true;
        [[fallthrough]];
    default: return integer_value(text).has_value() || real_value(text).has_value();
    }
}

void expect_invariants(TokenKind kind, std::string_view text, Encoding encoding) {
    const std::vector<Diagnostic> faults = check_literal(kind, text, encoding);
    for (std::size_t i = 0; i < faults.size(); ++i) {
        EXPECT_TRUE(is_inside(faults[i].range, text)) << text;
        EXPECT_TRUE(i == 0 || faults[i - 1].range.begin <= faults[i].range.begin) << text;
        EXPECT_FALSE(message(faults[i], encoding).empty());
        for (const DiagnosticLabel& label : faults[i].labels)
            EXPECT_TRUE(is_inside(label.range, text)) << text;
        for (const DiagnosticFix& fix : faults[i].fixes)
            for (const TextEdit& edit : fix.edits)
                EXPECT_TRUE(is_inside(edit.range, text)) << text;
    }
    const std::vector<TextEdit> edits = edits_of(faults);
    for (std::size_t i = 1; i < edits.size(); ++i)
        EXPECT_LE(edits[i - 1].range.end, edits[i].range.begin) << text;
    if (std::any_of(faults.begin(), faults.end(), takes_value)) {
        EXPECT_FALSE(has_value(kind, text, encoding)) << text;
    }
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
