#include "format/format_faults.hpp"

#include <iecfront/ast/nodes.hpp>
#include <iecfront/lexer/literals.hpp>
#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <vector>

namespace iecfront::test {
namespace {

struct Word {
    TokenKind kind;
    std::string_view text;
};

[[nodiscard]] std::vector<Word> words_of(const SyntaxTree& tree) {
    std::vector<Word> words;
    for (const SyntaxTree::Slot& slot : tree.slots())
        for (const Token token : slot.unit->tokens())
            words.push_back({token.kind(), slot.unit->text(token)});
    return words;
}

[[nodiscard]] std::vector<std::string_view> comments_of(const SyntaxTree& tree) {
    std::vector<std::string_view> comments;
    for (const SyntaxTree::Slot& slot : tree.slots())
        for (const Trivia& trivia : slot.unit->trivia())
            comments.push_back(slot.unit->text(trivia.range));
    return comments;
}

// The further lines of a comment may have moved, and end as others do.
[[nodiscard]] std::vector<std::string> lines_of_comment(std::string_view comment) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin <= comment.size();) {
        const std::size_t end = std::min(comment.find_first_of("\r\n", begin), comment.size());
        const std::string_view line = comment.substr(begin, end - begin);
        const std::size_t text = lines.empty() ? 0 : line.find_first_not_of(" \t");
        lines.emplace_back(text < line.size() ? line.substr(text) : std::string_view());
        begin = end + (comment.substr(end).starts_with("\r\n") ? 2 : 1);
    }
    return lines;
}

[[nodiscard]] bool same_comment(std::string_view before, std::string_view after) {
    return lines_of_comment(before) == lines_of_comment(after);
}

[[nodiscard]] bool has_syntax_fault(const SyntaxTree& tree) {
    return std::ranges::any_of(tree.diagnostics(), [](const Diagnostic& diagnostic) {
        const DiagnosticClass category = diagnostic_info(diagnostic.id).category;
        return category != DiagnosticClass::extension &&
               category != DiagnosticClass::implementation_dependent;
    });
}

// Keywords and the operators of IL may have become upper case, and nothing else.
[[nodiscard]] bool same_word(const Word& before, const Word& after) {
    if (before.kind != after.kind)
        return false;
    if (before.text == after.text)
        return true;
    const bool is_word = is_keyword(before.kind) || before.kind == TokenKind::identifier;
    return is_word && after.text == folded(before.text);
}

[[nodiscard]] bool equal_trees(const SyntaxTree& a, const SyntaxTree& b) {
    return std::ranges::equal(a.slots(), b.slots(),
                              [](const SyntaxTree::Slot& one, const SyntaxTree::Slot& other) {
                                  return ast::equal(one.unit->root(), other.unit->root());
                              });
}

[[nodiscard]] bool same_value(const Word& a, const Word& b, Encoding encoding) {
    if (a.kind != b.kind)
        return false;
    const auto one = string_value(a.text, encoding);
    const auto other = string_value(b.text, encoding);
    if (!one || !other)
        return names_equal(a.text, b.text);
    return one->double_byte == other->double_byte &&
           std::ranges::equal(one->elements, other->elements, {}, &StringElement::code,
                              &StringElement::code);
}

[[nodiscard]] bool is_blank_at_line_end(std::string_view text) {
    return text.find(" \n") != std::string_view::npos;
}

} // namespace

std::string format_fault(const SourceText& source, const ParseOptions& options,
                         const FormatOptions& layout) {
    const SyntaxTree tree = parse(source, options);
    const std::string text = format(tree, layout);
    const SyntaxTree again = parse(SourceText(text, {}, source.encoding()), options);
    if (!std::ranges::equal(words_of(tree), words_of(again), same_word))
        return "other tokens in\n" + text;
    if (!std::ranges::equal(comments_of(tree), comments_of(again), same_comment))
        return "other comments in\n" + text;
    if (again.diagnostics().size() > tree.diagnostics().size())
        return "more faults in\n" + text;
    if (!has_syntax_fault(tree) && !equal_trees(tree, again))
        return "another tree of\n" + text;
    if (const std::string twice = format(again, layout); twice != text)
        return "formatted\n" + text + "\nand twice\n" + twice;
    if (!has_syntax_fault(tree) && comments_of(tree).empty() && is_blank_at_line_end(text))
        return "blanks at the end of lines in\n" + text;
    return {};
}

std::string write_fault(const SourceText& source, const ParseOptions& options,
                        const WriteOptions& writing) {
    const SyntaxTree tree = parse(source, options);
    const WrittenText written = write(tree, writing);
    const SyntaxTree again = parse(SourceText(written.text, {}, source.encoding()), options);
    const auto same = [&](const Word& a, const Word& b) {
        return same_value(a, b, source.encoding());
    };
    if (!std::ranges::equal(words_of(tree), words_of(again), same))
        return "other tokens in\n" + written.text;
    if (!has_syntax_fault(tree) && !equal_trees(tree, again))
        return "another tree of\n" + written.text;
    const bool iso_646 = std::ranges::all_of(
        written.text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    if (written.beyond_iso_646.empty() && !iso_646)
        return "characters beyond ISO 646 in\n" + written.text;
    for (const TextRange place : written.beyond_iso_646)
        if (place.end > tree.size() ||
            std::ranges::all_of(source.bytes().substr(place.begin, place.size()),
                                [](char c) { return static_cast<unsigned char>(c) < 0x80; }))
            return "a place that has no such character";
    return {};
}

} // namespace iecfront::test
