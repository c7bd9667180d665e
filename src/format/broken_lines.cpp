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

[[nodiscard]] TextRange whole_lines(std::string_view text, TextRange range) {
    const std::size_t before = text.substr(0, range.begin).find_last_of("\r\n");
    const std::size_t behind = text.find_first_of("\r\n", range.end);
    return {before == std::string_view::npos ? 0 : static_cast<std::uint32_t>(before) + 1,
            static_cast<std::uint32_t>(std::min(behind, text.size()))};
}

// Puts stretches that touch together.
[[nodiscard]] std::vector<TextRange> joined(std::vector<TextRange> ranges) {
    std::ranges::sort(ranges, {}, &TextRange::begin);
    std::vector<TextRange> result;
    for (const TextRange range : ranges) {
        if (!result.empty() && range.begin <= result.back().end)
            result.back().end = std::max(result.back().end, range.end);
        else
            result.push_back(range);
    }
    return result;
}

} // namespace

std::vector<TextRange> broken_lines(const Unit& unit) {
    if (unit.diagnostics().empty())
        return {};
    std::vector<TextRange> ranges;
    for (const Diagnostic& diagnostic : unit.diagnostics())
        if (breaks_syntax(diagnostic))
            ranges.push_back(diagnostic.range);
    ast::walk(unit.root(), [&](const ast::Node& node) {
        if (stands_for_error(node.kind) || node.missing)
            ranges.push_back(unit.range(node));
        return ast::Walk::into;
    });
    std::vector<TextRange> lines = joined(std::move(ranges));
    for (TextRange& range : lines)
        range = whole_lines(unit.text(), range);
    return joined(std::move(lines));
}

} // namespace iecfront::layout
