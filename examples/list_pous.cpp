// Prints what a file declares: each library element with its kind, name and place, and below it
// the parameters by block.
#include "read_source.hpp"

namespace ast = iecfront::ast;

namespace {

class Lister : public ast::Visitor<Lister> {
public:
    Lister(const iecfront::SyntaxTree& tree, const iecfront::SyntaxTree::Slot& slot)
        : tree_(tree), slot_(slot) {}

    // What is declared inside of these is of no interest, but for the blocks of parameters.
    ast::Walk visit(const ast::FunctionDeclaration& function) {
        print_head("FUNCTION", *function.name, " : " + text(*function.result_type));
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::FunctionBlockDeclaration& function_block) {
        print_head("FUNCTION_BLOCK", *function_block.name);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::ProgramDeclaration& program) {
        print_head("PROGRAM", *program.name);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::ConfigurationDeclaration& configuration) {
        print_head("CONFIGURATION", *configuration.name);
        return ast::Walk::over;
    }
    ast::Walk visit(const ast::TypeDeclaration& type) {
        print_head("TYPE", *type.name);
        return ast::Walk::over;
    }

    ast::Walk visit(const ast::VariableDeclarations& block) {
        switch (block.block) {
        case ast::VariableBlock::var_input:
        case ast::VariableBlock::var_output:
        case ast::VariableBlock::var_in_out:
            block_ = iecfront::folded(to_string(block.block));
            return ast::Walk::into;
        default: return ast::Walk::over;
        }
    }
    ast::Walk visit(const ast::VariableDeclaration& declaration) {
        for (const ast::Identifier* name : declaration.names)
            std::printf("    %-10s %s : %s\n", block_.c_str(), text(*name).c_str(),
                        text(*declaration.specification).c_str());
        return ast::Walk::over;
    }
    ast::Walk visit(const ast::Body&) { return ast::Walk::over; }

private:
    [[nodiscard]] std::string text(const ast::Node& node) const {
        return std::string(slot_.unit->text(node));
    }

    void print_head(const char* kind, const ast::Identifier& name, const std::string& rest = {}) {
        const iecfront::Position place = tree_.position(slot_.range(name).begin);
        std::printf("%s %s%s  (%s:%u:%u)\n", kind, text(name).c_str(), rest.c_str(),
                    tree_.name().c_str(), place.line, place.column);
    }

    const iecfront::SyntaxTree& tree_;
    const iecfront::SyntaxTree::Slot& slot_;
    std::string block_; // that is being listed
};

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: list_pous FILE\n", stderr);
        return 2;
    }
    const std::optional<iecfront::SourceText> source = read_source(argv[1]);
    if (!source)
        return 2;
    const iecfront::SyntaxTree tree = iecfront::parse(*source);
    for (const iecfront::SyntaxTree::Slot& slot : tree.slots())
        Lister(tree, slot).traverse(slot.unit->root());
}
