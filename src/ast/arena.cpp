#include <iecfront/ast/arena.hpp>

#include <algorithm>
#include <utility>

namespace iecfront {
namespace {

constexpr std::size_t smallest_chunk = 512;

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
    // A sixteenth of what there is: so little lies unused in the end. Half of it, for fewer chunks,
    // made trees a fifth larger and reading no faster.
    next_chunk_ = std::max(smallest_chunk, reserved_ / 16);
}

} // namespace iecfront
