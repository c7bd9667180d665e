#include "lexer/comment_marks.hpp"

namespace iecfront {

void CommentMarks::build(std::string_view text, std::uint32_t begin) {
    built_ = true;
    std::vector<std::uint32_t> closing_ends; // of the marks not yet paired, the nearest one last
    for (std::size_t i = text.size(); i-- > begin;) {
        const bool star_next = i + 1 < text.size() && text[i + 1] == '*';
        const bool parenthesis_next = i + 1 < text.size() && text[i + 1] == ')';
        if (text[i] == '(' && star_next) {
            if (closing_ends.empty())
                continue;
            pairs_.push_back({static_cast<std::uint32_t>(i), closing_ends.back()});
            // `(*)` inside a comment opens and closes; only where a comment begins it is open.
            if (i + 2 >= text.size() || text[i + 2] != ')')
                closing_ends.pop_back();
        } else if (text[i] == '*' && parenthesis_next && (i == begin || text[i - 1] != '(')) {
            closing_ends.push_back(static_cast<std::uint32_t>(i + 2));
        }
    }
}

std::optional<std::uint32_t> CommentMarks::balanced_end(std::uint32_t opening) noexcept {
    while (!pairs_.empty() && pairs_.back().opening < opening)
        pairs_.pop_back();
    if (pairs_.empty() || pairs_.back().opening != opening)
        return std::nullopt;
    return pairs_.back().closing_end;
}

} // namespace iecfront
