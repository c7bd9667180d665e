#include <iecfront/ast/editor_ranges.hpp>
#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/visitor.hpp>

#include <algorithm>
#include <map>

namespace iecfront {
namespace {

[[nodiscard]] bool can_be_folded(ast::NodeKind kind) noexcept {
    switch (kind) {
    case ast::NodeKind::structure_declaration:
    case ast::NodeKind::enumerated_specification:
    case ast::NodeKind::if_statement:
    case ast::NodeKind::elsif_clause:
    case ast::NodeKind::case_statement:
    case ast::NodeKind::case_element:
    case ast::NodeKind::for_statement:
    case ast::NodeKind::while_statement:
    case ast::NodeKind::repeat_statement:
    case ast::NodeKind::fb_invocation:
    case ast::NodeKind::step:
    case ast::NodeKind::transition:
    case ast::NodeKind::action:
    case ast::NodeKind::resource_declaration:
    case ast::NodeKind::program_configuration:
    case ast::NodeKind::il_expression:
    case ast::NodeKind::il_fb_call:
    case ast::NodeKind::il_formal_funct_call: return true;
    default: return ast::is<ast::LibraryElement>(kind);
    }
}

/// By its first line, the longest range that begins there.
class FoldingCollector {
public:
    explicit FoldingCollector(const SyntaxTree& tree) {
        for (const SyntaxTree::Slot& slot : tree.slots()) {
            slot_ = &slot;
            add_nodes();
            add_comments();
        }
    }

    [[nodiscard]] std::vector<FoldingRange> ranges() const {
        std::vector<FoldingRange> result;
        for (const auto& [first_line, range] : by_line_)
            result.push_back(range);
        return result;
    }

private:
    [[nodiscard]] std::uint32_t line_of(std::uint32_t offset) const {
        return slot_->first_line + slot_->unit->lines().line_of(offset) + 1;
    }

    void add(std::uint32_t first_line, std::uint32_t last_line, FoldingKind kind) {
        if (first_line >= last_line)
            return;
        FoldingRange& range = by_line_[first_line];
        if (last_line > range.last_line)
            range = {first_line, last_line, kind};
    }

    void add_nodes() {
        ast::walk(slot_->unit->root(), [&](const ast::Node& node) {
            if (can_be_folded(node.kind) && node.first_token != node.end_token) {
                const TextRange range = slot_->unit->range(node);
                add(line_of(range.begin), line_of(range.end - 1), FoldingKind::code);
            }
            return ast::Walk::into;
        });
    }

    // Comments, each on the line below the one before it, are folded as one.
    void add_comments() {
        std::uint32_t first_line = 0; // none yet
        std::uint32_t last_line = 0;
        for (const Trivia& trivia : slot_->unit->trivia()) {
            if (trivia.kind == TriviaKind::pragma || trivia.range.empty())
                continue;
            const std::uint32_t begin = line_of(trivia.range.begin);
            const bool goes_on = first_line != 0 && begin == last_line + 1;
            if (!goes_on || !is_first_on_line(trivia.range.begin)) {
                add(first_line, last_line, FoldingKind::comment);
                first_line = begin;
            }
            last_line = line_of(trivia.range.end - 1);
        }
        add(first_line, last_line, FoldingKind::comment);
    }

    [[nodiscard]] bool is_first_on_line(std::uint32_t offset) const {
        const Unit& unit = *slot_->unit;
        const std::uint32_t line_start = unit.lines().line_start(unit.lines().line_of(offset));
        return unit.text({line_start, offset}).find_first_not_of(" \t") == std::string_view::npos;
    }

    const SyntaxTree::Slot* slot_ = nullptr;
    std::map<std::uint32_t, FoldingRange> by_line_;
};

/// The comment or pragma, or else the token, that holds the byte at `offset` of the unit.
[[nodiscard]] TextRange element_at(const Unit& unit, std::uint32_t offset) {
    for (const Trivia& trivia : unit.trivia())
        if (trivia.range.contains(offset))
            return trivia.range;
    const auto behind =
        std::upper_bound(unit.tokens().begin(), unit.tokens().end(), offset,
                         [](std::uint32_t o, Token token) { return o < token.offset(); });
    if (behind == unit.tokens().begin())
        return {offset, offset};
    const TextRange range = (behind - 1)->range();
    return range.contains(offset) ? range : TextRange{offset, offset};
}

} // namespace

std::vector<FoldingRange> folding_ranges(const SyntaxTree& tree) {
    return FoldingCollector(tree).ranges();
}

std::vector<TextRange> selection_ranges(const SyntaxTree& tree, std::uint32_t offset) {
    const SyntaxTree::Path path = tree.node_at(offset);
    const SyntaxTree::Slot& slot = *path.slot;
    const auto unit_size = static_cast<std::uint32_t>(slot.unit->text().size());
    std::vector<TextRange> ranges;
    const auto add = [&](TextRange range) {
        if (ranges.empty() ? !range.empty()
                           : range.contains(ranges.back()) && range != ranges.back())
            ranges.push_back(range);
    };
    add(element_at(*slot.unit, offset - slot.offset).shifted(slot.offset));
    for (auto node = path.nodes.rbegin(); node != path.nodes.rend(); ++node)
        if (slot.range(**node).contains(offset))
            add(slot.range(**node));
    add({slot.offset, slot.offset + unit_size});
    add({0, tree.size()});
    return ranges;
}

} // namespace iecfront
