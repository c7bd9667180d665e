#pragma once

#include <iecfront/parser/parse.hpp>
#include <iecfront/source/source_text.hpp>

#include <cstddef>
#include <string>

namespace iecfront::test {

/// What goes wrong when the text is edited, in words with the edit and the text; empty when every
/// edited tree is good and equals the tree of the new text. A small text is edited everywhere, a
/// large one at places drawn by a fixed seed; in the end edits are made one upon the other.
[[nodiscard]] std::string edit_fault(const SourceText& source, const ParseOptions& options);

/// The same for every stretch of a text of some dozen bytes and a row of things to put in its
/// place.
[[nodiscard]] std::string every_edit_fault(const SourceText& source, const ParseOptions& options);

/// The same for so many edits drawn by a fixed seed, half of them made upon others.
[[nodiscard]] std::string random_edits_fault(const SourceText& source, const ParseOptions& options,
                                             std::size_t count);

/// What goes wrong when tokens of the text are dropped, doubled or swapped, or its end is cut off:
/// empty when all of these texts have good trees. The places are drawn by a fixed seed.
[[nodiscard]] std::string mutation_fault(const SourceText& source, const ParseOptions& options);

/// `text` as it could be written in C++.
[[nodiscard]] std::string quoted(std::string_view text);

} // namespace iecfront::test
