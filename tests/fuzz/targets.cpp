#include "fuzz/targets.hpp"

#include <array>

namespace iecfront::test {

std::span<const FuzzTarget> fuzz_targets() noexcept {
    static constexpr std::array<FuzzTarget, 8> targets{{
        {"lex", lex_fault},
        {"parse", parse_fault},
        {"edit", edits_fault},
        {"literal", literals_fault},
        {"format", layout_fault},
        {"render", render_fault},
        {"build", build_fault},
        {"sentence", sentence_fault},
    }};
    return targets;
}

} // namespace iecfront::test
