#include "cli/progress.hpp"

#include "cli/platform.hpp"

#include <cstdio>

namespace iecfront::cli {
namespace {

// Short runs show nothing, long ones a steady line.
constexpr std::chrono::milliseconds first_after(700);
constexpr std::chrono::milliseconds then_every(100);

} // namespace

Progress::Progress(std::size_t total)
    : total_(total),
      enabled_(total > 1 && is_terminal(stderr)),
      next_(Clock::now() + first_after) {}

void Progress::show(std::size_t done) {
    if (!enabled_ || Clock::now() < next_)
        return;
    next_ = Clock::now() + then_every;
    // Short: of a line that a narrow terminal breaks only the end could be cleared.
    std::fprintf(stderr, "\r%zu/%zu files", done, total_);
    std::fflush(stderr);
    drawn_ = true;
}

void Progress::clear() {
    if (drawn_)
        std::fputs("\r\x1B[K", stderr);
    drawn_ = false;
}

} // namespace iecfront::cli
