#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/source/source_text.hpp>

#include <cstddef>
#include <string>

namespace iecfront::test {

/// What goes wrong when the parser has less room than the nodes of a unit take, at so many sizes of
/// it: it has to come to the end of the unit by itself, and to say so. Empty when it does.
[[nodiscard]] std::string room_fault(const SourceText& source, const ParseOptions& options,
                                     std::size_t sizes);

} // namespace iecfront::test
