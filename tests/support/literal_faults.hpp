#pragma once

#include <iecfront/lexer/literals.hpp>

#include <ostream>
#include <string>
#include <string_view>

// What the tests of literals share.
namespace iecfront::tests {

// A literal, its faults as `1302@2..3 5003@0..4`, and what its fix-its make of it ("" when there is
// none).
struct LiteralCase {
    TokenKind kind;
    std::string_view text;
    std::string_view faults;
    std::string_view fixed = {};
};

inline std::ostream& operator<<(std::ostream& out, const LiteralCase& literal) {
    return out << '`' << literal.text << '`';
}

[[nodiscard]] std::string faults_of(TokenKind kind, std::string_view text,
                                    Encoding encoding = Encoding::utf8);

// The text with the first fix of each fault applied.
[[nodiscard]] std::string with_fixes(TokenKind kind, std::string_view text,
                                     Encoding encoding = Encoding::utf8);

// Whether the value function of the kind gives one.
[[nodiscard]] bool has_value(TokenKind kind, std::string_view text,
                             Encoding encoding = Encoding::utf8);

// What holds for every text: faults are ordered and lie inside, fix-its do not overlap, and no
// value comes of a violation, except for one that its `overflow` tells of.
void expect_invariants(TokenKind kind, std::string_view text, Encoding encoding = Encoding::utf8);

// The faults and the fixed text of the case are as said; fixed faults are gone. And the lexer makes
// one token of the text and reports these faults (clause 2.2), but for the exceptions in the
// source.
void expect_faults(const LiteralCase& literal);

} // namespace iecfront::tests
