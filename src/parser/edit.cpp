#include "parser/unit_parser.hpp"

#include <iecfront/ast/syntax_tree.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace iecfront {
namespace {

using Slots = std::span<const SyntaxTree::Slot>;

/// So many tokens behind a place can decide whether a unit ends there: an opening word and what
/// makes it plausible, or the `;` behind a closing word. See `cut_units`.
constexpr std::size_t cutter_lookahead = 8;

/// The first slot that has to be read again when something changes in `slot`: tokens of later units
/// decide where one ends, and a comment that nothing closes depends on all that follows.
std::size_t first_touched(Slots slots, std::size_t slot) {
    for (std::size_t i = 0; i < slot; ++i)
        if (slots[i].unit->depends_on_rest())
            return i;
    std::size_t tokens = 0;
    while (slot > 0 && tokens < cutter_lookahead)
        tokens += slots[--slot].unit->tokens().size();
    return slot;
}

/// The text of slots `[first, end)` with the edit in it; `range` counts from the file's start.
std::string edited_text(Slots slots, std::size_t first, std::size_t end, TextRange range,
                        std::string_view replacement) {
    std::string text;
    for (std::size_t i = first; i < end; ++i)
        text += slots[i].unit->text();
    return text.replace(range.begin - slots[first].offset, range.size(), replacement);
}

/// The number of cuts up to the first one that falls together with the end of an old unit behind
/// the edit, with enough text behind it to be sure; nothing when there is none.
struct InStep {
    std::size_t cuts;
    std::size_t slot; // the old unit that ends there
};
std::optional<InStep> find_in_step(const LexedUnits& units, Slots slots, std::size_t first,
                                   std::size_t slot, std::uint32_t growth) {
    if (units.lexed.depends_on_rest_from < units.size())
        return std::nullopt;
    const std::size_t tokens = units.lexed.tokens.size() - 1;
    const std::uint32_t begin = slots[first].offset;
    for (std::size_t cut = 0; cut + 1 < units.cuts.size(); ++cut) {
        if (units.cuts[cut].end_token + cutter_lookahead > tokens)
            return std::nullopt;
        const std::uint32_t end = units.unit_end(cut) - growth;
        while (slot + 1 < slots.size() && slots[slot + 1].offset - begin < end)
            ++slot;
        if (slot + 1 < slots.size() && slots[slot + 1].offset - begin == end)
            return InStep{cut + 1, slot};
    }
    return std::nullopt;
}

/// Keeps the first `cuts` units, and of the text only what belongs to them.
void truncate(LexedUnits& units, std::size_t cuts) {
    const std::uint32_t size = units.unit_end(cuts - 1);
    units.buffer = std::make_shared<const std::string>(*units.buffer, 0, size);
    units.cuts.resize(cuts);
    auto& found = units.lexed.diagnostics;
    found.erase(std::find_if(found.begin(), found.end(),
                             [size](const Diagnostic& one) { return one.range.begin >= size; }),
                found.end());
    units.lexed.depends_on_rest_from = size;
}

} // namespace

SyntaxTree SyntaxTree::edited(TextRange range, std::string_view replacement) const {
    const Slots old = slots();
    const auto slot = static_cast<std::size_t>(&slot_at(range.begin) - old.data());
    const auto last = static_cast<std::size_t>(&slot_at(range.end) - old.data());
    const std::size_t first = first_touched(old, slot);
    const auto growth = static_cast<std::uint32_t>(replacement.size()) - range.size();

    // Read a few units more than were touched; when the cuts do not fall in step, more and more.
    for (std::size_t more = 2;; more *= 4) {
        const std::size_t end = std::min(last + more, old.size());
        auto text = edited_text(old, first, end, range, replacement);
        LexedUnits units =
            lex_units(std::make_shared<const std::string>(std::move(text)), encoding_, first == 0);
        const auto in_step =
            end == old.size() ? std::nullopt : find_in_step(units, old, first, last, growth);
        if (end < old.size() && !in_step)
            continue;
        if (in_step)
            truncate(units, in_step->cuts);
        std::vector<std::shared_ptr<const Unit>> row;
        row.reserve(old.size() + units.cuts.size());
        for (std::size_t i = 0; i < first; ++i)
            row.push_back(old[i].unit);
        for (auto& unit : parse_units(units, options_))
            row.push_back(std::move(unit));
        for (std::size_t i = in_step ? in_step->slot + 1 : end; i < old.size(); ++i)
            row.push_back(old[i].unit);
        return {name_, encoding_, std::move(row), options_};
    }
}

} // namespace iecfront
