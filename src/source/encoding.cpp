#include "source/ascii.hpp"

#include <iecfront/source/encoding.hpp>

#include <array>

namespace iecfront {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// What Windows-1252 has in the place of the control characters 0x80..0x9F; 0 where it has nothing.
constexpr std::array<char16_t, 32> windows_1252_high = {
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, //
    0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017D, 0,      //
    0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, //
    0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178,
};

[[nodiscard]] DecodedCharacter decode_windows_1252(unsigned char byte) noexcept {
    if (byte < 0x80 || byte > 0x9F)
        return {byte, 1, true};
    const char16_t code_point = windows_1252_high[byte - 0x80U];
    if (code_point == 0)
        return {byte, 1, false};
    return {code_point, 1, true};
}

// How a sequence goes on after its lead byte. The bounds of the second byte are what shuts out
// overlong forms, surrogates and everything above U+10FFFF (Unicode, table 3-7).
struct SequenceForm {
    std::uint32_t size = 0; // 0: no sequence begins with this byte
    unsigned char second_from = 0x80;
    unsigned char second_to = 0xBF;
    unsigned char lead_bits = 0; // mask of the bits that belong to the code point
};

[[nodiscard]] constexpr SequenceForm sequence_form(unsigned char lead) noexcept {
    if (lead < 0xC2 || lead > 0xF4)
        return {};
    if (lead < 0xE0)
        return {2, 0x80, 0xBF, 0x1F};
    switch (lead) {
    case 0xE0: return {3, 0xA0, 0xBF, 0x0F};
    case 0xED: return {3, 0x80, 0x9F, 0x0F};
    case 0xF0: return {4, 0x90, 0xBF, 0x07};
    case 0xF4: return {4, 0x80, 0x8F, 0x07};
    default: break;
    }
    if (lead < 0xF0)
        return {3, 0x80, 0xBF, 0x0F};
    return {4, 0x80, 0xBF, 0x07};
}

[[nodiscard]] DecodedCharacter decode_utf8(std::string_view text, std::size_t offset) noexcept {
    const auto byte_at = [&](std::size_t i) {
        return static_cast<unsigned char>(text[offset + i]);
    };
    const unsigned char lead = byte_at(0);
    if (lead < 0x80)
        return {lead, 1, true};
    const SequenceForm form = sequence_form(lead);
    if (form.size == 0 || text.size() - offset < form.size)
        return {};
    if (byte_at(1) < form.second_from || byte_at(1) > form.second_to)
        return {};
    char32_t code_point = lead & form.lead_bits;
    for (std::uint32_t i = 1; i < form.size; ++i) {
        if ((byte_at(i) & 0xC0U) != 0x80)
            return {};
        code_point = (code_point << 6U) | (byte_at(i) & 0x3FU);
    }
    return {code_point, form.size, true};
}

} // namespace

DecodedCharacter decode_character(std::string_view text, std::size_t offset,
                                  Encoding encoding) noexcept {
    const auto byte = static_cast<unsigned char>(text[offset]);
    switch (encoding) {
    case Encoding::utf8: break;
    case Encoding::iso_8859_1: return {byte, 1, true};
    case Encoding::windows_1252: return decode_windows_1252(byte);
    }
    return decode_utf8(text, offset);
}

std::string_view to_string(Encoding encoding) noexcept {
    switch (encoding) {
    case Encoding::utf8: break;
    case Encoding::iso_8859_1: return "iso-8859-1";
    case Encoding::windows_1252: return "windows-1252";
    }
    return "utf-8";
}

std::optional<Encoding> encoding_from_string(std::string_view name) noexcept {
    struct Row {
        std::string_view name;
        Encoding encoding;
    };
    static constexpr std::array<Row, 7> rows = {{
        {"utf-8", Encoding::utf8},
        {"utf8", Encoding::utf8},
        {"iso-8859-1", Encoding::iso_8859_1},
        {"latin-1", Encoding::iso_8859_1},
        {"latin1", Encoding::iso_8859_1},
        {"windows-1252", Encoding::windows_1252},
        {"cp1252", Encoding::windows_1252},
    }};
    for (const Row& row : rows)
        if (equal_in_any_case(row.name, name))
            return row.encoding;
    return std::nullopt;
}

std::uint32_t byte_order_mark_size(std::string_view text, Encoding encoding) noexcept {
    if (encoding != Encoding::utf8 || !text.starts_with(byte_order_mark))
        return 0;
    return static_cast<std::uint32_t>(byte_order_mark.size());
}

} // namespace iecfront
