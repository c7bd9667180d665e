#include "support/layout.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace iecfront::test {
namespace {

constexpr std::size_t width = 100;

/// Where the piece of an S-expression that begins at `begin` ends: at the blank or bracket behind
/// it, and not inside strings or groups of its own.
[[nodiscard]] std::size_t end_of_piece(std::string_view text, std::size_t begin) {
    std::size_t depth = 0;
    bool in_string = false;
    for (std::size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\')
                ++i;
            in_string = c != '"';
        } else if (c == '"') {
            in_string = true;
        } else if (c == '(' || c == '[') {
            ++depth;
        } else if (depth == 0 && (c == ' ' || c == ')' || c == ']')) {
            return i;
        } else if (c == ')' || c == ']') {
            --depth;
        }
    }
    return text.size();
}

/// The blank-separated pieces of what stands inside a group.
[[nodiscard]] std::vector<std::string_view> pieces_of(std::string_view inside) {
    std::vector<std::string_view> pieces;
    for (std::size_t at = 0; at < inside.size();) {
        const std::size_t end = end_of_piece(inside, at);
        pieces.push_back(inside.substr(at, end - at));
        at = end + 1;
    }
    return pieces;
}

/// True of a word like `var_input`, which stays with the head of its group.
[[nodiscard]] bool is_word(std::string_view piece) {
    return piece.find_first_of("([:") == std::string_view::npos || piece.front() == '"';
}

void append(std::string& out, std::string_view piece, std::size_t indent, std::size_t closers);

void append_group(std::string& out, std::string_view piece, std::size_t open, std::size_t indent,
                  std::size_t closers) {
    out += piece.substr(0, open + 1);
    const auto pieces = pieces_of(piece.substr(open + 1, piece.size() - open - 2));
    std::size_t next = 0;
    if (piece[open] == '(')
        for (; next < pieces.size() && is_word(pieces[next]); ++next) {
            if (next > 0)
                out += ' ';
            out += pieces[next];
        }
    for (; next < pieces.size(); ++next) {
        const std::size_t behind = next + 1 == pieces.size() ? closers + 1 : 0;
        if (pieces[next].front() == '[') { // the one list of a node stays with its head
            out += ' ';
            append_group(out, pieces[next], 0, indent, behind);
            continue;
        }
        out += '\n' + std::string(indent + 2, ' ');
        append(out, pieces[next], indent + 2, behind);
    }
    out += piece.back();
}

/// Appends `piece`, which begins in column `indent` and has `closers` brackets behind it.
void append(std::string& out, std::string_view piece, std::size_t indent, std::size_t closers) {
    const std::size_t open = piece.find_first_of("([\"");
    const bool group = open != std::string_view::npos && piece[open] != '"';
    if (!group || indent + piece.size() + closers <= width)
        out += piece;
    else
        append_group(out, piece, open, indent, closers);
}

} // namespace

std::string laid_out(std::string_view s_expression) {
    std::string out;
    append(out, s_expression, 0, 0);
    return out;
}

} // namespace iecfront::test
