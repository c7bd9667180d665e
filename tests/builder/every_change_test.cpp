#include "support/case_file.hpp"
#include "support/case_outcome.hpp"

#include <iecfront/ast/visitor.hpp>
#include <iecfront/builder/builder.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>

// Changes at every node of every case: the changed tree is that of its text, and what is put into a
// text without findings gives another one.

namespace iecfront::test {
namespace {

using namespace build;

/// Makes one change after the other at a node, each to the tree as it was.
class ChangeTester : public ast::Visitor<ChangeTester> {
public:
    ChangeTester(const SyntaxTree& tree, const SyntaxTree::Slot& slot)
        : tree_(tree), slot_(slot), good_(tree.diagnostics().empty()) {}

    ast::Walk visit(const ast::Statement& node) {
        return around(node, assignment_statement(variable_name("zz"), integer_literal(1)));
    }
    ast::Walk visit(const ast::TypeDeclaration& node) {
        return around(node, type_declaration("zz", elementary_type_name("INT")));
    }
    ast::Walk visit(const ast::StructureElementDeclaration& node) {
        return around(node, structure_element_declaration("zz", elementary_type_name("INT")));
    }
    ast::Walk visit(const ast::EnumeratedValueDeclaration& node) {
        return around(node, enumerated_value_declaration("zz"));
    }
    ast::Walk visit(const ast::CaseElement& node) {
        return around(node, case_element({integer_literal(77)}, statement_list({})));
    }
    ast::Walk visit(const ast::IlInstruction& node) {
        return around(
            node, il_instruction(il_simple_operation(ast::IlOperator::add, {variable_name("zz")})));
    }
    ast::Walk visit(const ast::Step& node) { return around(node, step("zz")); }
    ast::Walk visit(const ast::Transition& node) { return around(node, step("zz")); }
    ast::Walk visit(const ast::Action& node) { return around(node, step("zz")); }
    ast::Walk visit(const ast::ActionAssociation& node) {
        return around(node, action_association("zz"));
    }
    ast::Walk visit(const ast::FunctionDeclaration& node) { return around(node, program_); }
    ast::Walk visit(const ast::FunctionBlockDeclaration& node) { return around(node, program_); }
    ast::Walk visit(const ast::ProgramDeclaration& node) { return around(node, program_); }
    ast::Walk visit(const ast::DataTypeDeclaration& node) { return around(node, program_); }
    ast::Walk visit(const ast::ConfigurationDeclaration& node) { return around(node, program_); }
    ast::Walk visit(const ast::ProgCnxn& node) {
        return around(node, prog_cnxn(variable_name("zz"), integer_literal(1)));
    }
    // Names do not stand together with places, nor what has a name with what has none; and in a
    // function block places are incomplete.
    ast::Walk visit(const ast::VariableDeclaration& node) {
        const bool alike = node.location == nullptr;
        return around(node, variable_declaration({"zz"}, elementary_type_name("INT")), alike);
    }
    ast::Walk visit(const ast::InputArgument& node) {
        if (node.name == nullptr)
            return around(node, variable_name("zz"));
        return around(node, input_argument("zz", variable_name("zz")));
    }
    ast::Walk visit(const ast::Expression& node) {
        const Expression sum =
            binary_expression(ast::BinaryOperator::add, variable_name("zz"), integer_literal(1));
        Changes changes(tree_);
        changes.replace(slot_, node, sum);
        if (changes.fault() == "`zz + 1` is no variable")
            replace(node, variable_name("zz"));
        else
            check(changes, false, node);
        return ast::Walk::into;
    }

private:
    template<class Kind>
    void replace(const Kind& node, const PartFor<Kind>& part) {
        Changes changes(tree_);
        changes.replace(slot_, node, part);
        check(changes, false, node);
    }

    // `alike` is true when the part can stand beside the node in a good text.
    template<class Kind>
    ast::Walk around(const Kind& node, const PartFor<Kind>& part, bool alike = true) {
        Changes before(tree_);
        before.insert_before(slot_, node, part);
        check(before, alike, node);
        Changes after(tree_);
        after.insert_after(slot_, node, part);
        check(after, alike, node);
        Changes removal(tree_);
        removal.remove(slot_, node);
        check(removal, false, node);
        replace(node, part);
        return ast::Walk::into;
    }

    void check(const Changes& changes, bool stays_good, const ast::Node& node) const {
        const std::optional<SyntaxTree> changed = changes.tree();
        ASSERT_TRUE(changed.has_value()) << changes.fault();
        EXPECT_TRUE(*changed == parse(changed->source(), tree_.options()))
            << slot_.unit->text(node) << "\n\n"
            << changed->source().bytes();
        if (good_ && stays_good) {
            EXPECT_TRUE(changed->diagnostics().empty())
                << to_string(node.kind) << ": " << slot_.unit->text(node) << "\n\n"
                << changed->source().bytes();
        }
    }

    const SyntaxTree& tree_;
    const SyntaxTree::Slot& slot_;
    bool good_;
    LibraryElement program_ = program_declaration("zz", {}, statement_list({}));
};

TEST(Cases, AreChangedAtEveryNode) {
    for (const CaseFile& file : all_case_files())
        for (const Case& one : file.cases) {
            const SourceText source = source_text_of(one);
            if (source.bytes().size() > 2000)
                continue;
            SCOPED_TRACE(file.path + ": " + one.title);
            const SyntaxTree tree = parse(source, options_of_changed(one));
            for (const SyntaxTree::Slot& slot : tree.slots())
                ChangeTester(tree, slot).traverse(slot.unit->root());
        }
}

} // namespace
} // namespace iecfront::test
