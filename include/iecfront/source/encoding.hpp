#pragma once

#include <iecfront/export.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace iecfront {

/// How the bytes of a source text stand for characters of ISO/IEC 10646 (2.1.1).
enum class Encoding : std::uint8_t {
    utf8,         ///< the default; a byte order mark is accepted and kept
    iso_8859_1,   ///< each byte is the code point of the same number
    windows_1252, ///< as ISO 8859-1, but 0x80..0x9F hold typographic characters
};

/// One character as it stands in the text.
struct DecodedCharacter {
    char32_t code_point = U'\uFFFD'; ///< U+FFFD when the bytes are broken
    std::uint32_t size = 1;          ///< bytes used, at least 1
    bool valid = false;              ///< false: the bytes mean nothing in this encoding
};

/// Decodes the character at byte `offset` of `text`; `offset < text.size()`. Broken UTF-8 gives one
/// invalid character of one byte at a time, so that decoding always goes on.
[[nodiscard]] IECFRONT_API DecodedCharacter decode_character(std::string_view text,
                                                             std::size_t offset,
                                                             Encoding encoding) noexcept;

/// `utf-8`, `iso-8859-1` or `windows-1252`.
[[nodiscard]] IECFRONT_API std::string_view to_string(Encoding encoding) noexcept;

/// Finds an encoding by name, in any case; also `utf8`, `latin-1`, `latin1`, `cp1252`. Nothing for
/// any other name.
[[nodiscard]] IECFRONT_API std::optional<Encoding>
encoding_from_string(std::string_view name) noexcept;

/// The size of the UTF-8 byte order mark at the start of `text`: 3, or 0 when there is none (always
/// 0 in another encoding). The mark counts as white space.
[[nodiscard]] IECFRONT_API std::uint32_t byte_order_mark_size(std::string_view text,
                                                              Encoding encoding) noexcept;

} // namespace iecfront
