#pragma once

#include <iecfront/source/encoding.hpp>
#include <iecfront/source/line_table.hpp>

#include <cstdint>
#include <string_view>

namespace iecfront::cli {

/// Counts lines and columns (in code points) while going through a text from its start. Each byte
/// is looked at once, however long the lines are.
class PositionCounter {
public:
    PositionCounter(std::string_view text, Encoding encoding)
        : text_(text), encoding_(encoding), offset_(byte_order_mark_size(text, encoding)) {}

    /// The position of `offset`, which is not before the one asked for last.
    [[nodiscard]] Position advance(std::uint32_t offset) {
        while (offset_ < offset)
            step();
        return position_;
    }

private:
    void step() {
        const char c = text_[offset_];
        if (c == '\n' || (c == '\r' && !text_.substr(offset_ + 1).starts_with('\n'))) {
            ++position_.line;
            position_.column = 1;
            ++offset_;
            return;
        }
        ++position_.column;
        offset_ += decode_character(text_, offset_, encoding_).size;
    }

    std::string_view text_;
    Encoding encoding_;
    std::uint32_t offset_;
    Position position_;
};

} // namespace iecfront::cli
