#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace iecfront::cli {

/// How many letters have to be changed, added, removed or swapped with their neighbour to make `b`
/// of `a`. Case does not count.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// "; did you mean `x` or `y`?", with the names that `word` is very probably meant to be; empty
/// when there is none.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> names);

} // namespace iecfront::cli
