#include "format/unit_writer.hpp"

#include <iecfront/format/formatter.hpp>

namespace iecfront {

std::string format(const SyntaxTree& tree, const FormatOptions& options) {
    layout::UnitWriter writer(tree, options);
    for (const SyntaxTree::Slot& slot : tree.slots())
        writer.append(*slot.unit, nullptr);
    std::optional<std::string> text = std::move(writer).finish();
    return text ? *std::move(text) : std::string(tree.source().bytes());
}

} // namespace iecfront
