#include "parser/parser.hpp"

namespace iecfront {

/// A piece of a program that stands alone. It is read as it would be in a PROGRAM, where nearly all
/// is allowed; what is left over is reported once.
const ast::LibraryUnit* Parser::parse_fragment(FragmentKind kind) {
    if (kind == FragmentKind::library)
        return parse_library_unit();
    auto* unit = make<ast::LibraryUnit>();
    ListBuilder<ast::Node> elements(*this);
    place_ = Place::program;
    open_block(TokenKind::end_of_unit, at_);
    switch (kind) {
    case FragmentKind::library: break; // not reached
    case FragmentKind::body: elements.add(parse_body()); break;
    case FragmentKind::statement_list: elements.add(parse_statement_list("in a body")); break;
    case FragmentKind::expression: elements.add(parse_expression()); break;
    case FragmentKind::variable_declarations:
        for (const ast::VariableDeclarations* block : parse_declaration_blocks(place_))
            elements.add(block);
        break;
    }
    if (!at_end()) {
        report_unexpected("the end of the text");
        auto* skipped = make<ast::SkippedText>();
        while (!at_end())
            advance();
        elements.add(finish(skipped));
    }
    unit->elements = elements.finish();
    unit->first_token = 0;
    unit->end_token = count_;
    return unit;
}

} // namespace iecfront
