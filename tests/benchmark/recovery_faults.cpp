#include "benchmark/recovery_faults.hpp"

#include "support/repository_files.hpp"

#include <iecfront/lexer/token.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace iecfront::test {
namespace {

// ELSE, UNTIL and OF are no closing words: they part a construct.
[[nodiscard]] bool is_closing_word(TokenKind kind) noexcept {
    return is_keyword(kind) && spelling(kind).substr(0, 4) == "END_";
}

[[nodiscard]] bool is_string(TokenKind kind) noexcept {
    return kind == TokenKind::single_byte_string || kind == TokenKind::double_byte_string;
}

[[nodiscard]] TextRange range_of(std::size_t begin, std::size_t size) noexcept {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + size)};
}

} // namespace

std::string_view to_string(FaultKind kind) noexcept {
    switch (kind) {
    case FaultKind::drop_token: return "token dropped";
    case FaultKind::double_token: return "token doubled";
    case FaultKind::replace_token: return "token replaced";
    case FaultKind::insert_token: return "token inserted";
    case FaultKind::drop_line: return "line dropped";
    case FaultKind::cut_file: return "file cut";
    case FaultKind::remove_closing_word: return "closing word removed";
    case FaultKind::misspell_closing_word: return "closing word misspelt";
    case FaultKind::swap_closing_word: return "closing word swapped";
    case FaultKind::unclosed_comment: return "comment unclosed";
    case FaultKind::unclosed_string: return "string unclosed";
    }
    return {};
}

FaultMaker::FaultMaker(const SyntaxTree& tree, std::uint32_t seed)
    : text_(tree.source().bytes()), random_(seed) {
    for (const SyntaxTree::Slot& slot : tree.slots())
        for (const Token token : slot.unit->tokens())
            tokens_.push_back({token.range().shifted(slot.offset), token.kind()});
    auto token = tokens_.begin();
    for (const std::string_view line : lines_of(text_)) {
        const TextRange range =
            range_of(static_cast<std::size_t>(line.data() - text_.data()), line.size());
        token = std::find_if(token, tokens_.end(), [range](const Piece& piece) {
            return piece.range.begin >= range.begin;
        });
        if (token != tokens_.end() && token->range.begin < range.end)
            lines_.push_back(range);
    }
}

std::vector<TextEdit> FaultMaker::make(FaultKind kind, std::size_t count) {
    std::vector<TextRange> all = places(kind);
    std::shuffle(all.begin(), all.end(), random_);
    all.resize(std::min(all.size(), count));
    std::vector<TextEdit> edits;
    for (const TextRange place : all)
        edits.push_back(edit(kind, place));
    return edits;
}

// The tokens, or lines, where a fault of the kind can be made.
std::vector<TextRange> FaultMaker::places(FaultKind kind) const {
    if (kind == FaultKind::drop_line || kind == FaultKind::unclosed_comment)
        return lines_;
    std::vector<TextRange> result;
    for (const Piece& piece : tokens_) {
        switch (kind) {
        case FaultKind::remove_closing_word:
        case FaultKind::misspell_closing_word:
        case FaultKind::swap_closing_word:
            if (!is_closing_word(piece.kind))
                continue;
            break;
        case FaultKind::unclosed_string:
            if (!is_string(piece.kind))
                continue;
            break;
        default: break;
        }
        result.push_back(piece.range);
    }
    if (kind == FaultKind::cut_file && !result.empty())
        result.pop_back(); // behind the last token nothing is lost
    return result;
}

TextEdit FaultMaker::edit(FaultKind kind, TextRange place) {
    const std::string_view present = text(place);
    const TextRange end = {place.end, place.end};
    switch (kind) {
    case FaultKind::drop_token:
    case FaultKind::remove_closing_word: return {place, {}};
    case FaultKind::drop_line: {
        const std::size_t line_end = text_.find('\n', place.end);
        return {{place.begin, static_cast<std::uint32_t>(std::min(line_end, text_.size() - 1) + 1)},
                {}};
    }
    case FaultKind::double_token: return {end, ' ' + std::string(present)};
    case FaultKind::replace_token: return {place, apart(place, other_token(present))};
    case FaultKind::insert_token: return {end, ' ' + apart(end, other_token({}))};
    case FaultKind::cut_file: return {range_of(place.end, text_.size() - place.end), {}};
    case FaultKind::misspell_closing_word: {
        // A letter behind `END_`, so that the word is recognised for what it was.
        constexpr std::size_t prefix = 4;
        const std::size_t letter = place.begin + prefix + below(place.size() - prefix);
        return {range_of(letter, 1), {}};
    }
    case FaultKind::swap_closing_word: return {place, other_closing_word(present)};
    case FaultKind::unclosed_comment: return {end, " (* note"};
    case FaultKind::unclosed_string: return {range_of(place.end - 1, 1), {}};
    }
    return {};
}

std::string FaultMaker::apart(TextRange place, std::string token) const {
    const auto is_blank = [this](std::size_t at) {
        constexpr std::string_view blanks = " \t\r\n";
        return at >= text_.size() || blanks.find(text_[at]) != blanks.npos;
    };
    if (!place.empty() && place.begin > 0 && !is_blank(place.begin - 1))
        token.insert(0, " ");
    if (!is_blank(place.end))
        token += ' ';
    return token;
}

std::string FaultMaker::other_token(std::string_view present) {
    constexpr std::size_t attempts = 20;
    std::string_view drawn = ";";
    for (std::size_t i = 0; i < attempts; ++i) {
        drawn = text(tokens_[below(tokens_.size())].range);
        if (drawn != present)
            break;
    }
    return std::string(drawn);
}

std::string FaultMaker::other_closing_word(std::string_view present) {
    constexpr std::array words = {"END_IF",  "END_CASE",   "END_FOR",   "END_WHILE",
                                  "END_VAR", "END_STRUCT", "END_REPEAT"};
    const std::size_t first = below(words.size());
    return words[first] != present ? words[first] : words[(first + 1) % words.size()];
}

} // namespace iecfront::test
