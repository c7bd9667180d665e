#pragma once

#include <string_view>

namespace iecfront {

/// True when `word` is very probably meant to be the keyword `meant`: equal but for underscores, or
/// at most two letters wrong, missing, extra or swapped (one in a short word).
[[nodiscard]] bool is_misspelling(std::string_view word, std::string_view meant) noexcept;

} // namespace iecfront
