#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/source/text_range.hpp>

#include <array>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// A single mistake that somebody makes in a valid text.
enum class FaultKind : std::uint8_t {
    drop_token,
    double_token,
    replace_token, ///< by another one of the text
    insert_token,  ///< of the text
    drop_line,     ///< with its end, so that the next one takes its place
    cut_file,
    remove_closing_word,   ///< `END_IF` and its like
    misspell_closing_word, ///< one letter is lost
    swap_closing_word,     ///< it is that of another construct
    unclosed_comment,
    unclosed_string,
};

inline constexpr std::array all_fault_kinds = {
    FaultKind::drop_token,          FaultKind::double_token,
    FaultKind::replace_token,       FaultKind::insert_token,
    FaultKind::drop_line,           FaultKind::cut_file,
    FaultKind::remove_closing_word, FaultKind::misspell_closing_word,
    FaultKind::swap_closing_word,   FaultKind::unclosed_comment,
    FaultKind::unclosed_string};

[[nodiscard]] std::string_view to_string(FaultKind kind) noexcept;

/// Draws faults for a text. The same seed gives the same faults.
class FaultMaker {
public:
    FaultMaker(const SyntaxTree& tree, std::uint32_t seed);

    /// Up to `count` edits, each of which makes one fault of that kind; fewer, or none, when the
    /// text has not enough places for it.
    [[nodiscard]] std::vector<TextEdit> make(FaultKind kind, std::size_t count);

private:
    struct Piece {
        TextRange range;
        TokenKind kind;
    };
    [[nodiscard]] std::size_t below(std::size_t bound) { return random_() % bound; }
    [[nodiscard]] std::string_view text(TextRange range) const {
        return std::string_view(text_).substr(range.begin, range.size());
    }
    [[nodiscard]] std::vector<TextRange> places(FaultKind kind) const;
    [[nodiscard]] TextEdit edit(FaultKind kind, TextRange place);
    /// With blanks around it, so that it makes no other token with its neighbours in that place.
    [[nodiscard]] std::string apart(TextRange place, std::string token) const;
    [[nodiscard]] std::string other_token(std::string_view present);
    [[nodiscard]] std::string other_closing_word(std::string_view present);

    std::string text_;
    std::vector<Piece> tokens_;
    std::vector<TextRange> lines_; ///< with at least one token, without their ends
    std::mt19937 random_;
};

} // namespace iecfront::test
