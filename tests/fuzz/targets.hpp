#pragma once

#include <span>
#include <string>
#include <string_view>

namespace iecfront::test {

/// What is wrong when the library has to do with these bytes, in words; empty when all that has to
/// hold does. Whatever the bytes are, nothing else may happen.
[[nodiscard]] std::string lex_fault(std::string_view bytes);
[[nodiscard]] std::string parse_fault(std::string_view bytes);
[[nodiscard]] std::string edits_fault(std::string_view bytes);
[[nodiscard]] std::string literals_fault(std::string_view bytes);
[[nodiscard]] std::string layout_fault(std::string_view bytes);
[[nodiscard]] std::string render_fault(std::string_view bytes);
[[nodiscard]] std::string build_fault(std::string_view bytes);
[[nodiscard]] std::string sentence_fault(std::string_view bytes);

/// A row for each of them.
struct FuzzTarget {
    std::string_view name; ///< `lex`, `parse`
    std::string (*fault)(std::string_view bytes);
};
[[nodiscard]] std::span<const FuzzTarget> fuzz_targets() noexcept;

} // namespace iecfront::test
