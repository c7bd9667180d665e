#include <iecfront/lexer/name.hpp>

#include <algorithm>

namespace iecfront {

std::string folded(std::string_view name) {
    std::string result(name);
    std::ranges::transform(result, result.begin(), fold);
    return result;
}

} // namespace iecfront
