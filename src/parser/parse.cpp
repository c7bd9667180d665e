#include "parser/unit_parser.hpp"

#include <iecfront/parser/parse.hpp>

#include <memory>
#include <utility>

namespace iecfront {
namespace {

/// The tree of a text that is not read: one empty unit that says so.
SyntaxTree refuse(const SourceText& source, const ParseOptions& options) {
    Unit::Parts parts;
    parts.buffer = source.buffer();
    parts.text = source.bytes();
    parts.encoding = source.encoding();
    parts.root = parts.arena.create<ast::LibraryUnit>();
    parts.diagnostics.push_back({DiagnosticId::source_too_large, {}, {}, {}, {}});
    return {source.name(),
            source.encoding(),
            {std::make_shared<const Unit>(std::move(parts))},
            options,
            source.origin()};
}

} // namespace

SyntaxTree parse(const SourceText& source, const ParseOptions& options) {
    if (source.too_large())
        return refuse(source, options);
    const LexedUnits lexed = lex_units(source.buffer(), source.encoding(), true, options.read_as);
    return {source.name(), source.encoding(), parse_units(lexed, options), options,
            source.origin()};
}

} // namespace iecfront
