#include "builder/assembly.hpp"
#include "format/line_end.hpp"

#include <iecfront/ast/attached_comments.hpp>
#include <iecfront/ast/visitor.hpp>
#include <iecfront/builder/changes.hpp>
#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <utility>

namespace iecfront::build {
namespace {

using Slot = SyntaxTree::Slot;

// The node that `node` is a child of; null for the root.
[[nodiscard]] const ast::Node* parent_of(const Unit& unit, const ast::Node& node) {
    const ast::Node* parent = nullptr;
    ast::walk(unit.root(), [&](const ast::Node& candidate) {
        if (candidate.first_token > node.first_token || candidate.end_token < node.end_token)
            return ast::Walk::over;
        ast::for_each_child(candidate, [&](const ast::Node& child) {
            if (&child == &node)
                parent = &candidate;
        });
        return parent != nullptr ? ast::Walk::stop : ast::Walk::into;
    });
    return parent;
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
    } else {
        assembly.part(part);
    }
    return std::move(assembly).finish(part.kind(), strength::primary);
}

[[nodiscard]] bool is_blank(char c) noexcept {
    return c == ' ' || c == '\t';
}

[[nodiscard]] std::uint32_t line_start(const Unit& unit, std::uint32_t offset) {
    return unit.lines().line_start(unit.lines().line_of(offset));
}

// The blanks that the line of `offset` begins with.
[[nodiscard]] std::string_view indentation(const Unit& unit, std::uint32_t offset) {
    const std::string_view line = unit.text().substr(line_start(unit, offset));
    const auto end = std::ranges::find_if_not(line, is_blank);
    return line.substr(0, static_cast<std::size_t>(end - line.begin()));
}

[[nodiscard]] bool begins_line(const Unit& unit, std::uint32_t offset) {
    return line_start(unit, offset) + indentation(unit, offset).size() == offset;
}

// Elements of lists with commas.
[[nodiscard]] bool has_comma(ast::NodeKind kind) noexcept {
    switch (kind) {
    case ast::NodeKind::input_argument:
    case ast::NodeKind::output_argument:
    case ast::NodeKind::enumerated_value_declaration:
    case ast::NodeKind::subrange:
    case ast::NodeKind::structure_element_initialization:
    case ast::NodeKind::task_initialization:
    case ast::NodeKind::fb_task:
    case ast::NodeKind::prog_cnxn: return true;
    default: return ast::is<ast::Expression>(kind);
    }
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

[[nodiscard]] std::optional<Token> token_at(const Unit& unit, std::size_t index, TokenKind kind) {
    if (index < unit.tokens().size() && unit.tokens()[index].kind() == kind)
        return unit.tokens()[index];
    return std::nullopt;
}

// Where `node` ends with its `;`, when one stands behind it.
[[nodiscard]] std::uint32_t end_with_semicolon(const Unit& unit, const ast::Node& node) {
    if (has_semicolon(node.kind))
        if (const std::optional<Token> found = token_at(unit, node.end_token, TokenKind::semicolon))
            return found->end();
    return unit.range(node).end;
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
    const Unit& unit = *slot.unit;
    std::uint32_t place = unit.range(node).begin;
    std::string text = part.text();
    if (has_comma(part.kind())) {
        text += begins_line(unit, place) ? ",\n" : ", ";
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
    const Unit& unit = *slot.unit;
    const TextRange range = unit.range(node);
    if (!has_comma(part.kind())) {
        const std::uint32_t end = end_with_semicolon(unit, node);
        return insert_line_behind(slot, node, end_with_comments(unit, node, end), part);
    }
    if (fault_.empty())
        fault_ = part.fault();
    const std::string text = (begins_line(unit, range.begin) ? ",\n" : ", ") + part.text();
    edit(slot, {range.end, range.end}, moved_in(text, indentation(unit, range.begin)));
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
        replace(slot, *list.statements[0], statement);
    else if (!list.statements.empty())
        insert_after(slot, *list.statements.back(), statement);
    else
        insert_line_behind(slot, list, slot.unit->range(list).end, statement, "    ");
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

// ---- what is taken out -------------------------------------------------------------------------

void Changes::remove(const Slot& slot, const ast::Node& node) {
    const Unit& unit = *slot.unit;
    const ast::Node* parent = parent_of(unit, node);
    const TextRange range = unit.range(node);
    if (const auto* list = parent ? ast::as<ast::StatementList>(parent) : nullptr;
        list != nullptr && list->statements.size() == 1)
        return edit(slot, range, "");
    if (const auto* block = parent ? ast::as<ast::VariableDeclarations>(parent) : nullptr;
        block != nullptr && block->declarations.size() == 1)
        return remove_line(slot, unit.range(*block));
    if (!has_comma(node.kind))
        return remove_line(slot, {range.begin, end_with_semicolon(unit, node)});
    remove_with_comma(slot, node);
}

// The comma behind it, or that before the last element.
void Changes::remove_with_comma(const Slot& slot, const ast::Node& node) {
    const Unit& unit = *slot.unit;
    TextRange range = unit.range(node);
    if (const auto behind = token_at(unit, node.end_token, TokenKind::comma)) {
        range.end = behind->end();
    } else if (node.first_token > 0) {
        const Token before = unit.tokens()[node.first_token - 1];
        const std::string_view gap = unit.text({before.end(), range.begin});
        if (before.kind() == TokenKind::comma && std::ranges::all_of(gap, is_blank))
            range.begin = before.offset();
        else if (before.kind() == TokenKind::comma)
            edit(slot, before.range(), "");
    }
    remove_line(slot, range);
}

// With the blanks beside it, and its lines when nothing else stands in them.
void Changes::remove_line(const Slot& slot, TextRange range) {
    const Unit& unit = *slot.unit;
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
    }
    edit(slot, {range.begin, end}, "");
}

// ---- what comes of it --------------------------------------------------------------------------

void Changes::edit(const Slot& slot, TextRange range, std::string_view replacement) {
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
    std::ranges::stable_sort(sorted, {}, [](const TextEdit& edit) {
        return std::pair(edit.range.begin, edit.range.end);
    });
    return sorted;
}

std::optional<SyntaxTree> Changes::tree() const {
    if (!fault().empty())
        return std::nullopt;
    SyntaxTree changed = tree_;
    const std::vector<TextEdit> sorted = edits();
    for (auto edit = sorted.rbegin(); edit != sorted.rend(); ++edit) // those before stay in place
        changed = changed.edited(edit->range, edit->replacement);
    return changed;
}

} // namespace iecfront::build
