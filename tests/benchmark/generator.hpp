#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace iecfront::bench {

/// Source text of the second edition for measurements, without any fault: as much as programs for
/// plants as can be had without copying any. All library elements, mostly in Structured Text, some
/// in Instruction List and as charts; names, comments, and sizes of declarations and lines are
/// those of published programs. It has `size` bytes or the rest of a declaration more. The same
/// seed gives the same bytes on every machine.
[[nodiscard]] std::string generate_source(std::size_t size, std::uint64_t seed = 1);

/// A single function block in Structured Text of the same kind, with a body of about `body_lines`.
[[nodiscard]] std::string generate_function_block(std::size_t body_lines, std::uint64_t seed = 1);

} // namespace iecfront::bench
