#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace iecfront::bench {

/// Numbers that are the same on every machine for the same seed, which those of the standard
/// library's distributions are not (splitmix64).
class Random {
public:
    explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

    [[nodiscard]] std::uint64_t next() noexcept {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }
    /// Less than `end`, which is not 0.
    [[nodiscard]] std::size_t below(std::size_t end) noexcept { return next() % end; }
    /// From `first` to `last`, both included.
    [[nodiscard]] std::size_t between(std::size_t first, std::size_t last) noexcept {
        return first + below(last - first + 1);
    }
    /// True in `percent` of a hundred cases.
    [[nodiscard]] bool chance(std::size_t percent) noexcept { return below(100) < percent; }
    /// One of them; there is at least one.
    template<class Items>
    [[nodiscard]] const auto& pick(const Items& items) noexcept {
        return items[below(items.size())];
    }

private:
    std::uint64_t state_;
};

/// The pieces one behind the other. They are made in this order, which is left open for those of a
/// sum: so the text is the same with every compiler.
[[nodiscard]] std::string joined(std::initializer_list<std::string_view> pieces);

/// A name as programs for plants have them: `PumpSpeed`, `Main_Tank_Level3`, `bDoorOpen`. No
/// keyword and no standard name.
[[nodiscard]] std::string make_name(Random& random);

/// Some words about a plant, without the characters of any comment mark.
[[nodiscard]] std::string make_prose(Random& random, std::size_t words);

// Literals. Those of one class come in all their forms.
[[nodiscard]] std::string make_integer(Random& random);
[[nodiscard]] std::string make_real(Random& random);
[[nodiscard]] std::string make_duration(Random& random);
[[nodiscard]] std::string make_string(Random& random);

/// Lines of a text, indented by blocks.
class LineWriter {
public:
    /// `random` says where comments stand, and what they say.
    explicit LineWriter(Random& random) noexcept : random_(random) {}

    /// A line of code, which has a comment behind it in `comment_percent` of a hundred cases.
    void line(std::string_view code, std::size_t comment_percent = 0);
    void empty_line() { end_line(); }
    /// A comment on a line of its own.
    void comment_line();
    /// The comment above a declaration of the library.
    void head_comment(std::string_view name);

    void indent() noexcept { ++depth_; }
    void outdent() noexcept { --depth_; }
    /// The first column, for labels.
    void unindented_line(std::string_view code);

    [[nodiscard]] std::size_t lines() const noexcept { return lines_; }
    [[nodiscard]] std::size_t size() const noexcept { return text_.size(); }
    [[nodiscard]] std::string take() noexcept { return std::move(text_); }

private:
    void end_line();

    Random& random_;
    std::string text_;
    std::size_t depth_ = 0;
    std::size_t lines_ = 0;
};

} // namespace iecfront::bench
