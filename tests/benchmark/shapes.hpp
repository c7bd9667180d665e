#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace iecfront::bench {

/// A text of any size that would cost more than in proportion to it, if anything were looked up or
/// read again for each piece: a beginning, one piece again and again, a word between, another piece
/// as often, and an end.
struct Shape {
    std::string_view name; ///< a word
    std::string_view begin;
    std::string_view first;
    std::string_view between = {};
    std::string_view second = {};
    std::string_view end = {};

    /// A text of about `size` bytes.
    [[nodiscard]] std::string text(std::size_t size) const;
};

/// All of them.
[[nodiscard]] std::span<const Shape> shapes() noexcept;

} // namespace iecfront::bench
