#pragma once

#include "benchmark/figures.hpp"

#include <chrono>
#include <cstddef>
#include <vector>

namespace iecfront::bench {

template<class Work>
[[nodiscard]] double seconds_of(Work work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Seconds that `work` takes, in so many runs.
template<class Work>
[[nodiscard]] Spread timed(std::size_t runs, Work work) {
    std::vector<double> seconds;
    for (std::size_t i = 0; i < runs; ++i)
        seconds.push_back(seconds_of(work));
    return spread_of(std::move(seconds));
}

} // namespace iecfront::bench
