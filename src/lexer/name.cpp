#include <iecfront/lexer/name.hpp>

#include <algorithm>

namespace iecfront {

bool detail::are_equal_names(const char* a, const char* b, std::size_t size) noexcept {
    return are_equal_folded(a, b, size);
}

std::string folded(std::string_view name) {
    std::string result(name);
    std::ranges::transform(result, result.begin(), fold);
    return result;
}

} // namespace iecfront
