#include "parser/misspelling.hpp"
#include "parser/parser.hpp"

#include <iecfront/lexer/literals.hpp>
#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/standard_names.hpp>

namespace iecfront {
namespace {

using ast::BlockQualifier;
using ast::VariableBlock;

constexpr TokenSet ends_of_declarations =
    block_openers | unit_ends | statement_words |
    TokenSet{TokenKind::kw_end_var, TokenKind::kw_end_struct, TokenKind::kw_end_resource,
             TokenKind::kw_initial_step};

constexpr TokenSet qualifiers{TokenKind::kw_constant, TokenKind::kw_retain,
                              TokenKind::kw_non_retain};

// What follows the opening word of a block.
constexpr TokenSet after_opener = qualifiers | TokenSet{TokenKind::identifier};

VariableBlock block_of(TokenKind opener) noexcept {
    return static_cast<VariableBlock>(static_cast<unsigned>(opener) -
                                      static_cast<unsigned>(TokenKind::kw_var));
}

TokenKind opener_of(VariableBlock block) noexcept {
    return static_cast<TokenKind>(static_cast<unsigned>(TokenKind::kw_var) +
                                  static_cast<unsigned>(block));
}

/// `GLOBAL` of VAR_GLOBAL; nothing of VAR.
std::string_view without_prefix(TokenKind opener) noexcept {
    constexpr std::string_view prefix = "VAR_";
    const std::string_view word = spelling(opener);
    return word.size() < prefix.size() ? std::string_view() : word.substr(prefix.size());
}

ast::Edge edge_of(TokenKind word) noexcept {
    return word == TokenKind::kw_r_edge ? ast::Edge::rising : ast::Edge::falling;
}

/// Which blocks each place can have (B.1.5, B.1.7), and which qualifiers (B.1.4.3).
struct BlockRow {
    bool function, function_block, program, configuration, resource;
    bool constant, retain, non_retain;
};

constexpr BlockRow block_rows[] = {
    //               FUNCTION  FB     PROGRAM CONFIG RESOURCE  CONSTANT RETAIN NON_RETAIN
    /* VAR          */ {true, true, true, false, false, true, true, true},
    /* VAR_INPUT    */ {true, true, true, false, false, false, true, true},
    /* VAR_OUTPUT   */ {true, true, true, false, false, false, true, true},
    /* VAR_IN_OUT   */ {true, true, true, false, false, false, false, false},
    /* VAR_TEMP     */ {false, true, true, false, false, false, false, false},
    /* VAR_EXTERNAL */ {false, true, true, false, false, true, false, false},
    /* VAR_GLOBAL   */ {false, false, true, true, true, true, true, false},
    /* VAR_ACCESS   */ {false, false, true, true, false, false, false, false},
    /* VAR_CONFIG   */ {false, false, false, true, false, false, false, false},
};

} // namespace

/// `name : INT`, which can be nothing but a declaration.
bool Parser::at_plain_declaration() const noexcept {
    return at(TokenKind::identifier) && tokens_[at_ + 1].kind() == TokenKind::colon &&
           !tokens_[at_ + 1].first_on_line() && is_elementary_type_name(tokens_[at_ + 2].kind());
}

/// `name : INT;` has all that a declaration needs, and nothing that could not stand there.
bool Parser::at_whole_declaration() const noexcept {
    return at_plain_declaration() && !tokens_[at_ + 2].first_on_line() &&
           tokens_[at_ + 3].kind() == TokenKind::semicolon;
}

/// `name :` begins one as well, whatever else a statement or an instruction may be, where no block
/// is open.
bool Parser::at_named_declaration() {
    return at_plain_declaration() ||
           (at(TokenKind::identifier) && tokens_[at_ + 1].kind() == TokenKind::colon &&
            !tokens_[at_ + 1].first_on_line() && balanced());
}

bool Parser::at_end_of_declarations() {
    static constexpr TokenSet after_name{TokenKind::colon, TokenKind::comma, TokenKind::kw_at};
    if (at_named_declaration())
        return false;
    if (at(open_.back().closer) && balanced() && !after_name.contains(peek()))
        return true;
    if (at(ends_of_declarations))
        return at_end() || at_block_of_location() ||
               (!after_name.contains(peek()) && end_of_declaration_with_stray_word() == at_);
    if (at_misspelt_closer() || (!balanced() && at_foreign_closer()) || at_next_structure())
        return true;
    if (is_open(TokenKind::kw_end_configuration))
        return at_configuration_part() && unclosed(TokenKind::kw_end_var) > 0;
    // The body in a declaration block: its END_VAR is missing.
    const bool statement = at_statement_start() && !is_elementary_type_name(peek_second());
    const bool instruction = token().first_on_line() && peek() != TokenKind::colon &&
                             at(TokenKind::identifier) && begins_instruction_on_line();
    const bool empty = at(TokenKind::semicolon) && unit_ends.contains(peek());
    return open_.back().closer == TokenKind::kw_end_var && (statement || instruction || empty) &&
           unclosed(TokenKind::kw_end_var) > 0;
}

/// At `VAR AT %QX0.1 : BOOL;`, which begins another block: END_VAR is missing before it.
bool Parser::at_block_of_location() {
    return at(block_openers) && token().first_on_line() && peek() == TokenKind::kw_at &&
           unclosed(TokenKind::kw_end_var) > 0;
}

/// At the RESOURCE, TASK or PROGRAM that follows the declarations of a configuration.
bool Parser::at_configuration_part() const noexcept {
    static constexpr TokenSet parts{TokenKind::kw_resource, TokenKind::kw_task,
                                    TokenKind::kw_program};
    return parts.contains(misspelt_configuration_word()) && peek() != TokenKind::colon &&
           peek() != TokenKind::comma && peek() != TokenKind::kw_at;
}

/// At `VAR_STAT` and its like: a word of other dialects that opens a block.
bool Parser::at_unknown_block() const noexcept {
    constexpr std::string_view prefix = "VAR_";
    return at(TokenKind::identifier) && names_equal(text(at_).substr(0, prefix.size()), prefix) &&
           peek() != TokenKind::assign && peek() != TokenKind::colon;
}

/// The opening word of a block that is meant by a misspelt one at the cursor; end_of_unit when it
/// is none.
TokenKind Parser::misspelt_block_opener() const noexcept {
    TokenKind meant = TokenKind::end_of_unit;
    if (!at(TokenKind::identifier) || !after_opener.contains(peek()))
        return meant;
    if (at_word("VAR_IN"))
        return TokenKind::kw_var_input;
    if (at_word("VAR_OUT"))
        return TokenKind::kw_var_output;
    std::size_t fewest = 2;
    for (const BlockRow& row : block_rows) {
        const auto opener = opener_of(static_cast<VariableBlock>(&row - block_rows));
        if (names_equal(text(at_), without_prefix(opener))) // `GLOBAL`
            return opener;
        const auto wrong = misspelt_letters(text(at_), spelling(opener));
        if (wrong && *wrong < fewest) {
            fewest = *wrong;
            meant = opener;
        }
    }
    return meant;
}

/// True at declarations whose opening word is missing or has a fault: an END_VAR closes nothing
/// otherwise.
bool Parser::at_declarations_without_opener() {
    if (at(qualifiers) && block_openers.contains(peek()))
        return true;
    if ((at(qualifiers) || at_unknown_block() ||
         misspelt_block_opener() != TokenKind::end_of_unit) &&
        unclosed(TokenKind::kw_end_var) < 0)
        return true;
    return (at_declaration_start() || (at(TokenKind::identifier) && peek() == TokenKind::comma)) &&
           peek_second() != TokenKind::equal && unclosed(TokenKind::kw_end_var) < 0;
}

// ---- blocks -------------------------------------------------------------------------------------

// input_declarations = "VAR_INPUT" [ "RETAIN" | "NON_RETAIN" ]
//                      input_declaration ";" { input_declaration ";" } "END_VAR" ;
// output_declarations = "VAR_OUTPUT" [ "RETAIN" | "NON_RETAIN" ]
//                       output_declaration ";" { output_declaration ";" } "END_VAR" ;
// input_output_declarations = "VAR_IN_OUT" var_declaration ";" { var_declaration ";" } "END_VAR" ;
// var_declarations = "VAR" [ "CONSTANT" ] var_init_decl ";" { var_init_decl ";" } "END_VAR" ;
// retentive_var_declarations = "VAR" "RETAIN" var_init_decl ";" { var_init_decl ";" } "END_VAR" ;
// non_retentive_var_decls = "VAR" "NON_RETAIN" var_init_decl ";" { var_init_decl ";" } "END_VAR" ;
// function_var_decls = "VAR" [ "CONSTANT" ] var2_init_decl ";" { var2_init_decl ";" } "END_VAR" ;
// located_var_declarations = "VAR" [ "CONSTANT" | "RETAIN" | "NON_RETAIN" ]
//                            located_var_decl ";" { located_var_decl ";" } "END_VAR" ;
// incompl_located_var_declarations = "VAR" [ "RETAIN" | "NON_RETAIN" ]
//                                    incompl_located_var_decl ";"
//                                    { incompl_located_var_decl ";" } "END_VAR" ;
// temp_var_decls = "VAR_TEMP" temp_var_decl ";" { temp_var_decl ";" } "END_VAR" ;
// external_var_declarations = "VAR_EXTERNAL" [ "CONSTANT" ] external_declaration ";"
//                             { external_declaration ";" } "END_VAR" ;
// global_var_declarations = "VAR_GLOBAL" [ "CONSTANT" | "RETAIN" ]
//                           global_var_decl ";" { global_var_decl ";" } "END_VAR" ;
// program_access_decls = "VAR_ACCESS" program_access_decl ";" { program_access_decl ";" }
//                        "END_VAR" ;
// access_declarations = "VAR_ACCESS" access_declaration ";" { access_declaration ";" } "END_VAR" ;
// instance_specific_initializations = "VAR_CONFIG" instance_specific_init ";"
//                                     { instance_specific_init ";" } "END_VAR" ;
/// They differ in their word and in what is checked afterwards.
const ast::VariableDeclarations* Parser::parse_variable_declarations(Place place) {
    auto* node = make<ast::VariableDeclarations>();
    const std::uint32_t opener = at_;
    open_block(TokenKind::kw_end_var, opener);
    parse_block_head(*node, place);
    if (at(block_openers) && kind() == tokens_[opener].kind() && on_same_line(opener, at_)) {
        report_unexpected("the declaration of a variable").remove(token().range());
        change_unclosed(TokenKind::kw_end_var, -1);
        advance();
    }
    ListBuilder<ast::Node> declarations(*this);
    const bool of_paths =
        node->block == VariableBlock::var_access || node->block == VariableBlock::var_config;
    for (;;) {
        if (!of_paths && at_whole_declaration())
            declarations.add(parse_whole_declaration<ast::VariableDeclaration>());
        else if (!of_paths && at_named_declaration())
            declarations.add(parse_variable_declaration(*node, place));
        else if (!at_end_of_declarations())
            add_in_loop(declarations, [&] { return parse_declaration(*node, place); });
        else
            break;
    }
    if (declarations.empty())
        report_empty_block(opener);
    node->declarations = declarations.finish();
    check_mixed(*node);
    close_block("");
    finish(node);
    if (place == Place::configuration || place == Place::resource || place == Place::library ||
        place == Place::anywhere)
        accept_extra_semicolon();
    else
        accept_extra_semicolon_before_body();
    return node;
}

/// Part of var_declarations: the opening word of any block and its qualifier, or what stands for
/// them.
void Parser::parse_block_head(ast::VariableDeclarations& block, Place place) {
    if (at(block_openers)) {
        block.block = block_of(accept_split_block_opener());
        advance();
        const std::uint32_t qualifier = at_;
        block.qualifier = parse_block_qualifiers();
        check_block(block, qualifier, place);
        return;
    }
    if (at(qualifiers) && block_openers.contains(peek())) {
        report_swapped(next(at_));
        block.qualifier = parse_block_qualifiers();
        block.block = block_of(kind());
        advance();
        return;
    }
    change_unclosed(TokenKind::kw_end_var, 1);
    const bool globals = place == Place::configuration || place == Place::resource;
    block.block = globals ? VariableBlock::var_global : VariableBlock::var;
    if (const TokenKind meant = misspelt_block_opener(); meant != TokenKind::end_of_unit) {
        block.block = block_of(meant);
        accept_misspelt(meant);
    } else if (at_unknown_block()) {
        report_at(at_, DiagnosticId::unknown_block, {text(at_)})
            .replace(token().range(), std::string(spelling(opener_of(block.block))));
        advance();
    } else {
        const std::string word(spelling(opener_of(block.block)));
        report_missing(DiagnosticId::missing_token, {"`" + word + "`"})
            .insert(token().offset(), word + " ");
    }
    block.qualifier = parse_block_qualifiers();
}

/// Reports the token at the cursor and `second` behind it, which stand in the wrong order.
void Parser::report_swapped(std::uint32_t second, std::string_view between) {
    const TextRange range = token_range(at_, second + 1);
    const std::string meant =
        std::string(text(second)) + std::string(between) + std::string(text(at_));
    report(DiagnosticId::unexpected_token, range,
           {"`" + meant + "`", "`" + std::string(text_.substr(range.begin, range.size())) + "`"})
        .replace(range, meant);
}

/// Takes a misspelt keyword.
void Parser::accept_misspelt(TokenKind meant) {
    const std::string word(spelling(meant));
    report_at(at_, DiagnosticId::misspelt_word, {text(at_), word}).replace(token().range(), word);
    advance();
}

/// `VAR INPUT a : INT;`: passes over the first word, and gives what the two mean.
TokenKind Parser::accept_split_block_opener() {
    const std::uint32_t second = next(at_);
    const bool two_words = at(TokenKind::kw_var) &&
                           tokens_[second].kind() == TokenKind::identifier &&
                           after_opener.contains(tokens_[next(second)].kind());
    if (!two_words)
        return kind();
    const std::string word = "VAR_" + std::string(text(second));
    for (const BlockRow& row : block_rows) {
        const auto meant = opener_of(static_cast<VariableBlock>(&row - block_rows));
        if (!names_equal(word, spelling(meant)))
            continue;
        const TextRange words = token_range(at_, second + 1);
        report(DiagnosticId::misspelt_word, words,
               {text_.substr(words.begin, words.size()), spelling(meant)})
            .replace(words, std::string(spelling(meant)));
        advance();
        return meant;
    }
    return kind();
}

// Part of located_var_declarations: [ "CONSTANT" | "RETAIN" | "NON_RETAIN" ]
ast::BlockQualifier Parser::parse_block_qualifiers() {
    BlockQualifier qualifier = BlockQualifier::none;
    for (;;) {
        BlockQualifier here{};
        switch (misspelt_qualifier()) {
        case TokenKind::kw_constant: here = BlockQualifier::constant; break;
        case TokenKind::kw_retain: here = BlockQualifier::retain; break;
        case TokenKind::kw_non_retain: here = BlockQualifier::non_retain; break;
        default:
            if (!at_unknown_qualifier())
                return qualifier;
            report_at(at_, DiagnosticId::unknown_qualifier, {text(at_)}).remove(token().range());
            advance();
            continue;
        }
        if (qualifier != BlockQualifier::none)
            report_at(at_, DiagnosticId::several_qualifiers).remove(token().range());
        else
            qualifier = here;
        if (at(TokenKind::identifier))
            accept_misspelt(misspelt_qualifier());
        else
            advance();
    }
}

/// The qualifier at the cursor, also a misspelt one; end_of_unit when there is none.
TokenKind Parser::misspelt_qualifier() const noexcept {
    if (at(qualifiers))
        return kind();
    const bool alone = peek() == TokenKind::kw_at && tokens_[next(at_)].first_on_line();
    if (at(TokenKind::identifier) && !token().first_on_line() &&
        (after_opener.contains(peek()) || alone))
        for (const TokenKind meant :
             {TokenKind::kw_constant, TokenKind::kw_retain, TokenKind::kw_non_retain})
            if (is_misspelling(text(at_), spelling(meant)) ||
                is_beginning(text(at_), spelling(meant)))
                return meant;
    return TokenKind::end_of_unit;
}

/// At `PERSISTENT` and its like of other dialects, on the line of the opening word.
bool Parser::at_unknown_qualifier() const noexcept {
    if (!at(TokenKind::identifier) || token().first_on_line() || !after_opener.contains(peek()))
        return false;
    static constexpr std::array<std::string_view, 5> words = {"PERSISTENT", "PUBLIC", "PRIVATE",
                                                              "PROTECTED", "INTERNAL"};
    return tokens_[next(at_)].first_on_line() ||
           std::any_of(words.begin(), words.end(),
                       [this](std::string_view word) { return at_word(word); });
}

void Parser::check_block(const ast::VariableDeclarations& block, std::uint32_t qualifier,
                         Place place) {
    const BlockRow& row = block_rows[static_cast<std::size_t>(block.block)];
    const std::uint32_t opener = block.first_token;
    bool fits = true;
    std::string_view where = "library";
    switch (place) {
    case Place::function: fits = row.function, where = "function"; break;
    case Place::function_block: fits = row.function_block, where = "function block"; break;
    case Place::program: fits = row.program, where = "program"; break;
    case Place::configuration: fits = row.configuration, where = "configuration"; break;
    case Place::resource: fits = row.resource, where = "resource"; break;
    case Place::anywhere: break;
    case Place::library: return;
    }
    if (!fits && place == Place::function &&
        (block.block == VariableBlock::var_external || block.block == VariableBlock::var_temp))
        report_at(opener, DiagnosticId::block_in_function, {text(opener)});
    else if (!fits)
        report_at(opener, DiagnosticId::block_not_in_this_unit, {text(opener), where});
    else
        check_qualifier(block, qualifier, place);
}

void Parser::check_qualifier(const ast::VariableDeclarations& block, std::uint32_t qualifier,
                             Place place) {
    const BlockRow& row = block_rows[static_cast<std::size_t>(block.block)];
    bool fits = true;
    switch (block.qualifier) {
    case BlockQualifier::none: return;
    case BlockQualifier::constant: fits = row.constant; break;
    case BlockQualifier::retain: fits = row.retain && place != Place::function; break;
    case BlockQualifier::non_retain: fits = row.non_retain && place != Place::function; break;
    }
    if (fits)
        return;
    report_at(qualifier, DiagnosticId::qualifier_of_block,
              {text(qualifier), text(block.first_token)});
}

// ---- declarations -------------------------------------------------------------------------------

/// Part of var_declarations: any one declaration in a block.
const ast::Node* Parser::parse_declaration(const ast::VariableDeclarations& block, Place place) {
    if (block.block == VariableBlock::var_access)
        return parse_access_declaration(place);
    if (block.block == VariableBlock::var_config)
        return parse_instance_specific_init();
    if (is_elementary_type_name(kind()) && peek() == TokenKind::identifier &&
        !tokens_[next(at_)].first_on_line())
        return parse_type_before_names();
    accept_qualifier_of_declaration(block);
    drop_word_before_declaration("the declaration of a variable");
    if (!at(TokenKind::identifier) && !at(TokenKind::kw_at) && !at_declaration_start())
        return parse_error_declaration("the declaration of a variable");
    return parse_variable_declaration(block, place);
}

/// `CONSTANT x : INT := 3;`: it is the block that has a qualifier.
void Parser::accept_qualifier_of_declaration(const ast::VariableDeclarations& block) {
    static constexpr TokenSet after_name{TokenKind::colon, TokenKind::comma, TokenKind::kw_at};
    const bool declaration = peek() == TokenKind::identifier &&
                             !tokens_[next(at_)].first_on_line() &&
                             after_name.contains(peek_second());
    if (!declaration || !(at(qualifiers) || at_word("CONST")))
        return;
    const std::string qualifier = at_word("CONST") ? "CONSTANT" : std::string(text(at_));
    report_at(at_, DiagnosticId::unexpected_token,
              {"`" + std::string(text(block.first_token)) + " " + qualifier + "` for the block",
               quoted(at_)});
    advance();
}

// input_declaration = var_init_decl | edge_declaration
//                   | ( variable_name | "EN" ) { "," ( variable_name | "EN" ) } ":"
//                     ( "BOOL" ( "R_EDGE" | "F_EDGE" ) | parameter_spec_init ) ;
// output_declaration = ( variable_name | "ENO" ) { "," ( variable_name | "ENO" ) } ":"
//                      parameter_spec_init ;
// parameter_spec_init = located_var_spec_init
//                     | function_block_type_name [ ":=" structure_initialization ] ;
// edge_declaration = var1_list ":" "BOOL" ( "R_EDGE" | "F_EDGE" ) ;
// var_init_decl = var1_init_decl | array_var_init_decl
//               | structured_var_init_decl | fb_name_decl
//               | string_var_declaration ;
// var1_init_decl = var1_list ":" ( simple_spec_init | subrange_spec_init | enumerated_spec_init ) ;
// array_var_init_decl = var1_list ":" array_spec_init ;
// structured_var_init_decl = var1_list ":" initialized_structure ;
// fb_name_decl = fb_name_list ":" function_block_type_name [ ":=" structure_initialization ] ;
// var2_init_decl = var1_init_decl | array_var_init_decl | structured_var_init_decl
//                | string_var_declaration ;
// var_declaration = temp_var_decl | fb_name_decl ;
// temp_var_decl = var1_declaration | array_var_declaration
//               | structured_var_declaration | string_var_declaration ;
// var1_declaration = var1_list ":" ( simple_specification | subrange_specification
//                                  | enumerated_specification ) ;
// array_var_declaration = var1_list ":" array_specification ;
// structured_var_declaration = var1_list ":" structure_type_name ;
// string_var_declaration = single_byte_string_var_declaration
//                        | double_byte_string_var_declaration ;
// single_byte_string_var_declaration = var1_list ":" single_byte_string_spec ;
// double_byte_string_var_declaration = var1_list ":" double_byte_string_spec ;
// located_var_decl = [ variable_name ] location ":" located_var_spec_init ;
// located_var_spec_init = simple_spec_init | subrange_spec_init | enumerated_spec_init
//                       | array_spec_init | initialized_structure
//                       | single_byte_string_spec | double_byte_string_spec ;
// incompl_located_var_decl = variable_name incompl_location ":" var_spec ;
// external_declaration = global_var_name ":"
//                        ( simple_specification | subrange_specification
//                        | enumerated_specification | array_specification
//                        | structure_type_name | function_block_type_name
//                        | "STRING" "[" integer "]" | "WSTRING" "[" integer "]" ) ;
// global_var_decl = global_var_spec ":" ( located_var_spec_init | function_block_type_name ) ;
// global_var_spec = global_var_list | [ global_var_name ] location ;
/// All are read as names, location, `:`, specification, edge and initial value.
const ast::VariableDeclaration*
Parser::parse_variable_declaration(const ast::VariableDeclarations& block, Place place) {
    auto* node = make<ast::VariableDeclaration>();
    if (at(TokenKind::identifier) && tokens_[at_ + 1].kind() == TokenKind::colon) {
        node->names = list_of(parse_declared_name("the name of a variable"));
    } else if (!at(TokenKind::kw_at) || peek() == TokenKind::colon || peek() == TokenKind::comma) {
        ListBuilder<ast::Identifier> names(*this);
        parse_declared_names(names, block);
        node->names = names.finish();
    }
    if (at(TokenKind::identifier) && peek() == TokenKind::identifier && !colon_follows_on_line())
        return parse_names_only(node);
    if (at_location())
        node->location = parse_optional_location();
    expect_colon();
    const bool edge_first =
        (at(TokenKind::kw_r_edge) || at(TokenKind::kw_f_edge)) && is_elementary_type_name(peek());
    if (edge_first) {
        report_swapped(next(at_));
        node->edge = edge_of(tokens_[advance()].kind());
    }
    node->specification = parse_type_specification();
    if (!at(TokenKind::semicolon)) {
        if (!edge_first)
            node->edge = parse_optional_edge(block, place, *node->specification);
        if (at(TokenKind::kw_at) && node->location == nullptr && !node->names.empty())
            parse_location_behind_type(node->first_token, node->names.back()->end_token);
        drop_qualifier_behind_type();
        node->initial_value = parse_optional_initial_value();
    }
    finish(node);
    check_declaration(*node, block, place);
    expect_semicolon_of_declaration();
    return node;
}

/// `x : INT CONSTANT := 5;`: it is the block that has a qualifier.
void Parser::drop_qualifier_behind_type() {
    static constexpr TokenSet behind{TokenKind::assign, TokenKind::semicolon};
    if (!at(qualifiers) || !behind.contains(peek()))
        return;
    report_unexpected("`;`").remove(token().range());
    advance();
}

/// In place of var_init_decl: `INT x, y := 1;`, as other languages declare variables.
const ast::Node* Parser::parse_type_before_names() {
    auto* error = make<ast::ErrorDeclaration>();
    const std::uint32_t type = advance();
    const std::uint32_t first = at_;
    do
        advance();
    while (accept(TokenKind::comma) && at(TokenKind::identifier));
    if (at(TokenKind::kw_at))
        parse_optional_location();
    const TextRange names = token_range(first, end_);
    const std::string meant = " : " + std::string(text(type));
    Report swapped = report(
        DiagnosticId::not_a_declaration, token_range(type, end_),
        {"`" + std::string(text_.substr(names.begin, names.size())) + meant + "`",
         "`" +
             std::string(text_.substr(tokens_[type].offset(), names.end - tokens_[type].offset())) +
             "`"});
    if (at(TokenKind::semicolon) || at(TokenKind::assign)) {
        swapped.replace({tokens_[type].offset(), names.begin}, {});
        diagnostics_[swapped.index()].fixes.back().edits.push_back({{names.end, names.end}, meant});
    }
    skip_declaration();
    expect_semicolon_of_declaration();
    return finish(error);
}

/// In place of var_init_decl: `b c d e;`, words without a colon and a type.
const ast::VariableDeclaration* Parser::parse_names_only(ast::VariableDeclaration* node) {
    report_unexpected("`:`");
    skip_declaration();
    node->specification = make_missing<ast::ErrorType>();
    accept(TokenKind::semicolon);
    return finish(node);
}

// var1_list = variable_name { "," variable_name } ;
// fb_name_list = fb_name { "," fb_name } ;
// fb_name = identifier ;
// global_var_list = global_var_name { "," global_var_name } ;
// global_var_name = identifier ;
void Parser::parse_declared_names(ListBuilder<ast::Identifier>& names,
                                  const ast::VariableDeclarations& block) {
    do
        names.add(parse_variable_name(block));
    while (accept(TokenKind::comma) ||
           (at(TokenKind::identifier) && colon_follows_on_line() && accept_missing_comma()));
}

/// Part of var1_list, variable_name: a declared one; EN and ENO have their places (6.1 D23).
const ast::Identifier* Parser::parse_variable_name(const ast::VariableDeclarations& block) {
    if (at(TokenKind::identifier))
        return parse_declared_name("the name of a variable");
    const bool control = (at(TokenKind::kw_en) && block.block == VariableBlock::var_input) ||
                         (at(TokenKind::kw_eno) && block.block == VariableBlock::var_output);
    return control ? make_identifier() : parse_declared_name("the name of a variable");
}

/// At `AT`, or at a location that lacks it.
bool Parser::at_location() const noexcept {
    static constexpr TokenSet starts{TokenKind::kw_at, TokenKind::direct_variable,
                                     TokenKind::incomplete_location};
    return at(starts);
}

// location = "AT" direct_variable ;
// incompl_location = "AT" ( "%I*" | "%Q*" | "%M*" ) ;
const ast::Location* Parser::parse_optional_location() {
    if (!at_location())
        return nullptr;
    const bool located = !at(TokenKind::kw_at);
    auto* node = make<ast::Location>();
    if (located)
        report_missing(DiagnosticId::missing_token, {"`AT`"}).insert(token().offset(), "AT ");
    else
        advance();
    if (at(TokenKind::direct_variable) || at(TokenKind::incomplete_location)) {
        node->variable = parse_direct_variable();
        return finish(node);
    }
    if (at_next_declaration()) {
        report_unfinished(DiagnosticId::missing_token, {"a directly represented variable"});
        node->variable = make_missing<ast::ErrorExpression>();
        return finish(node);
    }
    Report unexpected = report_unexpected("a directly represented variable");
    if (const std::uint32_t end = end_of_location_without_sign(); end > at_) {
        unexpected.insert(token().offset(), "%");
        auto* error = make<ast::ErrorExpression>();
        while (at_ < end)
            advance();
        node->variable = finish(error);
    } else if (at(TokenKind::colon) || at(ends_of_declarations) || at(TokenKind::semicolon)) {
        node->variable = make_missing<ast::ErrorExpression>();
    } else {
        auto* error = make<ast::ErrorExpression>();
        advance();
        node->variable = finish(error);
    }
    return finish(node);
}

/// At `IX0.1`, a location that lacks its `%`: the token behind it; else the one at the cursor.
std::uint32_t Parser::end_of_location_without_sign() const noexcept {
    if (!at(TokenKind::identifier))
        return at_;
    std::uint32_t last = at_; // end_of_unit is behind it
    while (tokens_[last + 1].offset() == tokens_[last].end() &&
           (tokens_[last + 1].kind() == TokenKind::dot ||
            tokens_[last + 1].kind() == TokenKind::integer))
        ++last;
    const TextRange range = token_range(at_, last + 1);
    const std::string meant = "%" + std::string(text_.substr(range.begin, range.size()));
    return direct_variable_value(meant) ? last + 1 : at_;
}

/// In place of located_var_decl: `x : BOOL AT %IX1`, which is written `x AT %IX1 : BOOL`.
void Parser::parse_location_behind_type(std::uint32_t declaration, std::uint32_t names_end) {
    const std::uint32_t before = previous_end();
    const std::uint32_t first = at_;
    if (parse_optional_location()->variable->kind == ast::NodeKind::error_expression)
        return; // as was reported: there is nothing to move
    const TextRange location = token_range(first, end_);
    const TextRange all = token_range(declaration, end_);
    const std::uint32_t name_end = tokens_[names_end - 1].end();
    const std::string moved = " " + std::string(text_.substr(location.begin, location.size()));
    const std::string meant = std::string(text_.substr(all.begin, name_end - all.begin)) + moved +
                              std::string(text_.substr(name_end, before - name_end));
    const Report misplaced =
        report(DiagnosticId::unexpected_token, location,
               {"`" + meant + "`", "`" + std::string(text_.substr(all.begin, all.size())) + "`"});
    diagnostics_[misplaced.index()].fixes.push_back(
        {{{{name_end, name_end}, moved}, {{before, location.end}, {}}}});
}

// direct_variable = "%" location_prefix size_prefix integer { "." integer } ;
const ast::Expression* Parser::parse_direct_variable() {
    return take<ast::DirectVariable>();
}

// Part of edge_declaration: ( "R_EDGE" | "F_EDGE" )
ast::Edge Parser::parse_optional_edge(const ast::VariableDeclarations& block, Place place,
                                      const ast::TypeSpecification& type) {
    if (!at(TokenKind::kw_r_edge) && !at(TokenKind::kw_f_edge))
        return ast::Edge::none;
    const std::string word(text(at_));
    const bool is_bool = type.kind == ast::NodeKind::elementary_type_name &&
                         tokens_[type.first_token].kind() == TokenKind::kw_bool;
    if (block.block != VariableBlock::var_input || place == Place::function)
        report_at(at_, DiagnosticId::edge_outside_input, {word}).remove(token().range());
    else if (!is_bool || peek() == TokenKind::assign)
        report_at(at_, DiagnosticId::edge_needs_bool, {word});
    return edge_of(tokens_[advance()].kind());
}

// ---- checks -------------------------------------------------------------------------------------

void Parser::check_declaration(const ast::VariableDeclaration& declaration,
                               const ast::VariableDeclarations& block, Place place) {
    if (declaration.initial_value != nullptr)
        check_initial_value_in_block(declaration, block);
    if (block.block == VariableBlock::var_external && declaration.names.size() > 1)
        report(DiagnosticId::several_external_names,
               token_range(declaration.names[1]->first_token, declaration.names.back()->end_token));
    if (declaration.location != nullptr)
        check_location(declaration, block, place);
}

void Parser::check_initial_value_in_block(const ast::VariableDeclaration& declaration,
                                          const ast::VariableDeclarations& block) {
    const bool no_value =
        (block.block == VariableBlock::var_in_out || block.block == VariableBlock::var_temp ||
         block.block == VariableBlock::var_external) &&
        !has_derivable_value(declaration, block);
    const bool incomplete = declaration.location != nullptr && is_incomplete(*declaration.location);
    if (no_value || incomplete) {
        const std::uint32_t end = declaration.specification->end_token;
        report_node(*declaration.initial_value, DiagnosticId::unexpected_initial_value,
                    {incomplete ? "AT %...*" : std::string(text(block.first_token))})
            .remove({tokens_[end - 1].end(), tokens_[declaration.end_token - 1].end()});
    } else if (block.block == VariableBlock::var_global &&
               names_function_block(*declaration.specification)) {
        const std::uint32_t end = declaration.specification->end_token;
        report_node(*declaration.initial_value, DiagnosticId::unexpected_initial_value,
                    {"VAR_GLOBAL ... : " + std::string(text(end - 1))})
            .remove({tokens_[end - 1].end(), tokens_[declaration.end_token - 1].end()});
    } else {
        check_initial_value(*declaration.specification, declaration.initial_value);
    }
}

/// In blocks of variables without initial values: a string's, and in VAR_IN_OUT an instance's,
/// stand in productions which these blocks share with others.
bool Parser::has_derivable_value(const ast::VariableDeclaration& declaration,
                                 const ast::VariableDeclarations& block) const noexcept {
    if (block.block == VariableBlock::var_external)
        return false;
    const ast::TypeSpecification& type = *declaration.specification;
    const TokenKind word = tokens_[type.first_token].kind();
    const bool string = word == TokenKind::kw_string || word == TokenKind::kw_wstring;
    if (string && declaration.initial_value->kind == ast::NodeKind::character_string)
        return true;
    return block.block == VariableBlock::var_in_out &&
           type.kind == ast::NodeKind::derived_type_name &&
           declaration.initial_value->kind == ast::NodeKind::structure_initialization;
}

/// True for the name of a standard function block: of other names it is not known here.
bool Parser::names_function_block(const ast::TypeSpecification& type) const noexcept {
    return type.kind == ast::NodeKind::derived_type_name &&
           standard_name(text(type.first_token)) == StandardName::function_block;
}

bool Parser::is_incomplete(const ast::Location& location) const noexcept {
    return tokens_[location.end_token - 1].kind() == TokenKind::incomplete_location;
}

/// Where a location can stand: in VAR of a program and in VAR_GLOBAL; `%I*` in VAR of a program or
/// function block (2.4.1.1, 2.4.3.1).
void Parser::check_location(const ast::VariableDeclaration& declaration,
                            const ast::VariableDeclarations& block, Place place) {
    const ast::Location& location = *declaration.location;
    const bool incomplete = is_incomplete(location);
    const bool var = block.block == VariableBlock::var;
    const bool global = block.block == VariableBlock::var_global;
    if (!var && !global)
        report_node(location, DiagnosticId::name_with_location, {text(block.first_token)});
    else if (incomplete && (global || place == Place::function))
        report_node(location, DiagnosticId::incomplete_location);
    else if (incomplete && declaration.names.empty())
        report_node(location, DiagnosticId::location_needs_name);
    else if (incomplete && block.qualifier == BlockQualifier::constant)
        report_node(location, DiagnosticId::qualifier_of_block,
                    {"CONSTANT", "AT " + std::string(text(location.end_token - 1))});
    else if (!incomplete && var && place == Place::function)
        report_node(location, DiagnosticId::location_of_this_unit, {"function"});
    else if (!incomplete && var && place == Place::function_block)
        report_node(location, DiagnosticId::location_of_this_unit, {"function block"});
    if (declaration.names.size() > 1)
        report(DiagnosticId::several_located_names,
               token_range(declaration.names[1]->first_token, declaration.names.back()->end_token));
}

/// Located, incompletely located and plain declarations stand in blocks of their own (6.2 A19).
void Parser::check_mixed(const ast::VariableDeclarations& block) {
    if (block.block != VariableBlock::var)
        return;
    const auto form = [this](const ast::VariableDeclaration& declaration) -> std::string_view {
        if (declaration.location == nullptr)
            return "plain";
        return is_incomplete(*declaration.location) ? "incompletely located" : "located";
    };
    const ast::VariableDeclaration* first = nullptr;
    for (const ast::Node* node : block.declarations) {
        const auto* declaration = ast::as<ast::VariableDeclaration>(node);
        if (declaration == nullptr ||
            (declaration->location != nullptr &&
             declaration->location->variable->kind == ast::NodeKind::error_expression))
            continue;
        if (first == nullptr)
            first = declaration;
        if (form(*declaration) == form(*first))
            continue;
        report_node(*declaration, DiagnosticId::mixed_block, {form(*first), form(*declaration)})
            .label(LabelId::first_given, first->first_token);
        return;
    }
}

} // namespace iecfront
