#pragma once

#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/standard_names.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace iecfront {

namespace detail {

// Not constexpr: tables that come to its call while they are made do not compile.
void do_not_compile();

// How long the name is that has some hash, as far as eleven bits tell.
class LengthsByHash {
public:
    // Not when two names of different lengths have the same bits: another shift parts them.
    template<std::size_t Count>
    explicit consteval LengthsByHash(const std::array<std::string_view, Count>& all) {
        for (const std::string_view name : all) {
            std::uint8_t& length = lengths_[slot(hash_name(name))];
            if (length != 0 && length != name.size())
                do_not_compile();
            length = static_cast<std::uint8_t>(name.size());
        }
    }
    [[nodiscard]] constexpr bool may_hold(std::size_t name_size,
                                          std::uint32_t hash) const noexcept {
        return lengths_[slot(hash)] == name_size;
    }

private:
    static constexpr std::size_t size = 2048;
    static constexpr unsigned shift = 6;

    [[nodiscard]] static constexpr std::size_t slot(std::uint32_t hash) noexcept {
        return (hash >> shift) % size;
    }
    std::array<std::uint8_t, size> lengths_{};
};

extern const LengthsByHash lengths_of_standard_names;

// The last three letters of names, folded, the last one in the highest byte.
class LastLetters {
public:
    explicit consteval LastLetters(std::initializer_list<std::string_view> endings) {
        for (const std::string_view ending : endings) {
            const std::uint32_t letters = letters_of(ending);
            if (letters_[slot(letters)] != 0)
                do_not_compile();
            letters_[slot(letters)] = letters;
        }
    }
    [[nodiscard]] constexpr bool hold(std::uint32_t letters) const noexcept {
        return letters_[slot(letters)] == letters;
    }
    [[nodiscard]] constexpr bool end(std::string_view name) const noexcept {
        return name.size() >= 3 && hold(letters_of(name.substr(name.size() - 3)));
    }

private:
    [[nodiscard]] static constexpr std::uint32_t letters_of(std::string_view ending) noexcept {
        return static_cast<std::uint32_t>(fold_name_bytes(load_bytes(ending.data(), 3)));
    }
    // The factor is one that gives each ending a slot of its own.
    [[nodiscard]] static constexpr std::size_t slot(std::uint32_t letters) noexcept {
        return letters * 0x855C3845U >> 28;
    }
    std::array<std::uint32_t, 16> letters_{};
};

// Of the elementary types, and of TIME_OF_DAY, in which the names end that are not listed.
inline constexpr LastLetters last_letters_of_types{"ORD", "TOD", "IME", "ATE", "YTE", "ING",
                                                   "OOL", "EAL", "INT", "_DT", "DAY"};

} // namespace detail

// What one look at a word tells.
struct NameLook {
    std::uint32_t hash;   // what `hash_name` gives
    bool may_be_standard; // false for most words that are no names of the standard
};

// The same for the `size` bytes, at least one, at `begin` in a text. Eight bytes are loaded at
// once, in a short word with what is before it, and without a branch on how long it is up to
// sixteen letters, which no processor foresees.
[[nodiscard]] inline NameLook look_at_name(const char* text, std::size_t begin,
                                           std::size_t size) noexcept {
    constexpr std::size_t step = sizeof(std::uint64_t);
    const std::size_t end = begin + size;
    if (end < step) [[unlikely]]
        return {hash_name({text + begin, size}), true};
    const auto load = [text](std::size_t place) {
        return detail::fold_name_bytes(detail::load_bytes(text + place, step));
    };
    const std::size_t not_of_word = 8 * (step - std::min(size, step)); // bits
    const std::uint64_t last = load(end - step);
    const std::uint64_t first = load(std::min(begin, end - step));
    std::uint64_t hash = detail::mix_folded(size, first >> not_of_word);
    for (std::size_t i = step; i + step < size; i += step)
        [[unlikely]] hash = detail::mix_folded(hash, load(begin + i));
    const auto all =
        static_cast<std::uint32_t>(detail::mix_folded(hash, last >> not_of_word) >> 32);
    return {all, detail::lengths_of_standard_names.may_hold(size, all) ||
                     detail::last_letters_of_types.hold(static_cast<std::uint32_t>(last >> 40))};
}

// What `standard_name` gives, for who has the `hash_name` of `name` already.
[[nodiscard]] StandardName find_standard_name(std::string_view name, std::uint32_t hash) noexcept;

} // namespace iecfront
