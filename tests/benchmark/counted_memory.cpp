// Replaces operator new and delete of the program that this file is linked to. Each piece of memory
// has its size in front of it, so that giving it back can be counted as well.

#include "benchmark/counted_memory.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace iecfront::bench {
namespace {

// Keeps what follows aligned for any type.
constexpr std::size_t header = alignof(std::max_align_t);
static_assert(header >= sizeof(std::size_t));

bool counting = false;
MemoryCounts counts;

void count(std::ptrdiff_t bytes) noexcept {
    counts.live += bytes;
    counts.peak = std::max(counts.peak, counts.live);
}

[[nodiscard]] void* allocate(std::size_t size) {
    auto* memory = static_cast<std::byte*>(std::malloc(size + header));
    if (memory == nullptr)
        throw std::bad_alloc();
    ::new (memory) std::size_t(size);
    if (counting) {
        ++counts.allocations;
        count(static_cast<std::ptrdiff_t>(size));
    }
    return memory + header;
}

void release(void* memory) noexcept {
    if (memory == nullptr)
        return;
    auto* begin = static_cast<std::byte*>(memory) - header;
    if (counting)
        count(-static_cast<std::ptrdiff_t>(*reinterpret_cast<std::size_t*>(begin)));
    std::free(begin);
}

} // namespace

void start_counting_memory() noexcept {
    counts = {};
    counting = true;
}

MemoryCounts stop_counting_memory() noexcept {
    counting = false;
    return counts;
}

} // namespace iecfront::bench

// All but those for larger alignments: with a sanitizer, no form calls another one.
void* operator new(std::size_t size) {
    return iecfront::bench::allocate(size);
}
void* operator new[](std::size_t size) {
    return iecfront::bench::allocate(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return iecfront::bench::allocate(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return iecfront::bench::allocate(size);
}
void operator delete(void* memory) noexcept {
    iecfront::bench::release(memory);
}
void operator delete[](void* memory) noexcept {
    iecfront::bench::release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    iecfront::bench::release(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    iecfront::bench::release(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    iecfront::bench::release(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept {
    iecfront::bench::release(memory);
}
