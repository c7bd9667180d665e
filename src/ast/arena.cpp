#include <iecfront/ast/arena.hpp>

#include <algorithm>
#include <utility>

namespace iecfront {
namespace {

constexpr std::size_t smallest_chunk = 1024;

} // namespace

Arena::Arena(Arena&& other) noexcept
    : chunks_(std::move(other.chunks_)),
      chunk_(std::exchange(other.chunk_, nullptr)),
      used_(std::exchange(other.used_, 0)),
      capacity_(std::exchange(other.capacity_, 0)),
      next_chunk_(other.next_chunk_),
      reserved_(std::exchange(other.reserved_, 0)) {}

Arena& Arena::operator=(Arena&& other) noexcept {
    chunks_ = std::move(other.chunks_);
    chunk_ = std::exchange(other.chunk_, nullptr);
    used_ = std::exchange(other.used_, 0);
    capacity_ = std::exchange(other.capacity_, 0);
    next_chunk_ = other.next_chunk_;
    reserved_ = std::exchange(other.reserved_, 0);
    return *this;
}

void Arena::grow(std::size_t at_least) {
    capacity_ = std::max(next_chunk_, at_least);
    chunks_.push_back(std::make_unique_for_overwrite<std::byte[]>(capacity_));
    chunk_ = chunks_.back().get();
    reserved_ += capacity_;
    // Half of what there is: few chunks, and never more than about a third of all lies unused.
    next_chunk_ = std::max(smallest_chunk, reserved_ / 2);
}

} // namespace iecfront
