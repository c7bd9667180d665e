#include "format/broken_lines.hpp"

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/visitor.hpp>

#include <algorithm>

namespace iecfront::layout {
namespace {

// What is an extension has a tree, and what depends on the implementation as well; but of what
// other editions have as a whole there are only tokens.
[[nodiscard]] bool breaks_syntax(const Diagnostic& diagnostic) {
    if (diagnostic.id == DiagnosticId::foreign_construct)
        return true;
    const DiagnosticClass category = diagnostic_info(diagnostic.id).category;
    return category != DiagnosticClass::extension &&
           category != DiagnosticClass::implementation_dependent;
}

[[nodiscard]] bool stands_for_error(ast::NodeKind kind) noexcept {
    switch (kind) {
    case ast::NodeKind::skipped_text:
    case ast::NodeKind::error_type:
    case ast::NodeKind::error_declaration:
    case ast::NodeKind::error_expression:
    case ast::NodeKind::error_statement:
    case ast::NodeKind::il_error_operation: return true;
    default: return false;
    }
}

// What is missing at the end of the text is missing behind the last token, however many blank lines
// come between.
[[nodiscard]] TextRange place_of(const Diagnostic& diagnostic, const Unit& unit) {
    TextRange range = diagnostic.range;
    const std::span<const Token> tokens = unit.tokens();
    if (!tokens.empty())
        range.begin = std::min(range.begin, tokens.back().end());
    return range;
}

[[nodiscard]] TextRange whole_lines(std::string_view text, TextRange range) {
    const std::size_t before = text.substr(0, range.begin).find_last_of("\r\n");
    const std::size_t behind = text.find_first_of("\r\n", range.end);
    return {before == std::string_view::npos ? 0 : static_cast<std::uint32_t>(before) + 1,
            static_cast<std::uint32_t>(std::min(behind, text.size()))};
}

// No line is looked at twice, however long it is and however much is in it.
[[nodiscard]] std::vector<TextRange> lines_with(std::vector<TextRange> ranges,
                                                std::string_view text) {
    std::ranges::sort(ranges, {}, &TextRange::begin);
    std::vector<TextRange> lines;
    for (const TextRange range : ranges) {
        if (lines.empty() || range.begin > lines.back().end)
            lines.push_back(whole_lines(text, range));
        else if (range.end > lines.back().end)
            lines.back().end = whole_lines(text, {lines.back().end, range.end}).end;
    }
    return lines;
}

} // namespace

std::vector<TextRange> broken_lines(const Unit& unit) {
    if (unit.diagnostics().empty())
        return {};
    std::vector<TextRange> ranges;
    for (const Diagnostic& diagnostic : unit.diagnostics())
        if (breaks_syntax(diagnostic))
            ranges.push_back(place_of(diagnostic, unit));
    ast::walk(unit.root(), [&](const ast::Node& node) {
        if (stands_for_error(node.kind) || node.missing)
            ranges.push_back(unit.range(node));
        return ast::Walk::into;
    });
    return lines_with(std::move(ranges), unit.text());
}

} // namespace iecfront::layout
