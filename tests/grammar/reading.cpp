#include "grammar/reading.hpp"

#include "lexer/lexer.hpp"

#include <iecfront/ast/visitor.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>

#include <algorithm>

namespace iecfront::test {
namespace {

struct BodyLanguages : ast::Visitor<BodyLanguages> {
    ast::Walk visit(const ast::FunctionDeclaration& node) { return add(node.body); }
    ast::Walk visit(const ast::FunctionBlockDeclaration& node) { return add(node.body); }
    ast::Walk visit(const ast::ProgramDeclaration& node) { return add(node.body); }
    ast::Walk visit(const ast::Action& node) { return add(node.body); }

    std::vector<std::string> languages;

private:
    ast::Walk add(const ast::Body* body) {
        languages.emplace_back(to_string(body->kind));
        return ast::Walk::into;
    }
};

} // namespace

std::set<std::string> reported_codes(const SyntaxTree& tree) {
    std::set<std::string> codes;
    for (const Diagnostic& diagnostic : tree.diagnostics()) {
        const DiagnosticInfo& row = diagnostic_info(diagnostic.id);
        if (row.category != DiagnosticClass::limit && row.default_severity != Severity::allow)
            codes.insert(code_string(diagnostic.id));
    }
    return codes;
}

std::vector<std::string> body_languages(const SyntaxTree& tree) {
    BodyLanguages found;
    for (const SyntaxTree::Slot& slot : tree.slots())
        found.traverse(slot.unit->root());
    return found.languages;
}

Pieces::Pieces(std::string_view text) {
    const std::string terminated(text); // a zero byte stands behind it
    std::uint32_t end = 0;
    for (const Token token : lex(terminated, Encoding::utf8).tokens) {
        gaps.emplace_back(text.substr(end, token.offset() - end));
        if (token.kind() != TokenKind::end_of_unit)
            tokens.emplace_back(text.substr(token.offset(), token.length()));
        end = token.end();
    }
}

std::string Pieces::text() const {
    std::string text = gaps.front();
    for (std::size_t i = 0; i < tokens.size(); ++i)
        text += tokens[i] + gaps[i + 1];
    return text;
}

/// Of the gaps around what goes, the one with a line end stays.
void Pieces::erase(std::size_t begin, std::size_t end) {
    const auto at = [](auto& row, std::size_t i) {
        return row.begin() + static_cast<std::ptrdiff_t>(i);
    };
    const bool line_end = gaps[end].find('\n') != std::string::npos;
    tokens.erase(at(tokens, begin), at(tokens, end));
    gaps.erase(at(gaps, line_end ? begin : begin + 1), at(gaps, line_end ? end : end + 1));
    if (gaps[begin].empty())
        gaps[begin] = " ";
}

} // namespace iecfront::test
