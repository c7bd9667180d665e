#include "diagnostics/visible.hpp"

#include "source/utf8.hpp"

#include <algorithm>
#include <array>

namespace iecfront {
namespace {

struct CodePointSpan {
    char32_t first;
    char32_t last;
};

// Format characters and separators of Unicode's general categories Cc, Cf, Zl, Zp and Cs, and the
// blanks that look like a space or like nothing. Sorted.
constexpr std::array<CodePointSpan, 19> invisible = {{
    {0x0000, 0x001F}, {0x007F, 0x00A0}, {0x00AD, 0x00AD}, {0x034F, 0x034F},   {0x0600, 0x0605},
    {0x061C, 0x061C}, {0x115F, 0x1160}, {0x1680, 0x1680}, {0x17B4, 0x17B5},   {0x180B, 0x180F},
    {0x2000, 0x200F}, {0x2028, 0x202F}, {0x205F, 0x206F}, {0x3000, 0x3000},   {0xD800, 0xDFFF},
    {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF}, {0xFFF0, 0xFFFB}, {0xE0000, 0xE0FFF},
}};

void append_hex(std::string& out, char32_t value, unsigned digits) {
    while (digits < 6 && (value >> (4U * digits)) != 0)
        ++digits;
    for (unsigned i = digits; i-- > 0;)
        out += "0123456789ABCDEF"[(value >> (4U * i)) & 0xFU];
}

void append_byte(std::string& out, char byte) {
    out += "\\x";
    append_hex(out, static_cast<unsigned char>(byte), 2);
}

void append_character(std::string& out, std::string_view text, std::size_t offset,
                      const DecodedCharacter& character) {
    if (!character.valid || character.code_point < 0x20 || character.code_point == 0x7F) {
        append_byte(out, text[offset]);
    } else if (is_visible(character.code_point)) {
        append_utf8(out, character.code_point);
    } else {
        out += "\\u";
        append_hex(out, character.code_point, 4);
    }
}

// Number of characters in `text`, counted no further than `limit`.
[[nodiscard]] std::size_t character_count(std::string_view text, std::size_t limit,
                                          Encoding encoding) noexcept {
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size() && count < limit; ++count)
        at += decode_character(text, at, encoding).size;
    return count;
}

// Where the first `count` characters of `text` end.
[[nodiscard]] std::size_t end_of_characters(std::string_view text, std::size_t count,
                                            Encoding encoding) noexcept {
    std::size_t at = 0;
    for (; count > 0 && at < text.size(); --count)
        at += decode_character(text, at, encoding).size;
    return at;
}

// Where the last characters of `text`, about `count` of them, begin. UTF-8 is the only encoding in
// which a character has more than one byte, and its continuation bytes tell themselves apart.
[[nodiscard]] std::size_t begin_of_last_characters(std::string_view text, std::size_t count,
                                                   Encoding encoding) noexcept {
    const auto continues = [&](std::size_t i) {
        return encoding == Encoding::utf8 && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80;
    };
    std::size_t at = text.size();
    for (; count > 0 && at > 0; --count) {
        --at;
        for (int i = 0; i < 3 && at > 0 && continues(at); ++i)
            --at;
    }
    return at;
}

} // namespace

bool is_visible(char32_t code_point) noexcept {
    const auto* span =
        std::lower_bound(invisible.begin(), invisible.end(), code_point,
                         [](const CodePointSpan& row, char32_t value) { return row.last < value; });
    if (span != invisible.end() && span->first <= code_point)
        return code_point == U' ';
    const bool plane_end = (code_point & 0xFFFEU) == 0xFFFE; // never characters
    return !plane_end && code_point <= 0x10FFFF;
}

void append_visible(std::string& out, std::string_view text, Encoding encoding) {
    for (std::size_t at = 0; at < text.size();) {
        const DecodedCharacter character = decode_character(text, at, encoding);
        append_character(out, text, at, character);
        at += character.size;
    }
}

void append_shortened(std::string& out, std::string_view text, std::size_t width,
                      Encoding encoding) {
    if (text.size() <= width || character_count(text, width + 1, encoding) <= width) {
        append_visible(out, text, encoding);
        return;
    }
    constexpr std::string_view dots = "...";
    const std::size_t tail = (width - dots.size()) / 2;
    const std::size_t head = width - dots.size() - tail;
    append_visible(out, text.substr(0, end_of_characters(text, head, encoding)), encoding);
    out += dots;
    append_visible(out, text.substr(begin_of_last_characters(text, tail, encoding)), encoding);
}

void append_code_point_number(std::string& out, char32_t code_point) {
    out += "U+";
    append_hex(out, code_point, 4);
}

} // namespace iecfront
