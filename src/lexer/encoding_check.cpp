#include "lexer/encoding_check.hpp"

#include "source/byte_mask.hpp"

#include <cstdint>
#include <string>

namespace iecfront {
namespace {

/// How many bytes from `offset` on are ASCII, which nearly all of a text is, as far as two looks
/// tell.
[[nodiscard]] std::size_t size_of_ascii(std::string_view text, std::size_t offset) noexcept {
    const std::size_t left = text.size() - offset;
    if (left >= block_size && is_ascii_block(text.data() + offset))
        return block_size;
    return left >= word_size && is_ascii_word(text.data() + offset) ? word_size : 0;
}

[[nodiscard]] Diagnostic broken_byte(std::string_view text, std::uint32_t offset,
                                     Encoding encoding) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(text[offset]);
    Diagnostic diagnostic{DiagnosticId::broken_encoding, {offset, offset + 1}, {}, {}, {}};
    diagnostic.arguments.emplace_back(std::string("16#") + digits[byte / 16] + digits[byte % 16]);
    diagnostic.arguments.emplace_back(std::string(to_string(encoding)));
    return diagnostic;
}

} // namespace

std::optional<Diagnostic> check_encoding(std::string_view text, Encoding encoding) {
    if (encoding == Encoding::iso_8859_1)
        return std::nullopt; // every byte is a character
    for (std::size_t offset = 0; offset < text.size();) {
        if (const std::size_t size = size_of_ascii(text, offset); size > 0) {
            offset += size;
            continue;
        }
        const DecodedCharacter character = decode_character(text, offset, encoding);
        if (!character.valid)
            return broken_byte(text, static_cast<std::uint32_t>(offset), encoding);
        offset += character.size;
    }
    return std::nullopt;
}

} // namespace iecfront
