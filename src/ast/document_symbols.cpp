#include <iecfront/ast/document_symbols.hpp>
#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/visitor.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace iecfront {
namespace {

constexpr std::array<std::string_view, 16> kind_names = {
    "function",         "function_block", "program",       "data_type", "structure_element",
    "enumerated_value", "variable",       "access_path",   "step",      "transition",
    "action",           "label",          "configuration", "resource",  "task",
    "program_instance"};

/// Collects the symbols of a unit. What is declared inside a declaration that goes on lies on a
/// stack of lists, the outermost first.
class SymbolCollector : public ast::Visitor<SymbolCollector> {
public:
    explicit SymbolCollector(const Unit& unit) : unit_(unit) {}

    [[nodiscard]] std::vector<DocumentSymbol> take() { return std::move(open_.front()); }

    // Declarations that can hold others: what is inside goes to a list of its own.
    ast::Walk visit(const ast::Node& node) {
        if (holds_declarations(node.kind))
            open_.emplace_back();
        return ast::Walk::into;
    }

    void leave(const ast::FunctionDeclaration& node) { close(SymbolKind::function, node); }
    void leave(const ast::FunctionBlockDeclaration& node) {
        close(SymbolKind::function_block, node);
    }
    void leave(const ast::ProgramDeclaration& node) { close(SymbolKind::program, node); }
    void leave(const ast::ConfigurationDeclaration& node) {
        close(SymbolKind::configuration, node);
    }
    void leave(const ast::ResourceDeclaration& node) { close(SymbolKind::resource, node); }
    void leave(const ast::TypeDeclaration& node) { close(SymbolKind::data_type, node); }
    void leave(const ast::StructureElementDeclaration& node) {
        close_all(SymbolKind::structure_element, node);
    }
    void leave(const ast::Step& node) { close(SymbolKind::step, node); }
    void leave(const ast::Action& node) { close(SymbolKind::action, node); }
    void leave(const ast::VariableDeclaration& node) { close_all(SymbolKind::variable, node); }

    void leave(const ast::EnumeratedValueDeclaration& node) {
        add(SymbolKind::enumerated_value, node, *node.name);
    }
    void leave(const ast::AccessDeclaration& node) {
        add(SymbolKind::access_path, node, *node.name);
    }
    void leave(const ast::Transition& node) {
        if (node.name != nullptr)
            add(SymbolKind::transition, node, *node.name);
    }
    void leave(const ast::IlInstruction& node) {
        if (node.label != nullptr)
            add(SymbolKind::label, node, *node.label);
    }
    void leave(const ast::TaskConfiguration& node) { add(SymbolKind::task, node, *node.name); }
    void leave(const ast::ProgramConfiguration& node) {
        add(SymbolKind::program_instance, node, *node.name);
    }

private:
    [[nodiscard]] static bool holds_declarations(ast::NodeKind kind) noexcept {
        switch (kind) {
        case ast::NodeKind::function_declaration:
        case ast::NodeKind::function_block_declaration:
        case ast::NodeKind::program_declaration:
        case ast::NodeKind::configuration_declaration:
        case ast::NodeKind::resource_declaration:
        case ast::NodeKind::type_declaration:
        case ast::NodeKind::structure_element_declaration:
        case ast::NodeKind::variable_declaration:
        case ast::NodeKind::step:
        case ast::NodeKind::action: return true;
        default: return false;
        }
    }

    std::vector<DocumentSymbol> take_children() {
        std::vector<DocumentSymbol> children = std::move(open_.back());
        open_.pop_back();
        return children;
    }

    template<class Declaration>
    void close(SymbolKind kind, const Declaration& node) {
        std::vector<DocumentSymbol> children = take_children();
        add(kind, node, *node.name, std::move(children));
    }

    // `a, b : (Red, Green)`: what is inside is the first one's.
    template<class Declaration>
    void close_all(SymbolKind kind, const Declaration& node) {
        std::vector<DocumentSymbol> children = take_children();
        for (const ast::Identifier* name : node.names)
            add(kind, node, *name, std::exchange(children, {}));
    }

    void add(SymbolKind kind, const ast::Node& node, const ast::Identifier& name,
             std::vector<DocumentSymbol> children = {}) {
        const TextRange range = unit_.range(node);
        TextRange name_range = unit_.range(name);
        if (name.missing) // behind the token before, which can be outside of the declaration
            name_range.begin = name_range.end =
                std::clamp(name_range.begin, range.begin, range.end);
        open_.back().push_back({kind, name.missing ? std::string_view() : unit_.text(name), range,
                                name_range, std::move(children)});
    }

    const Unit& unit_;
    std::vector<std::vector<DocumentSymbol>> open_{1};
};

void shift(std::vector<DocumentSymbol>& symbols, std::uint32_t distance) {
    for (DocumentSymbol& symbol : symbols) {
        symbol.range = symbol.range.shifted(distance);
        symbol.name_range = symbol.name_range.shifted(distance);
        shift(symbol.children, distance);
    }
}

} // namespace

std::string_view to_string(SymbolKind kind) noexcept {
    return kind_names[static_cast<std::size_t>(kind)];
}

std::vector<DocumentSymbol> document_symbols(const Unit& unit) {
    SymbolCollector collector(unit);
    collector.traverse(unit.root());
    return collector.take();
}

std::vector<DocumentSymbol> document_symbols(const SyntaxTree& tree) {
    std::vector<DocumentSymbol> all;
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        std::vector<DocumentSymbol> symbols = document_symbols(*slot.unit);
        shift(symbols, slot.offset);
        all.insert(all.end(), std::make_move_iterator(symbols.begin()),
                   std::make_move_iterator(symbols.end()));
    }
    return all;
}

} // namespace iecfront
