#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/export.hpp>
#include <iecfront/source/source_text.hpp>

namespace iecfront {

/// Reads `source` as a library of element declarations (B.0), or as what `ParseOptions::read_as`
/// says. Never fails: whatever the bytes, the result has a tree that gives all of them back, and
/// the findings in `SyntaxTree::diagnostics()`.
[[nodiscard]] IECFRONT_API SyntaxTree parse(const SourceText& source,
                                            const ParseOptions& options = {});

} // namespace iecfront
