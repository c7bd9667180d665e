#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace iecfront::cli {

/// A line on standard error that says how far a long run has come. Only on a terminal.
class Progress {
public:
    explicit Progress(std::size_t total);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `done` files are behind us. Draws now and then only.
    void show(std::size_t done);
    /// Takes the line away, before something else is written.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    std::size_t total_;
    bool enabled_;
    bool drawn_ = false;
    Clock::time_point next_;
};

} // namespace iecfront::cli
