#include "source/byte_mask.hpp"

#include <iecfront/source/line_table.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>

namespace iecfront {
namespace {

constexpr std::uint64_t ones = 0x0101010101010101U;
constexpr std::uint64_t high_bits = 0x8080808080808080U;

[[nodiscard]] std::uint64_t load_word(const char* bytes) noexcept {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, word_size);
    return word;
}

// The high bits of the bytes in `word` that are `byte`. The lowest of them is exact, those above it
// may be others: the well-known test for zero bytes, on the word with the sought byte turned into
// zero.
[[nodiscard]] constexpr std::uint64_t bytes_equal_to(unsigned char byte,
                                                     std::uint64_t word) noexcept {
    const std::uint64_t difference = word ^ (ones * byte);
    return (difference - ones) & ~difference & high_bits;
}

[[nodiscard]] constexpr bool is_line_end(char c) noexcept {
    return c == '\n' || c == '\r';
}

[[nodiscard]] constexpr bool ends_line_at(std::string_view text, std::size_t offset) noexcept {
    return ends_line(text[offset], offset + 1 < text.size() ? text[offset + 1] : '\0');
}

// Offset of the next LF or CR at or after `offset`, or the size of the text. Eight bytes at a time:
// most bytes of a source end no line.
[[nodiscard]] std::size_t find_line_end(std::string_view text, std::size_t offset) noexcept {
    while (text.size() - offset >= word_size) {
        const std::uint64_t word = load_word(text.data() + offset);
        const std::uint64_t found = bytes_equal_to('\n', word) | bytes_equal_to('\r', word);
        if (found != 0) {
            if constexpr (std::endian::native == std::endian::little)
                return offset + static_cast<std::size_t>(std::countr_zero(found)) / 8;
            break;
        }
        offset += word_size;
    }
    while (offset < text.size() && !is_line_end(text[offset]))
        ++offset;
    return offset;
}

[[nodiscard]] std::uint32_t width_of(const DecodedCharacter& character, ColumnUnit unit) noexcept {
    return unit == ColumnUnit::utf16_units && character.code_point > 0xFFFF ? 2 : 1;
}

// True when the next eight bytes of [offset, end) are eight ASCII characters: eight columns in any
// unit.
[[nodiscard]] bool eight_ascii(std::string_view text, std::size_t offset,
                               std::size_t end) noexcept {
    return end - offset >= word_size && is_ascii_word(text.data() + offset);
}

// Where the columns of a line are counted from. A byte order mark has none: no editor shows it.
[[nodiscard]] std::size_t first_column_offset(std::string_view text, std::uint32_t line_start,
                                              Encoding encoding) noexcept {
    return line_start == 0 ? byte_order_mark_size(text, encoding) : line_start;
}

// How many bytes of a character that goes on at `offset` stand before it; `begin` begins one.
[[nodiscard]] std::uint32_t part_of_character_before(std::string_view text, std::uint32_t begin,
                                                     std::uint32_t offset,
                                                     Encoding encoding) noexcept {
    constexpr std::uint32_t longest = 4; // bytes
    for (std::uint32_t size = 1; size < longest && offset - begin >= size; ++size)
        if (decode_character(text, offset - size, encoding).size > size)
            return size;
    return 0;
}

} // namespace

std::uint32_t count_line_ends(std::string_view text) noexcept {
    std::uint32_t count = 0;
    std::size_t at = 0;
    while (text.size() - at > mask_size) { // one more byte is looked at
        const std::size_t rows = std::min(most_rows, (text.size() - at - 1) / mask_size);
        count += count_line_ends_in(text.data() + at, rows);
        at += rows * mask_size;
    }
    for (; at < text.size(); ++at)
        count += ends_line_at(text, at) ? 1 : 0;
    return count;
}

LineTable::LineTable(std::string_view text) {
    constexpr std::size_t step = 4 * mask_size;
    const auto mask_of_step = [](const char* bytes, char sought) {
        std::uint64_t mask = 0;
        for (std::size_t i = 0; i < step; i += mask_size)
            mask |= std::uint64_t{mask_of(bytes + i, sought)} << i;
        return mask;
    };
    starts_.reserve(count_line_ends(text));
    std::uint32_t at = 0;
    for (; text.size() - at > step; at += step) { // one more byte is looked at
        const std::uint64_t feeds = mask_of_step(text.data() + at, '\n');
        const std::uint64_t returns = mask_of_step(text.data() + at, '\r');
        const std::uint64_t feeds_behind = feeds >> 1 | std::uint64_t{text[at + step] == '\n'}
                                                            << (step - 1);
        for (std::uint64_t ends = feeds | (returns & ~feeds_behind); ends != 0; ends &= ends - 1)
            starts_.push_back(at + static_cast<std::uint32_t>(std::countr_zero(ends)) + 1);
    }
    for (; at < text.size(); ++at)
        if (ends_line_at(text, at))
            starts_.push_back(at + 1);
}

LineTable::LineTable(std::string_view text, Encoding encoding) : LineTable(text) {
    constexpr std::uint32_t stretch = 4096; // bytes between two columns that are noted
    for (std::uint32_t line = 0; line <= line_end_count(); ++line) {
        const std::size_t behind = line < line_end_count() ? starts_[line] : text.size();
        if (behind - line_start(line) <= 2 * stretch)
            continue;
        const std::uint32_t end = line_end(text, line);
        KnownColumn known{line_start(line), 1};
        while (end - known.offset > 2 * stretch) {
            std::uint32_t next = known.offset + stretch;
            next -= part_of_character_before(text, known.offset, next, encoding);
            known.column +=
                column_of(text, known.offset, next, encoding, ColumnUnit::code_points) - 1;
            known.offset = next;
            known_columns_.push_back(known);
        }
    }
}

std::uint32_t LineTable::line_end(std::string_view text, std::uint32_t line) const noexcept {
    if (line == line_end_count())
        return static_cast<std::uint32_t>(text.size());
    const std::uint32_t next = line_start(line + 1);
    const bool two_bytes =
        next - line_start(line) > 1 && text[next - 1] == '\n' && text[next - 2] == '\r';
    return next - (two_bytes ? 2 : 1);
}

LineTable::KnownColumn LineTable::known_column(std::uint32_t offset) const noexcept {
    const KnownColumn start{line_start(line_of(offset)), 1};
    const auto behind = std::ranges::upper_bound(known_columns_, offset, {}, &KnownColumn::offset);
    if (behind == known_columns_.begin() || std::prev(behind)->offset < start.offset)
        return start;
    return *std::prev(behind);
}

std::uint32_t LineTable::line_of(std::uint32_t offset) const noexcept {
    const auto behind = std::upper_bound(starts_.begin(), starts_.end(), offset);
    return static_cast<std::uint32_t>(behind - starts_.begin());
}

std::uint32_t LineTable::line_start(std::uint32_t line) const noexcept {
    return line == 0 ? 0 : starts_[line - 1];
}

std::uint32_t column_of(std::string_view text, std::uint32_t line_start, std::uint32_t offset,
                        Encoding encoding, ColumnUnit unit) noexcept {
    if (unit == ColumnUnit::bytes)
        return offset - line_start + 1;
    const std::size_t end = std::min<std::size_t>(offset, text.size());
    std::uint32_t column = 1;
    std::size_t at = first_column_offset(text, line_start, encoding);
    while (at < end) {
        if (eight_ascii(text, at, end)) {
            at += word_size;
            column += word_size;
            continue;
        }
        const DecodedCharacter character = decode_character(text, at, encoding);
        at += character.size;
        if (at <= end) // else `offset` lies inside this character, and has its column
            column += width_of(character, unit);
    }
    return column;
}

std::uint32_t offset_of_column(std::string_view text, std::uint32_t line_start,
                               std::uint32_t column, Encoding encoding, ColumnUnit unit) noexcept {
    const std::size_t line_end = find_line_end(text, line_start);
    if (unit == ColumnUnit::bytes)
        return static_cast<std::uint32_t>(
            std::min<std::uint64_t>(line_end, std::uint64_t{line_start} + column - 1));
    std::uint32_t left = column - 1;
    std::size_t at = first_column_offset(text, line_start, encoding);
    while (left > 0 && at < line_end) {
        const DecodedCharacter character = decode_character(text, at, encoding);
        const std::uint32_t width = width_of(character, unit);
        if (width > left) // the second half of a surrogate pair
            break;
        left -= width;
        at += character.size;
    }
    return static_cast<std::uint32_t>(at);
}

} // namespace iecfront
