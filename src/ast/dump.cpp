#include "ast/slot_columns.hpp"

#include <iecfront/ast/dump.hpp>
#include <iecfront/diagnostics/render_json.hpp>

#include <algorithm>
#include <charconv>
#include <type_traits>
#include <vector>

namespace iecfront {
namespace {

using ast::Node;

constexpr std::size_t longest_text = 40;
constexpr std::uint32_t deepest_indentation = 60;

template<class Member>
constexpr bool holds_nodes = ast::is_child_member<Member> || ast::is_list_member<Member>;

// Number of members of node type.
template<class Struct>
constexpr std::size_t node_member_count = std::apply(
    [](const auto&... member) {
        return (std::size_t{0} + ... +
                holds_nodes<std::remove_cvref_t<decltype(Struct().*(member.pointer))>>);
    },
    Struct::members());

[[nodiscard]] std::string_view shortened(std::string_view text, Encoding encoding) noexcept {
    if (text.size() <= longest_text)
        return text;
    std::size_t end = 0;
    while (end < longest_text) {
        const std::size_t size = decode_character(text, end, encoding).size;
        if (end + size > longest_text)
            break;
        end += size;
    }
    return text.substr(0, end);
}

void append_number(std::string& out, std::uint32_t number) {
    char digits[10];
    const std::to_chars_result result = std::to_chars(digits, digits + sizeof digits, number);
    out.append(digits, result.ptr);
}

void append_text(std::string& out, const Unit& unit, const Node& node) {
    const std::string_view text = unit.text(node);
    const std::string_view shown = shortened(text, unit.encoding());
    append_json_string(out, shown, unit.encoding());
    if (shown.size() < text.size())
        out.insert(out.size() - 1, "...");
}

// ---- s_expression and dump_tree ----------------------------------------------------------------

// Hashes and token numbers follow from the text, and are not written.
void append_scalar(std::string&, std::string_view, std::uint32_t) {}

void append_scalar(std::string& out, std::string_view name, bool value) {
    if (value)
        out.append(" ").append(name);
}

template<class Enumeration>
requires std::is_enum_v<Enumeration>
void append_scalar(std::string& out, std::string_view, Enumeration value) {
    const std::string_view word = to_string(value);
    if (word != "none")
        out.append(" ").append(word);
}

// Kind, scalars and text: all there is to say of a node but its children.
template<class Struct>
void append_head(std::string& out, const Unit& unit, const Struct& node) {
    out += to_string(node.kind);
    if (node.missing)
        out += " missing";
    ast::for_each_member(node, [&](std::string_view name, const auto& value) {
        if constexpr (!holds_nodes<std::remove_cvref_t<decltype(value)>>)
            append_scalar(out, name, value);
    });
    if (node_member_count<Struct> == 0 && node.first_token < node.end_token) {
        out += ' ';
        append_text(out, unit, node);
    }
}

// What is still to be written of nested text: words, or a node.
struct Piece {
    std::string_view text;
    const Node* node = nullptr;
};

// Writes a tree as nested text without recursion. `write_node(node, pieces)` writes the beginning
// of a node and gives what follows it.
template<class WriteNode>
void write_nested(std::string& out, const Node& root, WriteNode&& write_node) {
    std::vector<Piece> pending{{{}, &root}};
    std::vector<Piece> pieces;
    while (!pending.empty()) {
        const Piece piece = pending.back();
        pending.pop_back();
        out += piece.text;
        if (piece.node == nullptr)
            continue;
        pieces.clear();
        write_node(*piece.node, pieces);
        pending.insert(pending.end(), pieces.rbegin(), pieces.rend());
    }
}

void add_list(std::vector<Piece>& pieces, const auto& list, std::string_view separator) {
    pieces.push_back({"["});
    for (std::size_t i = 0; i < list.size(); ++i)
        pieces.insert(pieces.end(), {{i == 0 ? "" : separator}, {{}, list[i]}});
    pieces.push_back({"]"});
}

template<class Struct>
void add_children(std::vector<Piece>& pieces, const Struct& node) {
    const auto add_label = [&](std::string_view name) {
        pieces.push_back({" "});
        if (1 < node_member_count<Struct>)
            pieces.insert(pieces.end(), {{name}, {":"}});
    };
    ast::for_each_member(node, [&](std::string_view name, const auto& value) {
        using Member = std::remove_cvref_t<decltype(value)>;
        if constexpr (ast::is_child_member<Member>) {
            if (value == nullptr)
                return;
            add_label(name);
            pieces.push_back({{}, value});
        } else if constexpr (ast::is_list_member<Member>) {
            if (value.empty())
                return;
            add_label(name);
            add_list(pieces, value, " ");
        }
    });
}

void write_s_expression(std::string& out, const Unit& unit, const Node& node,
                        std::vector<Piece>& pieces) {
    if (node.kind == ast::NodeKind::identifier && !node.missing)
        return append_text(out, unit, node);
    ast::dispatch(node, [&](const auto& typed) {
        out += '(';
        append_head(out, unit, typed);
        add_children(pieces, typed);
    });
    pieces.push_back({")"});
}

// ---- dump_tree ---------------------------------------------------------------------------------

// Where the tokens of one unit after the other stand. All are found in one pass over the file:
// asked for one by one, they would have a long line counted again for each.
class TokenPositions {
public:
    // To be called for each slot, in order.
    void enter(const SyntaxTree::Slot& slot) {
        if (slot_ != nullptr)
            (void)advance(static_cast<std::uint32_t>(slot_->unit->text().size()));
        slot_ = &slot;
        offset_ = 0;
        line_ = 0;
        unit_begin_ = position_;
        begins_.clear();
        ends_.clear();
        for (const Token token : slot.unit->tokens()) {
            begins_.push_back(advance(token.offset()));
            ends_.push_back(advance(token.end()));
        }
    }

    [[nodiscard]] Position begin(const Node& node) const {
        return node.first_token < node.end_token ? begins_[node.first_token] : place(node);
    }
    [[nodiscard]] Position end(const Node& node) const {
        return node.first_token < node.end_token ? ends_[node.end_token - 1] : place(node);
    }

private:
    // Of a node without tokens, see `Unit::range`.
    [[nodiscard]] Position place(const Node& node) const {
        if (node.kind == ast::NodeKind::empty_statement)
            return begins_[node.first_token];
        return node.first_token == 0 ? unit_begin_ : ends_[node.first_token - 1];
    }

    // The position of an offset in the unit that is not before the last one.
    Position advance(std::uint32_t offset) {
        const LineTable& lines = slot_->unit->lines();
        const std::uint32_t line = lines.line_of(offset);
        if (line != line_) {
            position_ = {position_.line + line - line_, 1};
            line_ = line;
            offset_ = lines.line_start(line);
        }
        position_.column += columns_between(*slot_, offset_, offset, ColumnUnit::code_points);
        offset_ = offset;
        return position_;
    }

    const SyntaxTree::Slot* slot_ = nullptr;
    std::uint32_t offset_ = 0; // in the unit, as is line_
    std::uint32_t line_ = 0;
    Position position_;
    Position unit_begin_;
    std::vector<Position> begins_;
    std::vector<Position> ends_;
};

void append_position(std::string& out, Position position) {
    append_number(out, position.line);
    out += ':';
    append_number(out, position.column);
}

void append_positions(std::string& out, Position begin, Position end) {
    out += ' ';
    append_position(out, begin);
    if (end == begin)
        return;
    out += '-';
    append_position(out, end);
}

void append_indentation(std::string& out, std::uint32_t level) {
    out.append(2 * std::min(level, deepest_indentation), ' ');
    if (level <= deepest_indentation)
        return;
    append_number(out, level);
    out += ": ";
}

// A node that is still to be written, with the name of the member that it is.
struct TreeLine {
    const Node* node;
    std::string_view name; // empty when it goes without saying
    std::uint32_t level;
};

template<class Struct>
void add_lines(std::vector<TreeLine>& pending, const Struct& parent, std::uint32_t level) {
    const std::size_t first = pending.size();
    ast::for_each_member(parent, [&](std::string_view name, const auto& value) {
        using Member = std::remove_cvref_t<decltype(value)>;
        const std::string_view shown = 1 < node_member_count<Struct> ? name : "";
        if constexpr (ast::is_child_member<Member>) {
            if (value != nullptr)
                pending.push_back({value, shown, level});
        } else if constexpr (ast::is_list_member<Member>) {
            for (const Node* node : value)
                pending.push_back({node, shown, level});
        }
    });
    std::reverse(pending.begin() + static_cast<std::ptrdiff_t>(first), pending.end());
}

void append_line(std::string& out, const Unit& unit, const TreeLine& line,
                 const TokenPositions& positions) {
    append_indentation(out, line.level);
    if (!line.name.empty())
        out.append(line.name).append(": ");
    ast::dispatch(*line.node, [&](const auto& typed) { append_head(out, unit, typed); });
    append_positions(out, positions.begin(*line.node), positions.end(*line.node));
    out += '\n';
}

// ---- dump_json ---------------------------------------------------------------------------------

template<class Scalar>
void append_json_scalar(std::string& out, std::string_view name, Scalar value) {
    if constexpr (std::is_same_v<Scalar, bool>)
        out.append(", \"").append(name).append(value ? "\": true" : "\": false");
    else if constexpr (std::is_enum_v<Scalar>)
        out.append(", \"").append(name).append("\": \"").append(to_string(value)).append("\"");
}

// Scalars at once, children as pieces: all scalars of a struct stand before its nodes.
template<class Struct>
void append_json_members(std::string& out, const Struct& node, std::vector<Piece>& pieces) {
    ast::for_each_member(node, [&](std::string_view name, const auto& value) {
        using Member = std::remove_cvref_t<decltype(value)>;
        if constexpr (!holds_nodes<Member>)
            return append_json_scalar(out, name, value);
        pieces.insert(pieces.end(), {{", \""}, {name}, {"\": "}});
        if constexpr (ast::is_list_member<Member>)
            add_list(pieces, value, ", ");
        else if constexpr (ast::is_child_member<Member>)
            pieces.push_back(value != nullptr ? Piece{{}, value} : Piece{"null"});
    });
}

template<class Struct>
void append_json_node(std::string& out, const SyntaxTree::Slot& slot, const Struct& node,
                      std::vector<Piece>& pieces) {
    const TextRange range = slot.unit->range(node).shifted(slot.offset);
    out.append("{\"kind\": \"").append(to_string(node.kind)).append("\", \"offset\": ");
    append_number(out, range.begin);
    out += ", \"endOffset\": ";
    append_number(out, range.end);
    if (node.missing)
        out += ", \"missing\": true";
    append_json_members(out, node, pieces);
    if (node_member_count<Struct> == 0) {
        out += ", \"text\": ";
        append_json_string(out, slot.unit->text(node), slot.unit->encoding());
    }
    pieces.push_back({"}"});
}

} // namespace

std::string s_expression(const Unit& unit, const ast::Node& node) {
    std::string out;
    write_nested(out, node, [&](const Node& inner, std::vector<Piece>& pieces) {
        write_s_expression(out, unit, inner, pieces);
    });
    return out;
}

std::string dump_tree(const SyntaxTree& tree) {
    std::string out;
    TokenPositions positions;
    std::vector<TreeLine> pending;
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        positions.enter(slot);
        pending.push_back({&slot.unit->root(), {}, 0});
        while (!pending.empty()) {
            const TreeLine line = pending.back();
            pending.pop_back();
            append_line(out, *slot.unit, line, positions);
            ast::dispatch(*line.node,
                          [&](const auto& typed) { add_lines(pending, typed, line.level + 1); });
        }
    }
    return out;
}

std::string dump_json(const SyntaxTree& tree) {
    std::string out = "{\"file\": ";
    append_json_string(out, tree.name());
    out += ", \"units\": [\n";
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        if (&slot != &tree.slots().front())
            out += ",\n";
        write_nested(out, slot.unit->root(), [&](const Node& node, std::vector<Piece>& pieces) {
            ast::dispatch(node,
                          [&](const auto& typed) { append_json_node(out, slot, typed, pieces); });
        });
    }
    out += "\n]}\n";
    return out;
}

} // namespace iecfront
