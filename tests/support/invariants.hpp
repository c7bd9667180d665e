#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/parser/parse.hpp>
#include <iecfront/source/source_text.hpp>

namespace iecfront::test {

/// Checks everything that holds for any text whatever: the tree of `source` (`tree_faults.hpp`),
/// that reading it twice gives the same, and that edited and mutilated versions of it give good
/// trees too (`edit_faults.hpp`). A failure names the first fault with the text it shows in.
void expect_invariants(const SourceText& source, const ParseOptions& options = {});

} // namespace iecfront::test
