#include "support/lexed.hpp"

#include "support/lexed_faults.hpp"

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

} // namespace

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
