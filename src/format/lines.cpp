#include "format/lines.hpp"

#include <algorithm>
#include <vector>

namespace iecfront::layout {
namespace {

// Words behind which an expression stands; its lines begin below its first one.
[[nodiscard]] bool precedes_expression(TokenKind kind) noexcept {
    switch (kind) {
    case TokenKind::assign:
    case TokenKind::output_arrow:
    case TokenKind::kw_if:
    case TokenKind::kw_elsif:
    case TokenKind::kw_while:
    case TokenKind::kw_until:
    case TokenKind::kw_case: return true;
    default: return false;
    }
}

/// What is open where a line is broken: parentheses, or the statement as a whole.
struct Level {
    std::uint32_t list = 0;       ///< the column of lines that begin with an element of the list
    std::uint32_t expression = 0; ///< and of those that begin with an operator
    std::uint32_t line = 0;       ///< the column of the line that opens it
};

/// Places what is one line as long as it is not broken.
class LineBreaker {
public:
    LineBreaker(std::uint32_t indent_width, std::uint32_t line_length)
        : indent_width_(indent_width), line_length_(line_length) {}

    void place(std::span<Piece> pieces);

private:
    void drop_breaks_before_closing(std::span<Piece> pieces);
    [[nodiscard]] bool fits(std::span<const Piece> pieces) const;
    void measure_chunks(std::span<const Piece> pieces);
    void place(Piece& piece, const Piece* before, std::uint32_t chunk);
    [[nodiscard]] bool breaks_before(const Piece& piece, std::uint32_t chunk) const;
    [[nodiscard]] std::uint32_t spaces_before(const Piece& piece) const;
    [[nodiscard]] std::uint32_t column_of_line(const Piece& piece, const Piece* before);
    [[nodiscard]] std::uint32_t indent_of_last_line(const Piece& piece) const noexcept;
    void place_verbatim(Piece& piece);
    void open_and_close(const Piece& piece);

    std::uint32_t indent_width_;
    std::uint32_t line_length_;
    std::uint32_t column_ = 0;      // behind the last piece
    std::uint32_t line_column_ = 0; // where the line begins
    bool expression_begins_ = false;
    std::vector<Level> levels_;
    std::vector<std::uint32_t> chunks_; // for each piece, see `measure_chunks`
    std::vector<std::uint32_t> open_;   // scratch
};

void LineBreaker::place(std::span<Piece> pieces) {
    const auto level = static_cast<std::uint32_t>(pieces.front().level);
    levels_.assign(1, {level + indent_width_, level + indent_width_, level});
    expression_begins_ = false;
    drop_breaks_before_closing(pieces);
    const bool needs_no_break = fits(pieces);
    if (!needs_no_break)
        measure_chunks(pieces);
    const Piece* before = nullptr;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        place(pieces[i], before, needs_no_break ? 0 : chunks_[i]);
        before = &pieces[i];
    }
}

// The parenthesis that closes a list stands on a line of its own only if the elements begin below
// the one that opens it.
void LineBreaker::drop_breaks_before_closing(std::span<Piece> pieces) {
    open_.clear();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (opens_bracket(pieces[i].kind)) {
            open_.push_back(static_cast<std::uint32_t>(i));
        } else if (closes_bracket(pieces[i].kind)) {
            const bool hangs = !open_.empty() && pieces[open_.back() + 1].line_break == Break::kept;
            if (!open_.empty())
                open_.pop_back();
            const bool forced = i == 0 || pieces[i - 1].is_comment() || pieces[i].verbatim ||
                                pieces[i - 1].verbatim;
            if (!hangs && !forced && pieces[i].line_break == Break::kept)
                pieces[i].line_break = Break::none;
        }
    }
}

bool LineBreaker::fits(std::span<const Piece> pieces) const {
    std::uint64_t width = static_cast<std::uint64_t>(pieces.front().level);
    for (const Piece& piece : pieces)
        if (!piece.behind)
            width += piece.width + (piece.space ? 1U : 0U);
    return width <= line_length_;
}

// The chunk of a piece are the columns from it to the next place where a line ends or can be broken
// as well as before this piece.
void LineBreaker::measure_chunks(std::span<const Piece> pieces) {
    struct Place {
        std::uint64_t rank;
        std::uint32_t begin; // columns from the beginning of all pieces to this one
    };
    std::vector<Place> places;
    std::uint32_t behind = 0;
    for (const Piece& piece : pieces)
        behind += piece.behind ? 0 : piece.width + (piece.space ? 1U : 0U);
    std::uint32_t line_end = behind;
    chunks_.assign(pieces.size(), 0);
    for (std::size_t i = pieces.size(); i-- > 0;) {
        const Piece& piece = pieces[i];
        if (piece.behind)
            continue;
        const std::uint32_t begin = behind - piece.width;
        behind = begin - (piece.space ? 1U : 0U);
        if (piece.line_break == Break::kept) {
            places.clear();
            line_end = behind;
        } else if (piece.line_break == Break::allowed) {
            const std::uint64_t rank = (std::uint64_t{piece.brackets} << 8U) + piece.rank;
            while (!places.empty() && places.back().rank > rank)
                places.pop_back();
            chunks_[i] = (places.empty() ? line_end : places.back().begin) - begin;
            places.push_back({rank, behind});
        }
    }
}

void LineBreaker::place(Piece& piece, const Piece* before, std::uint32_t chunk) {
    piece.begins_line = before == nullptr || breaks_before(piece, chunk);
    if (piece.verbatim) {
        place_verbatim(piece);
    } else {
        // Not far to the right, however long the line above: there can be many of them.
        piece.spaces = piece.begins_line ? std::min(column_of_line(piece, before), line_length_)
                                         : spaces_before(piece);
        piece.column = (piece.begins_line ? 0 : column_) + piece.spaces;
    }
    if (piece.begins_line)
        line_column_ = piece.column;
    if (piece.several_lines)
        piece.width += indent_of_last_line(piece);
    if (!piece.behind)
        column_ = piece.width + (piece.several_lines ? 0 : piece.column);
    if (expression_begins_ && !piece.is_comment()) {
        levels_.back().expression = piece.column;
        expression_begins_ = false;
    }
    open_and_close(piece);
}

bool LineBreaker::breaks_before(const Piece& piece, std::uint32_t chunk) const {
    if (piece.line_break == Break::allowed)
        return column_ + (piece.space ? 1 : 0) + chunk > line_length_;
    return piece.line_break >= Break::kept;
}

std::uint32_t LineBreaker::spaces_before(const Piece& piece) const {
    if (piece.behind && !piece.pragma)
        return blanks_before_comment;
    const std::uint32_t least = piece.space ? 1 : 0;
    const auto level = std::min(static_cast<std::uint32_t>(piece.level), line_length_);
    const auto stop = level + static_cast<std::uint32_t>(piece.stop);
    return piece.stop >= 0 && stop > column_ + least ? stop - column_ : least;
}

std::uint32_t LineBreaker::column_of_line(const Piece& piece, const Piece* before) {
    if (before == nullptr)
        return static_cast<std::uint32_t>(piece.level);
    Level& level = levels_.back();
    if (closes_bracket(piece.kind))
        return level.line;
    if (opens_bracket(before->kind)) {
        level.list = level.line + indent_width_;
        level.expression = level.list;
    }
    const bool in_list = piece.is_comment() || expression_begins_ || piece.rank == 0;
    return in_list ? level.list : level.expression;
}

// Of a comment that has its place.
std::uint32_t LineBreaker::indent_of_last_line(const Piece& piece) const noexcept {
    return moved_indent(piece, last_line(piece.text), piece.column, line_length_).width();
}

void LineBreaker::place_verbatim(Piece& piece) {
    const std::size_t line_end = piece.gap.find_last_of("\r\n");
    const std::size_t indent = line_end == std::string_view::npos ? 0 : line_end + 1;
    piece.spaces = static_cast<std::uint32_t>(piece.gap.size() - indent);
    piece.column = (piece.begins_line ? 0 : column_) + piece.spaces;
}

void LineBreaker::open_and_close(const Piece& piece) {
    if (opens_bracket(piece.kind))
        levels_.push_back({column_, column_, line_column_});
    else if (closes_bracket(piece.kind) && levels_.size() > 1)
        levels_.pop_back();
    else if (piece.kind == TokenKind::comma)
        levels_.back().expression = levels_.back().list;
    else if (precedes_expression(piece.kind))
        expression_begins_ = true;
}

// A line can have been broken behind a comment that stood inside of it.
void mark_comments_behind(std::span<Piece> pieces) {
    for (std::size_t i = pieces.size(); i-- > 1;) {
        const bool ends_line = i + 1 == pieces.size() || pieces[i + 1].begins_line;
        const bool ends_comments = ends_line || pieces[i + 1].behind;
        if (!ends_comments || !pieces[i].is_comment() || pieces[i].begins_line || pieces[i].behind)
            continue;
        pieces[i].behind = true;
        pieces[i].source_column = Piece::no_column;
        if (!ends_line)
            pieces[i + 1].behind = false;
    }
}

} // namespace

void break_lines(std::span<Piece> pieces, std::uint32_t indent_width, std::uint32_t line_length) {
    LineBreaker breaker(indent_width, line_length);
    for (std::size_t begin = 0; begin < pieces.size();) {
        std::size_t end = begin + 1;
        while (end < pieces.size() && pieces[end].line_break != Break::line)
            ++end;
        breaker.place(pieces.subspan(begin, end - begin));
        begin = end;
    }
    mark_comments_behind(pieces);
}

} // namespace iecfront::layout
