#include <iecfront/ast/editor_ranges.hpp>
#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/visitor.hpp>

#include <algorithm>
#include <map>
#include <optional>

namespace iecfront {
namespace {

[[nodiscard]] bool can_be_folded(ast::NodeKind kind) noexcept {
    switch (kind) {
    case ast::NodeKind::structure_declaration:
    case ast::NodeKind::enumerated_specification:
    case ast::NodeKind::if_statement:
    case ast::NodeKind::elsif_clause:
    case ast::NodeKind::case_statement:
    case ast::NodeKind::case_element:
    case ast::NodeKind::for_statement:
    case ast::NodeKind::while_statement:
    case ast::NodeKind::repeat_statement:
    case ast::NodeKind::fb_invocation:
    case ast::NodeKind::function_call:
    case ast::NodeKind::array_initialization:
    case ast::NodeKind::structure_initialization:
    case ast::NodeKind::step:
    case ast::NodeKind::transition:
    case ast::NodeKind::action:
    case ast::NodeKind::resource_declaration:
    case ast::NodeKind::program_configuration:
    case ast::NodeKind::il_expression:
    case ast::NodeKind::il_fb_call:
    case ast::NodeKind::il_formal_funct_call: return true;
    default: return ast::is<ast::LibraryElement>(kind);
    }
}

/// What stands behind ELSE; null when `node` has no such branch.
[[nodiscard]] const ast::StatementList* else_list_of(const ast::Node& node) noexcept {
    if (const auto* choice = ast::as<ast::IfStatement>(&node))
        return choice->else_list;
    if (const auto* choice = ast::as<ast::CaseStatement>(&node))
        return choice->else_list;
    return nullptr;
}

/// By its first line, the longest range that begins there.
class FoldingCollector {
public:
    explicit FoldingCollector(const SyntaxTree& tree) {
        for (const SyntaxTree::Slot& slot : tree.slots()) {
            slot_ = &slot;
            add_nodes();
            add_comments();
        }
    }

    [[nodiscard]] std::vector<FoldingRange> ranges() const {
        std::vector<FoldingRange> result;
        for (const auto& [first_line, range] : by_line_)
            result.push_back(range);
        return result;
    }

private:
    [[nodiscard]] std::uint32_t line_of(std::uint32_t offset) const {
        return slot_->first_line + slot_->unit->lines().line_of(offset) + 1;
    }

    void add(std::uint32_t first_line, std::uint32_t last_line, FoldingKind kind) {
        if (first_line >= last_line)
            return;
        FoldingRange& range = by_line_[first_line];
        if (last_line > range.last_line)
            range = {first_line, last_line, kind};
    }

    void add_nodes() {
        ast::walk(slot_->unit->root(), [&](const ast::Node& node) {
            if (can_be_folded(node.kind))
                add_code(node.first_token, node.end_token);
            const ast::StatementList* branch = else_list_of(node);
            if (branch != nullptr && branch->first_token != branch->end_token)
                add_code(branch->first_token - 1, branch->end_token);
            return ast::Walk::into;
        });
    }

    // The last line stays when something else goes on there: it must not be hidden.
    void add_code(std::uint32_t first, std::uint32_t end) {
        if (first == end)
            return;
        static constexpr auto separates = [](Token token) {
            return token.kind() == TokenKind::semicolon || token.kind() == TokenKind::comma;
        };
        const std::span<const Token> tokens = slot_->unit->tokens();
        const std::uint32_t last_line = line_of(tokens[end - 1].end() - 1);
        const std::uint32_t next = end < tokens.size() && separates(tokens[end]) ? end + 1 : end;
        const bool goes_on = next < tokens.size() && line_of(tokens[next].offset()) == last_line;
        add(line_of(tokens[first].offset()), goes_on ? last_line - 1 : last_line,
            FoldingKind::code);
    }

    // Comments that are alone on their lines, each on the line below the one before it, are folded
    // as one; any other by itself, up to the line where code goes on.
    void add_comments() {
        const std::vector<bool> code = lines_with_code();
        std::uint32_t first_line = 0; // none yet
        std::uint32_t last_line = 0;
        for (const Trivia& trivia : slot_->unit->trivia()) {
            if (trivia.kind == TriviaKind::pragma || trivia.range.empty())
                continue;
            const std::uint32_t begin = line_of(trivia.range.begin);
            const std::uint32_t end = line_of(trivia.range.end - 1);
            const bool alone = !code[begin - slot_->first_line] && !code[end - slot_->first_line];
            if (!alone || first_line == 0 || begin > last_line + 1) {
                add(first_line, last_line, FoldingKind::comment);
                first_line = begin;
            }
            last_line = end;
            if (!alone) {
                add(begin, code[end - slot_->first_line] ? end - 1 : end, FoldingKind::comment);
                first_line = last_line = 0;
            }
        }
        add(first_line, last_line, FoldingKind::comment);
    }

    // Where tokens and pragmas begin and end; 1-based, counted in the unit.
    [[nodiscard]] std::vector<bool> lines_with_code() const {
        const LineTable& lines = slot_->unit->lines();
        std::vector<bool> code(std::size_t{lines.line_end_count()} + 2);
        const auto mark = [&](TextRange range) {
            code[lines.line_of(range.begin) + 1] = true;
            code[lines.line_of(range.end - 1) + 1] = true;
        };
        for (const Token token : slot_->unit->tokens())
            mark(token.range());
        for (const Trivia& trivia : slot_->unit->trivia())
            if (trivia.kind == TriviaKind::pragma)
                mark(trivia.range);
        return code;
    }

    const SyntaxTree::Slot* slot_ = nullptr;
    std::map<std::uint32_t, FoldingRange> by_line_;
};

/// What stands at a byte of the file, ordered by how near it is to a caret beside it.
enum class Nearness : std::uint8_t { nothing, delimiter, word };

/// The comment or pragma, or else the token, that holds a byte of the file.
struct Element {
    TextRange range;
    Nearness nearness = Nearness::nothing;
};

[[nodiscard]] Element element_at(const SyntaxTree& tree, std::uint32_t offset) {
    if (const std::optional<SyntaxTree::TokenPlace> place = tree.token_at(offset))
        return {place->range(),
                is_delimiter(place->token().kind()) ? Nearness::delimiter : Nearness::word};
    const SyntaxTree::Slot& slot = tree.slot_at(offset);
    for (const Trivia& trivia : slot.unit->trivia())
        if (trivia.range.contains(offset - slot.offset))
            return {trivia.range.shifted(slot.offset), Nearness::delimiter};
    return {{offset, offset}, Nearness::nothing};
}

/// The byte that a caret before the one at `offset` is meant to be at: the end of a word counts for
/// more than what begins behind it, unless that is a word as well.
[[nodiscard]] std::uint32_t byte_at_caret(const SyntaxTree& tree, std::uint32_t offset) {
    const bool before =
        offset > 0 && element_at(tree, offset - 1).nearness > element_at(tree, offset).nearness;
    return before ? offset - 1 : offset;
}

} // namespace

std::vector<FoldingRange> folding_ranges(const SyntaxTree& tree) {
    return FoldingCollector(tree).ranges();
}

std::vector<TextRange> selection_ranges(const SyntaxTree& tree, std::uint32_t offset) {
    offset = byte_at_caret(tree, offset);
    const SyntaxTree::Path path = tree.node_at(offset);
    const SyntaxTree::Slot& slot = *path.slot;
    const auto unit_size = static_cast<std::uint32_t>(slot.unit->text().size());
    std::vector<TextRange> ranges;
    const auto add = [&](TextRange range) {
        if (ranges.empty() ? !range.empty()
                           : range.contains(ranges.back()) && range != ranges.back())
            ranges.push_back(range);
    };
    add(element_at(tree, offset).range);
    for (auto node = path.nodes.rbegin(); node != path.nodes.rend(); ++node)
        if (slot.range(**node).contains(offset))
            add(slot.range(**node));
    add({slot.offset, slot.offset + unit_size});
    add({0, tree.size()});
    return ranges;
}

} // namespace iecfront
