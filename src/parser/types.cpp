#include "ast/unused_nodes.hpp"
#include "lexer/keywords.hpp"
#include "parser/misspelling.hpp"
#include "parser/parser.hpp"

#include <iecfront/lexer/literals.hpp>
#include <iecfront/lexer/name.hpp>

#include <algorithm>

namespace iecfront {
namespace {

constexpr TokenSet integer_type_names = TokenSet::range(TokenKind::kw_sint, TokenKind::kw_ulint);

// Words that go on behind a declaration without a type.
constexpr TokenSet words_of_blocks =
    block_openers | unit_ends |
    TokenSet{TokenKind::kw_end_var, TokenKind::kw_end_struct, TokenKind::kw_end_resource};

constexpr TokenSet behind_bounds{TokenKind::right_parenthesis, TokenKind::right_bracket,
                                 TokenKind::comma};

constexpr TokenSet string_type_names{TokenKind::kw_string, TokenKind::kw_wstring};

} // namespace

// ---- declarations -------------------------------------------------------------------------------

// data_type_declaration = "TYPE" type_declaration ";" { type_declaration ";" } "END_TYPE" ;
const ast::DataTypeDeclaration* Parser::parse_data_type_declaration() {
    auto* node = make<ast::DataTypeDeclaration>();
    open_block(TokenKind::kw_end_type, advance());
    ListBuilder<ast::Node> declarations(*this);
    while (!at_end_of_declarations())
        add_in_loop(declarations, [this] { return parse_type_declaration(); });
    if (declarations.empty())
        report_empty_block(open_.back().opener);
    node->declarations = declarations.finish();
    close_block("");
    return finish(node);
}

/// Of an empty block that lacks its closing word as well, only that is said.
void Parser::report_empty_block(std::uint32_t opener) {
    if (at(open_.back().closer))
        report(DiagnosticId::empty_block, tokens_[opener].range(), {text(opener)});
}

/// In place of type_declaration, var_init_decl, structure_element_declaration: passes over what
/// cannot begin a declaration, up to the next one.
const ast::ErrorDeclaration* Parser::parse_error_declaration(std::string_view what) {
    auto* error = make<ast::ErrorDeclaration>();
    if (at(TokenKind::semicolon)) {
        accept_extra_semicolon();
        return finish(error);
    }
    report_at(at_, DiagnosticId::not_a_declaration, {what, describe(at_)});
    advance();
    skip_declaration();
    accept(TokenKind::semicolon);
    return finish(error);
}

// type_declaration = single_element_type_declaration | array_type_declaration
//                  | structure_type_declaration | string_type_declaration ;
// single_element_type_declaration = simple_type_declaration | subrange_type_declaration
//                                 | enumerated_type_declaration ;
// simple_type_declaration = simple_type_name ":" simple_spec_init ;
// subrange_type_declaration = subrange_type_name ":" subrange_spec_init ;
// enumerated_type_declaration = enumerated_type_name ":" enumerated_spec_init ;
// array_type_declaration = array_type_name ":" array_spec_init ;
// structure_type_declaration = structure_type_name ":" structure_specification ;
// structure_specification = structure_declaration | initialized_structure ;
// string_type_declaration = string_type_name ":" ( "STRING" | "WSTRING" )
//                           [ "[" integer "]" ] [ ":=" character_string ] ;
const ast::Node* Parser::parse_type_declaration() {
    if (at(TokenKind::kw_struct) && peek() == TokenKind::identifier && !at_stray_struct())
        return parse_struct_before_name();
    drop_word_before_declaration("a type declaration");
    if (!at(TokenKind::identifier) && !(is_keyword(kind()) && peek() == TokenKind::colon))
        return parse_error_declaration("a type declaration");
    auto* node = make<ast::TypeDeclaration>();
    node->name = parse_declared_name("the name of a data type");
    expect_colon();
    node->specification = parse_type_specification(StructureUse::named);
    const std::uint32_t type_end = end_;
    node->initial_value = parse_optional_initial_value();
    finish(node);
    if (node->specification->kind == ast::NodeKind::structure_declaration &&
        node->initial_value != nullptr)
        report_node(*node->initial_value, DiagnosticId::unexpected_initial_value, {"STRUCT"})
            .remove({tokens_[type_end - 1].end(), tokens_[node->end_token - 1].end()});
    else
        check_initial_value(*node->specification, node->initial_value);
    expect_semicolon_of_declaration();
    return node;
}

/// In place of structure_type_declaration: `STRUCT S`, which is meant to be `S : STRUCT`.
const ast::TypeDeclaration* Parser::parse_struct_before_name() {
    auto* node = make<ast::TypeDeclaration>();
    const std::uint32_t opener = advance();
    const TextRange range = token_range(opener, at_ + 1);
    const std::string meant = std::string(text(at_)) + " : " + std::string(text(opener));
    report(DiagnosticId::unexpected_token, range,
           {"`" + meant + "`", "`" + std::string(text_.substr(range.begin, range.size())) + "`"})
        .replace(range, meant);
    node->name = parse_declared_name("the name of a data type");
    auto* structure = make<ast::StructureDeclaration>();
    parse_structure_elements(*structure, opener);
    node->specification = finish(structure);
    finish(node);
    expect_semicolon_of_declaration();
    return node;
}

/// The `:` between a name and its type is not there; `:=` and `=` are common slips for it.
void Parser::report_missing_colon() {
    if (at_next_declaration()) {
        report_unfinished(DiagnosticId::missing_type, {describe(at_)});
        return;
    }
    const bool slip = at(TokenKind::assign) || at(TokenKind::equal);
    if (slip && begins_type(next(at_))) {
        report_unexpected("`:`").replace(token().range(), ":");
        advance();
        return;
    }
    if (is_keyword(kind()) && peek() == TokenKind::colon && !begins_type(at_)) {
        report_unexpected("`:`").remove(token().range());
        count_as_name(kind());
        advance();
        advance();
        return;
    }
    if (at(TokenKind::colon) || peek() == TokenKind::colon || begins_type(at_)) {
        expect(TokenKind::colon);
        return;
    }
    if (at(words_of_blocks) && token().first_on_line()) {
        report_unfinished(DiagnosticId::missing_type, {describe(at_)});
        return;
    }
    // Something that is no part of a name: nothing is read from it.
    report_unexpected("`:`");
    if (colon_follows_on_line())
        skip_to({TokenKind::colon});
    accept(TokenKind::colon);
}

/// True when a `:` stands further on in this line of a declaration.
bool Parser::colon_follows_on_line() const noexcept {
    std::uint32_t i = at_;
    for (std::uint32_t steps = 0; steps < furthest_on_line; ++steps) {
        const TokenKind here = tokens_[i].kind();
        if (here == TokenKind::semicolon || here == TokenKind::end_of_unit || is_keyword(here))
            return false;
        const std::uint32_t behind = next(i);
        if (!on_same_line(i, behind))
            return false;
        if (tokens_[behind].kind() == TokenKind::colon)
            return true;
        i = behind;
    }
    return false;
}

// ---- specifications -----------------------------------------------------------------------------

// simple_specification = elementary_type_name | simple_type_name | string_type_name ;
// var_spec = simple_specification | subrange_specification
//          | enumerated_specification | array_specification
//          | structure_type_name
//          | "STRING" [ "[" integer "]" ]
//          | "WSTRING" [ "[" integer "]" ] ;
// non_generic_type_name = elementary_type_name | derived_type_name ;
/// Whatever stands behind the `:` of a declaration.
const ast::TypeSpecification* Parser::parse_type_specification(StructureUse use) {
    if (is_elementary_type_name(kind()) && !token().first_on_line())
        return is_plain_type() ? take<ast::ElementaryTypeName>() : parse_elementary_type();
    if (at_element_without_struct())
        return parse_structure_declaration();
    if (at_next_declaration())
        return parse_missing_type();
    switch (kind()) {
    case TokenKind::identifier:
        return at_misspelt_struct() ? parse_structure_declaration() : parse_derived_type();
    case TokenKind::left_parenthesis: return parse_enumerated_specification();
    case TokenKind::kw_array: return parse_array_specification();
    case TokenKind::kw_struct:
        if (at_stray_struct())
            return parse_type_behind_struct(use);
        if (use == StructureUse::anonymous)
            report(DiagnosticId::anonymous_structure, token().range());
        return parse_structure_declaration();
    default: break;
    }
    if (is_elementary_type_name(kind()) || is_generic_type_name(kind()))
        return parse_elementary_type();
    static constexpr TokenSet after_type{TokenKind::semicolon, TokenKind::assign};
    const bool only_name =
        after_type.contains(peek()) && !token().first_on_line() && !at(words_of_blocks);
    if (is_keyword(kind()) && (used_as_name(kind()) || only_name)) {
        report_reserved_word(at_);
        return parse_type_name();
    }
    return parse_missing_type();
}

/// In place of simple_specification: nothing that begins a type. A line that breaks off has the
/// report at its end.
const ast::TypeSpecification* Parser::parse_missing_type() {
    if (token().first_on_line() || at_end())
        report_unfinished(DiagnosticId::missing_type, {describe(at_)});
    else
        report_at(at_, DiagnosticId::missing_type, {describe(at_)});
    return make_missing<ast::ErrorType>();
}

/// At a type behind which nothing stands that belongs to it.
bool Parser::is_plain_type() const noexcept {
    static constexpr TokenSet behind{TokenKind::semicolon, TokenKind::assign};
    return behind.contains(tokens_[at_ + 1].kind());
}

// derived_type_name = single_element_type_name | array_type_name | structure_type_name
//                   | string_type_name ;
// single_element_type_name = simple_type_name | subrange_type_name | enumerated_type_name ;
// simple_type_name = identifier ;
// subrange_type_name = identifier ;
// enumerated_type_name = identifier ;
// array_type_name = identifier ;
// structure_type_name = identifier ;
// string_type_name = identifier ;
const ast::TypeSpecification* Parser::parse_type_name() {
    return at(TokenKind::identifier) ? take_name<ast::DerivedTypeName, NameUse::type>()
                                     : take_word<ast::DerivedTypeName>();
}

/// Part of simple_specification, subrange_specification: what begins with the name of a type.
const ast::TypeSpecification* Parser::parse_derived_type() {
    if (at_pointer_type())
        return parse_pointer_type();
    const bool names_follow =
        peek() == TokenKind::left_parenthesis && peek_second() == TokenKind::identifier;
    if (names_follow && at_word("ENUM")) { // as other languages have it
        report_unexpected("`(`").remove(token().range());
        advance();
        return parse_enumerated_specification();
    }
    if (peek() == TokenKind::dot && peek_second() == TokenKind::identifier)
        return parse_qualified_type_name();
    const ast::TypeSpecification* name = parse_type_name();
    if (!at(TokenKind::left_parenthesis))
        return name;
    const TokenKind behind = peek_second();
    if (peek() == TokenKind::right_parenthesis || behind == TokenKind::assign ||
        (names_follow && (behind == TokenKind::comma || behind == TokenKind::right_parenthesis))) {
        report_at(at_, DiagnosticId::instance_arguments);
        parse_arguments();
        return name;
    }
    report_node(*name, DiagnosticId::subrange_of_derived_type, {quoted(name->first_token)});
    return parse_subrange_specification(name);
}

/// `POINTER TO`, `REFERENCE TO` and `REF_TO` of other dialects and later editions.
bool Parser::at_pointer_type() const noexcept {
    return at_word("REF_TO") ||
           ((at_word("POINTER") || at_word("REFERENCE")) && peek() == TokenKind::kw_to);
}

/// In place of simple_specification: a pointer of other dialects.
const ast::TypeSpecification* Parser::parse_pointer_type() {
    const NestingGuard guard(*this);
    if (guard.too_deep())
        return parse_too_deep_type();
    auto* node = make<ast::ErrorType>();
    report_at(at_, DiagnosticId::pointer_type, {text(at_)});
    advance();
    accept(TokenKind::kw_to);
    parse_type_specification();
    return finish(node);
}

// elementary_type_name = numeric_type_name | date_type_name | bit_string_type_name
//                      | "STRING" | "WSTRING" | "TIME" ;
// numeric_type_name = integer_type_name | real_type_name ;
// integer_type_name = signed_integer_type_name | unsigned_integer_type_name ;
// signed_integer_type_name = "SINT" | "INT" | "DINT" | "LINT" ;
// unsigned_integer_type_name = "USINT" | "UINT" | "UDINT" | "ULINT" ;
// real_type_name = "REAL" | "LREAL" ;
// date_type_name = "DATE" | "TIME_OF_DAY" | "TOD" | "DATE_AND_TIME" | "DT" ;
// bit_string_type_name = "BOOL" | "BYTE" | "WORD" | "DWORD" | "LWORD" ;
const ast::TypeSpecification* Parser::parse_elementary_type() {
    const TokenKind type = kind();
    if (is_generic_type_name(type))
        report_at(at_, DiagnosticId::generic_type_in_declaration, {text(at_)});
    const auto* node = take<ast::ElementaryTypeName>();
    const bool string = string_type_names.contains(type);
    if (string && (at(TokenKind::left_bracket) || at(TokenKind::left_parenthesis)))
        return parse_string_specification(node);
    if (!at(TokenKind::left_parenthesis))
        return node;
    const TokenKind after_name = peek_second();
    if (peek() == TokenKind::identifier &&
        (after_name == TokenKind::comma || after_name == TokenKind::assign ||
         after_name == TokenKind::right_parenthesis))
        return parse_enumeration_of(node);
    if (integer_type_names.contains(type))
        return parse_subrange_specification(node);
    report_unexpected("`;`");
    skip_balanced();
    return node;
}

// single_byte_string_spec = "STRING" [ "[" integer "]" ] [ ":=" single_byte_character_string ] ;
// double_byte_string_spec = "WSTRING" [ "[" integer "]" ] [ ":=" double_byte_character_string ] ;
const ast::TypeSpecification* Parser::parse_string_specification(const ast::Node* keyword) {
    auto* node = make_from<ast::StringSpecification>(keyword);
    node->double_byte = tokens_[keyword->first_token].kind() == TokenKind::kw_wstring;
    ast::mark_unused(*keyword, arena_.bytes());
    const bool parentheses = at(TokenKind::left_parenthesis);
    const std::uint32_t open = advance();
    node->length = parse_integer("the length of a string");
    const TokenKind bracket = parentheses ? TokenKind::right_parenthesis : TokenKind::right_bracket;
    if (at(TokenKind::dot_dot) || at(TokenKind::comma)) {
        report_unexpected("`" + std::string(spelling(bracket)) + "`");
        skip_to({bracket, TokenKind::semicolon});
    }
    const std::uint32_t close = at_;
    expect(bracket);
    finish(node);
    if (!parentheses)
        return node;
    Report extension =
        report(DiagnosticId::parenthesized_string_length, token_range(open, node->end_token));
    if (close < node->end_token)
        diagnostics_[extension.index()].fixes.push_back(
            {{{tokens_[open].range(), "["}, {tokens_[close].range(), "]"}}});
    return node;
}

// subrange_specification = integer_type_name "(" subrange ")" | subrange_type_name ;
const ast::TypeSpecification*
Parser::parse_subrange_specification(const ast::TypeSpecification* base) {
    auto* node = make_from<ast::SubrangeSpecification>(base);
    advance();
    node->base = base;
    node->range = parse_subrange();
    expect(TokenKind::right_parenthesis);
    return finish(node);
}

// subrange = signed_integer ".." signed_integer ;
const ast::Subrange* Parser::parse_subrange() {
    auto* node = make<ast::Subrange>();
    const bool open =
        at(TokenKind::star) && (peek() == TokenKind::right_bracket || peek() == TokenKind::comma);
    if (open) { // `ARRAY [*]`
        const bool first = at_ < 2 || tokens_[at_ - 2].kind() != TokenKind::star;
        if (first)
            report_at(at_, DiagnosticId::foreign_construct,
                      {"`*` for the bounds of an array", "the third edition"});
        advance();
        node->lower = make_missing<ast::ErrorExpression>();
        node->upper = make_missing<ast::ErrorExpression>();
        return finish(node);
    }
    if (at_bounds_as_real()) {
        const std::size_t point = text(at_).find('.');
        const auto offset = token().offset() + static_cast<std::uint32_t>(point);
        report_at(at_, DiagnosticId::subrange_needs_two_bounds).insert(offset, ".");
        auto* both = make<ast::ErrorExpression>();
        advance();
        node->lower = finish(both);
        node->upper = make_missing<ast::ErrorExpression>();
        return finish(node);
    }
    node->lower = at_bounds_with_dash() ? parse_constant() : parse_constant_expression("a bound");
    node->first_token = node->lower->first_token;
    if (accept_between_bounds()) {
        node->upper = parse_constant_expression("a bound");
    } else {
        report_missing(DiagnosticId::subrange_needs_two_bounds);
        node->upper = make_missing<ast::ErrorExpression>();
    }
    return finish(node);
}

/// `[1-3]`
bool Parser::at_bounds_with_dash() const noexcept {
    return at(TokenKind::integer) && peek() == TokenKind::minus &&
           peek_second() == TokenKind::integer &&
           behind_bounds.contains(tokens_[next(next(next(at_)))].kind());
}

/// `(0.9)`
bool Parser::at_bounds_as_real() const noexcept {
    const std::string_view word = text(at_);
    return at(TokenKind::real) && behind_bounds.contains(peek()) &&
           word.find_first_not_of("0123456789.") == word.npos;
}

/// `..`, or what is written instead of it by mistake.
bool Parser::accept_between_bounds() {
    if (at(TokenKind::comma) && peek() == TokenKind::comma && adjoins_next()) { // `1,,3`
        const TextRange commas = token_range(at_, next(at_) + 1);
        report(DiagnosticId::unexpected_token, commas, {"`..`", "`,,`"}).replace(commas, "..");
        advance();
        advance();
        return true;
    }
    static constexpr TokenSet look_alikes{TokenKind::colon, TokenKind::kw_to};
    static constexpr TokenSet begin_bound{TokenKind::integer, TokenKind::identifier,
                                          TokenKind::minus};
    if (at(look_alikes) && begin_bound.contains(peek())) {
        accept_as(TokenKind::dot_dot);
        return true;
    }
    if (at(TokenKind::minus) && peek() == TokenKind::integer) {
        report_unexpected("`..`").replace(token().range(), "..");
        advance();
        return true;
    }
    if (!accept(TokenKind::dot_dot))
        return false;
    if (at(TokenKind::dot)) {
        report_unexpected("a bound").remove(token().range());
        advance();
    }
    return true;
}

// enumerated_specification = ( "(" enumerated_value { "," enumerated_value } ")" )
//                          | enumerated_type_name ;
const ast::TypeSpecification* Parser::parse_enumerated_specification() {
    auto* node = make<ast::EnumeratedSpecification>();
    node->values = parse_enumerated_value_list();
    if (is_elementary_type_name(kind())) {
        report(DiagnosticId::enumeration_base_type, token().range());
        node->base_behind = parse_elementary_type();
    }
    return finish(node);
}

// Part of enumerated_specification: "(" enumerated_value { "," enumerated_value } ")"
Parser::Children<ast::EnumeratedValueDeclaration> Parser::parse_enumerated_value_list() {
    advance();
    ListBuilder<ast::EnumeratedValueDeclaration> values(*this);
    std::optional<Report> semicolons;
    const ast::EnumeratedValueDeclaration* value = nullptr;
    do {
        if (value != nullptr && value->name->missing && at(TokenKind::integer))
            reported_at_ = at_; // a list of numbers is one mistake
        values.add(value = parse_enumerated_value_declaration());
    } while (accept(TokenKind::comma) || (at(TokenKind::identifier) && accept_missing_comma()) ||
             accept_semicolon_for_comma(TokenKind::right_parenthesis, semicolons));
    if (at(TokenKind::assign))
        expect(TokenKind::right_parenthesis);
    else
        expect_closing(TokenKind::right_parenthesis);
    return values.finish();
}

/// In place of enumerated_specification: `INT (Red, Green)`, with the base type before it, an
/// extension.
const ast::TypeSpecification* Parser::parse_enumeration_of(const ast::TypeSpecification* base) {
    auto* node = make_from<ast::EnumeratedSpecification>(base);
    report_node(*base, DiagnosticId::enumeration_base_type);
    node->base = base;
    node->values = parse_enumerated_value_list();
    return finish(node);
}

/// Part of enumerated_specification: an enumerated_value that is declared.
const ast::EnumeratedValueDeclaration* Parser::parse_enumerated_value_declaration() {
    auto* node = make<ast::EnumeratedValueDeclaration>();
    if (at(TokenKind::enumerated_value)) {
        auto* name = make<ast::Identifier>();
        name->hash = hash_name(split_enumerated_value(text(at_)).value);
        check_enumerated_value_names(advance());
        node->name = finish(name);
    } else {
        node->name = at_next_declaration() ? make_missing_identifier("an enumerated value")
                                           : parse_declared_name("an enumerated value");
        // What stands in the place of a name, as the number in `(Red, 5, Blue)`, is passed over.
        if (node->name->missing && !at(TokenKind::comma) && !at(TokenKind::right_parenthesis) &&
            (peek() == TokenKind::comma || peek() == TokenKind::right_parenthesis))
            advance();
    }
    if (at(TokenKind::assign) && !at_initial_value_behind_open_list()) {
        report(DiagnosticId::enumerated_value_given, token().range());
        advance();
        node->value = parse_expression();
    }
    return finish(node);
}

/// `(Idle, Heat := Idle;`: a number that is given to a value is no name, and the list goes on or is
/// closed behind it.
bool Parser::at_initial_value_behind_open_list() const noexcept {
    const bool name = peek() == TokenKind::identifier || peek() == TokenKind::enumerated_value;
    return at(TokenKind::assign) && name && peek_second() == TokenKind::semicolon;
}

/// The closing bracket of a list in which no more element can be read.
void Parser::expect_closing(TokenKind bracket) {
    const bool outer = at(closing_brackets) && closes_open_bracket(); // `[2(0]`
    if (!at(bracket) && !outer && !at(TokenKind::semicolon) && !is_keyword(kind()) &&
        !token().first_on_line()) {
        report_unexpected("`,` or `" + std::string(spelling(bracket)) + "`");
        skip_to({bracket, TokenKind::semicolon});
    }
    expect(bracket);
}

// array_specification = array_type_name
//                     | "ARRAY" "[" subrange { "," subrange } "]" "OF" non_generic_type_name ;
const ast::TypeSpecification* Parser::parse_array_specification() {
    const NestingGuard guard(*this);
    if (guard.too_deep())
        return parse_too_deep_type();
    auto* node = make<ast::ArraySpecification>();
    advance();
    if (at(TokenKind::kw_of) || at(TokenKind::semicolon))
        report_missing(DiagnosticId::missing_token, {"`[` with a subrange"});
    else
        node->subranges = parse_subranges();
    const bool of_before_bracket = end_ > 1 && tokens_[end_ - 2].kind() == TokenKind::kw_of;
    if (at(TokenKind::colon))
        accept_as(TokenKind::kw_of);
    else if (!of_before_bracket)
        expect(TokenKind::kw_of);
    node->element_type = parse_type_specification(StructureUse::named);
    check_element_type(*node->element_type);
    return finish(node);
}

// Part of array_specification: "[" subrange { "," subrange } "]"
Parser::Children<ast::Subrange> Parser::parse_subranges() {
    const std::optional<Report> parentheses = accept_parenthesis_for_bracket();
    if (!parentheses)
        expect(TokenKind::left_bracket);
    static constexpr TokenSet bracket_look_alikes{TokenKind::right_parenthesis,
                                                  TokenKind::semicolon, TokenKind::colon};
    ListBuilder<ast::Subrange> subranges(*this);
    do
        subranges.add(parse_subrange());
    while (accept(TokenKind::comma) || accept_comma_look_alike());
    if (parentheses)
        close_parenthesis_for_bracket(*parentheses);
    else if (at(bracket_look_alikes) && peek() == TokenKind::kw_of)
        accept_as(TokenKind::right_bracket);
    else if (at(TokenKind::kw_of) && peek() == TokenKind::right_bracket) { // `[0..9 OF] INT`
        report_swapped(next(at_));
        advance();
        advance();
    } else
        expect_closing(TokenKind::right_bracket);
    return subranges.finish();
}

/// `[1..2; 1..3]` and `[1..2][1..3]`.
bool Parser::accept_comma_look_alike() {
    const std::uint32_t second = next(at_);
    if (at(TokenKind::semicolon) && peek() == TokenKind::integer && on_same_line(at_, second)) {
        accept_as(TokenKind::comma);
        return true;
    }
    if (!at(TokenKind::right_bracket) || peek() != TokenKind::left_bracket)
        return false;
    const TextRange range = token_range(at_, second + 1);
    report(DiagnosticId::unexpected_token, range,
           {"`,`", "`" + std::string(text_.substr(range.begin, range.size())) + "`"})
        .replace(range, ", ");
    advance();
    advance();
    return true;
}

/// Passes over the token at the cursor, which stands in the place of `meant`.
Parser::Report Parser::accept_as(TokenKind meant) {
    const std::string words(spelling(meant));
    Report report =
        report_at(at_, DiagnosticId::unexpected_token, {"`" + words + "`", describe(at_)});
    report.replace(token().range(), words);
    advance();
    return report;
}

/// Passes over a `(` where a `[` belongs.
std::optional<Parser::Report> Parser::accept_parenthesis_for_bracket() {
    if (!at(TokenKind::left_parenthesis))
        return std::nullopt;
    return accept_as(TokenKind::left_bracket);
}

/// The `)` that goes with it; the fix has both.
void Parser::close_parenthesis_for_bracket(Report report) {
    const TextRange close = token().range();
    const bool closed = at(TokenKind::right_parenthesis);
    expect_closing(TokenKind::right_parenthesis);
    if (closed && report)
        diagnostics_[report.index()].fixes.front().edits.push_back({close, "]"});
}

/// An element type is a name (6.1 D15).
void Parser::check_element_type(const ast::TypeSpecification& type) {
    const char* what = nullptr;
    switch (type.kind) {
    case ast::NodeKind::array_specification: what = "an array"; break;
    case ast::NodeKind::structure_declaration: what = "a structure written out"; break;
    case ast::NodeKind::enumerated_specification: what = "an enumeration written out"; break;
    case ast::NodeKind::subrange_specification: what = "a subrange written out"; break;
    case ast::NodeKind::string_specification: what = "a string with a length"; break;
    default: check_no_function_block(type, "an array element"); return;
    }
    report_node(type, DiagnosticId::element_type, {what});
}

/// Elements are of data types. Of the names that a program gives it is not known what they are.
void Parser::check_no_function_block(const ast::TypeSpecification& type, const char* of) {
    if (names_function_block(type))
        report_node(type, DiagnosticId::function_block_as_element, {text(type.first_token), of});
}

/// In place of array_specification, structure_declaration: passes over one that is nested too deep.
const ast::TypeSpecification* Parser::parse_too_deep_type() {
    auto* error = make<ast::ErrorType>();
    const bool structure = accept(TokenKind::kw_struct);
    if (!structure) {
        advance();
        skip_declaration();
    }
    if (structure || accept(TokenKind::kw_struct))
        skip_structure();
    return finish(error);
}

/// Behind STRUCT: passes over the structure with its closing word.
void Parser::skip_structure() {
    for (std::uint32_t depth = 1; depth > 0 && !at(unit_ends) && !at(TokenKind::kw_end_var);
         advance()) {
        depth += at(TokenKind::kw_struct) ? 1 : 0;
        depth -= at(TokenKind::kw_end_struct) ? 1 : 0;
    }
}

// structure_declaration = "STRUCT" structure_element_declaration ";"
//                         { structure_element_declaration ";" } "END_STRUCT" ;
const ast::TypeSpecification* Parser::parse_structure_declaration() {
    const NestingGuard guard(*this);
    if (guard.too_deep())
        return parse_too_deep_type();
    auto* node = make<ast::StructureDeclaration>();
    std::uint32_t opener = at_;
    if (at_element_without_struct()) {
        opener = at_ - 1; // the `:`
        change_unclosed(TokenKind::kw_end_struct, 1);
        report_missing(DiagnosticId::missing_token, {"`STRUCT`"}).insert(previous_end(), " STRUCT");
    } else if (at(TokenKind::identifier)) {
        change_unclosed(TokenKind::kw_end_struct, 1);
        accept_misspelt(TokenKind::kw_struct);
    } else {
        advance();
    }
    accept_foreign_overlap();
    parse_structure_elements(*node, opener);
    return finish(node);
}

/// At a STRUCT that nothing closes, and no element follows in its line.
bool Parser::at_stray_struct() {
    const std::uint32_t behind = next(at_);
    const TokenKind after_name = peek_second();
    const bool element = tokens_[behind].kind() == TokenKind::identifier &&
                         (after_name == TokenKind::colon || after_name == TokenKind::comma);
    return at(TokenKind::kw_struct) && unclosed(TokenKind::kw_end_struct) > 0 && !element &&
           !tokens_[behind].first_on_line() && tokens_[behind].kind() != TokenKind::kw_end_struct;
}

/// In place of structure_declaration: `STRUCT INT`, a word too many before the type; or `STRUCT;`.
const ast::TypeSpecification* Parser::parse_type_behind_struct(StructureUse use) {
    Report unexpected = report_at(at_, DiagnosticId::missing_type, {describe(at_)});
    count_as_name(kind());
    advance();
    if (!begins_type(at_))
        return make_missing<ast::ErrorType>();
    unexpected.remove(tokens_[at_ - 1].range());
    return parse_type_specification(use);
}

/// At a misspelt STRUCT: an END_STRUCT closes nothing otherwise.
bool Parser::at_misspelt_struct() {
    static constexpr TokenSet after_name{TokenKind::colon, TokenKind::comma};
    return peek() == TokenKind::identifier && after_name.contains(peek_second()) &&
           is_misspelling(text(at_), spelling(TokenKind::kw_struct)) &&
           unclosed(TokenKind::kw_end_struct) < 0;
}

/// Behind a `:`, at an element of a structure that lacks its STRUCT: an END_STRUCT closes nothing
/// otherwise.
bool Parser::at_element_without_struct() {
    return at(TokenKind::identifier) && peek() == TokenKind::colon && at_ > 0 &&
           tokens_[at_ - 1].kind() == TokenKind::colon && begins_type(next(next(at_))) &&
           unclosed(TokenKind::kw_end_struct) < 0;
}

/// In a structure that lacks its closing word, at the next one: it begins in the column of this one
/// or in its line. Otherwise it is nested in it.
bool Parser::at_next_structure() {
    const OpenBlock& block = open_.back();
    if (block.closer != TokenKind::kw_end_struct || peek() != TokenKind::colon ||
        peek_second() != TokenKind::kw_struct || block.opener < 2 ||
        unclosed(TokenKind::kw_end_struct) <= 0)
        return false;
    const std::uint32_t name = block.opener - 2; // with the `:` between them
    return token().first_on_line() ? tokens_[name].first_on_line() && column(name) == column(at_)
                                   : on_same_line(name, at_);
}

/// Passes over VAR and END_VAR in a structure that is closed: they stand around the elements of no
/// structure. All of them are one mistake.
void Parser::skip_block_words(std::optional<Report>& report) {
    while ((at(block_openers) && unclosed(TokenKind::kw_end_struct) <= 0) ||
           (at(TokenKind::kw_end_var) && report)) {
        if (report)
            report->also_remove(token().range());
        else
            report.emplace(report_at(at_, DiagnosticId::not_a_declaration,
                                     {"the declaration of a structure element", describe(at_)})
                               .remove(token().range()));
        count_as_name(kind());
        advance();
    }
}

/// Part of structure_declaration: the elements of the structure that the token `opener` opens, and
/// its closing word.
void Parser::parse_structure_elements(ast::StructureDeclaration& structure, std::uint32_t opener) {
    open_block(TokenKind::kw_end_struct, opener);
    ListBuilder<ast::Node> elements(*this);
    std::optional<Report> words;
    while (skip_block_words(words), !at_end_of_declarations())
        add_in_loop(elements, [this] { return parse_structure_element_declaration(); });
    if (elements.empty())
        report_empty_block(opener);
    structure.elements = elements.finish();
    close_block(";");
}

// structure_element_declaration = structure_element_name ":"
//     ( simple_spec_init | subrange_spec_init | enumerated_spec_init | array_spec_init
//     | initialized_structure | single_byte_string_spec | double_byte_string_spec ) ;
// structure_element_name = identifier ;
const ast::Node* Parser::parse_structure_element_declaration() {
    if (at_whole_declaration())
        return parse_whole_declaration<ast::StructureElementDeclaration>();
    drop_word_before_declaration("the declaration of a structure element");
    if (!at(TokenKind::identifier) && !at_declaration_start())
        return parse_error_declaration("the declaration of a structure element");
    auto* node = make<ast::StructureElementDeclaration>();
    ListBuilder<ast::Identifier> names(*this);
    do
        names.add(parse_declared_name("the name of a structure element"));
    while (accept(TokenKind::comma));
    node->names = names.finish();
    if (node->names.size() > 1)
        report(DiagnosticId::several_element_names,
               token_range(node->names[1]->first_token, node->names.back()->end_token));
    if (const ast::Location* location = parse_optional_location();
        location != nullptr && !tokens_[location->end_token - 1].malformed())
        report_node(*location, DiagnosticId::name_with_location, {"STRUCT"})
            .remove(
                {tokens_[location->first_token - 1].end(), tokens_[location->end_token - 1].end()});
    expect_colon();
    node->specification = parse_type_specification();
    check_no_function_block(*node->specification, "a structure element");
    node->initial_value = parse_optional_initial_value();
    check_initial_value(*node->specification, node->initial_value);
    finish(node);
    expect_semicolon_of_declaration();
    return node;
}

// ---- initial values -----------------------------------------------------------------------------

/// Part of simple_spec_init, subrange_spec_init, enumerated_spec_init, array_spec_init,
/// initialized_structure: the `:=` and what stands behind it.
const ast::Expression* Parser::parse_optional_initial_value() {
    const bool slip = at(TokenKind::equal) || at(TokenKind::equal_equal) ||
                      (at(TokenKind::colon) && peek() == TokenKind::equal);
    if (slip)
        expect_assign();
    else if (!accept(TokenKind::assign))
        return nullptr;
    const bool alone = at(plain_operands) && tokens_[at_ + 1].kind() == TokenKind::semicolon &&
                       tokens_[next(at_ + 1)].first_on_line();
    if (alone)
        return at_literal() ? parse_literal(at_) : parse_enumerated_value();
    static constexpr TokenSet opening{TokenKind::left_bracket, TokenKind::left_parenthesis};
    const bool lacks_bracket =
        !at(opening) && !token().first_on_line() && list_closes_on_line(TokenKind::right_bracket);
    return lacks_bracket ? parse_array_initialization() : parse_initial_value();
}

// array_initial_element = constant | enumerated_value | structure_initialization
//                       | array_initialization ;
/// The same stands behind the `:=` of every declaration; what fits which type is checked
/// afterwards.
const ast::Expression* Parser::parse_initial_value() {
    if (at(TokenKind::left_bracket))
        return parse_array_initialization();
    if (at(TokenKind::left_parenthesis)) {
        if (at_equal_in_structure())
            return parse_structure_initialization();
        if (peek_second() == TokenKind::assign || peek() == TokenKind::assign ||
            peek() == TokenKind::right_parenthesis ||
            (peek() == TokenKind::identifier && peek_second() == TokenKind::colon))
            return parse_structure_initialization();
        const TokenKind separator = separator_in_parentheses();
        if (separator == TokenKind::assign)
            return parse_structure_initialization();
        if (separator == TokenKind::comma)
            return parse_array_initialization();
    }
    static constexpr TokenSet after_value{TokenKind::semicolon, TokenKind::comma,
                                          TokenKind::right_parenthesis, TokenKind::right_bracket};
    if (at(after_value) && report_braces())
        return make_missing<ast::ErrorExpression>();
    const bool name = at(TokenKind::identifier) || at_operand_keyword();
    if (at(TokenKind::enumerated_value) || (name && after_value.contains(peek()))) {
        if (is_keyword(kind()))
            report_reserved_word(at_);
        return parse_enumerated_value();
    }
    if (at_sign_apart_from_number())
        return parse_constant_behind_gap();
    const std::size_t reports = diagnostics_.size();
    const ast::Expression* value = parse_expression();
    if (value->missing || ast::is<ast::Constant>(value->kind) ||
        value->kind == ast::NodeKind::error_expression)
        return value;
    if (value->kind == ast::NodeKind::variable_name)
        return as_enumerated_value(*value);
    if (!is_faulty(*value, reports))
        report_not_plain(*value, "an initial value");
    return value;
}

/// `(a = 1)` behind the `:=` of a derived type or a structure element, or in a list of an array's
/// initial values. Behind the `:=` of an elementary type it compares.
bool Parser::at_equal_in_structure() const noexcept {
    static constexpr TokenSet before{TokenKind::assign, TokenKind::equal, TokenKind::equal_equal};
    if (!before.contains(peek_second()) || peek() != TokenKind::identifier || at_ < 2)
        return false;
    const TokenKind second = tokens_[at_ - 2].kind();
    const TokenKind first = tokens_[at_ - 1].kind();
    const bool in_list = first == TokenKind::left_bracket || first == TokenKind::comma ||
                         (first == TokenKind::left_parenthesis && second == TokenKind::integer);
    std::uint32_t value = next(next(next(at_)));
    if (tokens_[value].kind() == TokenKind::minus)
        value = next(value);
    const TokenKind behind = tokens_[next(value)].kind();
    return (in_list || (before.contains(first) && second == TokenKind::identifier)) &&
           (tokens_[value].kind() == TokenKind::left_parenthesis ||
            behind == TokenKind::right_parenthesis || behind == TokenKind::comma);
}

/// `{1, 2, 3}` of other languages for an initial value: here it is a pragma.
bool Parser::report_braces() {
    const auto pragma = std::ranges::lower_bound(
        lexical_, previous_end(), {}, [](const Diagnostic& one) { return one.range.begin; });
    if (pragma == lexical_.end() || pragma->id != DiagnosticId::pragma ||
        pragma->range.begin > token().offset())
        return false;
    const TextRange open{pragma->range.begin, pragma->range.begin + 1};
    const TextRange close{pragma->range.end - 1, pragma->range.end};
    const std::string_view values = text_.substr(open.end, close.begin - open.end);
    const bool structure = values.find(":=") != values.npos;
    const Report braces =
        report(DiagnosticId::unexpected_token, open, {structure ? "`(`" : "`[`", "`{`"});
    reported_at_ = at_;
    const bool nested = values.find('{') != values.npos;
    if (nested && structure) // which of them are structures?
        return true;
    std::vector<TextEdit> edits;
    for (std::uint32_t i = open.begin; i < close.end; ++i)
        if (text_[i] == '{')
            edits.push_back({{i, i + 1}, structure ? "(" : "["});
        else if (text_[i] == '}')
            edits.push_back({{i, i + 1}, structure ? ")" : "]"});
    diagnostics_[braces.index()].fixes.push_back({std::move(edits)});
    return true;
}

/// `:=` or `,` when one stands directly inside the parentheses that begin here.
TokenKind Parser::separator_in_parentheses() const noexcept {
    constexpr std::uint32_t furthest = 1000; // bounds the time that nested ones take
    TokenKind found = TokenKind::left_parenthesis;
    std::uint32_t depth = 0;
    for (std::uint32_t i = at_; i != count_ && i - at_ < furthest; i = next(i)) {
        const TokenKind here = tokens_[i].kind();
        if (here == TokenKind::left_parenthesis || here == TokenKind::left_bracket)
            ++depth;
        else if (here == TokenKind::right_parenthesis || here == TokenKind::right_bracket)
            --depth;
        else if (here == TokenKind::assign && depth == 1)
            return here;
        else if (here == TokenKind::comma && depth == 1)
            found = here;
        if (depth == 0 || here == TokenKind::semicolon)
            break;
    }
    return found;
}

// simple_spec_init = simple_specification [ ":=" constant ] ;
// subrange_spec_init = subrange_specification [ ":=" signed_integer ] ;
// enumerated_spec_init = enumerated_specification [ ":=" enumerated_value ] ;
// array_spec_init = array_specification [ ":=" array_initialization ] ;
// initialized_structure = structure_type_name [ ":=" structure_initialization ] ;
/// What each kind of specification takes; of a type's name it is not known here.
void Parser::check_initial_value(const ast::TypeSpecification& type, const ast::Expression* value) {
    if (value == nullptr || value->missing || is_faulty(*value, diagnostics_.size()))
        return;
    const bool constant = ast::is<ast::Constant>(value->kind);
    const bool name = value->kind == ast::NodeKind::enumerated_value;
    const bool list = value->kind == ast::NodeKind::array_initialization;
    if (!constant && !name && !list && value->kind != ast::NodeKind::structure_initialization)
        return; // reported where it was read
    const bool subrange = type.kind == ast::NodeKind::subrange_specification;
    bool fits = true;
    const char* needed = "a constant";
    switch (type.kind) {
    case ast::NodeKind::elementary_type_name: fits = constant; break;
    case ast::NodeKind::string_specification:
        fits = has_width_of(*value, *ast::as<ast::StringSpecification>(&type));
        needed = ast::as<ast::StringSpecification>(&type)->double_byte
                     ? "a string in double quotes"
                     : "a string in single quotes";
        break;
    case ast::NodeKind::subrange_specification:
        fits = is_signed_integer(*value);
        needed = "an integer";
        break;
    case ast::NodeKind::enumerated_specification:
        fits = name;
        needed = "an enumerated value";
        break;
    case ast::NodeKind::array_specification:
        fits = list;
        needed = "`[`";
        break;
    default: break;
    }
    const bool other_number = value->kind == ast::NodeKind::integer_literal ||
                              value->kind == ast::NodeKind::bit_string_literal;
    if (fits)
        return;
    const bool reported = name && used_as_name(tokens_[value->first_token].kind());
    if (reported)
        return;
    if (name || (subrange && other_number)) // the name of a constant, a number in another notation
        report_not_plain(*value, "an initial value");
    else
        report_at(value->first_token, DiagnosticId::unexpected_token,
                  {needed, quoted(value->first_token)});
    if (type.kind == ast::NodeKind::array_specification && at(TokenKind::comma))
        reported_at_ = at_; // the rest of a list without brackets
}

/// True for a character string of the width that STRING or WSTRING with a length asks for; of both
/// behind the name of a data type (string_type_declaration).
bool Parser::has_width_of(const ast::Expression& value,
                          const ast::StringSpecification& type) const noexcept {
    if (value.kind != ast::NodeKind::character_string)
        return false;
    return open_.back().closer == TokenKind::kw_end_type ||
           tokens_[value.first_token].kind() ==
               (type.double_byte ? TokenKind::double_byte_string : TokenKind::single_byte_string);
}

/// A lone name where only a constant can stand.
const ast::Expression* Parser::as_enumerated_value(const ast::Expression& name) {
    auto* node = make_from<ast::EnumeratedValue>(&name);
    node->hash = static_cast<const ast::VariableName&>(name).hash;
    node->end_token = name.end_token;
    ast::mark_unused(name, arena_.bytes());
    return node;
}

// enumerated_value = [ enumerated_type_name "#" ] identifier ;
const ast::Expression* Parser::parse_enumerated_value() {
    auto* node = make<ast::EnumeratedValue>();
    node->hash = hash_name(split_enumerated_value(text(at_)).value);
    check_enumerated_value_names(advance());
    return finish(node);
}

/// The two names of `Color#Red` are one token, so that no other function sees them.
void Parser::check_enumerated_value_names(std::uint32_t token) {
    if (tokens_[token].malformed() || is_keyword(tokens_[token].kind())) // reported already
        return;
    const EnumeratedValueName names = split_enumerated_value(text(token));
    for (const std::string_view name : {names.type, names.value}) {
        if (name.empty())
            continue;
        const auto begin = static_cast<std::uint32_t>(name.data() - text_.data());
        const TextRange range{begin, begin + static_cast<std::uint32_t>(name.size())};
        if (keyword_kind(name) != TokenKind::identifier)
            report(DiagnosticId::reserved_word_as_name, range, {name})
                .replace(range, std::string(name) + "_1");
        else
            check_name_of_standard(range, hash_name(name), NameUse::other);
    }
}

/// `[1; 2]`, when the list goes on behind the `;` and is closed in this line. All of them are one
/// mistake: `first` is its report.
bool Parser::accept_semicolon_for_comma(TokenKind bracket, std::optional<Report>& first) {
    if (!at(TokenKind::semicolon) || peek() == bracket || !list_closes_on_line(bracket))
        return false;
    take_semicolon_for_comma(first);
    return true;
}

/// Adds the `;` at the cursor to the report of the first one in its list.
void Parser::take_semicolon_for_comma(std::optional<Report>& first) {
    if (!first)
        first.emplace(report_unexpected("`,`").replace(token().range(), ","));
    else if (*first)
        diagnostics_[first->index()].fixes.front().edits.push_back({token().range(), ","});
    advance();
}

/// True when nothing but elements of a list stand between the cursor and `bracket`.
bool Parser::list_closes_on_line(TokenKind bracket) const noexcept {
    static constexpr TokenSet not_in_list =
        statement_words | block_openers | TokenSet{TokenKind::assign, TokenKind::colon};
    static constexpr TokenSet opening_brackets{TokenKind::left_parenthesis,
                                               TokenKind::left_bracket};
    std::uint32_t depth = 0;
    std::uint32_t i = at_;
    for (std::uint32_t steps = 0; steps < furthest_on_line; ++steps) {
        const TokenKind here = tokens_[i].kind();
        if (here == TokenKind::end_of_unit || not_in_list.contains(here) ||
            tokens_[next(i)].first_on_line())
            break;
        if (closing_brackets.contains(here) && depth-- == 0)
            return here == bracket;
        depth += opening_brackets.contains(here) ? 1 : 0;
        i = next(i);
    }
    return depth == 0 && tokens_[i].kind() == bracket;
}

// array_initialization = "[" array_initial_elements { "," array_initial_elements } "]" ;
const ast::Expression* Parser::parse_array_initialization() {
    const NestingGuard guard(*this);
    if (guard.too_deep())
        return parse_too_deep_expression();
    auto* node = make<ast::ArrayInitialization>();
    const std::optional<Report> parentheses = accept_parenthesis_for_bracket();
    if (!parentheses && !accept(TokenKind::left_bracket)) // `1, 2]`
        report_missing(DiagnosticId::missing_token, {"`[`"}).insert(token().offset(), "[");
    ListBuilder<ast::Expression> elements(*this);
    std::optional<Report> semicolons;
    const TokenKind bracket = parentheses ? TokenKind::right_parenthesis : TokenKind::right_bracket;
    do
        elements.add(parse_array_initial_elements());
    while (accept(TokenKind::comma) || accept_missing_comma() ||
           accept_semicolon_for_comma(bracket, semicolons));
    if (parentheses)
        close_parenthesis_for_bracket(*parentheses);
    else
        expect_closing(TokenKind::right_bracket);
    node->elements = elements.finish();
    return finish(node);
}

// array_initial_elements = array_initial_element | integer "(" [ array_initial_element ] ")" ;
const ast::Expression* Parser::parse_array_initial_elements() {
    const bool other_count = (at_signed_number() && peek_second() == TokenKind::left_parenthesis) ||
                             ((at(TokenKind::based_integer) || at(TokenKind::typed_literal)) &&
                              peek() == TokenKind::left_parenthesis);
    if (!other_count && !(at(TokenKind::integer) && peek() == TokenKind::left_parenthesis))
        return parse_initial_value();
    auto* node = make<ast::ArrayInitialElements>();
    node->count = parse_integer("the count of a repetition");
    advance();
    ListBuilder<ast::Expression> elements(*this);
    if (!at(TokenKind::right_parenthesis)) {
        do
            elements.add(parse_initial_value());
        while (accept(TokenKind::comma));
    }
    expect_closing(TokenKind::right_parenthesis);
    node->elements = elements.finish();
    if (node->elements.size() > 1)
        report_node(*node->elements[1], DiagnosticId::repeated_group);
    return finish(node);
}

// structure_initialization = "(" structure_element_initialization
//                            { "," structure_element_initialization } ")" ;
const ast::Expression* Parser::parse_structure_initialization() {
    const NestingGuard guard(*this);
    if (guard.too_deep())
        return parse_too_deep_expression();
    auto* node = make<ast::StructureInitialization>();
    advance();
    ListBuilder<ast::StructureElementInitialization> elements(*this);
    // A parenthesis behind the comma belongs to the list around this one.
    const auto next_element = [this] {
        return !(at(TokenKind::comma) && peek() == TokenKind::left_parenthesis) &&
               (accept(TokenKind::comma) || accept_missing_comma(true));
    };
    do
        elements.add(parse_structure_element_initialization());
    while (next_element());
    if (at(TokenKind::comma))
        expect(TokenKind::right_parenthesis);
    else
        expect_closing(TokenKind::right_parenthesis);
    node->elements = elements.finish();
    return finish(node);
}

// structure_element_initialization = structure_element_name ":="
//     ( constant | enumerated_value | array_initialization | structure_initialization ) ;
const ast::StructureElementInitialization* Parser::parse_structure_element_initialization() {
    auto* node = make<ast::StructureElementInitialization>();
    if (at_next_declaration()) {
        node->name = make_missing_identifier("the name of a structure element");
        node->value = make_missing<ast::ErrorExpression>();
        return finish(node);
    }
    node->name = parse_name("the name of a structure element");
    if (at(TokenKind::dot) || at(TokenKind::left_bracket)) {
        report_unexpected("`:=`");
        skip_to({TokenKind::assign, TokenKind::comma, TokenKind::right_parenthesis,
                 TokenKind::semicolon});
        accept(TokenKind::assign);
    } else {
        expect_assign();
    }
    node->value = parse_initial_value();
    return finish(node);
}

} // namespace iecfront
