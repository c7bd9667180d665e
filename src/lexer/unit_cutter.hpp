#pragma once

#include <iecfront/lexer/token.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace iecfront {

/// A unit as a stretch of a token row: one library element declaration and the trivia before it.
struct UnitCut {
    std::uint32_t end_token; // one past its last token
    std::uint32_t opener;    // the word that opens the declaration; end_token when there is none
    bool balanced;           // as many blocks of each kind begin as are closed: see `block_pairs`
};

/// So many tokens behind a place can decide whether a unit ends there: an opening word and what
/// makes it plausible, or the `;` behind a closing word.
inline constexpr std::size_t cutter_lookahead = 8;

/// Cuts the tokens of a file into units, by a table of which word closes which and which openers
/// may stand inside which. There is at least one unit. One begins where the one before it ends, at
/// the end of its last token; the last one takes the rest of the text.
class UnitCutter {
public:
    /// The next cut of a row that may have grown since the last one; its last token is end_of_unit
    /// when it is `complete`. Nothing when more tokens are needed to tell, or all units are cut.
    [[nodiscard]] std::optional<UnitCut> next(std::span<const Token> tokens, bool complete);

    /// The first `count` tokens are no longer in the row: all are of units that were cut.
    void drop(std::size_t count) noexcept;

private:
    bool look_at(std::span<const Token> some, bool complete);
    void see(std::size_t i);
    void find_cut(std::size_t i);
    void open(std::size_t i);
    void close(std::size_t i);
    void cut_before(std::size_t i);
    [[nodiscard]] bool sees_semicolons(std::size_t closer) const noexcept;
    [[nodiscard]] bool is_stray_closer(std::size_t i) const noexcept;
    [[nodiscard]] bool is_in_two_words(std::size_t i) const noexcept;
    [[nodiscard]] bool begins_stray_text(std::size_t i) const noexcept;
    [[nodiscard]] bool follows_unknown_head(std::size_t i) const noexcept;
    [[nodiscard]] bool opens_declaration(std::size_t i) const noexcept;
    [[nodiscard]] bool is_misused_name(std::size_t i) const noexcept;
    [[nodiscard]] bool is_prose(std::size_t i) const noexcept;
    [[nodiscard]] bool is_declaration_head(std::size_t i) const noexcept;
    [[nodiscard]] bool goes_on_as_head(std::size_t i) const noexcept;
    [[nodiscard]] bool begins_declaration(std::size_t i) const noexcept;
    [[nodiscard]] bool is_program_configuration(std::size_t i) const noexcept;

    [[nodiscard]] Token at(std::size_t i) const noexcept {
        return tokens_[std::min(i, tokens_.size() - 1)];
    }

    std::span<const Token> tokens_;
    std::optional<UnitCut> cut_;
    bool cut_any_ = false;
    std::size_t at_ = 0; // the next token to see
    std::size_t unit_begin_ = 0;
    TokenKind open_ = TokenKind::end_of_unit; // the opener; end_of_unit when nothing is open
    std::size_t opener_ = 0;
    bool variables_open_ = false; // a block of variables in it
    // By closing word: how many more blocks begin in the unit than are closed, so far.
    std::array<std::int32_t, token_kind_count> unclosed_{};
};

/// The cuts of a whole file, whose last token is end_of_unit.
[[nodiscard]] std::vector<UnitCut> cut_units(std::span<const Token> tokens);

} // namespace iecfront
