#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace iecfront {

/// True when `word` is very probably meant to be the keyword `meant`: equal but for underscores, or
/// at most two letters wrong, missing, extra or swapped (one in a short word).
[[nodiscard]] bool is_misspelling(std::string_view word, std::string_view meant) noexcept;

/// How many letters are then wrong; nothing when `meant` is not meant.
[[nodiscard]] std::optional<std::size_t> misspelt_letters(std::string_view word,
                                                          std::string_view meant) noexcept;

/// True when `word` is the beginning of the keyword `meant`, and long enough to tell: `CONFIG`.
[[nodiscard]] bool is_beginning(std::string_view word, std::string_view meant) noexcept;

/// True when `word` is short for the closing word `meant`: its beginning (`END_CONF`), or END with
/// the first letters of its parts (`END_FB`).
[[nodiscard]] bool is_abbreviation(std::string_view word, std::string_view meant) noexcept;

} // namespace iecfront
