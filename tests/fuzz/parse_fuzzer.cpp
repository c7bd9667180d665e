// Any bytes: the tree is sound, and an edited tree equals the tree of the edited text.

#include "support/tree_faults.hpp"

#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

void require_none(std::string_view fault) {
    if (fault.empty())
        return;
    std::fprintf(stderr, "%.*s\n", static_cast<int>(fault.size()), fault.data());
    std::abort();
}

/// An edit that the last bytes of `text` choose: a piece of the text takes the place of another.
/// So a text stays what it is when it serves as a seed.
[[nodiscard]] iecfront::TextEdit edit_from(std::string_view text) {
    const auto number = [&](std::size_t from_end, std::size_t below) {
        std::size_t value = 0;
        for (std::size_t i = from_end; i < from_end + 2 && i < text.size(); ++i)
            value = value * 256 + static_cast<unsigned char>(text[text.size() - 1 - i]);
        return value % below;
    };
    const std::size_t begin = number(0, text.size() + 1);
    const std::size_t end = begin + number(2, std::min<std::size_t>(text.size() - begin, 32) + 1);
    const std::size_t source = number(4, text.size() + 1);
    return {{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)},
            std::string(text.substr(source, number(6, 32)))};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace iecfront;
    std::string text(data, data + size);
    const SyntaxTree tree = parse(SourceText(text));
    require_none(test::tree_fault(tree, text));

    const TextEdit edit = edit_from(text);
    const SyntaxTree edited = tree.edited(edit.range, edit.replacement);
    text.replace(edit.range.begin, edit.range.size(), edit.replacement);
    require_none(test::tree_fault(edited, text));
    if (!(edited == parse(SourceText(text))))
        require_none("the edited tree differs from a fresh one");
    return 0;
}
