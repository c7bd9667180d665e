#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace iecfront {

// Which `*)` balances which `(*`, for comments that hold another `(*` (2.1.5, Annex E). Built once,
// when the first such comment is met, in one pass from the end of the text, so that many of them
// cost no more than one.
class CommentMarks {
public:
    // Pairs the marks of `text` from offset `begin` on.
    void build(std::string_view text, std::uint32_t begin);
    [[nodiscard]] bool built() const noexcept { return built_; }

    // The offset behind the `*)` that balances the `(*` at `opening`. Offsets asked for must grow.
    [[nodiscard]] std::optional<std::uint32_t> balanced_end(std::uint32_t opening) noexcept;

private:
    struct Pair {
        std::uint32_t opening;
        std::uint32_t closing_end;
    };

    std::vector<Pair> pairs_; // the last one of the text first; those passed are dropped
    bool built_ = false;
};

} // namespace iecfront
