#pragma once

#include <iecfront/lexer/name.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace iecfront {

/// Finds which of `Count` names a word is, in any case (2.1.2): a hash table with linear probing,
/// made at compile time, in which most other words meet an empty slot at once.
template<std::size_t Count>
class NameTable {
public:
    explicit constexpr NameTable(const std::array<std::string_view, Count>& names) : names_(names) {
        slots_.fill(empty);
        for (std::size_t i = 0; i < Count; ++i) {
            std::size_t slot = first_slot(hash_name(names[i]));
            while (slots_[slot] != empty)
                slot = (slot + 1) % slot_count;
            slots_[slot] = static_cast<std::uint8_t>(i);
        }
    }

    /// The index of a word, of which `hash` is the `hash_name`; `Count` when it is none of the
    /// names.
    [[nodiscard]] constexpr std::size_t find(std::string_view word,
                                             std::uint32_t hash) const noexcept {
        for (std::size_t slot = first_slot(hash); slots_[slot] != empty;
             slot = (slot + 1) % slot_count)
            if (names_equal(names_[slots_[slot]], word))
                return slots_[slot];
        return Count;
    }

private:
    static constexpr std::size_t slot_count = 1024;
    static constexpr std::uint8_t empty = 0xFF;
    static_assert(Count < empty);

    [[nodiscard]] static constexpr std::size_t first_slot(std::uint32_t hash) noexcept {
        return hash % slot_count;
    }

    std::array<std::string_view, Count> names_;
    std::array<std::uint8_t, slot_count> slots_{};
};

} // namespace iecfront
