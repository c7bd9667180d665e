#include "format/comment_text.hpp"

namespace iecfront::layout {

std::string as_comment(std::string_view content) {
    std::string out = "(*";
    for (const char c : content) {
        if ((c == ')' && out.back() == '*' && out.size() > 2) || (c == '*' && out.back() == '('))
            out += ' ';
        out += c;
    }
    return out + "*)";
}

} // namespace iecfront::layout
