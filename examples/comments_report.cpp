// Prints the comments and pragmas of a file: their share of it, and what each of them is about.
#include "read_source.hpp"

#include <algorithm>

namespace ast = iecfront::ast;

namespace {

using Slot = iecfront::SyntaxTree::Slot;

// The outermost part of the unit that begins with this token: of a whole declaration and its name,
// which begin together, the declaration. Null when nothing does, as at END_VAR.
const ast::Node* begins_with(const iecfront::SyntaxTree& tree, const Slot& slot,
                             iecfront::Token token) {
    for (const ast::Node* node : tree.node_at(slot.offset + token.offset()).nodes)
        if (!ast::is<ast::LibraryUnit>(node->kind) && !ast::is<ast::Body>(node->kind) &&
            slot.unit->range(*node).begin == token.offset())
            return node;
    return nullptr;
}

// `variable_declaration Main`: the kind of node, and the first name that stands directly in it.
std::string described(const Slot& slot, const ast::Node& node) {
    std::string words(to_string(node.kind));
    const ast::Identifier* name = nullptr;
    ast::for_each_child(node, [&](const ast::Node& child) {
        if (name == nullptr)
            name = ast::as<ast::Identifier>(&child);
    });
    return name == nullptr ? words : words + " " + std::string(slot.unit->text(*name));
}

// What a comment stands before, or, behind something on the same line, what it stands beside.
std::string subject(const iecfront::SyntaxTree& tree, const Slot& slot, iecfront::Trivia comment) {
    const auto tokens = slot.unit->tokens();
    auto token = std::find_if(tokens.begin(), tokens.end(), [&](iecfront::Token candidate) {
        return candidate.offset() >= comment.range.end;
    });
    const iecfront::LineTable& lines = slot.unit->lines();
    const bool beside = token != tokens.begin() &&
                        lines.line_of((token - 1)->offset()) == lines.line_of(comment.range.begin);
    if (beside) {
        do
            --token;
        while (!token->first_on_line() && token != tokens.begin());
    }
    if (token == tokens.end())
        return "before the end of the file";
    const ast::Node* node = begins_with(tree, slot, *token);
    return (beside ? "beside " : "before ") +
           (node != nullptr ? described(slot, *node) : std::string(slot.unit->text(*token)));
}

void print_comments(const iecfront::SyntaxTree& tree, const Slot& slot) {
    for (const iecfront::Trivia comment : slot.unit->trivia()) {
        const iecfront::Position place = tree.position(slot.offset + comment.range.begin);
        std::printf("%4u:%-3u %-8s %5u bytes %s\n", place.line, place.column,
                    to_string(comment.kind).data(), comment.range.size(),
                    subject(tree, slot, comment).c_str());
    }
}

std::uint32_t bytes_in(const iecfront::SyntaxTree& tree, bool pragmas) {
    std::uint32_t bytes = 0;
    for (const Slot& slot : tree.slots())
        for (const iecfront::Trivia comment : slot.unit->trivia())
            if ((comment.kind == iecfront::TriviaKind::pragma) == pragmas)
                bytes += comment.range.size();
    return bytes;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: comments_report FILE\n", stderr);
        return 2;
    }
    const std::optional<iecfront::SourceText> source = read_source(argv[1]);
    if (!source)
        return 2;
    const iecfront::SyntaxTree tree = iecfront::parse(*source);
    for (const Slot& slot : tree.slots())
        print_comments(tree, slot);
    const double percent = tree.size() == 0 ? 0.0 : 100.0 / tree.size();
    std::printf("%u bytes: %.1f %% in comments, %.1f %% in pragmas\n", tree.size(),
                percent * bytes_in(tree, false), percent * bytes_in(tree, true));
}
