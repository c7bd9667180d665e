#pragma once

#include <iecfront/export.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace iecfront {

/// A half-open stretch of source text, `[begin, end)`, counted in bytes from 0. What it is
/// relative to (a file, a unit, a literal) is said where it is used.
struct TextRange {
    std::uint32_t begin = 0; ///< the first byte
    std::uint32_t end = 0;   ///< one past the last byte; never before `begin`

    /// In bytes.
    [[nodiscard]] constexpr std::uint32_t size() const noexcept { return end - begin; }
    /// True for a place between two bytes.
    [[nodiscard]] constexpr bool empty() const noexcept { return begin == end; }

    /// True when the byte at `offset` lies inside.
    [[nodiscard]] constexpr bool contains(std::uint32_t offset) const noexcept {
        return begin <= offset && offset < end;
    }
    /// True when `other` lies inside, or is the same; also an empty range at either end.
    [[nodiscard]] constexpr bool contains(TextRange other) const noexcept {
        return begin <= other.begin && other.end <= end;
    }
    /// The same stretch, `distance` bytes further on: from unit-relative to file-relative.
    [[nodiscard]] constexpr TextRange shifted(std::uint32_t distance) const noexcept {
        return {begin + distance, end + distance};
    }

    friend constexpr bool operator==(TextRange, TextRange) noexcept = default;
};

/// Puts `replacement` in the place of the bytes in `range`. An empty range inserts.
struct TextEdit {
    TextRange range;         ///< relative to what the edit belongs to: a unit, a file
    std::string replacement; ///< bytes in the encoding of the text; none removes

    friend bool operator==(const TextEdit&, const TextEdit&) = default;
};

/// `text` with all of `edits` made, whose ranges all refer to `text` as it is given. They are
/// ordered by position; one that overlaps the one before it, or reaches beyond the text, is left
/// out.
[[nodiscard]] IECFRONT_API std::string apply_edits(std::string_view text,
                                                   std::span<const TextEdit> edits);

} // namespace iecfront
