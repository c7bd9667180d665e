#include "parser/unit_parser.hpp"

#include <iecfront/parser/parse.hpp>

#include <memory>
#include <string>
#include <utility>

namespace iecfront {
namespace {

/// The tree of a text that is not read: one unit that says so.
SyntaxTree refuse(const SourceText& source, const ParseOptions& options, std::uint64_t limit) {
    Unit::Parts parts;
    parts.buffer = source.buffer();
    parts.text = source.bytes();
    parts.encoding = source.encoding();
    leave_unexamined(parts, {DiagnosticId::source_too_large, {}, {std::to_string(limit)}, {}, {}});
    return {source.name(),
            source.encoding(),
            {std::make_shared<const Unit>(std::move(parts))},
            options,
            source.origin()};
}

} // namespace

SyntaxTree parse(const SourceText& source, const ParseOptions& options) {
    if (source.too_large())
        return refuse(source, options, SourceText::maximum_size);
    if (source.bytes().size() > options.maximum_source_size)
        return refuse(source, options, options.maximum_source_size);
    UnitReader reader(source.buffer(), source.encoding(), true, options);
    std::vector<std::shared_ptr<const Unit>> units;
    while (reader.next())
        units.push_back(reader.parse());
    return {source.name(), source.encoding(), std::move(units), options, source.origin()};
}

} // namespace iecfront
