#include "format/pieces.hpp"

#include "format/broken_lines.hpp"

#include <iecfront/ast/syntax_tree.hpp>

#include <algorithm>

namespace iecfront::layout {
namespace {

// ... even a comment.
[[nodiscard]] bool follows_directly(TokenKind kind) noexcept {
    return kind == TokenKind::comma || kind == TokenKind::semicolon || closes_bracket(kind);
}

// CR LF ends one line.
[[nodiscard]] std::uint32_t line_ends_in(std::string_view gap) noexcept {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < gap.size(); ++i)
        if (gap[i] == '\n' ? i == 0 || gap[i - 1] != '\r' : gap[i] == '\r')
            ++count;
    return count;
}

struct Extent {
    std::uint32_t width = 0; // characters in the last line
    bool several_lines = false;
};

[[nodiscard]] Extent extent_of(std::string_view text, Encoding encoding) noexcept {
    // In UTF-8 the bytes behind the first one of a character are 10xxxxxx.
    const bool utf8 = encoding == Encoding::utf8;
    Extent extent;
    for (const char c : text) {
        if (c == '\n' || c == '\r')
            extent = {0, true};
        else if (!utf8 || (static_cast<unsigned char>(c) & 0xC0U) != 0x80U)
            ++extent.width;
    }
    return extent;
}

/// Counts the columns of the source on the way from its beginning to its end.
class ColumnCounter {
public:
    /// A byte order mark takes no column.
    explicit ColumnCounter(const Unit& unit) : unit_(unit), offset_(leading_mark_size(unit)) {}

    /// Only forwards.
    void move_to(std::uint32_t offset) {
        const std::string_view way = unit_.text({offset_, offset});
        const Extent extent = extent_of(way, unit_.encoding());
        if (extent.several_lines) {
            column_ = 0;
            behind_tab_ = false;
        }
        column_ += extent.width;
        behind_tab_ |= way.substr(way.find_last_of("\r\n") + 1).find('\t') != way.npos;
        offset_ = offset;
    }
    /// Counted from 0; a tab is one.
    [[nodiscard]] std::uint32_t column() const noexcept { return column_; }
    /// Nothing when a tab makes it uncertain.
    [[nodiscard]] std::uint32_t certain_column() const noexcept {
        return behind_tab_ ? Piece::no_column : column_;
    }

private:
    const Unit& unit_;
    std::uint32_t offset_;
    std::uint32_t column_ = 0;
    bool behind_tab_ = false;
};

class Arranger {
public:
    Arranger(const Unit& unit, std::uint32_t indent_width, TextRule* rule)
        : unit_(unit),
          rule_(rule),
          width_(static_cast<std::int32_t>(indent_width)),
          rows_(lay_out(unit, indent_width)),
          broken_(broken_lines(unit)),
          trivia_column_(unit),
          token_column_(unit) {}

    std::vector<Piece> arrange();

private:
    void add_trivia_before(std::uint32_t token);
    [[nodiscard]] std::uint32_t line_begin_of(std::uint32_t token) const;
    void add_trivia(Trivia trivia, std::uint32_t token);
    void add_token(std::uint32_t token);
    void add(Piece piece, std::uint32_t token, TextRange range);
    [[nodiscard]] Break break_before(const Piece& piece, std::uint32_t token,
                                     std::uint32_t line_ends) const;
    void keep_break_at_operator(std::uint32_t token);
    [[nodiscard]] bool wants_blank_line(std::uint32_t token, std::uint32_t line_ends) const;
    void remember_place(Piece& piece, std::uint32_t begin) const;
    void rank_break(Piece& piece, std::uint8_t rank);
    [[nodiscard]] std::int32_t level_of_comment(std::uint32_t token);
    [[nodiscard]] bool in_broken_line(std::uint32_t offset);
    void mark_comments_behind();

    [[nodiscard]] bool at_end(std::uint32_t token) const { return token >= rows_.size(); }
    [[nodiscard]] bool begins_line(std::uint32_t token) const {
        return token == 0 || at_end(token) || rows_[token].begins_line;
    }
    [[nodiscard]] bool after_comment() const {
        return !pieces_.empty() && pieces_.back().is_comment();
    }

    const Unit& unit_;
    TextRule* rule_;
    std::int32_t width_;
    std::vector<TokenLayout> rows_;
    std::vector<TextRange> broken_;
    std::size_t next_broken_ = 0;

    ColumnCounter trivia_column_;  // of the last comment
    ColumnCounter token_column_;   // of the line of the token behind it
    std::uint32_t line_begin_ = 0; // of the line of the next token

    std::vector<Piece> pieces_;
    std::size_t next_trivia_ = 0;
    std::uint32_t end_ = 0;                // of the piece before
    std::uint32_t line_ends_left_out_ = 0; // before a comment that is left out
    std::uint32_t brackets_ = 0;           // open before the next token, in its line
    bool line_in_gap_ = false;             // a line ends between the token before and the next one
    bool blank_in_gap_ = false;            // an empty line stands there
};

std::vector<Piece> Arranger::arrange() {
    end_ = leading_mark_size(unit_);
    pieces_.reserve(rows_.size() + unit_.trivia().size());
    const auto count = static_cast<std::uint32_t>(rows_.size());
    for (std::uint32_t token = 0; token < count; ++token) {
        add_trivia_before(token);
        add_token(token);
    }
    add_trivia_before(count);
    mark_comments_behind();
    return std::move(pieces_);
}

// Those up to `token`, or to the end of the unit.
void Arranger::add_trivia_before(std::uint32_t token) {
    line_in_gap_ = false;
    blank_in_gap_ = false;
    const std::uint32_t end = at_end(token) ? static_cast<std::uint32_t>(unit_.text().size()) + 1
                                            : unit_.tokens()[token].offset();
    line_begin_ = line_begin_of(token);
    while (next_trivia_ < unit_.trivia().size() && unit_.trivia()[next_trivia_].range.begin < end)
        add_trivia(unit_.trivia()[next_trivia_++], token);
}

// Where the line of `token` begins, if comments before it stand there as well.
std::uint32_t Arranger::line_begin_of(std::uint32_t token) const {
    if (at_end(token))
        return static_cast<std::uint32_t>(unit_.text().size());
    std::uint32_t begin = unit_.tokens()[token].offset();
    std::size_t behind = next_trivia_;
    while (behind < unit_.trivia().size() && unit_.trivia()[behind].range.begin < begin)
        ++behind;
    for (; behind > next_trivia_; --behind) {
        const TextRange trivia = unit_.trivia()[behind - 1].range;
        if (line_ends_in(unit_.text({trivia.end, begin})) > 0)
            break;
        begin = trivia.begin;
    }
    return begin;
}

void Arranger::add_trivia(Trivia trivia, std::uint32_t token) {
    Piece piece;
    piece.text = unit_.text(trivia.range);
    if (rule_ != nullptr)
        piece.text = rule_->trivia(trivia, piece.text, in_broken_line(trivia.range.begin));
    piece.gap = unit_.text({end_, trivia.range.begin});
    if (piece.text.empty()) {
        line_ends_left_out_ = std::max(line_ends_left_out_, line_ends_in(piece.gap));
        end_ = trivia.range.end;
        return;
    }
    trivia_column_.move_to(trivia.range.begin);
    piece.space = true;
    piece.pragma = trivia.kind == TriviaKind::pragma;
    if (pieces_.empty() || line_ends_in(piece.gap) > 0)
        piece.level = level_of_comment(token);
    else
        piece.source_column = trivia_column_.certain_column();
    add(piece, token, trivia.range);
}

void Arranger::add_token(std::uint32_t token) {
    const Token source = unit_.tokens()[token];
    const TokenLayout& row = rows_[token];
    Piece piece;
    piece.text = unit_.text(source);
    if (rule_ != nullptr)
        piece.text = rule_->token(source, piece.text);
    piece.gap = unit_.text({end_, source.offset()});
    piece.kind = source.kind();
    piece.level = row.level;
    piece.space = row.space || (after_comment() && !follows_directly(piece.kind));
    piece.word = row.word;
    piece.row = row.row;
    piece.cell = row.cell;
    piece.stop = row.stop;
    add(piece, token, source.range());
}

void Arranger::add(Piece piece, std::uint32_t token, TextRange range) {
    const std::uint32_t line_ends = std::max(line_ends_in(piece.gap), line_ends_left_out_);
    line_ends_left_out_ = 0;
    const Extent extent = extent_of(piece.text, unit_.encoding());
    piece.width = extent.width;
    piece.several_lines = extent.several_lines;
    if (piece.several_lines) {
        piece.width -= static_cast<std::uint32_t>(indent_of(last_line(piece.text)).size());
        remember_place(piece, range.begin);
    }
    piece.verbatim = in_broken_line(range.begin);
    piece.line_break = break_before(piece, token, line_ends);
    if (piece.line_break == Break::none && line_ends > 0 && !piece.is_comment())
        keep_break_at_operator(token);
    if (piece.line_break == Break::line) {
        piece.blank_line = wants_blank_line(token, line_ends);
        blank_in_gap_ |= piece.blank_line;
    }
    line_in_gap_ |= piece.line_break >= Break::kept;
    rank_break(piece, piece.is_comment() ? std::uint8_t{0} : rows_[token].rank);
    end_ = range.end;
    pieces_.push_back(piece);
}

// Where the first line of a comment stands in the source.
void Arranger::remember_place(Piece& piece, std::uint32_t begin) const {
    const std::size_t line_end = unit_.text({0, begin}).find_last_of("\r\n");
    const std::size_t line_begin =
        line_end == std::string_view::npos ? leading_mark_size(unit_) : line_end + 1;
    piece.line_before = unit_.text({static_cast<std::uint32_t>(line_begin), begin});
    piece.first_column = width_of_last_line(piece.line_before, unit_.encoding());
    piece.tab_before = piece.line_before.find('\t') != std::string_view::npos;
    piece.blanks_before = indent_of(piece.line_before).size() == piece.line_before.size();
}

// `piece` is token `token`, or a comment before it, with `line_ends` before it in the source.
Break Arranger::break_before(const Piece& piece, std::uint32_t token,
                             std::uint32_t line_ends) const {
    if (pieces_.empty())
        return Break::line;
    const bool stays_apart =
        piece.is_comment() || after_comment() || piece.verbatim || pieces_.back().verbatim;
    if (stays_apart && line_ends > 0)
        return begins_line(token) ? Break::line : Break::kept;
    if (piece.is_comment() || piece.verbatim)
        return Break::none;
    if (begins_line(token))
        return line_in_gap_ ? Break::none : Break::line;
    if (line_ends > 0 && (rows_[token].may_break || closes_bracket(piece.kind)))
        return Break::kept;
    return rows_[token].may_break ? Break::allowed : Break::none;
}

// Where the user has ended the line behind an operator, it ends before it.
void Arranger::keep_break_at_operator(std::uint32_t token) {
    const bool behind_operator = token > 0 && rows_[token - 1].rank > 0 && !after_comment();
    if (behind_operator && pieces_.back().line_break == Break::allowed)
        pieces_.back().line_break = Break::kept;
}

// One empty line of the user's, and one before each library element.
bool Arranger::wants_blank_line(std::uint32_t token, std::uint32_t line_ends) const {
    const bool separates = !at_end(token) && rows_[token].blank_before && !blank_in_gap_;
    return line_ends > 1 || separates;
}

void Arranger::rank_break(Piece& piece, std::uint8_t rank) {
    if (piece.line_break == Break::line)
        brackets_ = 0;
    piece.brackets = brackets_;
    piece.rank = rank;
    if (opens_bracket(piece.kind))
        ++brackets_;
    else if (closes_bracket(piece.kind) && brackets_ > 0)
        --brackets_;
}

// A comment above a word that closes something belongs to what is closed when it stands further
// right than the word; and so does one between parts of different levels.
std::int32_t Arranger::level_of_comment(std::uint32_t token) {
    const std::int32_t before = token > 0 ? rows_[token - 1].level : 0;
    if (at_end(token))
        return trivia_column_.column() == 0 ? 0 : before;
    const TokenLayout& row = rows_[token];
    const std::int32_t inside = std::max(before, row.closes ? row.level + width_ : row.level);
    token_column_.move_to(line_begin_);
    return trivia_column_.column() > token_column_.column() ? inside : row.level;
}

// To be asked in the order of offsets.
bool Arranger::in_broken_line(std::uint32_t offset) {
    while (next_broken_ < broken_.size() && broken_[next_broken_].end < offset)
        ++next_broken_;
    return next_broken_ < broken_.size() && broken_[next_broken_].begin <= offset;
}

// The first of the comments that end a line.
void Arranger::mark_comments_behind() {
    for (std::size_t i = pieces_.size(); i-- > 0;) {
        const bool ends_line = i + 1 == pieces_.size() || pieces_[i + 1].line_break >= Break::kept;
        const bool ends_comments = ends_line || pieces_[i + 1].behind;
        if (!ends_comments || !pieces_[i].is_comment() || pieces_[i].line_break >= Break::kept)
            continue;
        const bool ended_line = i + 1 == pieces_.size() || line_ends_in(pieces_[i + 1].gap) > 0;
        if (ends_line && !ended_line) // it was not put there by the user
            pieces_[i].source_column = Piece::no_column;
        pieces_[i].behind = true;
        if (ends_line)
            continue;
        pieces_[i + 1].behind = false;
        if (pieces_[i + 1].source_column == Piece::no_column)
            pieces_[i].source_column = Piece::no_column;
    }
}

} // namespace

std::string_view last_line(std::string_view text) noexcept {
    return text.substr(text.find_last_of("\r\n") + 1);
}

std::string_view indent_of(std::string_view line) noexcept {
    return line.substr(0, std::min(line.find_first_not_of(" \t"), line.size()));
}

MovedIndent moved_indent(const Piece& comment, std::string_view line, std::uint32_t column,
                         std::uint32_t furthest) noexcept {
    const std::uint32_t from = std::min(comment.first_column, furthest);
    const std::uint32_t to = std::min(column, furthest);
    const std::string_view indent = indent_of(line);
    const bool empty = indent.size() == line.size();
    if (empty || comment.verbatim || comment.pragma)
        return {0, indent};
    if (comment.blanks_before && indent.starts_with(comment.line_before))
        return {to, indent.substr(comment.line_before.size())};
    if (comment.tab_before) // nobody knows how wide it is
        return {0, indent};
    if (to >= from)
        return {to - from, indent};
    const std::size_t blanks = std::min(indent.find_first_not_of(' '), indent.size());
    return {0, indent.substr(std::min<std::size_t>(blanks, from - to))};
}

std::uint32_t width_of_last_line(std::string_view text, Encoding encoding) noexcept {
    return extent_of(text, encoding).width;
}

std::uint32_t leading_mark_size(const Unit& unit) noexcept {
    const std::uint32_t size = byte_order_mark_size(unit.text(), unit.encoding());
    const bool is_token = !unit.tokens().empty() && unit.tokens().front().offset() < size;
    return is_token ? 0 : size;
}

std::vector<Piece> pieces_of(const Unit& unit, std::uint32_t indent_width, TextRule* rule) {
    return Arranger(unit, indent_width, rule).arrange();
}

} // namespace iecfront::layout
