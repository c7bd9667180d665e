#include "parser/unit_parser.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/lexer/name.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace iecfront {
namespace {

using Slots = std::span<const SyntaxTree::Slot>;

/// So many tokens behind a place can decide whether a unit ends there: an opening word and what
/// makes it plausible, or the `;` behind a closing word. See `cut_units`.
constexpr std::size_t cutter_lookahead = 8;

/// True when the unit begins with a word. A point or a number sign can belong to the token before
/// it instead, so that there a text can be read neither from its middle on nor up to it; so can `%`
/// and `|`, which alone are taken for MOD and OR.
bool begins_with_word(const Unit& unit) {
    const auto tokens = unit.tokens();
    if (tokens.empty())
        return false;
    const Token first = tokens[0];
    const char letter = fold(unit.text()[first.offset()]);
    return first.kind() == TokenKind::identifier ||
           (is_keyword(first.kind()) && letter >= 'A' && letter <= 'Z');
}

/// The first slot that has to be read again when something changes in `slot`: tokens of later units
/// decide where one ends, and a comment that nothing closes depends on all that follows.
std::size_t first_touched(Slots slots, std::size_t slot) {
    for (std::size_t i = 0; i < slot; ++i)
        if (slots[i].unit->depends_on_rest()) {
            slot = i;
            break;
        }
    std::size_t tokens = 0;
    while (slot > 0 && (tokens < cutter_lookahead || !begins_with_word(*slots[slot].unit)))
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

/// Looks where newly read units fall in step with old ones.
struct InStep {
    std::size_t cuts; // up to that place
    std::size_t slot; // the old unit that ends there
};

/// The first place behind the edit where a new unit ends as an old one did, with enough text behind
/// it to be sure; nothing when there is none. `units` are those of the old slots from `first` on,
/// `slot` is the one that the edit ends in.
std::optional<InStep> find_in_step(const LexedUnits& units, Slots slots, std::size_t first,
                                   std::size_t slot, std::uint32_t growth) {
    if (!units.lexed.open_ended.empty())
        return std::nullopt;
    const std::size_t tokens = units.lexed.tokens.size() - 1;
    for (std::size_t cut = 0; cut + 1 < units.cuts.size() && slot + 1 < slots.size();) {
        if (units.cuts[cut].end_token + cutter_lookahead > tokens)
            return std::nullopt;
        const std::uint32_t end = units.unit_end(cut);
        const std::uint32_t old_end = slots[slot + 1].offset - slots[first].offset + growth;
        if (end == old_end && begins_with_word(*slots[slot + 1].unit))
            return InStep{cut + 1, slot};
        cut += end <= old_end ? 1 : 0;
        slot += end >= old_end ? 1 : 0;
    }
    return std::nullopt;
}

/// Keeps the first `cuts` units, and of the text only what belongs to them.
void truncate(LexedUnits& units, std::size_t cuts) {
    const std::uint32_t size = units.unit_end(cuts - 1);
    units.buffer = std::make_shared<const std::string>(*units.buffer, 0, size);
    units.cuts.resize(cuts);
    std::erase_if(units.lexed.diagnostics,
                  [size](const Diagnostic& one) { return !belongs_before(one.range, size); });
}

/// For a text that is not read for its size, before the edit or after it.
SyntaxTree read_anew(const SyntaxTree& tree, TextRange range, std::string_view replacement) {
    std::string text(tree.source().bytes());
    text.replace(range.begin, range.size(), replacement);
    return parse(SourceText(std::move(text), tree.name(), tree.encoding()).at(tree.origin()),
                 tree.options());
}

} // namespace

SyntaxTree SyntaxTree::edited(TextRange range, std::string_view replacement) const {
    if (range.end < range.begin)
        std::swap(range.begin, range.end);
    range = {std::min(range.begin, size_), std::min(range.end, size_)};
    const std::uint64_t new_size = std::uint64_t{size_} - range.size() + replacement.size();
    if (std::max<std::uint64_t>(size_, new_size) > options_.maximum_source_size)
        return read_anew(*this, range, replacement);
    const Slots old = slots();
    const auto slot = static_cast<std::size_t>(&slot_at(range.begin) - old.data());
    const auto last = static_cast<std::size_t>(&slot_at(range.end) - old.data());
    const std::size_t first = first_touched(old, slot);
    const auto growth = static_cast<std::uint32_t>(replacement.size()) - range.size();

    // Read a few units more than were touched; when the cuts do not fall in step, more and more.
    for (std::size_t more = 2;; more *= 4) {
        const std::size_t end = std::min(last + more, old.size());
        auto text = edited_text(old, first, end, range, replacement);
        LexedUnits units = lex_units(std::make_shared<const std::string>(std::move(text)),
                                     encoding_, first == 0, options_.read_as);
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
        return {name_, encoding_, std::move(row), options_, origin_};
    }
}

} // namespace iecfront
