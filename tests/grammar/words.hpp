#pragma once

#include "grammar/ebnf.hpp"

#include <set>
#include <string>
#include <string_view>

namespace iecfront::test {

/// Which words docs/grammar.md makes keywords, and which it reserves. All in upper case.
struct Words {
    std::set<std::string> keywords;
    std::set<std::string> standard_names; ///< terminals that name functions and function blocks
    std::set<std::string> il_operators;   ///< of B.2.2; no `il_function_name`

    /// `document` is the text that `grammar` was read from.
    Words(const Grammar& grammar, std::string_view document);

    [[nodiscard]] bool is_keyword(std::string_view word) const;
    /// Not for a name that the text declares (Annex C).
    [[nodiscard]] bool is_reserved(std::string_view word) const;
};

[[nodiscard]] std::string upper_case(std::string_view word);

/// Letters, digits and underscores make words.
[[nodiscard]] bool is_word_character(char c);

} // namespace iecfront::test
