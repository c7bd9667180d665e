#include "builder/assembly.hpp"
#include "builder/places.hpp"
#include "builder/removals.hpp"
#include "format/line_end.hpp"

#include <iecfront/ast/attached_comments.hpp>
#include <iecfront/ast/visitor.hpp>
#include <iecfront/builder/changes.hpp>
#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <span>
#include <utility>

namespace iecfront::build {
namespace {

using Slot = SyntaxTree::Slot;

// True when a `.`, a `[` or a `^` belongs to `node`, a child of `parent`.
[[nodiscard]] bool is_variable_of(const ast::Node* parent, const ast::Node& node) {
    if (const auto* array = ast::as<ast::ArrayVariable>(parent))
        return array->subscripted_variable == &node;
    if (const auto* record = ast::as<ast::StructuredVariable>(parent))
        return record->record_variable == &node;
    return ast::as<ast::DereferencedVariable>(parent) != nullptr;
}

// `part` as it can stand where `node` stands.
[[nodiscard]] AnyPart fitted(const Unit& unit, const ast::Node& node, const AnyPart& part) {
    const ast::Node* parent = parent_of(unit, node);
    Assembly assembly;
    if (const auto* binary = parent != nullptr ? ast::as<ast::BinaryExpression>(parent) : nullptr) {
        const int further = binary->right == &node ? 1 : 0;
        assembly.operand(part, static_cast<std::uint8_t>(strength_of(binary->op) + further));
    } else if (const auto* unary =
                   parent != nullptr ? ast::as<ast::UnaryExpression>(parent) : nullptr) {
        assembly.operand(part, unary->op);
    } else if (is_variable_of(parent, node)) {
        assembly.variable(part);
    } else {
        assembly.part(part);
    }
    return std::move(assembly).finish(part.kind(), strength::primary);
}

// True for an element of a list that is laid out with a line for each. The names of a declaration
// share theirs.
[[nodiscard]] bool is_on_own_line(const Unit& unit, const ast::Node& node) {
    return node.kind != ast::NodeKind::identifier && begins_line(unit, unit.range(node).begin);
}

[[nodiscard]] std::string_view line_break_for(ast::NodeKind kind) noexcept {
    const bool apart =
        ast::is<ast::LibraryElement>(kind) && kind != ast::NodeKind::variable_declarations;
    return apart ? "\n\n" : "\n";
}

// With the `;` that belongs behind it.
[[nodiscard]] std::string whole_line(const AnyPart& part) {
    return part.text() + (has_semicolon(part.kind()) ? ";" : "");
}

[[nodiscard]] AttachedComments comments_of(const Unit& unit, const ast::Node& node) {
    return node.first_token < node.end_token ? attached_comments(unit, node) : AttachedComments();
}

// Where `end` is the end of `node`, or that with the comments behind it.
[[nodiscard]] std::uint32_t end_with_comments(const Unit& unit, const ast::Node& node,
                                              std::uint32_t end) {
    const AttachedComments comments = comments_of(unit, node);
    return comments.behind.empty() ? end : std::max(end, comments.behind.back().range.end);
}

// `text`, which is UTF-8; nothing when `encoding` lacks one of its characters.
[[nodiscard]] std::optional<std::string> encoded(std::string_view text, Encoding encoding) {
    if (encoding == Encoding::utf8)
        return std::string(text);
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const DecodedCharacter character = decode_character(text, i, Encoding::utf8);
        const auto is_it = [&](int byte) {
            const char c = static_cast<char>(byte);
            const DecodedCharacter one = decode_character({&c, 1}, 0, encoding);
            return one.valid && one.code_point == character.code_point;
        };
        int byte = 0;
        while (byte < 256 && !is_it(byte))
            ++byte;
        if (byte == 256)
            return std::nullopt;
        out += static_cast<char>(byte);
        i += character.size;
    }
    return out;
}

[[nodiscard]] bool is_in_word(char c) noexcept {
    return (fold(c) >= 'A' && fold(c) <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

// True when the two would be one token, or taken for one.
[[nodiscard]] bool run_together(char left, char right) noexcept {
    if (left == '-')
        return right == '-';
    return is_in_word(left) && (is_in_word(right) || right == '\'' || right == '"');
}

// With a blank where it would run together with what stands beside `range`.
[[nodiscard]] std::string set_apart(std::string_view text, TextRange range,
                                    std::string_view replacement) {
    std::string out(replacement);
    if (out.empty())
        return out;
    if (range.begin > 0 && run_together(text[range.begin - 1], out.front()))
        out.insert(0, 1, ' ');
    if (range.end < text.size() && run_together(out.back(), text[range.end]))
        out += ' ';
    return out;
}

[[nodiscard]] std::string with_line_ends(std::string_view text, std::string_view line_end) {
    std::string out;
    for (const char c : text)
        out += c == '\n' ? line_end : std::string_view(&c, 1);
    return out;
}

[[nodiscard]] std::pair<std::uint32_t, std::uint32_t> place_of(const TextEdit& edit) noexcept {
    return {edit.range.begin, edit.range.end};
}

// What stands in `range` of `text` after `edits`, which lie in it.
[[nodiscard]] std::string edited_text(std::string_view text, TextRange range,
                                      std::span<const TextEdit> edits) {
    std::string out;
    std::uint32_t copied = range.begin;
    for (const TextEdit& edit : edits) {
        out += text.substr(copied, edit.range.begin - copied);
        out += edit.replacement;
        copied = edit.range.end;
    }
    return out;
}

} // namespace

// ---- what is put in ----------------------------------------------------------------------------

void Changes::replace_node(const Slot& slot, const ast::Node& node, const AnyPart& part) {
    const Unit& unit = *slot.unit;
    const TextRange range = unit.range(node);
    const AnyPart fitting = fitted(unit, node, part);
    if (fault_.empty())
        fault_ = fitting.fault();
    edit(slot, range, moved_in(fitting.text(), indentation(unit, range.begin)));
}

void Changes::insert_before_node(const Slot& slot, const ast::Node& node, const AnyPart& part) {
    put_beside(slot, node);
    const Unit& unit = *slot.unit;
    std::uint32_t place = unit.range(node).begin;
    std::string text = part.text();
    if (has_comma(part.kind())) {
        text += is_on_own_line(unit, node) ? ",\n" : ", ";
    } else {
        const AttachedComments comments = comments_of(unit, node);
        if (!comments.before.empty())
            place = comments.before.front().range.begin;
        text = whole_line(part).append(line_break_for(part.kind()));
    }
    if (fault_.empty())
        fault_ = part.fault();
    const std::string_view blanks = indentation(unit, place);
    edit(slot, {place, place}, moved_in(text, blanks).append(text.ends_with('\n') ? blanks : ""));
}

void Changes::insert_after_node(const Slot& slot, const ast::Node& node, const AnyPart& part) {
    put_beside(slot, node);
    const Unit& unit = *slot.unit;
    const TextRange range = unit.range(node);
    if (!has_comma(part.kind())) {
        const std::uint32_t end = end_with_semicolon(unit, node);
        return insert_line_behind(slot, node, end_with_comments(unit, node, end), part);
    }
    if (fault_.empty())
        fault_ = part.fault();
    const bool on_own_line = is_on_own_line(unit, node);
    const std::uint32_t end = end_with_comments(unit, node, range.end);
    if (on_own_line && end > range.end)
        return insert_behind_comments(slot, node, end, part);
    const std::string text = (on_own_line ? ",\n" : ", ") + part.text();
    edit(slot, {range.end, range.end}, moved_in(text, indentation(unit, range.begin)));
}

// On a line of its own behind the comments of `node`, which end at `end`. The comma stands before
// them.
void Changes::insert_behind_comments(const Slot& slot, const ast::Node& node, std::uint32_t end,
                                     const AnyPart& part) {
    const Unit& unit = *slot.unit;
    const TextRange range = unit.range(node);
    const std::string line = moved_in('\n' + part.text(), indentation(unit, range.begin));
    if (const std::optional<Token> comma = token_at(unit, node.end_token, TokenKind::comma)) {
        end = std::max(end, comma->end());
        return edit(slot, {end, end}, line + ',');
    }
    const std::uint32_t place = slot.offset + range.end;
    const bool has_one = std::ranges::find(edits_, TextEdit{{place, place}, ","}) != edits_.end();
    if (!has_one)
        edit(slot, {range.end, range.end}, ",");
    edit(slot, {end, end}, (has_one ? "," : "") + line);
}

void Changes::put_beside(const Slot& slot, const ast::Node& node) {
    accompanied_.push_back(&node);
    require_element(slot, node);
}

bool Changes::require_element(const Slot& slot, const ast::Node& node) {
    if (!require_own(slot))
        return false;
    const bool is_one = !siblings_of(*slot.unit, node).elements.empty();
    if (!is_one && fault_.empty())
        fault_ = "this " + quoted(to_string(node.kind)) + " is no element of a list";
    return is_one;
}

bool Changes::require_own(const Slot& slot) {
    const Slot& own = tree_.slot_at(slot.offset);
    const bool is_own = own.unit == slot.unit && own.offset == slot.offset;
    if (!is_own && fault_.empty())
        fault_ = "a slot is of another tree";
    return is_own;
}

// On a line of its own behind `offset`, as far in as the line of `node` is, and `further`.
void Changes::insert_line_behind(const Slot& slot, const ast::Node& node, std::uint32_t offset,
                                 const AnyPart& part, std::string_view further) {
    const Unit& unit = *slot.unit;
    if (fault_.empty())
        fault_ = part.fault();
    const std::string text = std::string(line_break_for(part.kind())) + whole_line(part);
    std::string blanks(indentation(unit, unit.range(node).begin));
    edit(slot, {offset, offset}, moved_in(text, blanks += further));
}

void Changes::append(const Slot& slot, const ast::StatementList& list, const Statement& statement) {
    if (list.statements.size() == 1 && list.statements[0]->kind == ast::NodeKind::empty_statement)
        append_to_empty(slot, *list.statements[0], statement);
    else if (!list.statements.empty())
        insert_after(slot, *list.statements.back(), statement);
    else
        insert_line_behind(slot, list, slot.unit->range(list).end, statement, "    ");
}

// The first statement takes the `;` of the empty one, and each later one that of the one before.
void Changes::append_to_empty(const Slot& slot, const ast::Node& empty, const AnyPart& statement) {
    if (std::ranges::find(accompanied_, &empty) == accompanied_.end()) {
        replace_node(slot, empty, statement);
        return put_beside(slot, empty);
    }
    if (fault_.empty())
        fault_ = statement.fault();
    const Unit& unit = *slot.unit;
    const TextRange range = unit.range(empty);
    edit(slot, range, moved_in(";\n" + statement.text(), indentation(unit, range.begin)));
}

void Changes::append(const Slot& slot, const ast::VariableDeclarations& block,
                     const Declaration& declaration) {
    if (!block.declarations.empty())
        return insert_after_node(slot, *block.declarations.back(), declaration);
    const std::uint32_t head = slot.unit->tokens()[block.first_token].end();
    insert_line_behind(slot, block, head, declaration, "    ");
}

void Changes::append(const Slot& slot, const ast::FunctionDeclaration& function,
                     const Part<ast::VariableDeclarations>& block) {
    append_block(slot, function.declarations, *function.result_type, block);
}
void Changes::append(const Slot& slot, const ast::FunctionBlockDeclaration& function_block,
                     const Part<ast::VariableDeclarations>& block) {
    append_block(slot, function_block.declarations, *function_block.name, block);
}
void Changes::append(const Slot& slot, const ast::ProgramDeclaration& program,
                     const Part<ast::VariableDeclarations>& block) {
    append_block(slot, program.declarations, *program.name, block);
}

// `head` is the last node of the line that the first block follows.
void Changes::append_block(const Slot& slot, const ast::List<ast::VariableDeclarations>& blocks,
                           const ast::Node& head, const AnyPart& block) {
    const ast::Node& last = blocks.empty() ? head : *blocks.back();
    const Unit& unit = *slot.unit;
    const std::uint32_t end = end_with_comments(unit, last, unit.range(last).end);
    insert_line_behind(slot, last, end, block, blocks.empty() ? "    " : "");
}

void Changes::remove(const Slot& slot, const ast::Node& node) {
    if (require_element(slot, node))
        removals_.push_back({slot, &node});
}

// ---- what comes of it --------------------------------------------------------------------------

void Changes::edit(const Slot& slot, TextRange range, std::string_view replacement) {
    if (!require_own(slot))
        return;
    const std::string apart = set_apart(slot.unit->text(), range, replacement);
    const std::string text = with_line_ends(apart, layout::line_end_of(tree_));
    const std::optional<std::string> bytes = encoded(text, tree_.encoding());
    if (!bytes && fault_.empty())
        fault_ = "a character is not in the encoding of the tree";
    edits_.push_back({range.shifted(slot.offset), bytes.value_or(text)});
}

std::string Changes::fault() const {
    if (!fault_.empty())
        return fault_;
    const std::vector<TextEdit> sorted = edits();
    const auto overlap = [](const TextEdit& a, const TextEdit& b) {
        return b.range.begin < a.range.end;
    };
    const bool found = std::ranges::adjacent_find(sorted, overlap) != sorted.end();
    return found ? "two changes are of the same place" : "";
}

std::vector<TextEdit> Changes::edits() const {
    std::vector<TextEdit> sorted = edits_;
    std::ranges::stable_sort(sorted, {}, place_of);
    take_out(sorted, removals_, accompanied_);
    std::ranges::stable_sort(sorted, {}, place_of);
    return sorted;
}

// Edits of one unit, and of units side by side, are made in one go: reading a long unit once for
// each of its edits would take a time that grows with their square.
std::optional<SyntaxTree> Changes::tree() const {
    if (!fault().empty())
        return std::nullopt;
    const SourceText source = tree_.source();
    const std::vector<TextEdit> sorted = edits();
    const auto slot_at = [&](std::uint32_t offset) { return &tree_.slot_at(offset); };
    SyntaxTree changed = tree_;
    for (std::size_t end = sorted.size(); end > 0;) { // from the last: those before stay in place
        std::size_t begin = end - 1;
        while (begin > 0 &&
               slot_at(sorted[begin].range.begin) <= slot_at(sorted[begin - 1].range.end) + 1)
            --begin;
        const TextRange range{sorted[begin].range.begin, sorted[end - 1].range.end};
        changed = changed.edited(
            range, edited_text(source.bytes(), range, {&sorted[begin], &sorted[end - 1] + 1}));
        end = begin;
    }
    return changed;
}

} // namespace iecfront::build
