#include "lexer/encoding_check.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

namespace iecfront {
namespace {

/// How many bytes from `offset` on are ASCII as a block of so many words, which nearly all of a
/// text is.
template<std::size_t Words>
[[nodiscard]] std::size_t ascii_block(std::string_view text, std::size_t offset) noexcept {
    constexpr std::uint64_t high_bits = 0x8080808080808080U;
    std::array<std::uint64_t, Words> words;
    if (text.size() - offset < sizeof words)
        return 0;
    std::memcpy(words.data(), text.data() + offset, sizeof words);
    std::uint64_t all = 0;
    for (const std::uint64_t word : words)
        all |= word;
    return (all & high_bits) == 0 ? sizeof words : 0;
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
        std::size_t size = ascii_block<16>(text, offset);
        if (size == 0)
            size = ascii_block<1>(text, offset);
        if (size > 0) {
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
