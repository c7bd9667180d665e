#include <iecfront/lexer/name.hpp>

#include <algorithm>

namespace iecfront {

std::uint32_t detail::hash_name_within(const char* text, std::size_t begin,
                                       std::size_t size) noexcept {
    constexpr std::size_t step = sizeof(std::uint64_t);
    if (size > step || begin + size < step || size == 0)
        return hash_name({text + begin, size});
    const std::uint64_t bytes = load_bytes(text + begin + size - step, step);
    return static_cast<std::uint32_t>(mix_name(size, bytes >> (8 * (step - size))));
}

std::string folded(std::string_view name) {
    std::string result(name);
    std::ranges::transform(result, result.begin(), fold);
    return result;
}

} // namespace iecfront
