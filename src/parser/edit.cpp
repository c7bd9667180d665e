#include "parser/unit_parser.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/lexer/name.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace iecfront {
namespace {

using Slots = std::span<const SyntaxTree::Slot>;

/// So many tokens are read behind the units that an edit touches, so that no end of the text is
/// near to those that decide about a cut.
constexpr std::size_t tokens_behind = 2 * cutter_lookahead;

/// True for `{ { }`: whether a pragma nests depends on the token before it.
bool may_nest(std::string_view pragma) {
    return pragma.find('{', 1) != std::string_view::npos;
}

/// True when the unit begins with a word. A point or a number sign can belong to the token before
/// it instead, so that there a text can be read neither from its middle on nor up to it; so can `%`
/// and `|`, which alone are taken for MOD and OR.
bool begins_with_word(const Unit& unit) {
    const auto tokens = unit.tokens();
    if (tokens.empty())
        return false;
    const Token first = tokens[0];
    for (const Trivia& trivia : unit.trivia()) {
        if (trivia.range.begin > first.offset())
            break;
        if (trivia.kind == TriviaKind::pragma && may_nest(unit.text(trivia.range)))
            return false;
    }
    const char letter = fold(unit.text()[first.offset()]);
    return first.kind() == TokenKind::identifier ||
           (is_keyword(first.kind()) && letter >= 'A' && letter <= 'Z');
}

/// True when the unit at the reader is the old one: its text is, and it was cut and read alike.
bool is_same(const UnitReader& reader, const Unit& old) {
    const std::span<const Token> tokens = reader.tokens();
    const std::span<const Trivia> trivia = reader.trivia();
    const auto moved = [&reader](const Trivia& one) {
        const TextRange range{one.range.begin - reader.begin(), one.range.end - reader.begin()};
        return Trivia{range, one.kind};
    };
    return begins_with_word(old) && !old.depends_on_rest() && !reader.depends_on_rest() &&
           // else the opener may be another one, which the tokens do not tell
           reader.opener() + cutter_lookahead <= tokens.size() &&
           std::ranges::equal(
               tokens, old.tokens(), {},
               [&reader](Token token) { return token.moved_back(reader.begin()); }) &&
           std::ranges::equal(trivia, old.trivia(), {}, moved);
}

/// An edit of a row of units. Reads units of the new text until they fall in step with old ones.
class Edit {
public:
    Edit(const SyntaxTree& tree, TextRange range, std::string_view replacement)
        : old_(tree.slots()),
          size_(tree.size()),
          encoding_(tree.encoding()),
          options_(tree.options()),
          range_(range),
          replacement_(replacement),
          last_(slot_at(tree, range.end)) {}

    /// Reads from the unit in which the edit begins, or from one before it; `first_open` is the
    /// first one that depends on what follows.
    void read(std::size_t slot, std::size_t first_open);

    /// The new row, and its first unit that depends on what follows.
    [[nodiscard]] std::vector<SyntaxTree::Slot> row() const;
    [[nodiscard]] std::size_t first_open(std::size_t before) const;

    static std::size_t slot_at(const SyntaxTree& tree, std::uint32_t offset) {
        return static_cast<std::size_t>(&tree.slot_at(offset) - tree.slots().data());
    }

private:
    enum class Outcome : std::uint8_t { read, needs_more_text, needs_unit_before };

    [[nodiscard]] bool can_begin_at(std::size_t slot) const;
    [[nodiscard]] std::size_t first_touched(std::size_t slot) const;
    [[nodiscard]] bool read_from(std::size_t first, bool alone);
    [[nodiscard]] Outcome read_stretch(std::string text, bool complete, bool alone);
    [[nodiscard]] std::string text_with(std::size_t more, bool& complete) const;
    [[nodiscard]] bool begins_as_before(std::span<const Token> tokens) const;
    [[nodiscard]] std::size_t old_slot(std::uint32_t offset, bool moved) const;
    [[nodiscard]] std::shared_ptr<const Unit> old_unit(const UnitReader& reader) const;
    [[nodiscard]] std::uint32_t growth() const noexcept {
        return static_cast<std::uint32_t>(replacement_.size()) - range_.size();
    }
    [[nodiscard]] std::uint32_t end_of_slot(std::size_t slot) const noexcept {
        return slot + 1 < old_.size() ? old_[slot + 1].offset : size_;
    }

    Slots old_;
    std::uint32_t size_; // of the old text
    Encoding encoding_;
    const ParseOptions& options_;
    TextRange range_; // in the old text
    std::string_view replacement_;
    std::size_t last_;                               // slot in which the edit ends
    std::size_t first_ = 0;                          // slots from here on,
    std::size_t rest_ = 0;                           // up to here,
    std::vector<std::shared_ptr<const Unit>> units_; // become these
};

/// True when the unit alone can be read again: whatever else decides about the unit before it is
/// looked at behind its beginning, which stays.
bool Edit::can_begin_at(std::size_t slot) const {
    const Unit& unit = *old_[slot].unit;
    return slot == 0 || (unit.tokens().size() >= cutter_lookahead && begins_with_word(unit) &&
                         range_.begin > old_[slot].offset + unit.tokens()[0].end());
}

/// The first slot that has to be read again when something changes in `slot`: tokens of later units
/// decide where one ends.
std::size_t Edit::first_touched(std::size_t slot) const {
    std::size_t tokens = 0;
    while (slot > 0 && (tokens < cutter_lookahead || !begins_with_word(*old_[slot].unit)))
        tokens += old_[--slot].unit->tokens().size();
    return slot;
}

void Edit::read(std::size_t slot, std::size_t first_open) {
    if (slot <= first_open && can_begin_at(slot) && read_from(slot, slot != 0))
        return;
    // A comment that nothing closes depends on all that follows.
    (void)read_from(first_touched(std::min(slot, first_open)), false);
}

/// False when `alone` was wrong: not only the units from `first` on can have changed.
bool Edit::read_from(std::size_t first, bool alone) {
    first_ = first;
    units_.clear();
    for (std::size_t more = 0;; more = 16 * more + 2) {
        bool complete = false;
        std::string text = text_with(more, complete);
        const Outcome outcome = read_stretch(std::move(text), complete, alone);
        if (outcome != Outcome::needs_more_text)
            return outcome == Outcome::read;
    }
}

/// The new text from the first slot on, with so many units behind the edit, and some tokens more.
std::string Edit::text_with(std::size_t more, bool& complete) const {
    const std::size_t end = std::min(last_ + more + 1, old_.size());
    std::string text;
    text.reserve(end_of_slot(end - 1) - old_[first_].offset + replacement_.size() + 1000);
    for (std::size_t i = first_; i < end; ++i)
        text += old_[i].unit->text();
    text.replace(range_.begin - old_[first_].offset, range_.size(), replacement_);

    std::size_t wanted = tokens_behind;
    for (std::size_t i = end; i < old_.size(); ++i) {
        const Unit& unit = *old_[i].unit;
        if (unit.tokens().size() > wanted) {
            text += unit.text().substr(0, unit.tokens()[wanted].offset());
            return text;
        }
        text += unit.text();
        wanted -= unit.tokens().size();
    }
    complete = true;
    return text;
}

Edit::Outcome Edit::read_stretch(std::string text, bool complete, bool alone) {
    const auto size = static_cast<std::uint32_t>(text.size());
    const auto edit_end = static_cast<std::uint32_t>(range_.begin + replacement_.size());
    UnitReader reader(std::make_shared<const std::string>(std::move(text)), encoding_, first_ == 0,
                      options_, UnitMemory::own);
    for (std::size_t count = 0; reader.next(); ++count) {
        const std::span<const Token> ahead = reader.tokens_ahead();
        const std::size_t decisive = reader.tokens().size() + cutter_lookahead;
        if (!complete &&
            (ahead.size() <= decisive || reader.looked_to(ahead[decisive].offset()) > size))
            return Outcome::needs_more_text;
        if (alone && count == 0 && !begins_as_before(ahead))
            return Outcome::needs_unit_before;
        if (count == units_.size()) { // else it was read from a shorter stretch
            auto unit = old_unit(reader);
            units_.push_back(unit != nullptr ? std::move(unit) : reader.parse());
        }
        const std::uint32_t end = old_[first_].offset + reader.end();
        rest_ = end < edit_end ? old_.size() : old_slot(end - growth(), true);
        if (rest_ < old_.size() && begins_with_word(*old_[rest_].unit))
            return Outcome::read;
    }
    rest_ = old_.size();
    return complete ? Outcome::read : Outcome::needs_more_text;
}

/// True when the first unit begins as it did, as far as it decides about the unit before it.
bool Edit::begins_as_before(std::span<const Token> tokens) const {
    const std::span<const Token> before = old_[first_].unit->tokens().first(cutter_lookahead);
    return tokens.size() >= cutter_lookahead && tokens[0].offset() == before[0].offset() &&
           std::ranges::equal(tokens.first(cutter_lookahead), before, [](Token a, Token b) {
               return a.kind() == b.kind() && a.first_on_line() == b.first_on_line();
           });
}

/// The slot that begins at `offset` of the old text; one past the last for none. The first one does
/// not count where it is `moved`: a file begins as a line does.
std::size_t Edit::old_slot(std::uint32_t offset, bool moved) const {
    const auto found = std::ranges::lower_bound(old_, offset, {}, &SyntaxTree::Slot::offset);
    return found != old_.end() && found->offset == offset && !(moved && offset == 0)
               ? static_cast<std::size_t>(found - old_.begin())
               : old_.size();
}

/// The old unit that the one at the reader is; null when it was touched, or is another one.
std::shared_ptr<const Unit> Edit::old_unit(const UnitReader& reader) const {
    const std::uint32_t begin = old_[first_].offset + reader.begin();
    const std::uint32_t end = old_[first_].offset + reader.end();
    const bool before = end <= range_.begin;
    if (!before && begin < range_.begin + replacement_.size())
        return nullptr;
    const std::uint32_t moved = before ? 0 : growth();
    const std::size_t slot = old_slot(begin - moved, !before);
    if (slot == old_.size() || end_of_slot(slot) != end - moved ||
        !is_same(reader, *old_[slot].unit))
        return nullptr;
    return old_[slot].unit;
}

std::vector<SyntaxTree::Slot> Edit::row() const {
    std::vector<SyntaxTree::Slot> row;
    row.reserve(first_ + units_.size() + old_.size() - rest_);
    row.assign(old_.begin(), old_.begin() + static_cast<std::ptrdiff_t>(first_));
    std::uint32_t offset = old_[first_].offset;
    std::uint32_t line = old_[first_].first_line;
    for (const auto& unit : units_) {
        row.push_back({offset, line, unit});
        offset += static_cast<std::uint32_t>(unit->text().size());
        line += unit->line_end_count();
    }
    if (rest_ == old_.size())
        return row;
    line -= old_[rest_].first_line;
    for (const SyntaxTree::Slot& slot : old_.subspan(rest_))
        row.push_back({slot.offset + growth(), slot.first_line + line, slot.unit});
    return row;
}

std::size_t Edit::first_open(std::size_t before) const {
    const auto is_open = [](const auto& unit) { return unit->depends_on_rest(); };
    if (before < first_)
        return before;
    const auto found = std::ranges::find_if(units_, is_open);
    if (found == units_.end() && before < rest_) // it is closed: which is the next one?
        before = rest_ + static_cast<std::size_t>(std::ranges::find_if(old_.subspan(rest_), is_open,
                                                                       &SyntaxTree::Slot::unit) -
                                                  old_.subspan(rest_).begin());
    return found != units_.end() ? first_ + static_cast<std::size_t>(found - units_.begin())
                                 : before - rest_ + first_ + units_.size();
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
    Edit edit(*this, range, replacement);
    edit.read(Edit::slot_at(*this, range.begin), first_open_);
    return {*this, edit.row(), edit.first_open(first_open_)};
}

} // namespace iecfront
