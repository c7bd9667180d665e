#pragma once

#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/token.hpp>

#include <array>
#include <cstdint>
#include <string_view>

namespace iecfront {

namespace keywords {

inline constexpr std::array spellings = {
#define IECFRONT_KEYWORD(enumerator, spelling) std::string_view(spelling),
#include <iecfront/lexer/tokens.def>
};

inline constexpr std::size_t shortest = 2;
inline constexpr std::size_t longest = 18;

// 106 words occupy a slot in ten, so that most names are told from keywords without a look at their
// text; and a multiplier without collisions is found within the limits that compilers set to
// constant evaluation.
inline constexpr unsigned slot_bits = 10;
inline constexpr std::uint8_t empty_slot = 0xFF;

// The first two, the middle and the last two letters and the length tell all keywords apart.
// Clearing bit 5 folds letters and maps nothing else that a word can hold to a letter.
[[nodiscard]] constexpr std::uint32_t key(const char* word, std::size_t size) noexcept {
    const auto byte = [word](std::size_t i) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(word[i]));
    };
    const std::uint32_t ends = byte(0) | byte(1) << 8 | byte(size - 2) << 16 | byte(size - 1) << 24;
    const std::uint32_t middle = byte(size / 2) & 0xDFU;
    return (ends & 0xDFDFDFDFU) + (middle << 5) + (static_cast<std::uint32_t>(size) << 12);
}

[[nodiscard]] constexpr std::uint32_t slot(std::uint32_t key, std::uint32_t multiplier) noexcept {
    return key * multiplier >> (32 - slot_bits);
}

using SlotTable = std::array<std::uint8_t, std::size_t{1} << slot_bits>;

// False when two keywords would share a slot.
[[nodiscard]] constexpr bool tells_apart(std::uint32_t multiplier) {
    std::array<bool, std::size_t{1} << slot_bits> occupied{};
    for (const std::string_view word : spellings) {
        bool& entry = occupied[slot(key(word.data(), word.size()), multiplier)];
        if (entry)
            return false;
        entry = true;
    }
    return true;
}

[[nodiscard]] consteval std::uint32_t find_multiplier() {
    std::uint32_t multiplier = 0x9E3779B1U; // odd, of mixed bits; the 82nd trial succeeds
    while (!tells_apart(multiplier))
        multiplier += 2;
    return multiplier;
}

inline constexpr std::uint32_t multiplier = find_multiplier();

[[nodiscard]] consteval SlotTable slot_table() {
    SlotTable table{};
    for (std::uint8_t& entry : table)
        entry = empty_slot;
    for (std::size_t i = 0; i < spellings.size(); ++i)
        table[slot(key(spellings[i].data(), spellings[i].size()), multiplier)] =
            static_cast<std::uint8_t>(i);
    return table;
}

inline constexpr SlotTable slots = slot_table();

} // namespace keywords

// The kind of keyword that `word`, made of letters, digits and underscores only, is in any case of
// its letters; `identifier` when it is none. One probe.
[[nodiscard]] inline TokenKind keyword_kind(const char* word, std::size_t size) noexcept {
    if (size < keywords::shortest || size > keywords::longest)
        return TokenKind::identifier;
    const std::uint8_t index =
        keywords::slots[keywords::slot(keywords::key(word, size), keywords::multiplier)];
    if (index == keywords::empty_slot)
        return TokenKind::identifier;
    const std::string_view spelling = keywords::spellings[index];
    if (spelling.size() != size)
        return TokenKind::identifier;
    for (std::size_t i = 0; i < size; ++i)
        if (fold(word[i]) != spelling[i])
            return TokenKind::identifier;
    return static_cast<TokenKind>(index);
}

[[nodiscard]] inline TokenKind keyword_kind(std::string_view word) noexcept {
    return keyword_kind(word.data(), word.size());
}

} // namespace iecfront
