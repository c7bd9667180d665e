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

/// Where units have their text and their tree: in memory that they share with others, and which is
/// there as long as any of these; or each in its own.
enum class UnitMemory : std::uint8_t { shared, own };

/// Reads a text unit by unit. Of the tokens, it holds those of the unit where it stands, and a
/// stretch of what follows. A fragment is one unit.
class UnitReader {
public:
    /// `at_file_start` says whether `buffer` begins a file: a byte order mark can stand there, and
    /// its first token is the first on its line.
    UnitReader(std::shared_ptr<const std::string> buffer, Encoding encoding, bool at_file_start,
               const ParseOptions& options, UnitMemory memory = UnitMemory::shared);

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

private:
    void read_cut();
    void read_more();
    [[nodiscard]] std::uint32_t end_of_cut() const noexcept;
    void take_text(Unit::Parts& parts) const;
    [[nodiscard]] bool parse_into(Unit::Parts& parts);
    [[nodiscard]] bool is_allowed(const ParserArena& room, const Unit::Parts& parts) const noexcept;
    [[nodiscard]] bool parse_in_shared_room(Unit::Parts& parts);
    [[nodiscard]] bool parse_in_own_room(Unit::Parts& parts);
    [[nodiscard]] std::size_t usual_room() const noexcept;
    [[nodiscard]] std::size_t most_room() const noexcept;
    [[nodiscard]] bool parse_in(ParserArena& room, Unit::Parts& parts);
    void move_out(Unit::Parts& parts) const;
    [[nodiscard]] std::span<Token> copy_tokens(ParserArena& room);
    [[nodiscard]] std::span<const Trivia> copy_trivia(ParserArena& room) const;
    [[nodiscard]] std::vector<Diagnostic> take_diagnostics();

    std::shared_ptr<const std::string> buffer_;
    Encoding encoding_;
    const ParseOptions& options_;
    UnitMemory memory_;
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
    ParserArena shared_room_;   // the rest of a block in which units stay
    ParserArena own_room_;      // where those are made that get blocks of their own
    std::uint32_t lengths_ = 0; // of the tokens when they were copied, their bits put together
};

} // namespace iecfront
