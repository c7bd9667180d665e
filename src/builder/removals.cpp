#include "builder/removals.hpp"

#include "builder/places.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace iecfront::build {
namespace {

using Slot = SyntaxTree::Slot;
using Elements = std::vector<const ast::Node*>;

/// A stretch of a unit that goes.
struct Cut {
    const Slot* slot;
    TextRange range; ///< in the unit
    bool whole_line; ///< with its lines when nothing else stands in them

    [[nodiscard]] TextRange in_file() const noexcept { return range.shifted(slot->offset); }
};

[[nodiscard]] bool is_separator(char c) noexcept {
    return is_blank(c) || c == '\n' || c == '\r' || c == ',';
}

// With the blanks beside it, and its lines when nothing else stands in them. What stands behind the
// last element of a list stays as far from it as it was.
[[nodiscard]] TextRange widened(const Unit& unit, TextRange range) {
    const std::string_view text = unit.text();
    std::uint32_t end = range.end;
    while (end < text.size() && is_blank(text[end]))
        ++end;
    const bool ends_line = end == text.size() || text[end] == '\n' || text[end] == '\r';
    if (ends_line && begins_line(unit, range.begin)) {
        range.begin = line_start(unit, range.begin);
        end += end < text.size() ? 1 : 0;
        end += end < text.size() && text[end - 1] == '\r' && text[end] == '\n' ? 1 : 0;
    } else if (ends_line) {
        while (range.begin > 0 && is_blank(text[range.begin - 1]))
            --range.begin;
    } else if (text[range.begin] == ',') {
        end = range.end;
    }
    return {range.begin, end};
}

// True when `next` lies in `cut`, or goes with it: no more than blanks are between the two.
[[nodiscard]] bool belongs_to(const Cut& cut, const Cut& next) {
    if (cut.slot->offset != next.slot->offset)
        return false;
    if (next.range.end <= cut.range.end)
        return true;
    return cut.whole_line == next.whole_line &&
           (next.range.begin <= cut.range.end ||
            std::ranges::all_of(cut.slot->unit->text({cut.range.end, next.range.begin}), is_blank));
}

class Remover {
public:
    Remover(std::vector<TextEdit>& edits, std::span<const detail::Removal> removals,
            std::span<const ast::Node* const> accompanied)
        : edits_(edits), accompanied_(accompanied.begin(), accompanied.end()) {
        for (const detail::Removal& removal : removals)
            removed_.insert(removal.node);
    }

    void take_out(const Slot& slot, const ast::Node& node) {
        const Siblings siblings = siblings_of(*slot.unit, node);
        const TextRange range = slot.unit->range(node);
        const TextRange whole{range.begin, end_with_semicolon(*slot.unit, node)};
        const bool none_stays = std::ranges::none_of(
            siblings.elements, [&](const ast::Node* element) { return stays(*element); });
        if (const TextEdit* other = edit_beside(slot, node, whole))
            cut(slot, whole, other->replacement.empty());
        else if (none_stays && is_block(*siblings.parent))
            cut(slot, slot.unit->range(*siblings.parent), true);
        else if (none_stays && siblings.parent->kind == ast::NodeKind::statement_list &&
                 siblings.elements.back() == &node)
            cut(slot, range, false); // its `;` is an empty statement
        else if (has_comma(node.kind))
            cut_with_comma(slot, node, siblings.elements);
        else
            cut(slot, whole, true);
    }

    // What lies side by side goes together, so that its lines do.
    void finish() {
        std::erase_if(edits_, [](const TextEdit& edit) {
            return edit.range.empty() && edit.replacement.empty();
        });
        const auto place = [](const Cut& one) { return one.in_file().begin; };
        std::ranges::stable_sort(cuts_, {}, place);
        for (std::size_t i = 0; i < cuts_.size();) {
            Cut whole = cuts_[i++];
            for (; i < cuts_.size() && belongs_to(whole, cuts_[i]); ++i)
                whole.range.end = std::max(whole.range.end, cuts_[i].range.end);
            if (whole.whole_line)
                whole.range = widened(*whole.slot->unit, whole.range);
            edits_.push_back({whole.in_file(), ""});
        }
    }

private:
    [[nodiscard]] static bool is_block(const ast::Node& node) noexcept {
        return node.kind == ast::NodeKind::variable_declarations ||
               node.kind == ast::NodeKind::data_type_declaration;
    }

    // True when the element or something in its place stays.
    [[nodiscard]] bool stays(const ast::Node& element) const {
        return !removed_.contains(&element) || accompanied_.contains(&element);
    }

    void cut(const Slot& slot, TextRange range, bool whole_line) {
        cuts_.push_back({&slot, range, whole_line});
    }

    // What was put in directly beside `whole` and comes into its place, without what separated the
    // two; null when there is no such thing.
    [[nodiscard]] const TextEdit* edit_beside(const Slot& slot, const ast::Node& node,
                                              TextRange whole) {
        if (!accompanied_.contains(&node))
            return nullptr;
        if (const auto before = edits_at(slot.offset + whole.begin); !before.empty()) {
            std::string& text = before.back().replacement;
            while (!text.empty() && is_separator(text.back()))
                text.pop_back();
            return &before.back();
        }
        if (const auto behind = edits_at(slot.offset + whole.end); !behind.empty()) {
            std::string& text = behind.front().replacement;
            text.erase(text.begin(), std::ranges::find_if_not(text, is_separator));
            return &behind.front();
        }
        return nullptr;
    }
    [[nodiscard]] std::span<TextEdit> edits_at(std::uint32_t offset) {
        const auto before = [](const TextEdit& a, const TextEdit& b) {
            return std::pair(a.range.begin, a.range.end) < std::pair(b.range.begin, b.range.end);
        };
        const TextEdit here{{offset, offset}, ""};
        const auto [first, last] = std::equal_range(edits_.begin(), edits_.end(), here, before);
        return {first, last};
    }

    // With the comma behind it when something behind that stays, otherwise with that before it.
    void cut_with_comma(const Slot& slot, const ast::Node& node, const Elements& elements) {
        const Unit& unit = *slot.unit;
        TextRange range = unit.range(node);
        const auto stay = [&](const ast::Node* element) { return stays(*element); };
        const auto here = std::ranges::find(elements, &node);
        const bool later = std::any_of(here, elements.end(), stay);
        const bool earlier =
            std::any_of(elements.begin(), here, stay) || comma_before(unit, *elements.front());
        if (const auto behind = token_at(unit, node.end_token, TokenKind::comma);
            behind && (later || !earlier))
            range.end = behind->end();
        else if (const auto before = comma_before(unit, node); before && earlier)
            cut(slot, before->range(), true);
        cut(slot, range, true);
    }
    [[nodiscard]] static std::optional<Token> comma_before(const Unit& unit,
                                                           const ast::Node& node) {
        if (node.first_token == 0)
            return std::nullopt;
        return token_at(unit, node.first_token - 1, TokenKind::comma);
    }

    std::vector<TextEdit>& edits_;
    std::unordered_set<const ast::Node*> removed_;
    std::unordered_set<const ast::Node*> accompanied_;
    std::vector<Cut> cuts_;
};

} // namespace

void take_out(std::vector<TextEdit>& edits, std::span<const detail::Removal> removals,
              std::span<const ast::Node* const> accompanied) {
    Remover remover(edits, removals, accompanied);
    for (const detail::Removal& removal : removals)
        remover.take_out(removal.slot, *removal.node);
    remover.finish();
}

} // namespace iecfront::build
