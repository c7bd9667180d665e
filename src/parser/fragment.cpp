#include "parser/keyword_sets.hpp"
#include "parser/parser.hpp"

namespace iecfront {
namespace {

constexpr TokenSet element_openers{TokenKind::kw_type, TokenKind::kw_function,
                                   TokenKind::kw_function_block, TokenKind::kw_program,
                                   TokenKind::kw_configuration};

const char* name_of(FragmentKind kind) noexcept {
    switch (kind) {
    case FragmentKind::library: break; // read by itself
    case FragmentKind::body: return "a body";
    case FragmentKind::statement_list: return "statements";
    case FragmentKind::expression: return "an expression";
    case FragmentKind::variable_declarations: return "declaration blocks";
    }
    return "library elements";
}

} // namespace

/// In place of library: a piece of a program that stands alone. A body is read as it would be in a
/// PROGRAM, where nearly all is allowed, and declarations as if they stood where they can; what is
/// left over is reported once.
const ast::LibraryUnit* Parser::parse_fragment(FragmentKind kind) {
    if (kind == FragmentKind::library)
        return parse_library_unit();
    auto* unit = make<ast::LibraryUnit>();
    ListBuilder<ast::Node> elements(*this);
    place_ = kind == FragmentKind::variable_declarations ? Place::anywhere : Place::program;
    open_block(TokenKind::end_of_unit, at_);
    if (at(element_openers)) {
        report_at(at_, DiagnosticId::unexpected_token,
                  {name_of(kind), "the library element " + quoted(at_)});
        add_missing_fragment(elements, kind);
    } else {
        parse_elements_of_fragment(elements, kind);
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

/// In place of library: what the fragment is said to be.
void Parser::parse_elements_of_fragment(ListBuilder<ast::Node>& elements, FragmentKind kind) {
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
}

/// What stands for a fragment that is not there, so that whoever asks for one gets one.
void Parser::add_missing_fragment(ListBuilder<ast::Node>& elements, FragmentKind kind) {
    if (kind == FragmentKind::expression)
        elements.add(make_missing<ast::ErrorExpression>());
    else if (kind != FragmentKind::variable_declarations)
        elements.add(make_missing<ast::StatementList>());
}

} // namespace iecfront
