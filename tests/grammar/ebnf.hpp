#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// Reads the formal syntax that stands in docs/grammar.md; "Notation" there says what is what.
namespace iecfront::test {

/// A part of a production.
struct Expression {
    enum class Kind {
        nothing,      ///< `NIL`
        terminal,     ///< `"text"`, `'text'`
        described,    ///< `<text>`
        line_end,     ///< `EOL`
        name,         ///< what the production with this name derives
        sequence,     ///< `a b`
        alternatives, ///< `a | b`
        option,       ///< `[ a ]`
        repetition,   ///< `{ a }`
    };

    Kind kind = Kind::nothing;
    std::string text;           ///< of a terminal, description or name
    std::size_t production = 0; ///< of a name: its place in `Grammar::productions`
    std::size_t number = 0;     ///< counts all expressions of the grammar
    std::vector<Expression> parts;
};

struct Production {
    std::string name;
    std::string text;    ///< as it stands there, each run of white space made one blank
    std::string heading; ///< the one it stands under, without the number signs
    Expression body;

    /// True when it makes tokens: its parts adjoin.
    [[nodiscard]] bool lexical() const { return heading.ends_with("(lexical)"); }
    /// True for Instruction List, where line ends count.
    [[nodiscard]] bool by_line() const { return heading.starts_with("B.2."); }
};

struct Grammar {
    std::vector<Production> productions; ///< in the order of the document
    std::size_t expression_count = 0;
    std::vector<std::string> faults; ///< what is wrong with the document

    /// Null when there is none.
    [[nodiscard]] const Production* find(std::string_view name) const;
};

/// The productions in the blocks of the Markdown text `document` that are marked `mark`.
[[nodiscard]] Grammar read_grammar(std::string_view document, std::string_view mark = "ebnf");

/// An extension: the productions that it has in the place of others.
struct GrammarExtension {
    std::string name; ///< `line-comment`
    std::string code; ///< `IEC5001`
    std::vector<Production> productions;
};

/// What the blocks of `document` that are marked `ebnf-extension` say, each under a heading
/// `name (code)`. What cannot be read goes to `faults`.
[[nodiscard]] std::vector<GrammarExtension> read_extensions(std::string_view document,
                                                            std::vector<std::string>& faults);

/// The grammar of the blocks marked `ebnf`, with an extension.
[[nodiscard]] Grammar extended_grammar(std::string_view document,
                                       const GrammarExtension& extension);

/// Calls `visit(const Expression&)` for `expression` and all its parts.
template<class Visit>
void for_each_expression(const Expression& expression, Visit&& visit) {
    visit(expression);
    for (const Expression& part : expression.parts)
        for_each_expression(part, visit);
}

} // namespace iecfront::test
