#include "parser/misspelling.hpp"
#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>

namespace iecfront {
namespace {

constexpr TokenSet openers{TokenKind::kw_type,           TokenKind::kw_function,
                           TokenKind::kw_function_block, TokenKind::kw_program,
                           TokenKind::kw_configuration,  TokenKind::kw_var_global};

// Opening words that a misspelt one is compared with.
constexpr TokenKind elements_with_words[] = {TokenKind::kw_function_block, TokenKind::kw_function,
                                             TokenKind::kw_program, TokenKind::kw_configuration,
                                             TokenKind::kw_type};

} // namespace

bool Parser::at_library_element_closer() const noexcept {
    return at(library_element_closers);
}

// library = { library_element_declaration } ;
const ast::LibraryUnit* Parser::parse_library_unit() {
    auto* unit = make<ast::LibraryUnit>();
    ListBuilder<ast::Node> elements(*this);
    const bool misused = opener_ == count_ && at(openers); // `TYPE : INT;`
    const bool configuration = opener_ < count_ && opener_ == next(next(at_)) &&
                               tokens_[opener_].kind() == TokenKind::kw_var_global &&
                               misspelt_opener(at_) == TokenKind::kw_configuration;
    if (!misused && !configuration)
        parse_misspelt_elements(elements);
    if (at_ > opener_) {
        skip_stray_text(elements, count_);
    } else if (!at_end()) {
        elements.add(parse_library_element());
        accept_extra_semicolon();
        skip_stray_text(elements, count_);
    }
    unit->elements = elements.finish();
    unit->first_token = 0;
    unit->end_token = count_;
    return unit;
}

// library_element_declaration = data_type_declaration | function_declaration
//                             | function_block_declaration | program_declaration
//                             | configuration_declaration ;
const ast::Node* Parser::parse_library_element() {
    TokenKind opener = kind();
    if (at(TokenKind::identifier)) {
        opener = misspelt_opener(at_);
        const std::string meant(spelling(opener));
        report_at(at_, DiagnosticId::misspelt_word, {text(at_), meant})
            .replace(token().range(), meant);
        change_unclosed(closer_of(opener), 1);
    }
    switch (opener) {
    case TokenKind::kw_type: return parse_data_type_declaration();
    case TokenKind::kw_function:
        return accept_split_opener()
                   ? static_cast<const ast::Node*>(parse_function_block_declaration())
                   : parse_function_declaration();
    case TokenKind::kw_function_block: return parse_function_block_declaration();
    case TokenKind::kw_program: return parse_program_declaration();
    case TokenKind::kw_configuration: return parse_configuration_declaration();
    default: break;
    }
    report_at(at_, DiagnosticId::global_variables_outside);
    return parse_variable_declarations(Place::library);
}

/// The opening word of a library element that a misspelt one means; end_of_unit when it is none.
TokenKind Parser::misspelt_opener(std::uint32_t index) const noexcept {
    if (tokens_[index].kind() != TokenKind::identifier ||
        tokens_[next(index)].kind() != TokenKind::identifier)
        return TokenKind::end_of_unit;
    for (const TokenKind opener : elements_with_words)
        if (is_misspelling(text(index), spelling(opener)))
            return opener;
    // FUNCTION is the likelier one of two that begin alike.
    const auto begun =
        std::find_if(std::rbegin(elements_with_words), std::rend(elements_with_words),
                     [&](TokenKind opener) { return is_beginning(text(index), spelling(opener)); });
    return begun == std::rend(elements_with_words) ? TokenKind::end_of_unit : *begun;
}

/// `FUNCTION BLOCK name`: passes over the first word.
bool Parser::accept_split_opener() {
    const std::uint32_t second = next(at_);
    const std::uint32_t name = next(second);
    if (!names_equal(text(second), "BLOCK") || tokens_[name].kind() != TokenKind::identifier ||
        !on_same_line(at_, name))
        return false;
    const TextRange words = token_range(at_, second + 1);
    const std::string meant(spelling(TokenKind::kw_function_block));
    report(DiagnosticId::misspelt_word, words, {text_.substr(words.begin, words.size()), meant})
        .replace(words, meant);
    advance();
    return true;
}

/// Passes over what is outside every declaration, up to token `end`. It is reported once.
void Parser::skip_stray_text(ListBuilder<ast::Node>& elements, std::uint32_t end) {
    if (at_ >= end)
        return;
    auto* skipped = make<ast::SkippedText>();
    const bool unclosed_before = follows_unclosed();
    const bool foreign = !unclosed_before && report_foreign_element();
    if (!unclosed_before && !foreign)
        report_at(at_, DiagnosticId::expected_library_element, {describe(at_)});
    while (at_ < end) {
        advance();
        if (foreign && at_ < end && at_next_foreign_element())
            report_foreign_element();
    }
    elements.add(finish(skipped));
}

/// In place of library_element_declaration: what stands before the opener, which is declarations
/// whose own opening words are misspelt, or text that belongs to nothing.
void Parser::parse_misspelt_elements(ListBuilder<ast::Node>& elements) {
    for (;;) {
        const std::uint32_t begin = find_misspelt_opener();
        skip_stray_text(elements, begin);
        if (at_ >= opener_)
            return;
        elements.add(parse_library_element());
        accept_extra_semicolon();
    }
}

/// Where a declaration begins whose opening word is misspelt, or the opener when there is none;
/// only looked for when a closing word, which can be misspelt as well, stands before that.
std::uint32_t Parser::find_misspelt_opener() const noexcept {
    std::uint32_t last = opener_;
    while (last > at_ && tokens_[last - 1].kind() == TokenKind::semicolon)
        --last;
    if (last <= at_ || !ends_library_element(last - 1))
        return opener_;
    std::uint32_t i = at_;
    while (i < opener_ && misspelt_opener(i) == TokenKind::end_of_unit)
        i = next(i);
    return i;
}

/// True at the closing word of a library element, also a misspelt one.
bool Parser::ends_library_element(std::uint32_t index) const noexcept {
    const TokenKind here = tokens_[index].kind();
    return library_element_closers.contains(here) ||
           (here == TokenKind::identifier &&
            std::any_of(std::begin(elements_with_words), std::end(elements_with_words),
                        [&](TokenKind opener) {
                            const std::string_view closer = spelling(closer_of(opener));
                            return is_misspelling(text(index), closer) ||
                                   is_abbreviation(text(index), closer);
                        }));
}

/// Some dialects have a `;` behind closing words and heads of declarations.
void Parser::accept_extra_semicolon() {
    if (!at(TokenKind::semicolon))
        return;
    const std::uint32_t first = at_;
    const std::string after(end_ > 0 ? text(end_ - 1) : std::string_view{});
    while (accept(TokenKind::semicolon)) {
    }
    report_at(first, DiagnosticId::extra_semicolon, {after}).remove(token_range(first, end_));
}

/// Before a body, a `;` that no declaration follows is the first statement of the body.
void Parser::accept_extra_semicolon_before_body() {
    std::uint32_t behind = at_;
    while (tokens_[behind].kind() == TokenKind::semicolon && behind - at_ < furthest_on_line)
        behind = next(behind);
    if (block_openers.contains(tokens_[behind].kind()))
        accept_extra_semicolon();
}

} // namespace iecfront
