#pragma once

#include "lexer/lexer.hpp"
#include "lexer/unit_cutter.hpp"
#include "parser/parser_arena.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/ast/unit.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront {

/// Makes `parts`, of which the text is known, a unit that is not examined, as `report` says: all of
/// its text is a comment, so that no byte is lost.
void leave_unexamined(Unit::Parts& parts, Diagnostic report);

/// Reads a text unit by unit. Of the tokens, it holds those of the unit where it stands, and a
/// stretch of what follows. A fragment is one unit.
class UnitReader {
public:
    /// Units will share `buffer`. `at_file_start` says whether it begins a file: a byte order mark
    /// can stand there, and its first token is the first on its line.
    UnitReader(std::shared_ptr<const std::string> buffer, Encoding encoding, bool at_file_start,
               const ParseOptions& options);

    /// Goes to the next unit, at first to the first one. False behind the last one.
    [[nodiscard]] bool next();

    /// Where the unit begins and ends, in the buffer.
    [[nodiscard]] std::uint32_t begin() const noexcept { return begin_; }
    [[nodiscard]] std::uint32_t end() const noexcept { return end_; }
    /// Its tokens and trivia, and the word that opens its declaration, as `UnitCut` has it.
    /// Positions count from the start of the buffer, indices from the start of the unit.
    [[nodiscard]] std::span<const Token> tokens() const noexcept {
        return lexer_.tokens().subspan(token_, cut_.end_token - token_);
    }
    [[nodiscard]] std::span<const Trivia> trivia() const noexcept {
        return lexer_.trivia().subspan(trivia_, trivia_end_ - trivia_);
    }
    [[nodiscard]] std::uint32_t opener() const noexcept { return cut_.opener - token_; }
    /// As `UnitCut` has it.
    [[nodiscard]] bool balanced() const noexcept { return cut_.balanced; }
    /// True when an edit behind it can change it.
    [[nodiscard]] bool depends_on_rest() const noexcept;

    /// The tokens from its first one on, as far as they are read: at least `cutter_lookahead` more
    /// than its own, if there are so many. The last one of a text is end_of_unit.
    [[nodiscard]] std::span<const Token> tokens_ahead() const noexcept {
        return lexer_.tokens().subspan(token_);
    }
    /// How far into the buffer it was looked, for what begins before `place`.
    [[nodiscard]] std::uint32_t looked_to(std::uint32_t place) const noexcept;

    /// Parses the unit, once.
    [[nodiscard]] std::shared_ptr<const Unit> parse();
    /// The same, with a copy of its text for a buffer.
    [[nodiscard]] std::shared_ptr<const Unit> parse_copy();

private:
    void read_cut();
    void read_more();
    [[nodiscard]] std::uint32_t end_of_cut() const noexcept;
    [[nodiscard]] std::shared_ptr<const Unit> parse(std::shared_ptr<const std::string> buffer,
                                                    std::string_view text);
    [[nodiscard]] bool parse_into(Unit::Parts& parts);
    void make_room();
    [[nodiscard]] std::size_t most_room() const noexcept;
    [[nodiscard]] bool parse_in_room(Unit::Parts& parts);
    [[nodiscard]] std::span<Token> copy_tokens();
    [[nodiscard]] std::span<const Trivia> copy_trivia();
    [[nodiscard]] std::vector<Diagnostic> take_diagnostics();

    std::shared_ptr<const std::string> buffer_;
    Encoding encoding_;
    const ParseOptions& options_;
    Lexer lexer_;
    UnitCutter cutter_;
    bool last_ = false; // nothing stands behind the unit

    // The unit: in the buffer, and in the rows of the lexer.
    std::uint32_t begin_ = 0;
    std::uint32_t end_ = 0;
    std::uint32_t token_ = 0;
    UnitCut cut_{0, 0, false};
    std::size_t trivia_ = 0;
    std::size_t trivia_end_ = 0;
    std::size_t diagnostic_ = 0;
    std::size_t diagnostic_end_ = 0;
    std::size_t open_end_ = 0;
    std::size_t open_end_end_ = 0;
    ParserArena room_;          // where units are made, one after the other
    std::uint32_t lengths_ = 0; // of the tokens when they were copied, their bits put together
};

} // namespace iecfront
