#include "benchmark/recovery_outcome.hpp"

#include <iecfront/ast/dump.hpp>
#include <iecfront/ast/visitor.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

namespace iecfront::test {
namespace {

/// Where `offset` of the valid text is in the faulty one.
[[nodiscard]] std::uint32_t moved(std::uint32_t offset, const TextEdit& fault) {
    if (offset < fault.range.end || offset == fault.range.begin)
        return offset;
    return offset - fault.range.size() + static_cast<std::uint32_t>(fault.replacement.size());
}

[[nodiscard]] bool touches(TextRange range, TextRange edited) {
    return range.begin <= edited.end && edited.begin <= range.end;
}

/// What the fault changes: for an insertion also the token behind it, which it may be read with.
[[nodiscard]] TextRange reach_of(const SyntaxTree& tree, const TextEdit& fault) {
    TextRange reach = fault.range;
    if (!reach.empty())
        return reach;
    const SyntaxTree::Slot& slot = tree.slot_at(reach.begin);
    for (const Token token : slot.unit->tokens()) {
        if (slot.offset + token.offset() >= reach.begin) {
            reach.end = slot.offset + token.end();
            break;
        }
    }
    return reach;
}

/// The last token that ends at or before `offset`; an empty range when there is none.
[[nodiscard]] TextRange token_before(const SyntaxTree& tree, std::uint32_t offset) {
    TextRange result;
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        for (const Token token : slot.unit->tokens()) {
            const TextRange range = token.range().shifted(slot.offset);
            if (range.end > offset)
                return result;
            result = range;
        }
    }
    return result;
}

[[nodiscard]] const SyntaxTree::Slot* slot_that_begins_at(const SyntaxTree& tree,
                                                          std::uint32_t offset) {
    const SyntaxTree::Slot& slot = tree.slot_at(offset);
    return slot.offset == offset ? &slot : nullptr;
}

/// The statements of a tree by where they begin.
class StatementFinder {
public:
    explicit StatementFinder(const SyntaxTree& tree) {
        for (const SyntaxTree::Slot& slot : tree.slots()) {
            ast::walk(slot.unit->root(), [&](const ast::Node& node) {
                if (ast::is<ast::Statement>(node.kind))
                    places_.emplace(slot.range(node).begin, Place{&slot, &node});
                return ast::Walk::into;
            });
        }
    }

    [[nodiscard]] bool holds(std::uint32_t offset, ast::NodeKind kind,
                             const std::string& tree) const {
        const auto [first, last] = places_.equal_range(offset);
        return std::any_of(first, last, [&](const auto& entry) {
            const Place& place = entry.second;
            return place.node->kind == kind && s_expression(*place.slot->unit, *place.node) == tree;
        });
    }

private:
    struct Place {
        const SyntaxTree::Slot* slot;
        const ast::Node* node;
    };
    std::unordered_multimap<std::uint32_t, Place> places_;
};

} // namespace

std::vector<Diagnostic> reports_of(const SyntaxTree& tree) {
    std::vector<Diagnostic> reports = tree.diagnostics();
    std::erase_if(reports, [](const Diagnostic& diagnostic) {
        return diagnostic_info(diagnostic.id).default_severity == Severity::allow;
    });
    return reports;
}

ValidText::ValidText(SyntaxTree tree) : tree_(std::move(tree)) {
    for (const SyntaxTree::Slot& slot : tree_.slots())
        units_.push_back(statements_of(slot));
}

ValidText::UnitStatements ValidText::statements_of(const SyntaxTree::Slot& slot) {
    UnitStatements result;
    std::vector<std::size_t> open;
    const std::span<const Token> tokens = slot.unit->tokens();
    ast::walk(
        slot.unit->root(),
        [&](const ast::Node& node) {
            if (!ast::is<ast::Statement>(node.kind))
                return ast::Walk::into;
            TextRange range = slot.range(node);
            if (node.end_token < tokens.size() &&
                tokens[node.end_token].kind() == TokenKind::semicolon)
                range.end = slot.offset + tokens[node.end_token].end();
            open.push_back(result.statements.size());
            result.statements.push_back({&node, range, 0});
            result.trees.push_back(s_expression(*slot.unit, node));
            return ast::Walk::into;
        },
        [&](const ast::Node& node) {
            if (!ast::is<ast::Statement>(node.kind))
                return;
            result.statements[open.back()].end = result.statements.size();
            open.pop_back();
        });
    return result;
}

Outcome ValidText::outcome_of(const TextEdit& fault) const {
    const std::string text = apply_edits(tree_.source().bytes(), {&fault, 1});
    const SyntaxTree faulty = parse(SourceText(text), tree_.options());
    Outcome outcome;
    outcome.reports = reports_of(faulty);
    outcome.located = is_located(faulty, fault, outcome.reports);
    const TextRange reach = reach_of(tree_, fault);
    for (std::size_t i = 0; i < units_.size(); ++i) {
        const SyntaxTree::Slot& slot = tree_.slots()[i];
        const auto end = slot.offset + static_cast<std::uint32_t>(slot.unit->text().size());
        const SyntaxTree::Slot* const now = slot_that_begins_at(faulty, moved(slot.offset, fault));
        const bool equal = now != nullptr && *now->unit == *slot.unit;
        if (!touches({slot.offset, end}, fault.range)) {
            ++outcome.other_units;
            outcome.equal_units += equal ? 1 : 0;
        }
        if (equal && !touches({slot.offset, end}, reach)) {
            outcome.other_statements += units_[i].statements.size();
            outcome.equal_statements += units_[i].statements.size();
        } else {
            compare_statements(units_[i], faulty, fault, outcome);
        }
    }
    return outcome;
}

bool ValidText::is_located(const SyntaxTree& faulty, const TextEdit& fault,
                           const std::vector<Diagnostic>& reports) const {
    const std::uint32_t begin = fault.range.begin;
    const auto end = begin + static_cast<std::uint32_t>(fault.replacement.size());
    const std::uint32_t first_line = faulty.position(begin).line;
    const std::uint32_t last_line = faulty.position(end).line;
    const TextRange before = token_before(tree_, begin);
    return std::any_of(reports.begin(), reports.end(), [&](const Diagnostic& report) {
        const std::uint32_t line = faulty.position(report.range.begin).line;
        return (first_line <= line && line <= last_line) ||
               (before.begin <= report.range.begin && report.range.begin <= before.end);
    });
}

void ValidText::compare_statements(const UnitStatements& unit, const SyntaxTree& faulty,
                                   const TextEdit& fault, Outcome& outcome) const {
    const TextRange reach = reach_of(tree_, fault);
    const StatementFinder finder(faulty);
    for (std::size_t i = 0; i < unit.statements.size(); ++i) {
        const StatementPlace& place = unit.statements[i];
        if (touches(place.range, reach)) {
            // Of those around the fault, what is inside the innermost one does not count.
            const bool innermost = std::none_of(
                unit.statements.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                unit.statements.begin() + static_cast<std::ptrdiff_t>(place.end),
                [&](const StatementPlace& inner) { return touches(inner.range, reach); });
            if (innermost)
                i = place.end - 1;
            continue;
        }
        ++outcome.other_statements;
        outcome.equal_statements +=
            finder.holds(moved(place.range.begin, fault), place.node->kind, unit.trees[i]) ? 1 : 0;
    }
}

} // namespace iecfront::test
