#pragma once

#include <cstddef>

namespace iecfront::bench {

/// What `operator new` gave out since counting began; of one thread.
struct MemoryCounts {
    std::ptrdiff_t live = 0;     ///< bytes not yet given back
    std::ptrdiff_t peak = 0;     ///< most bytes live at a time
    std::size_t allocations = 0; ///< calls
};

/// From here on all memory is counted, beginning from nothing.
void start_counting_memory() noexcept;
/// What was counted so far; ends counting.
MemoryCounts stop_counting_memory() noexcept;

} // namespace iecfront::bench
