#include "builder/assembly.hpp"
#include "builder/places.hpp"
#include "format/comment_text.hpp"
#include "source/utf8.hpp"

#include <iecfront/ast/visitor.hpp>
#include <iecfront/builder/tree.hpp>
#include <iecfront/format/formatter.hpp>
#include <iecfront/parser/parse.hpp>

namespace iecfront::build {
namespace {

[[nodiscard]] std::string in_utf8(std::string_view text, Encoding encoding) {
    if (encoding == Encoding::utf8)
        return std::string(text);
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const DecodedCharacter character = decode_character(text, i, encoding);
        append_utf8(out, character.code_point);
        i += character.size;
    }
    return out;
}

// With LF for every line end, and its lines but the first so many blanks further out.
[[nodiscard]] std::string moved_out(std::string_view text, std::size_t blanks) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i++];
        const bool ends_line = c == '\n' || c == '\r';
        out += ends_line ? '\n' : c;
        if (!ends_line)
            continue;
        if (c == '\r' && i < text.size() && text[i] == '\n')
            ++i;
        for (std::size_t n = 0; n < blanks && i < text.size() && is_blank(text[i]); ++n)
            ++i;
    }
    return out;
}

[[nodiscard]] bool is_whole(const ast::Node& node) {
    return ast::walk(node, [](const ast::Node& part) {
        const std::string_view kind = to_string(part.kind);
        const bool broken = part.missing || part.kind == ast::NodeKind::skipped_text ||
                            kind.starts_with("error_") || kind == "il_error_operation";
        return broken ? ast::Walk::stop : ast::Walk::into;
    });
}

[[nodiscard]] bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const DecodedCharacter character = decode_character(text, i, Encoding::utf8);
        if (!character.valid)
            return false;
        i += character.size;
    }
    return true;
}

[[nodiscard]] std::uint8_t strength_of(const ast::Node& node) {
    if (const auto* binary = ast::as<ast::BinaryExpression>(&node))
        return build::strength_of(binary->op);
    return node.kind == ast::NodeKind::unary_expression ? strength::unary : strength::primary;
}

[[nodiscard]] std::optional<SyntaxTree> read(const AnyPart& part, FragmentKind kind) {
    if (!part.fault().empty())
        return std::nullopt;
    ParseOptions options;
    options.read_as = kind;
    return parse(SourceText(part.text()), options);
}

} // namespace

namespace detail {

AnyPart copied(const Unit& unit, const ast::Node& node) {
    const TextRange range = unit.range(node);
    Assembly assembly;
    assembly.require(is_whole(node), "what is copied has a violation of the syntax in it")
        .text(moved_out(in_utf8(unit.text(range), unit.encoding()),
                        indentation(unit, range.begin).size()));
    return std::move(assembly).finish(node.kind, strength_of(node));
}

AnyPart with_comment(const AnyPart& part, std::string_view comment) {
    Assembly assembly;
    assembly.require(is_utf8(comment), "a comment is not UTF-8");
    assembly.text(layout::as_comment(' ' + std::string(comment) + ' ')).text("\n").part(part);
    return std::move(assembly).finish(part.kind(), strength::primary);
}

} // namespace detail

std::optional<SyntaxTree> library(const std::vector<LibraryElement>& elements, std::string name) {
    Assembly assembly;
    const AnyPart text = std::move(assembly.list(elements, "\n\n").text("\n"))
                             .finish(ast::NodeKind::library_unit, strength::primary);
    if (!text.fault().empty())
        return std::nullopt;
    return parse(SourceText(format(parse(SourceText(text.text()))), std::move(name)));
}

std::optional<SyntaxTree> fragment(const Expression& expression) {
    return read(expression, FragmentKind::expression);
}

std::optional<SyntaxTree> fragment(const Body& body) {
    const bool is_st = body.kind() == ast::NodeKind::statement_list;
    return read(body, is_st ? FragmentKind::statement_list : FragmentKind::body);
}

std::optional<SyntaxTree> fragment(const std::vector<Part<ast::VariableDeclarations>>& blocks) {
    return read(std::move(Assembly().list(blocks, "\n"))
                    .finish(ast::NodeKind::library_unit, strength::primary),
                FragmentKind::variable_declarations);
}

} // namespace iecfront::build
