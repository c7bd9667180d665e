#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace iecfront::cli {

/// Does `work(0)` ... `work(count - 1)`, up to `jobs` of them at a time, and hands the results in
/// that order to `consume(i, result)` on the calling thread as they come. `work` must not throw;
/// when `consume` does, no more work is begun.
template<class Work, class Consume>
class OrderedWork {
public:
    using Result = decltype(std::declval<Work&>()(std::size_t{}));

    OrderedWork(std::size_t count, Work& work, Consume& consume)
        : count_(count), work_(work), consume_(consume), results_(count) {}

    ~OrderedWork() {
        stop();
        for (std::thread& thread : threads_)
            thread.join();
    }
    OrderedWork(const OrderedWork&) = delete;
    OrderedWork& operator=(const OrderedWork&) = delete;

    void run(unsigned jobs) {
        // Results that wait to be consumed take memory: nobody runs further ahead than this.
        lead_ = std::size_t{16} * jobs;
        for (unsigned i = 0; i < jobs && i < count_; ++i)
            threads_.emplace_back([this] { do_work(); });
        for (std::size_t i = 0; i < count_; ++i)
            consume_(i, wait_for(i));
    }

private:
    void do_work() {
        while (const std::optional<std::size_t> i = begin_next()) {
            Result result = work_(*i);
            const std::lock_guard lock(mutex_);
            results_[*i] = std::move(result);
            changed_.notify_all();
        }
    }

    [[nodiscard]] std::optional<std::size_t> begin_next() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return next_ >= count_ || next_ < consumed_ + lead_; });
        if (next_ >= count_)
            return std::nullopt;
        return next_++;
    }

    [[nodiscard]] Result wait_for(std::size_t i) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return results_[i].has_value(); });
        consumed_ = i + 1;
        changed_.notify_all();
        return *std::exchange(results_[i], std::nullopt);
    }

    void stop() {
        const std::lock_guard lock(mutex_);
        next_ = count_;
        changed_.notify_all();
    }

    std::size_t count_;
    Work& work_;
    Consume& consume_;
    std::size_t lead_ = 0;

    std::mutex mutex_; // guards what follows
    std::condition_variable changed_;
    std::size_t next_ = 0;
    std::size_t consumed_ = 0;
    std::vector<std::optional<Result>> results_;

    std::vector<std::thread> threads_;
};

/// See `OrderedWork`. With one job everything happens on the calling thread.
template<class Work, class Consume>
void work_in_order(std::size_t count, unsigned jobs, Work work, Consume consume) {
    if (jobs > 1 && count > 1) {
        OrderedWork<Work, Consume>(count, work, consume).run(jobs);
        return;
    }
    for (std::size_t i = 0; i < count; ++i)
        consume(i, work(i));
}

} // namespace iecfront::cli
