#include "support/tree_faults.hpp"

#include "support/json.hpp"

#include <iecfront/ast/dump.hpp>
#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/visitor.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/diagnostics/render_text.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace iecfront::test {
namespace {

using ast::Node;
using ast::NodeKind;

[[nodiscard]] std::string in_words(TextRange range) {
    return std::to_string(range.begin) + ".." + std::to_string(range.end);
}

[[nodiscard]] bool inside(TextRange range, std::size_t size) {
    return range.begin <= range.end && range.end <= size;
}

// ---- units, tokens, trivia
// -----------------------------------------------------------------------

[[nodiscard]] std::string tiling_fault(const SyntaxTree& tree, std::string_view text) {
    if (tree.size() != text.size())
        return "the tree has another size than the text";
    if (tree.slots().empty())
        return "there is no unit";
    std::uint32_t offset = 0;
    std::uint32_t line = 0;
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        if (slot.offset != offset || slot.first_line != line)
            return "a unit does not begin where the one before it ends, at " +
                   std::to_string(offset);
        if (text.substr(offset, slot.unit->text().size()) != slot.unit->text())
            return "the unit at " + std::to_string(offset) + " has another text";
        if (slot.unit->encoding() != tree.encoding())
            return "the unit at " + std::to_string(offset) + " has another encoding";
        offset += static_cast<std::uint32_t>(slot.unit->text().size());
        line += slot.unit->lines().line_end_count();
    }
    if (offset != text.size())
        return "the units do not reach the end of the text";
    return tree.source().bytes() == text ? "" : "source() gives another text";
}

[[nodiscard]] bool is_white_space(std::string_view gap, bool at_file_start, Encoding encoding) {
    if (at_file_start)
        gap.remove_prefix(byte_order_mark_size(gap, encoding));
    return gap.find_first_not_of(" \t\v\f\r\n") == std::string_view::npos;
}

/// Tokens and trivia in one row, by position.
[[nodiscard]] std::vector<TextRange> elements_of(const Unit& unit) {
    std::vector<TextRange> ranges;
    ranges.reserve(unit.tokens().size() + unit.trivia().size());
    for (const Token token : unit.tokens())
        ranges.push_back(token.range());
    for (const Trivia& trivia : unit.trivia())
        ranges.push_back(trivia.range);
    std::stable_sort(ranges.begin(), ranges.end(),
                     [](TextRange a, TextRange b) { return a.begin < b.begin; });
    return ranges;
}

template<class Items, class Range>
[[nodiscard]] bool in_order(const Items& items, Range range) {
    return std::is_sorted(items.begin(), items.end(), [&](const auto& a, const auto& b) {
        return range(a).begin < range(b).begin;
    });
}

[[nodiscard]] std::string element_fault(const Unit& unit, bool first) {
    if (!in_order(unit.tokens(), [](Token token) { return token.range(); }) ||
        !in_order(unit.trivia(), [](const Trivia& trivia) { return trivia.range; }))
        return "tokens or trivia are not in order";
    std::uint32_t end = 0;
    for (const TextRange range : elements_of(unit)) {
        if (range.empty() || !inside(range, unit.text().size()) || range.begin < end)
            return "a token or comment is empty, outside or overlaps: " + in_words(range);
        if (!is_white_space(unit.text({end, range.begin}), first && end == 0, unit.encoding()))
            return "bytes are lost before " + in_words(range);
        end = range.end;
    }
    const TextRange rest{end, static_cast<std::uint32_t>(unit.text().size())};
    return is_white_space(unit.text(rest), first && end == 0, unit.encoding())
               ? ""
               : "bytes are lost in " + in_words(rest);
}

// ---- nodes
// ---------------------------------------------------------------------------------------

/// A member that the grammar says is optional.
struct OptionalMember {
    NodeKind kind;
    std::string_view name;
};

// As the structs document it.
constexpr std::array optional_members = {
    OptionalMember{NodeKind::type_declaration, "initial_value"},
    OptionalMember{NodeKind::enumerated_specification, "base"},
    OptionalMember{NodeKind::enumerated_specification, "base_behind"},
    OptionalMember{NodeKind::enumerated_specification, "base_behind"},
    OptionalMember{NodeKind::enumerated_value_declaration, "value"},
    OptionalMember{NodeKind::structure_element_declaration, "initial_value"},
    OptionalMember{NodeKind::variable_declaration, "location"},
    OptionalMember{NodeKind::variable_declaration, "initial_value"},
    OptionalMember{NodeKind::instance_specific_init, "location"},
    OptionalMember{NodeKind::instance_specific_init, "initial_value"},
    OptionalMember{NodeKind::input_argument, "name"},
    OptionalMember{NodeKind::if_statement, "else_list"},
    OptionalMember{NodeKind::case_statement, "else_list"},
    OptionalMember{NodeKind::for_statement, "by"},
    OptionalMember{NodeKind::action_association, "qualifier"},
    OptionalMember{NodeKind::action_qualifier, "time"},
    OptionalMember{NodeKind::transition, "name"},
    OptionalMember{NodeKind::transition, "priority"},
    OptionalMember{NodeKind::program_configuration, "task"},
    OptionalMember{NodeKind::il_instruction, "label"},
    OptionalMember{NodeKind::il_instruction, "operation"},
    OptionalMember{NodeKind::il_simple_operation, "function_name"},
    OptionalMember{NodeKind::il_expression, "operand"},
};

[[nodiscard]] bool is_optional(NodeKind kind, std::string_view member) {
    return std::any_of(
        optional_members.begin(), optional_members.end(),
        [&](const OptionalMember& one) { return one.kind == kind && one.name == member; });
}

/// Checks each node against its parent and its neighbours.
class NodeChecker {
public:
    explicit NodeChecker(const Unit& unit) : unit_(unit) {}

    [[nodiscard]] std::string check() {
        const Node& root = unit_.root();
        if (root.first_token != 0 || root.end_token != unit_.tokens().size())
            complain(root, "does not cover its unit");
        ast::walk(root, [&](const Node& node) {
            check(node);
            return fault_.empty() ? ast::Walk::into : ast::Walk::stop;
        });
        return fault_;
    }

private:
    void complain(const Node& node, std::string_view what) {
        if (fault_.empty())
            fault_ = std::string(to_string(node.kind)) + " of tokens " +
                     in_words({node.first_token, node.end_token}) + ' ' + std::string(what);
    }

    [[nodiscard]] static bool stands_for_a_fault(ast::NodeKind kind) {
        return to_string(kind).find("error_") != std::string_view::npos ||
               kind == ast::NodeKind::skipped_text;
    }

    void check(const Node& node) {
        if (node.end_token < node.first_token || node.end_token > unit_.tokens().size())
            complain(node, "has no good tokens");
        if (node.missing && node.first_token != node.end_token)
            complain(node, "is missing and has tokens");
        if ((node.missing || stands_for_a_fault(node.kind)) && unit_.diagnostics().empty())
            complain(node, "is not reported");
        if (const auto* constant = ast::as<ast::Constant>(&node))
            if (constant->literal_token < node.first_token ||
                constant->literal_token >= node.end_token)
                complain(node, "has its literal outside");
        next_ = node.first_token;
        ast::for_each_member(node, [&](std::string_view name, const auto& member) {
            check_member(node, name, member);
        });
    }

    template<class Member>
    void check_member(const Node& node, std::string_view name, const Member& member) {
        if constexpr (ast::is_child_member<Member>) {
            if (member != nullptr)
                check_child(node, name, *member);
            else if (!is_optional(node.kind, name))
                complain(node, "has no " + std::string(name));
        } else if constexpr (ast::is_list_member<Member>) {
            for (const auto* child : member) {
                if (child == nullptr)
                    complain(node, "has a hole in " + std::string(name));
                else
                    check_child(node, name, *child);
            }
        }
    }

    template<class Child>
    void check_child(const Node& node, std::string_view name, const Child& child) {
        if (!ast::is<Child>(child.kind))
            complain(node, "has a wrong kind of node as " + std::string(name));
        if (child.first_token < next_ || child.end_token > node.end_token)
            complain(node, "does not hold in order its " + std::string(name) + ", tokens " +
                               in_words({child.first_token, child.end_token}));
        next_ = child.end_token;
    }

    const Unit& unit_;
    std::uint32_t next_ = 0; // token from which the next child may begin
    std::string fault_;
};

/// What `Unit::nodes` gives has to be what a walk comes to.
[[nodiscard]] std::string stored_nodes_fault(const Unit& unit) {
    std::vector<const Node*> walked;
    ast::walk(unit.root(), [&](const Node& node) {
        walked.push_back(&node);
        return ast::Walk::into;
    });
    std::ranges::sort(walked);
    auto expected = walked.begin();
    for (const Node& stored : unit.nodes()) {
        if (expected == walked.end() || *expected != &stored)
            return "a node that is stored is not in the tree, or not the next one in memory: " +
                   std::string(to_string(stored.kind)) + " of tokens " +
                   in_words({stored.first_token, stored.end_token});
        ++expected;
    }
    return expected == walked.end() ? "" : "not all nodes are stored";
}

// ---- diagnostics
// ---------------------------------------------------------------------------------

[[nodiscard]] std::string edits_fault(std::span<const TextEdit> edits, std::size_t size) {
    std::uint32_t end = 0;
    for (const TextEdit& edit : edits) {
        if (!inside(edit.range, size) || edit.range.begin < end)
            return "has an edit at " + in_words(edit.range);
        if (edit.range.empty() && edit.replacement.empty())
            return "has an edit that does nothing";
        end = edit.range.end;
    }
    return edits.empty() ? "has a fix without edits" : "";
}

[[nodiscard]] std::string diagnostic_fault(const Diagnostic& diagnostic, std::size_t size) {
    if (!inside(diagnostic.range, size))
        return "stands at " + in_words(diagnostic.range);
    for (const DiagnosticLabel& label : diagnostic.labels)
        if (!inside(label.range, size))
            return "has a label at " + in_words(label.range);
    for (const DiagnosticFix& fix : diagnostic.fixes)
        if (std::string fault = edits_fault(fix.edits, size); !fault.empty())
            return fault;
    return "";
}

[[nodiscard]] std::string diagnostics_fault(std::span<const Diagnostic> diagnostics,
                                            std::size_t size) {
    if (!in_order(diagnostics, [](const Diagnostic& diagnostic) { return diagnostic.range; }))
        return "the diagnostics are not in order";
    for (const Diagnostic& diagnostic : diagnostics)
        if (const std::string fault = diagnostic_fault(diagnostic, size); !fault.empty())
            return code_string(diagnostic.id) + ' ' + fault;
    return "";
}

// ---- output
// --------------------------------------------------------------------------------------

[[nodiscard]] std::string message_fault(const SyntaxTree& tree) {
    const SourceText source = tree.source();
    const LineTable lines(source.bytes());
    for (const Diagnostic& diagnostic : tree.diagnostics()) {
        std::string json;
        render_json(json, diagnostic, Severity::error, source, lines);
        std::string text;
        render_text(text, diagnostic, Severity::error, source, lines);
        if (!read_json(json) || text.empty() || message(diagnostic, tree.encoding()).empty())
            return code_string(diagnostic.id) + " cannot be rendered";
        for (const DiagnosticFix& fix : diagnostic.fixes)
            if (description(fix, source.bytes(), tree.encoding()).empty())
                return "a fix of " + code_string(diagnostic.id) + " has no words";
    }
    return "";
}

[[nodiscard]] std::string place_fault(const SyntaxTree& tree, std::uint32_t offset) {
    const Position position = tree.position(offset);
    if (tree.offset(position) != offset)
        return "the position of offset " + std::to_string(offset) + " leads elsewhere";
    const SyntaxTree::Path path = tree.node_at(offset);
    for (const Node* node : path.nodes)
        if (node != path.nodes.front() && !path.slot->range(*node).contains(offset))
            return "node_at(" + std::to_string(offset) + ") gives what is elsewhere";
    return "";
}

[[nodiscard]] std::string places_fault(const SyntaxTree& tree) {
    constexpr std::size_t enough = 200; // places; a large text is looked at here and there
    const std::size_t step = tree.size() / enough + 1;
    std::uint32_t next = 0;
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        for (const Token token : slot.unit->tokens()) {
            const std::uint32_t offset = slot.offset + token.offset();
            if (offset < next)
                continue;
            next = offset + static_cast<std::uint32_t>(step);
            if (std::string fault = place_fault(tree, offset); !fault.empty())
                return fault;
        }
    }
    return "";
}

[[nodiscard]] bool is_balanced(std::string_view s_expression) {
    std::string open;
    bool in_string = false;
    for (std::size_t i = 0; i < s_expression.size(); ++i) {
        const char c = s_expression[i];
        if (c == '"')
            in_string = !in_string;
        else if (in_string)
            i += c == '\\' ? 1 : 0;
        else if (c == '(' || c == '[')
            open += c == '(' ? ')' : ']';
        else if ((c == ')' || c == ']') && (open.empty() || open.back() != c))
            return false;
        else if (c == ')' || c == ']')
            open.pop_back();
    }
    return open.empty() && !in_string;
}

/// Calls the checks one by one and gives the first fault that one of them finds.
template<class... Checks>
[[nodiscard]] std::string first_fault(Checks... checks) {
    std::string fault;
    ((fault.empty() ? void(fault = checks()) : void()), ...);
    return fault;
}

} // namespace

std::string tree_fault(const SyntaxTree& tree, std::string_view text) {
    std::string fault = tiling_fault(tree, text);
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        const Unit& unit = *slot.unit;
        if (fault.empty())
            fault = first_fault(
                [&] { return element_fault(unit, slot.offset == 0); },
                [&] { return stored_nodes_fault(unit); }, [&] { return NodeChecker(unit).check(); },
                [&] { return diagnostics_fault(unit.diagnostics(), unit.text().size()); });
    }
    return fault.empty() ? diagnostics_fault(tree.diagnostics(), text.size()) : fault;
}

std::string output_fault(const SyntaxTree& tree) {
    return first_fault([&] { return read_json(dump_json(tree)) ? "" : "dump_json gives no JSON"; },
                       [&] { return dump_tree(tree).empty() ? "dump_tree gives nothing" : ""; },
                       [&] {
                           for (const SyntaxTree::Slot& slot : tree.slots())
                               if (!is_balanced(s_expression(*slot.unit, slot.unit->root())))
                                   return "an S-expression is not balanced";
                           return "";
                       },
                       [&] { return message_fault(tree); }, [&] { return places_fault(tree); });
}

} // namespace iecfront::test
