#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace iecfront::test {

/// Numbers for choices that bytes make, so that a fuzzer can learn what a byte is good for. Behind
/// the last byte they go on as those of a random generator do: what loops until something else is
/// drawn has to end.
class Numbers {
public:
    explicit Numbers(std::string_view bytes) : bytes_(bytes) {}

    [[nodiscard]] std::uint32_t next() {
        if (at_ < bytes_.size())
            return state_ = state_ * 31 + static_cast<unsigned char>(bytes_[at_++]);
        return (state_ = state_ * 1'664'525U + 1'013'904'223U) >> 8U;
    }
    /// One byte's choice among `end` ways.
    [[nodiscard]] std::size_t below(std::size_t end) {
        return at_ < bytes_.size() && end <= 256 ? static_cast<unsigned char>(bytes_[at_++]) % end
                                                 : next() % end;
    }
    [[nodiscard]] bool done() const { return at_ >= bytes_.size(); }
    /// Up to `size` bytes as they stand there.
    [[nodiscard]] std::string_view text(std::size_t size) {
        const std::string_view text = bytes_.substr(at_, size);
        at_ += text.size();
        return text;
    }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
    std::uint32_t state_ = 1;
};

/// Numbers from the end of a text, so that a text stays what it is when it serves as a seed.
class NumbersFromEnd {
public:
    explicit NumbersFromEnd(std::string_view text) : text_(text) {}

    /// Two bytes' choice.
    [[nodiscard]] std::size_t below(std::size_t end) {
        std::size_t value = 0;
        for (int i = 0; i < 2 && at_ < text_.size(); ++i)
            value = value * 256 + static_cast<unsigned char>(text_[text_.size() - 1 - at_++]);
        return value % end;
    }

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

} // namespace iecfront::test
