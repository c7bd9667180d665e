#pragma once

#include <iecfront/ast/arena.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace iecfront {

/// Where the parser makes the nodes of a unit, before it is known how much memory they take. When
/// there is no more room, the parser goes to the end of the unit, which is then read again with
/// more. What it makes on its way out of all that is open comes from a reserve: so much for each
/// level of nesting.
class ParserArena : public Arena {
public:
    ParserArena() = default;
    explicit ParserArena(std::size_t capacity) : Arena(capacity) { clear(); }

    /// The parser has to be ready for there being no room.
    template<class T>
    T* create() = delete;

    /// Takes back all.
    void clear() noexcept {
        rewind(0);
        full_ = false;
        refused_ = false;
        reserve_ = 0;
        hold_back(reserve_of_unit);
    }
    /// As `Arena` has it; the rest has its reserve.
    [[nodiscard]] Arena split() {
        Arena given = Arena::split();
        clear();
        return given;
    }
    /// True when more was asked for than there was: what was made is of no use.
    [[nodiscard]] bool full() const noexcept { return full_; }
    /// True when more room would not help either: the unit has too many findings.
    [[nodiscard]] bool refused() const noexcept { return refused_; }
    void refuse() noexcept { refused_ = true; }

    void enter_level() noexcept { hold_back(reserve_of_level); }
    void leave_level() noexcept {
        reserve_ -= reserve_of_level;
        set_limit();
    }
    void open_reserve() noexcept {
        full_ = true;
        set_limit();
    }

    static constexpr std::size_t reserve_of_unit = 4'096;
    static constexpr std::size_t reserve_of_level = 512;
    /// With that of as many levels as most units have.
    static constexpr std::size_t usual_reserve = reserve_of_unit + 24 * reserve_of_level;

private:
    void hold_back(std::size_t size) noexcept {
        reserve_ += size;
        set_limit();
    }
    void set_limit() noexcept {
        limit_ = full_ ? capacity() : capacity() - std::min(capacity(), reserve_);
    }

    std::size_t reserve_ = 0; // at the end of the block
    bool full_ = false;
    bool refused_ = false;
};

} // namespace iecfront
