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

// How long the name is that has some hash, as far as eleven bits tell.
class LengthsByHash {
public:
    template<std::size_t Count>
    explicit consteval LengthsByHash(const std::array<std::string_view, Count>& names) {
        while (!add_all(names))
            ++shift_; // the bits where names of different lengths have the same value
    }
    [[nodiscard]] constexpr bool may_hold(std::string_view name,
                                          std::uint32_t hash) const noexcept {
        return lengths_[slot(hash)] == name.size();
    }

private:
    static constexpr std::size_t size = 2048;

    template<std::size_t Count>
    constexpr bool add_all(const std::array<std::string_view, Count>& names) {
        lengths_ = {};
        for (const std::string_view name : names) {
            std::uint8_t& length = lengths_[slot(hash_name(name))];
            if (length != 0 && length != name.size())
                return false;
            length = static_cast<std::uint8_t>(name.size());
        }
        return true;
    }
    [[nodiscard]] constexpr std::size_t slot(std::uint32_t hash) const noexcept {
        return (hash >> shift_) % size;
    }

    std::uint32_t shift_ = 0;
    std::array<std::uint8_t, size> lengths_{};
};

// Of the names that are listed.
extern const LengthsByHash standard_name_lengths;

// The last two letters of the elementary types, and of TIME_OF_DAY, in which the names end that are
// not listed: for each last letter the ones before it, as bits. Other bytes may pass for letters.
class LastLetters {
public:
    explicit consteval LastLetters(std::initializer_list<std::string_view> endings) {
        for (const std::string_view ending : endings)
            before_[row(ending[1])] |= bit(ending[0]);
    }
    [[nodiscard]] constexpr bool end(std::string_view name) const noexcept {
        return name.size() >= 2 && (before_[row(name.back())] & bit(name[name.size() - 2])) != 0;
    }

private:
    static constexpr std::size_t row(char letter) noexcept { return letter & 0x5FU; } // any case
    static constexpr std::uint32_t bit(char letter) noexcept { return 1U << (letter & 0x1FU); }
    std::array<std::uint32_t, 0x60> before_{};
};

inline constexpr LastLetters last_letters_of_types{"RD", "OD", "ME", "TE", "NG",
                                                   "OL", "AL", "NT", "DT", "AY"};

} // namespace detail

// False for most names that are none of the standard; `hash` is the `hash_name` of `name`.
[[nodiscard]] inline bool may_be_standard_name(std::string_view name, std::uint32_t hash) noexcept {
    return detail::standard_name_lengths.may_hold(name, hash) ||
           detail::last_letters_of_types.end(name);
}

// What `standard_name` gives, for who has the `hash_name` of `name` already.
[[nodiscard]] StandardName find_standard_name(std::string_view name, std::uint32_t hash) noexcept;

} // namespace iecfront
