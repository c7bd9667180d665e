#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace iecfront {

// The literal of base 16 that a word of another language stands for: `16#FF` for `0FFh`, `$FF`, and
// for `16FF`, where only the `#` is missing. Empty when it evidently stands for none.
[[nodiscard]] std::string meant_hexadecimal(std::string_view word);

// The length of what stands before a keyword that a number has run into: 1 of `3MOD`. Zero when the
// text does not end in a keyword that can follow a number.
[[nodiscard]] std::size_t size_before_keyword(std::string_view text) noexcept;

} // namespace iecfront
