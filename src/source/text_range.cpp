#include <iecfront/source/text_range.hpp>

namespace iecfront {

std::string apply_edits(std::string_view text, std::span<const TextEdit> edits) {
    std::string result;
    std::size_t at = 0;
    for (const TextEdit& edit : edits) {
        if (edit.range.begin < at || edit.range.end < edit.range.begin ||
            edit.range.end > text.size())
            continue;
        result += text.substr(at, edit.range.begin - at);
        result += edit.replacement;
        at = edit.range.end;
    }
    result += text.substr(at);
    return result;
}

} // namespace iecfront
