#pragma once

#include "grammar/words.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// Changes one token of a text: drops it, doubles it, swaps it with the next one, replaces it, puts
/// another before it, or moves a line end to it.
class Damager {
public:
    /// Puts in the terminals of the grammar and some literals. The same seed does the same.
    Damager(const Grammar& grammar, std::uint32_t seed);

    [[nodiscard]] std::string damaged(std::string_view text);

    /// Chooses by `numbers`.
    void follow(std::function<std::uint32_t()> numbers) { random_ = std::move(numbers); }

private:
    [[nodiscard]] std::size_t random(std::size_t below) { return random_() % below; }

    std::vector<std::string> vocabulary_;
    std::function<std::uint32_t()> random_;
};

} // namespace iecfront::test
