#include "support/lexed_faults.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace iecfront::test {
namespace {

std::string place(TextRange range) {
    return std::to_string(range.begin) + ".." + std::to_string(range.end);
}

bool is_white_space(std::string_view gap, std::uint32_t at, Encoding encoding) {
    if (at == 0 && encoding == Encoding::utf8 && gap.starts_with("\xEF\xBB\xBF"))
        gap.remove_prefix(3);
    return gap.find_first_not_of(" \t\n\v\f\r") == std::string_view::npos;
}

std::vector<TextRange> elements(const LexedText& lexed) {
    std::vector<TextRange> ranges;
    for (const Token token : lexed.tokens)
        ranges.push_back(token.range());
    for (const Trivia& trivia : lexed.trivia)
        ranges.push_back(trivia.range);
    std::ranges::sort(ranges, {},
                      [](TextRange range) { return std::pair(range.begin, range.end); });
    return ranges;
}

} // namespace

std::string tiling_fault(std::string_view text, const LexedText& lexed, Encoding encoding) {
    const auto size = static_cast<std::uint32_t>(text.size());
    if (lexed.tokens.empty() || lexed.tokens.back() != Token(TokenKind::end_of_unit, size, 0, true))
        return "no end_of_unit";
    if (!std::ranges::is_sorted(lexed.tokens, {}, &Token::offset) ||
        !std::ranges::is_sorted(lexed.trivia, {}, [](Trivia t) { return t.range.begin; }))
        return "not in order";
    std::uint32_t at = 0;
    for (const TextRange range : elements(lexed)) {
        if (range.begin < at)
            return "overlap at " + place(range);
        if (range.empty() && range.begin != size)
            return "empty at " + place(range);
        if (!is_white_space(text.substr(at, range.begin - at), at, encoding))
            return "lost bytes before " + place(range);
        at = range.end;
    }
    std::uint32_t last = 0;
    for (const Diagnostic& diagnostic : lexed.diagnostics) {
        if (diagnostic.range.begin < last || diagnostic.range.end > size ||
            diagnostic.range.begin > diagnostic.range.end)
            return "diagnostic at " + place(diagnostic.range);
        last = diagnostic.range.begin;
    }
    const bool ordered = std::ranges::is_sorted(lexed.open_ends, {}, &OpenEnd::begin);
    return ordered ? "" : "open ends are not in order";
}

} // namespace iecfront::test
