#pragma once

#include <iecfront/export.hpp>
#include <iecfront/source/encoding.hpp>
#include <iecfront/source/line_table.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace iecfront {

/// Where a text begins in the file that it is a piece of.
struct Origin {
    std::uint32_t offset = 0; ///< in bytes, of the text's first byte
    std::uint32_t line = 1;   ///< 1-based, of the text's first line
    std::uint32_t column = 1; ///< 1-based, of the text's first character, in code points
    /// The same column in UTF-16 units and in bytes, for who asks for them; 0 where it is the same
    /// number, as it is when only ASCII stands before the text on its line.
    std::uint32_t column_in_utf16_units = 0;
    std::uint32_t column_in_bytes = 0; ///< see there

    /// The column in the given unit.
    [[nodiscard]] constexpr std::uint32_t column_in(ColumnUnit unit) const noexcept {
        if (unit == ColumnUnit::utf16_units && column_in_utf16_units != 0)
            return column_in_utf16_units;
        return unit == ColumnUnit::bytes && column_in_bytes != 0 ? column_in_bytes : column;
    }

    friend constexpr bool operator==(Origin, Origin) noexcept = default;
};

/// A place in a file that a text may be a piece of.
struct HostPlace {
    std::uint32_t offset = 0; ///< in bytes, from the start of the file
    Position position;        ///< its line and column there

    friend constexpr bool operator==(HostPlace, HostPlace) noexcept = default;
};

/// The bytes of one source file, with the name to report them under. Immutable; copies share the
/// bytes, and so may be handed to several threads.
class IECFRONT_API SourceText {
public:
    /// The largest text that can be read, in bytes: 4 GiB minus 1. Offsets are 32 bits wide.
    static constexpr std::uint64_t maximum_size = std::numeric_limits<std::uint32_t>::max();

    /// Takes over `bytes`. `name` is what diagnostics call the file; it is never opened. A text
    /// above `maximum_size` is refused: it becomes empty and `too_large()`, and parsing it gives
    /// the diagnostic `source-too-large`.
    explicit SourceText(std::string bytes, std::string name = {},
                        Encoding encoding = Encoding::utf8);

    /// A text over bytes that are shared already; `buffer` is not null and not above
    /// `maximum_size`.
    explicit SourceText(std::shared_ptr<const std::string> buffer, std::string name = {},
                        Encoding encoding = Encoding::utf8)
        : buffer_(std::move(buffer)), name_(std::move(name)), encoding_(encoding) {}

    /// All bytes, a byte order mark included. A zero byte stands behind the last one.
    [[nodiscard]] std::string_view bytes() const noexcept { return *buffer_; }
    /// What diagnostics call the file, as it was given; may be empty.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    /// What the bytes are read as. Nothing is converted.
    [[nodiscard]] Encoding encoding() const noexcept { return encoding_; }
    /// True when the text was refused because it is above `maximum_size`. It is empty then.
    [[nodiscard]] bool too_large() const noexcept { return too_large_; }

    /// The same text as a piece of a larger file, whose `name` this is: the renderers of
    /// diagnostics give places in that file, if it has the piece byte for byte. (Otherwise see
    /// `mapped`.)
    [[nodiscard]] SourceText at(Origin origin) const {
        SourceText piece = *this;
        piece.origin_ = origin;
        return piece;
    }
    /// Where the text begins in its file: what `at` was given, else the start of the file.
    [[nodiscard]] Origin origin() const noexcept { return origin_; }

    /// The shared bytes themselves, for whoever keeps views into them.
    [[nodiscard]] const std::shared_ptr<const std::string>& buffer() const noexcept {
        return buffer_;
    }

private:
    std::shared_ptr<const std::string> buffer_;
    std::string name_;
    Encoding encoding_;
    bool too_large_ = false;
    Origin origin_;
};

} // namespace iecfront
