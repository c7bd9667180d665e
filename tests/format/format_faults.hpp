#pragma once

#include <iecfront/format/formatter.hpp>
#include <iecfront/format/writer.hpp>
#include <iecfront/parser/parse.hpp>

#include <string>

namespace iecfront::test {

/// What is wrong with the layout that `format` gives the text; empty when nothing is. It has to
/// have the same tokens but for keywords in upper case, the same comments, an equal tree when no
/// fault of syntax is in the text and no more faults otherwise, and to be formatted already.
[[nodiscard]] std::string format_fault(const SourceText& source, const ParseOptions& options = {},
                                       const FormatOptions& layout = {});

/// What is wrong with the text that `write` gives; empty when nothing is. Read again it has to have
/// an equal tree with equal values, and nothing beyond ISO 646 but what is reported.
[[nodiscard]] std::string write_fault(const SourceText& source, const ParseOptions& options = {},
                                      const WriteOptions& writing = {});

} // namespace iecfront::test
