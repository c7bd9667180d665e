#pragma once

#include "lexer/comment_marks.hpp"
#include "lexer/extents.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/lexer/token.hpp>
#include <iecfront/source/encoding.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace iecfront {

/// Something whose end, or kind, depended on text far behind it: a comment that nothing closes, a
/// string that a word adjoins. An edit there can change it.
struct OpenEnd {
    std::uint32_t begin = 0;     // of it
    std::uint32_t looked_to = 0; // behind the last byte looked at; the end of text counts as one

    friend bool operator==(const OpenEnd&, const OpenEnd&) = default;
};

/// What the lexer makes of a text. All positions count from the start of that text.
struct LexedText {
    std::vector<Token> tokens; // ends in one end_of_unit token of length 0 at the end of the text
    std::vector<Trivia> trivia;
    std::vector<Diagnostic> diagnostics; // ordered by position
    std::vector<OpenEnd> open_ends;      // ordered by position
};

/// Nobody writes a longer literal than this, but for strings: what is longer is not tried as one.
inline constexpr std::size_t longest_tried = 40;

/// Reads a text, all of it or some tokens at a time. Never fails: tokens, trivia and the white
/// space between them give back every byte.
class Lexer {
public:
    /// Of `text`, which a zero byte must follow.
    /// `at_file_start` is false for a text that goes on in the middle of a line: no byte order mark
    /// can stand there, and its first token is not the first on its line.
    Lexer(std::string_view text, Encoding encoding, bool at_file_start = true);

    /// Reads on until the row has `count` tokens and a line ends, or the text does.
    void read(std::size_t count);
    /// True when all of the text was read. Then the last token is end_of_unit.
    [[nodiscard]] bool done() const noexcept { return done_; }

    /// The rows of what was read and not dropped.
    [[nodiscard]] std::span<const Token> tokens() const noexcept {
        return {result_.tokens.data(), token_count()};
    }
    [[nodiscard]] std::span<const Trivia> trivia() const noexcept { return result_.trivia; }
    [[nodiscard]] std::span<Diagnostic> diagnostics() noexcept { return result_.diagnostics; }
    [[nodiscard]] std::span<const OpenEnd> open_ends() const noexcept { return result_.open_ends; }

    /// Drops so many of each row, the first ones. One token at least must be left.
    void drop(std::size_t tokens, std::size_t trivia, std::size_t diagnostics,
              std::size_t open_ends);

    /// All rows as they are; the lexer is of no use any more.
    [[nodiscard]] LexedText take();

private:
    // White space, comments and pragmas that wrongly stand inside a literal (2.1.4), each with what
    // should stand in its place: nothing, mostly.
    using Gaps = std::vector<TextEdit>;

    // A literal that the next characters make, its kind and its extent.
    struct Found {
        TokenKind kind;
        const char* end;
        Gaps gaps;
        bool of_named_type = false; // of no elementary one
    };

    const char* read_until(std::size_t count);
    [[nodiscard]] static bool word_goes_on(const char* end) noexcept;
    [[nodiscard]] static bool number_goes_on(const char* begin, const char* end) noexcept;

    // Each of these takes the place where something begins, makes tokens or trivia of it, and gives
    // the place behind it; some give null when there is no such thing.

    // ---- lexer_words.cpp
    const char* odd_word(const char* begin);
    const char* plain_word(const char* begin, const char* end);
    const char* identifier(const char* begin, const char* end);
    bool check_word(const char* begin, const char* end);
    const char* parted_keyword(const char* begin, const char* end);
    void check_underscores(const char* begin, const char* end);
    bool check_foreign_letters(const char* begin, const char* end);

    // ---- lexer_literals.cpp
    const char* prefixed(const char* begin, const char* prefix_end);
    const char* found_literal(const char* begin, const char* prefix_end, const Found& found);
    bool find_prefixed(const char* begin, const char* prefix_end, Found& found) const;
    bool find_based(const char* begin, const char* prefix_end, const char* body,
                    Found& found) const;
    bool find_of_named_type(std::string_view prefix, const char* body, Found& found) const;
    [[nodiscard]] bool can_begin_value(TokenKind kind, std::string_view prefix,
                                       const char* body) const;
    void report_type_of_literal(const char* begin, const char* prefix_end, const char* end);
    const char* literal(TokenKind kind, const char* begin, const char* end);
    const char* literal_with_gaps(TokenKind kind, const char* begin, const char* end);
    const char* spaced_literal(TokenKind kind, const char* begin, const char* end, Gaps gaps);
    [[nodiscard]] static Gaps gaps_of(std::initializer_list<TextRange> ranges);
    [[nodiscard]] Gaps take_back_gaps(Token literal);
    const char* with_pound_sign(const char* begin, const char* end);
    const char* number_sign(const char* begin);
    [[nodiscard]] bool can_be_prefix(Token token) const;

    // ---- lexer_numbers.cpp
    const char* long_number(const char* begin);
    const char* number_with_point(const char* begin, const char* point);
    const char* number_with_exponent(const char* begin, const char* letter);
    [[nodiscard]] bool lacks_duration_prefix(const char* begin, const char* end) const;
    const char* duration_without_prefix(const char* begin, const char* end);
    const char* c_style_integer(const char* begin, const char* end);
    const char* hexadecimal_of_other_language(const char* begin, const char* end);
    const char* number_before_keyword(TokenKind kind, const char* begin, const char* end);
    const char* digit_first_word(const char* begin, const char* end);

    // ---- lexer_strings.cpp
    const char* string(const char* begin);
    const char* unclosed_string(const char* begin, const char* end);
    [[nodiscard]] bool is_stray_quote(const char* begin) const;
    [[nodiscard]] const char* end_behind_inner_quote(const char* end);

    // ---- lexer_locations.cpp
    const char* part_selector(const char* begin);
    const char* location(const char* begin);

    // ---- lexer_delimiters.cpp
    [[nodiscard]] bool ends_operand(Token token, const char* next) const;
    const char* dot(const char* begin);
    const char* caret(const char* begin);
    const char* non_ascii(const char* begin);
    const char* typographic_string(const char* begin, const DecodedCharacter& opening);
    const char* look_alike(const char* begin, const DecodedCharacter& character);
    const char* operator_of_other_language(const char* begin);
    const char* unexpected(const char* begin);

    // ---- lexer_comments.cpp
    const char* line_end(const char* begin);
    // What begins at `begin` depends on all that stands before and at `last`.
    void note_open_end(const char* begin, const char* last);
    const char* end_of_first_line(const char* begin, DiagnosticId fault, std::string_view opening,
                                  std::string_view closing);
    const char* end_of_prose(const char* begin, std::string_view opening, std::string_view closing);
    const char* find_comment_end(const char* begin);
    const char* left_parenthesis(const char* begin);
    const char* comment(const char* begin);
    const char* end_of_nested_comment(const char* begin, const char* inner, const char* closing);
    [[nodiscard]] std::optional<Token> comment_begin_without_star(const char* end) const;
    const char* stray_comment_end(const char* begin);
    const char* line_comment(const char* begin);
    const char* c_comment(const char* begin);
    const char* end_of_nested_braces(const char* begin);
    const char* pragma(const char* begin);
    const char* stray_pragma_end(const char* begin);

    // ---- lexer.cpp: tokens
    const char* delimiter(TokenKind kind, const char* begin, std::uint32_t size) {
        emit(kind, begin, begin + size);
        return begin + size;
    }
    void emit(TokenKind kind, const char* begin, const char* end, bool malformed = false);
    // The same, inlined where most tokens are made.
    void put(TokenKind kind, const char* begin, const char* end, bool malformed = false) {
        if (next_token_ == tokens_end_) [[unlikely]]
            grow_tokens(result_.tokens.size() / 2 + 16);
        *next_token_++ = Token(kind, offset(begin), static_cast<std::uint32_t>(end - begin),
                               first_on_line_, malformed);
        first_on_line_ = false;
    }
    // The same for what may be longer than a token can be.
    void emit_any(TokenKind kind, const char* begin, const char* end, bool malformed = false);
    void emit_pieces(const char* begin, const char* end);
    void add_trivia(TriviaKind kind, const char* begin, const char* end) {
        result_.trivia.push_back({range(begin, end), kind});
    }
    Diagnostic& report(DiagnosticId id, TextRange where) {
        return result_.diagnostics.emplace_back(Diagnostic{id, where, {}, {}, {}});
    }
    static void add_replacement(Diagnostic& diagnostic, TextRange where, std::string text = {}) {
        diagnostic.fixes.push_back({{TextEdit{where, std::move(text)}}});
    }
    void report_gap(TextRange gap, const char* delimiter) {
        Diagnostic& diagnostic = report(DiagnosticId::white_space_in_delimiter, gap);
        diagnostic.arguments.emplace_back(std::string(delimiter));
        add_replacement(diagnostic, gap);
    }
    Token take_back();
    // Tokens are written into a row made beforehand, which is longer than what is read.
    void grow_tokens(std::size_t by);
    [[nodiscard]] std::size_t token_count() const noexcept {
        return static_cast<std::size_t>(next_token_ - result_.tokens.data());
    }
    [[nodiscard]] bool has_tokens() const noexcept { return next_token_ != result_.tokens.data(); }
    [[nodiscard]] Token last_token() const noexcept { return next_token_[-1]; }

    [[nodiscard]] std::uint32_t offset(const char* p) const noexcept {
        return static_cast<std::uint32_t>(p - begin_);
    }
    [[nodiscard]] TextRange range(const char* begin, const char* end) const noexcept {
        return {offset(begin), offset(end)};
    }
    [[nodiscard]] static std::string_view view(const char* begin, const char* end) noexcept {
        return {begin, static_cast<std::size_t>(end - begin)};
    }

    std::string_view text_;
    const char* begin_;
    const char* end_;                   // where the zero byte stands
    const char* at_;                    // where to go on
    const char* line_feed_;             // the last one looked up, or the end
    const char* line_begin_ = nullptr;  // from here to `line_end_` no line ends
    const char* line_end_ = nullptr;    // the last one looked up
    const char* comment_end_ = nullptr; // the last one looked up
    // Behind these no `*)`, `*/`, `}` stands any more: nobody looks for one twice.
    const char* comment_end_missing_from_;
    const char* c_comment_end_missing_from_;
    const char* pragma_end_missing_from_;
    bool first_on_line_;
    bool done_ = false;
    Encoding encoding_;
    Extents extents_;
    CommentMarks marks_;
    LexedText result_;
    Token* next_token_ = nullptr;
    Token* tokens_end_ = nullptr;
};

/// Reads all of `text`, which a zero byte must follow.
[[nodiscard]] LexedText lex(std::string_view text, Encoding encoding, bool at_file_start = true);

} // namespace iecfront
