#include "format/line_end.hpp"

#include <algorithm>
#include <cstddef>

namespace iecfront::layout {
namespace {

// The first line end behind `at` that no comment holds; the end of text when there is none.
[[nodiscard]] std::size_t find_line_end(const Unit& unit, std::size_t at) {
    const std::string_view text = unit.text();
    at = text.find_first_of("\r\n", at);
    for (const Trivia& trivia : unit.trivia())
        if (at != std::string_view::npos && trivia.range.begin <= at && at < trivia.range.end)
            at = text.find_first_of("\r\n", trivia.range.end);
    return at;
}

[[nodiscard]] std::size_t begin_of_contents(const Unit& unit) {
    std::size_t begin = unit.text().size();
    if (!unit.tokens().empty())
        begin = unit.tokens().front().offset();
    if (!unit.trivia().empty())
        begin = std::min<std::size_t>(begin, unit.trivia().front().range.begin);
    return begin;
}

// What the first line in a comment ends in; LF when there is none.
[[nodiscard]] std::string_view line_end_in_comments(const SyntaxTree& tree) {
    for (const SyntaxTree::Slot& slot : tree.slots())
        for (const Trivia& trivia : slot.unit->trivia()) {
            const std::string_view text = slot.unit->text(trivia.range);
            const std::size_t found = text.find_first_of("\r\n");
            if (found != std::string_view::npos)
                return line_end_at(text, found);
        }
    return "\n";
}

} // namespace

std::string_view line_end_at(std::string_view text, std::size_t at) noexcept {
    if (text[at] == '\n')
        return "\n";
    return at + 1 < text.size() && text[at + 1] == '\n' ? "\r\n" : "\r";
}

std::string_view line_end_of(const SyntaxTree& tree) {
    std::size_t begin = begin_of_contents(*tree.slots().front().unit);
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        const std::size_t found = find_line_end(*slot.unit, begin);
        if (found != std::string_view::npos)
            return line_end_at(slot.unit->text(), found);
        begin = 0;
    }
    return line_end_in_comments(tree);
}

} // namespace iecfront::layout
