#pragma once

#include <cstdint>

namespace iecfront::ast::detail {

/// Asks for what lies some way behind `place`, where compilers can: nodes lie about in the order in
/// which they are looked at, and by then memory has it ready.
inline void fetch_ahead(const void* place) noexcept {
#ifdef __GNUC__
    constexpr std::uintptr_t distance = 16 * 1024; // bytes
    __builtin_prefetch(
        reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(place) + distance));
#else
    static_cast<void>(place);
#endif
}

} // namespace iecfront::ast::detail
