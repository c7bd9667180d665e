#include <iecfront/ast/attached_comments.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>

namespace iecfront {
namespace {

[[nodiscard]] bool is_comment(const Trivia& trivia) noexcept {
    return trivia.kind != TriviaKind::pragma && !trivia.range.empty();
}

/// The index of the first comment or pragma at or behind `offset`.
[[nodiscard]] std::size_t trivia_from(const Unit& unit, std::uint32_t offset) {
    const auto found = std::lower_bound(
        unit.trivia().begin(), unit.trivia().end(), offset,
        [](const Trivia& trivia, std::uint32_t o) { return trivia.range.begin < o; });
    return static_cast<std::size_t>(found - unit.trivia().begin());
}

[[nodiscard]] std::vector<Trivia> comments_in(std::span<const Trivia> row) {
    std::vector<Trivia> comments;
    std::ranges::copy_if(row, std::back_inserter(comments), is_comment);
    return comments;
}

/// Those that end above the token, each on the line below the one before.
[[nodiscard]] std::vector<Trivia> comments_above(const Unit& unit, std::uint32_t first_token) {
    const LineTable& lines = unit.lines();
    const std::uint32_t begin = unit.tokens()[first_token].offset();
    const std::uint32_t behind_token = first_token == 0 ? 0 : unit.tokens()[first_token - 1].end();
    // The line of the token before belongs to what ends there.
    const std::int64_t line_before = first_token == 0 ? -1 : lines.line_of(behind_token);
    const std::size_t end = trivia_from(unit, begin);
    std::size_t first = end;
    std::int64_t line = lines.line_of(begin);
    while (first > 0) {
        const Trivia& candidate = unit.trivia()[first - 1];
        if (candidate.range.empty() || candidate.range.begin < behind_token)
            break;
        const std::int64_t last_line = lines.line_of(candidate.range.end - 1);
        const std::int64_t first_line = lines.line_of(candidate.range.begin);
        if (last_line + 1 < line || first_line == line_before)
            break;
        line = first_line;
        --first;
    }
    return comments_in(unit.trivia().subspan(first, end - first));
}

[[nodiscard]] std::vector<Trivia> comments_behind(const Unit& unit, std::uint32_t end_token) {
    const std::span<const Token> tokens = unit.tokens();
    std::uint32_t next = end_token;
    if (next < tokens.size() &&
        (tokens[next].kind() == TokenKind::semicolon || tokens[next].kind() == TokenKind::comma))
        ++next;
    const std::uint32_t end = tokens[next - 1].end();
    const std::uint32_t limit =
        next < tokens.size() ? tokens[next].offset() : std::numeric_limits<std::uint32_t>::max();
    const std::uint32_t line = unit.lines().line_of(tokens[end_token - 1].end());
    const std::size_t first = trivia_from(unit, end);
    std::size_t behind = first;
    while (behind < unit.trivia().size()) {
        const Trivia& candidate = unit.trivia()[behind];
        if (candidate.range.begin >= limit || unit.lines().line_of(candidate.range.begin) != line)
            break;
        ++behind;
    }
    // Before another token of the same line, a comment speaks of that, but for one behind a `;`.
    const bool more_on_line = tokens[next - 1].kind() != TokenKind::semicolon &&
                              next < tokens.size() &&
                              unit.lines().line_of(tokens[next].offset()) == line;
    return comments_in(unit.trivia().subspan(first, more_on_line ? 0 : behind - first));
}

} // namespace

AttachedComments attached_comments(const Unit& unit, const ast::Node& node) {
    if (node.first_token == node.end_token)
        return {};
    return {comments_above(unit, node.first_token), comments_behind(unit, node.end_token)};
}

} // namespace iecfront
