#pragma once

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/source/text_range.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace iecfront::test {

/// What a fault did to the tree of a text.
struct Outcome {
    std::vector<Diagnostic> reports; ///< those that are not allowed by default
    bool located = false; ///< a report lies on the line of the fault, or at the token before it
    std::size_t other_statements = 0; ///< outside the statement that encloses the fault
    std::size_t equal_statements = 0; ///< of these, with an equal subtree in the same place
    std::size_t other_units = 0;      ///< that the edit does not touch
    std::size_t equal_units = 0;
};

/// A valid text, ready to be compared with faulty versions of it.
class ValidText {
public:
    explicit ValidText(SyntaxTree tree);

    [[nodiscard]] const SyntaxTree& tree() const noexcept { return tree_; }
    [[nodiscard]] Outcome outcome_of(const TextEdit& fault) const;

private:
    struct StatementPlace {
        const ast::Node* node;
        TextRange range; ///< in the file, with the `;` behind it
        std::size_t end; ///< index behind its last descendant
    };
    struct UnitStatements {
        std::vector<StatementPlace> statements; ///< in preorder
        std::vector<std::string> trees;         ///< their S-expressions
    };

    [[nodiscard]] static UnitStatements statements_of(const SyntaxTree::Slot& slot);
    [[nodiscard]] bool is_located(const SyntaxTree& faulty, const TextEdit& fault,
                                  const std::vector<Diagnostic>& reports) const;
    void compare_statements(const UnitStatements& unit, const SyntaxTree& faulty,
                            const TextEdit& fault, Outcome& outcome) const;

    SyntaxTree tree_;
    std::vector<UnitStatements> units_;
};

/// The findings of `tree` that are reported by default.
[[nodiscard]] std::vector<Diagnostic> reports_of(const SyntaxTree& tree);

} // namespace iecfront::test
