#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/builder/part.hpp>
#include <iecfront/export.hpp>
#include <iecfront/source/text_range.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace iecfront::build {

/// What can stand in the place of a `Kind`: any expression for an expression, any statement for a
/// statement, any argument for an argument.
template<class Kind>
struct Place {
    static auto find() {
        using std::type_identity;
        if constexpr (std::same_as<Kind, ast::VariableDeclarations>)
            return type_identity<Kind>();
        else if constexpr (std::derived_from<Kind, ast::Expression>)
            return type_identity<ast::Expression>();
        else if constexpr (std::derived_from<Kind, ast::Statement>)
            return type_identity<ast::Statement>();
        else if constexpr (std::derived_from<Kind, ast::TypeSpecification>)
            return type_identity<ast::TypeSpecification>();
        else if constexpr (std::derived_from<Kind, ast::LibraryElement>)
            return type_identity<ast::LibraryElement>();
        else if constexpr (std::derived_from<Kind, ast::IlOperation>)
            return type_identity<ast::IlOperation>();
        else if constexpr (stands_for<Kind, AnyArgument>)
            return type_identity<AnyArgument>();
        else if constexpr (stands_for<Kind, AnyChartElement>)
            return type_identity<AnyChartElement>();
        else if constexpr (stands_for<Kind, AnyProgConfElement>)
            return type_identity<AnyProgConfElement>();
        else if constexpr (stands_for<Kind, AnyConfigurationElement>)
            return type_identity<AnyConfigurationElement>();
        else
            return type_identity<Kind>();
    }
    using Category = typename decltype(find())::type;
};
/// A part that can stand where a `Kind` stands.
template<class Kind>
using PartFor = Part<typename Place<Kind>::Category>;

namespace detail {
// What is taken out.
struct Removal {
    SyntaxTree::Slot slot;
    const ast::Node* node;
};
} // namespace detail

/// Changes to a tree, collected and then made together. The tree itself stays as it is, and the
/// changed one shares all units with it that no change touches.
///
/// Nodes belong to the tree, and `slot` to their unit. What is put in keeps to the indentation of
/// its place, and comments stay where they are; `format` lays out the whole. Of several things put
/// in at one place, the first stands first.
class IECFRONT_API Changes {
public:
    explicit Changes(SyntaxTree tree) : tree_(std::move(tree)) {}

    /// Puts `part` in the place of `node`. An expression comes into parentheses where the operator
    /// that it becomes an operand of needs them.
    template<class Kind>
    void replace(const SyntaxTree::Slot& slot, const Kind& node, const PartFor<Kind>& part) {
        replace_node(slot, node, part);
    }

    /// Puts `part` before `node`, an element of a list, with the comments above it: on a line of
    /// its own, or with a comma between the two.
    template<class Kind>
    void insert_before(const SyntaxTree::Slot& slot, const Kind& node, const PartFor<Kind>& part) {
        insert_before_node(slot, node, part);
    }
    /// Puts `part` behind `node`, an element of a list, and the comments behind it.
    template<class Kind>
    void insert_after(const SyntaxTree::Slot& slot, const Kind& node, const PartFor<Kind>& part) {
        insert_after_node(slot, node, part);
    }

    /// Puts a statement behind the last one of a list.
    void append(const SyntaxTree::Slot& slot, const ast::StatementList& list,
                const Statement& statement);
    /// Puts a declaration behind the last one of a block.
    void append(const SyntaxTree::Slot& slot, const ast::VariableDeclarations& block,
                const Declaration& declaration);
    /// Puts a block of variables behind the last one of a program organization unit.
    void append(const SyntaxTree::Slot& slot, const ast::FunctionDeclaration& function,
                const Part<ast::VariableDeclarations>& block);
    void append(const SyntaxTree::Slot& slot, const ast::FunctionBlockDeclaration& function_block,
                const Part<ast::VariableDeclarations>& block);
    void append(const SyntaxTree::Slot& slot, const ast::ProgramDeclaration& program,
                const Part<ast::VariableDeclarations>& block);

    /// Takes an element out of its list, with the `;` or the comma that goes with it. When all
    /// declarations of a block of variables or types go, the block goes with them; when all
    /// statements of a list go, a `;` stays. What is put in beside the element, before or later,
    /// comes into its place. Comments stay.
    void remove(const SyntaxTree::Slot& slot, const ast::Node& node);

    /// What is wrong: the first fault of a part; a character that the encoding of the tree lacks;
    /// a node that is no element of a list, where one is needed; a slot of another tree; two
    /// changes of the same place. Empty when all is well.
    [[nodiscard]] std::string fault() const;
    /// The changes as edits of the file, by their place; for an editor that makes them itself.
    [[nodiscard]] std::vector<TextEdit> edits() const;
    /// The changed tree. Nothing when there is a `fault`.
    [[nodiscard]] std::optional<SyntaxTree> tree() const;

private:
    void replace_node(const SyntaxTree::Slot& slot, const ast::Node& node, const AnyPart& part);
    void insert_before_node(const SyntaxTree::Slot& slot, const ast::Node& node,
                            const AnyPart& part);
    void insert_after_node(const SyntaxTree::Slot& slot, const ast::Node& node,
                           const AnyPart& part);
    void insert_line_behind(const SyntaxTree::Slot& slot, const ast::Node& node,
                            std::uint32_t offset, const AnyPart& part,
                            std::string_view further = {});
    void append_block(const SyntaxTree::Slot& slot,
                      const ast::List<ast::VariableDeclarations>& blocks, const ast::Node& head,
                      const AnyPart& block);
    void insert_behind_comments(const SyntaxTree::Slot& slot, const ast::Node& node,
                                std::uint32_t end, const AnyPart& part);
    void append_to_empty(const SyntaxTree::Slot& slot, const ast::Node& empty,
                         const AnyPart& statement);
    void put_beside(const SyntaxTree::Slot& slot, const ast::Node& node);
    bool require_own(const SyntaxTree::Slot& slot);
    bool require_element(const SyntaxTree::Slot& slot, const ast::Node& node);
    void edit(const SyntaxTree::Slot& slot, TextRange range, std::string_view replacement);

    SyntaxTree tree_;
    std::string fault_;
    std::vector<TextEdit> edits_; // that put something in, as they came
    std::vector<detail::Removal> removals_;
    std::vector<const ast::Node*> accompanied_; // what something was put in beside
};

} // namespace iecfront::build
