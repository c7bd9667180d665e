#include "support/lexed.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace iecfront::test {

namespace {

LexedText checked(std::string_view text, Encoding encoding) {
    const std::string terminated(text); // a zero byte stands behind it
    LexedText lexed = lex(terminated, encoding);
    EXPECT_EQ(tiling_fault(text, lexed, encoding), "") << text;
    return lexed;
}

std::string place(TextRange range) {
    return std::to_string(range.begin) + ".." + std::to_string(range.end);
}

std::string joined(const std::vector<std::string>& words) {
    std::string result;
    for (const std::string& word : words)
        result += (result.empty() ? "" : " ") + word;
    return result;
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
    const bool ordered = std::is_sorted(lexed.open_ended.begin(), lexed.open_ended.end());
    return ordered ? "" : "open ends are not in order";
}

std::string tokens(std::string_view text, Encoding encoding) {
    std::vector<std::string> words;
    for (const Token token : checked(text, encoding).tokens)
        if (token.kind() != TokenKind::end_of_unit)
            words.push_back(std::string(to_string(token.kind())) + (token.malformed() ? "!" : "") +
                            "(" + std::string(text.substr(token.offset(), token.length())) + ")");
    return joined(words);
}

std::string kinds(std::string_view text, Encoding encoding) {
    std::vector<std::string> words;
    for (const Token token : checked(text, encoding).tokens)
        if (token.kind() != TokenKind::end_of_unit)
            words.emplace_back(to_string(token.kind()));
    return joined(words);
}

std::string line_starts(std::string_view text) {
    std::vector<std::string> words;
    for (const Token token : checked(text, Encoding::utf8).tokens)
        if (token.first_on_line() && token.kind() != TokenKind::end_of_unit)
            words.emplace_back(text.substr(token.offset(), token.length()));
    return joined(words);
}

std::string trivia(std::string_view text) {
    std::vector<std::string> words;
    for (const Trivia& element : checked(text, Encoding::utf8).trivia)
        words.push_back(std::string(to_string(element.kind)) + "(" + place(element.range) + ")");
    return joined(words);
}

std::string faults(std::string_view text, Encoding encoding) {
    std::vector<std::string> words;
    for (const Diagnostic& diagnostic : checked(text, encoding).diagnostics)
        words.push_back(std::to_string(diagnostic_info(diagnostic.id).code) + "@" +
                        place(diagnostic.range));
    return joined(words);
}

std::string fixed(std::string_view text) {
    std::vector<TextEdit> edits;
    for (const Diagnostic& diagnostic : checked(text, Encoding::utf8).diagnostics)
        if (!diagnostic.fixes.empty())
            for (const TextEdit& edit : diagnostic.fixes.front().edits)
                edits.push_back(edit);
    std::string result(text);
    for (std::size_t i = edits.size(); i-- > 0;)
        result.replace(edits[i].range.begin, edits[i].range.size(), edits[i].replacement);
    return result;
}

} // namespace iecfront::test
