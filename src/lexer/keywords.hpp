#pragma once

#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/token.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace iecfront {

namespace keywords {

inline constexpr std::array spellings = {
#define IECFRONT_KEYWORD(enumerator, spelling) std::string_view(spelling),
#include <iecfront/lexer/tokens.def>
};

// Bytes of a word that are looked at as one number.
inline constexpr std::size_t head_size = 8;

// The first bytes of a word, folded; the first byte is the lowest.
[[nodiscard]] constexpr std::uint64_t head_of(std::string_view word) noexcept {
    return detail::fold_name_bytes(
        detail::load_bytes(word.data(), std::min(word.size(), head_size)));
}

// What tells each keyword from all others. The last one is of no word at all.
struct Entry {
    std::uint64_t head = ~std::uint64_t{0};
    std::size_t size = 0;
};
inline constexpr std::uint8_t no_keyword = spellings.size();

[[nodiscard]] consteval std::array<Entry, spellings.size() + 1> entry_table() {
    std::array<Entry, spellings.size() + 1> table{};
    for (std::size_t i = 0; i < spellings.size(); ++i)
        table[i] = {head_of(spellings[i]), spellings[i].size()};
    return table;
}

inline constexpr auto entries = entry_table();

// 106 words occupy a slot in twenty, and a multiplier without collisions is found within the limits
// that compilers set to constant evaluation.
inline constexpr unsigned slot_bits = 11;

[[nodiscard]] constexpr std::size_t slot(Entry entry, std::uint64_t multiplier) noexcept {
    return static_cast<std::size_t>((entry.head + entry.size) * multiplier >> (64 - slot_bits));
}

using SlotTable = std::array<std::uint8_t, std::size_t{1} << slot_bits>;

// False when two keywords would share a slot.
[[nodiscard]] constexpr bool tells_apart(std::uint64_t multiplier) {
    std::array<bool, std::size_t{1} << slot_bits> occupied{};
    for (std::size_t i = 0; i < spellings.size(); ++i) {
        bool& here = occupied[slot(entries[i], multiplier)];
        if (here)
            return false;
        here = true;
    }
    return true;
}

[[nodiscard]] consteval std::uint64_t find_multiplier() {
    std::uint64_t multiplier = 0x9E3779B97F4A7C15U; // odd, of mixed bits
    while (!tells_apart(multiplier))
        multiplier += 2;
    return multiplier;
}

inline constexpr std::uint64_t multiplier = find_multiplier();

[[nodiscard]] consteval SlotTable slot_table() {
    SlotTable table{};
    table.fill(no_keyword);
    for (std::size_t i = 0; i < spellings.size(); ++i)
        table[slot(entries[i], multiplier)] = static_cast<std::uint8_t>(i);
    return table;
}

inline constexpr SlotTable slots = slot_table();

// True when `word` is keyword `index`, which has the same size and begins alike.
[[nodiscard]] bool ends_alike(std::string_view word, std::uint8_t index) noexcept;

} // namespace keywords

// `keyword_kind` of letters, digits and underscores only, whose `keywords::head_of` is known.
[[nodiscard]] inline TokenKind keyword_kind(std::string_view word, std::uint64_t head) noexcept {
    const std::uint8_t index =
        keywords::slots[keywords::slot({head, word.size()}, keywords::multiplier)];
    const keywords::Entry& entry = keywords::entries[index];
    // Chosen without a branch: no processor foresees which words are keywords.
    bool same = (entry.head == head) & (entry.size == word.size());
    if (same & (entry.size > keywords::head_size)) [[unlikely]]
        same = keywords::ends_alike(word, index);
    constexpr auto identifier = static_cast<std::uint32_t>(TokenKind::identifier);
    const std::uint32_t chosen = 0U - static_cast<std::uint32_t>(same); // all bits, or none
    return static_cast<TokenKind>(identifier ^ ((index ^ identifier) & chosen));
}

// The kind of keyword that `word` is in any case of its letters; `identifier` when it is none. One
// probe.
[[nodiscard]] TokenKind keyword_kind(std::string_view word) noexcept;

} // namespace iecfront
