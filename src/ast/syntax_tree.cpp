#include "ast/slot_columns.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace iecfront {
namespace {

using Slot = SyntaxTree::Slot;

[[nodiscard]] std::uint32_t size_of(const Slot& slot) noexcept {
    return static_cast<std::uint32_t>(slot.unit->text().size());
}

// Size of a byte order mark at `begin` of a unit that does not begin the file. It is a character
// like any other there, while `column_of` and `offset_of_column`, which see the unit only, give it
// no column.
[[nodiscard]] std::uint32_t inner_mark_size(const Slot& slot, std::uint32_t begin,
                                            ColumnUnit unit) noexcept {
    if (slot.offset == 0 || begin != 0 || unit == ColumnUnit::bytes)
        return 0;
    return byte_order_mark_size(slot.unit->text(), slot.unit->encoding());
}

// The inverse of `columns_between`: the offset in the unit of 1-based `column`, counted from
// `begin`.
[[nodiscard]] std::uint32_t offset_in_unit(const Slot& slot, std::uint32_t begin,
                                           std::uint32_t column, ColumnUnit unit) noexcept {
    if (inner_mark_size(slot, begin, unit) != 0) {
        if (column == 1)
            return begin;
        --column;
    }
    return offset_of_column(slot.unit->text(), begin, column, slot.unit->encoding(), unit);
}

// The slot in which 0-based `line` begins. A line that begins where a unit does also begins at the
// end of the unit before it.
[[nodiscard]] const Slot* slot_of_line(std::span<const Slot> slots, std::uint32_t line) noexcept {
    const auto behind =
        std::lower_bound(slots.begin(), slots.end(), line,
                         [](const Slot& slot, std::uint32_t l) { return slot.first_line < l; });
    return behind == slots.begin() ? slots.data() : &*(behind - 1);
}

// The buffer that the units cut into pieces; null when they do not stand in one, or not all of it
// is left.
[[nodiscard]] std::shared_ptr<const std::string> common_buffer(std::span<const Slot> slots,
                                                               std::uint32_t size) {
    const auto& buffer = slots.front().unit->buffer();
    if (buffer == nullptr || buffer->size() != size)
        return nullptr;
    const auto stands_in_buffer = [&](const Slot& slot) {
        const std::string_view text = slot.unit->text();
        return text.empty() || text.data() == buffer->data() + slot.offset;
    };
    return std::all_of(slots.begin(), slots.end(), stands_in_buffer) ? buffer : nullptr;
}

[[nodiscard]] const ast::Node* child_at(const Unit& unit, const ast::Node& node,
                                        std::uint32_t offset) {
    const ast::Node* found = nullptr;
    ast::for_each_child(node, [&](const ast::Node& child) {
        if (unit.range(child).contains(offset))
            found = &child;
    });
    return found;
}

// True for the report of this word of another edition.
[[nodiscard]] bool is_foreign(const Diagnostic& diagnostic, std::string_view quoted_word) noexcept {
    if (diagnostic.id != DiagnosticId::foreign_construct || diagnostic.arguments.empty())
        return false;
    const auto* word = std::get_if<std::string>(&diagnostic.arguments.front());
    return word != nullptr && names_equal(*word, quoted_word);
}

} // namespace

std::uint32_t columns_between(const SyntaxTree::Slot& slot, std::uint32_t begin, std::uint32_t end,
                              ColumnUnit unit) noexcept {
    const std::uint32_t mark = inner_mark_size(slot, begin, unit);
    const std::uint32_t of_mark = mark != 0 && mark <= end ? 1 : 0;
    return of_mark + column_of(slot.unit->text(), begin, end, slot.unit->encoding(), unit) - 1;
}

SyntaxTree::SyntaxTree(std::string name, Encoding encoding,
                       std::vector<std::shared_ptr<const Unit>> units, const ParseOptions& options,
                       const Origin& origin)
    : name_(std::move(name)), encoding_(encoding), options_(options), origin_(origin) {
    std::vector<Slot> slots;
    slots.reserve(units.size());
    std::uint32_t line = 0;
    for (std::shared_ptr<const Unit>& unit : units) {
        slots.push_back({size_, line, std::move(unit)});
        size_ += size_of(slots.back());
        line += slots.back().unit->line_end_count();
        if (first_open_ + 1 == slots.size() && !slots.back().unit->depends_on_rest())
            ++first_open_;
    }
    slots_ = std::make_shared<const std::vector<Slot>>(std::move(slots));
}

SyntaxTree::SyntaxTree(const SyntaxTree& before, std::vector<Slot> slots, std::size_t first_open)
    : name_(before.name_),
      encoding_(before.encoding_),
      size_(slots.back().offset + size_of(slots.back())),
      slots_(std::make_shared<const std::vector<Slot>>(std::move(slots))),
      first_open_(first_open),
      options_(before.options_),
      origin_(before.origin_) {}

SourceText SyntaxTree::source() const {
    if (auto buffer = common_buffer(*slots_, size_))
        return SourceText(std::move(buffer), name_, encoding_).at(origin_);
    std::string text;
    text.reserve(size_);
    for (const Slot& slot : *slots_)
        text += slot.unit->text();
    return SourceText(std::move(text), name_, encoding_).at(origin_);
}

const SyntaxTree::Slot& SyntaxTree::slot_at(std::uint32_t offset) const noexcept {
    const auto behind =
        std::upper_bound(slots_->begin(), slots_->end(), offset,
                         [](std::uint32_t o, const Slot& slot) { return o < slot.offset; });
    return *(behind - 1);
}

Position SyntaxTree::position(std::uint32_t offset, ColumnUnit unit) const noexcept {
    const Slot* slot = &slot_at(offset);
    std::uint32_t end = offset - slot->offset;
    std::uint32_t line = slot->unit->lines().line_of(end);
    Position position{slot->first_line + line + 1, 1};
    while (line == 0 && slot != slots_->data()) { // the line may begin in an earlier unit
        position.column += columns_between(*slot, 0, end, unit);
        --slot;
        end = size_of(*slot);
        line = slot->unit->line_end_count();
    }
    position.column += columns_between(*slot, slot->unit->lines().line_start(line), end, unit);
    return position;
}

std::uint32_t SyntaxTree::offset(Position position, ColumnUnit unit) const noexcept {
    const std::uint32_t line = std::max(position.line, 1U) - 1;
    const Slot* slot = slot_of_line(*slots_, line);
    std::uint32_t line_in_unit = line - slot->first_line;
    if (line_in_unit > slot->unit->line_end_count())
        return size_;
    std::uint32_t begin = slot->unit->lines().line_start(line_in_unit);
    std::uint32_t column = std::max(position.column, 1U);
    // The last line of a unit goes on in the next one.
    while (line_in_unit == slot->unit->line_end_count() && slot != &slots_->back()) {
        const std::uint32_t columns = columns_between(*slot, begin, size_of(*slot), unit);
        if (column <= columns)
            break;
        column -= columns;
        ++slot;
        line_in_unit = 0;
        begin = 0;
    }
    return slot->offset + offset_in_unit(*slot, begin, column, unit);
}

HostPlace SyntaxTree::host_place(std::uint32_t offset, ColumnUnit unit) const noexcept {
    Position there = position(offset, unit);
    if (there.line == 1)
        there.column += origin_.column_in(unit) - 1;
    there.line += origin_.line - 1;
    return {origin_.offset + offset, there};
}

std::vector<Diagnostic> SyntaxTree::diagnostics() const {
    std::vector<Diagnostic> result;
    std::uint32_t namespaces = 0; // open, and reported
    for (const Slot& slot : *slots_)
        for (const Diagnostic& diagnostic : slot.unit->diagnostics()) {
            // A unit cannot know that the namespace was reported that it ends.
            if (namespaces > 0 && is_foreign(diagnostic, "`END_NAMESPACE`")) {
                --namespaces;
                continue;
            }
            namespaces += is_foreign(diagnostic, "`NAMESPACE`") ? 1 : 0;
            result.push_back(shifted(diagnostic, slot.offset));
            if (result.size() > options_.maximum_diagnostics) {
                result.back() = {DiagnosticId::too_many_diagnostics,
                                 result.back().range,
                                 {std::uint64_t{options_.maximum_diagnostics}},
                                 {},
                                 {}};
                return result;
            }
        }
    return result;
}

SyntaxTree::Path SyntaxTree::node_at(std::uint32_t offset) const {
    const Slot& slot = slot_at(offset);
    Path path{&slot, {}};
    const ast::Node* node = &slot.unit->root();
    while (node != nullptr) {
        path.nodes.push_back(node);
        node = child_at(*slot.unit, *node, offset - slot.offset);
    }
    return path;
}

std::optional<SyntaxTree::TokenPlace>
SyntaxTree::token_before(std::uint32_t offset) const noexcept {
    const Slot* slot = &slot_at(offset);
    for (;;) {
        const std::span<const Token> tokens = slot->unit->tokens();
        const auto behind = std::partition_point(tokens.begin(), tokens.end(), [&](Token token) {
            return slot->offset + token.offset() < offset;
        });
        if (behind != tokens.begin())
            return TokenPlace{slot, static_cast<std::uint32_t>(behind - tokens.begin() - 1)};
        if (slot == slots_->data())
            return std::nullopt;
        --slot;
    }
}

std::optional<SyntaxTree::TokenPlace> SyntaxTree::token_at(std::uint32_t offset) const noexcept {
    if (offset >= size_)
        return std::nullopt;
    const std::optional<TokenPlace> place = token_before(offset + 1);
    return place && place->range().contains(offset) ? place : std::nullopt;
}

bool operator==(const SyntaxTree& a, const SyntaxTree& b) {
    return std::ranges::equal(a.slots(), b.slots(), [](const Slot& left, const Slot& right) {
        return left.unit == right.unit || *left.unit == *right.unit;
    });
}

} // namespace iecfront
