#include "cli/near_names.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace iecfront::cli {
namespace {

constexpr std::size_t most_suggestions = 3;

using Row = std::vector<std::size_t>;

[[nodiscard]] bool same_letter(char a, char b) noexcept {
    return fold(a) == fold(b);
}

// True when `word`, long enough to mean something, stands in `name`.
[[nodiscard]] bool is_part(std::string_view word, std::string_view name) {
    return word.size() >= 4 && folded(name).find(folded(word)) != std::string::npos;
}

} // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
    Row before_last;
    Row last(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        Row row(b.size() + 1);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = same_letter(a[i - 1], b[j - 1]) ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) &&
                same_letter(a[i - 2], b[j - 1]))
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        before_last = std::exchange(last, std::move(row));
    }
    return last.back();
}

std::string did_you_mean(std::string_view word, std::span<const std::string> names) {
    // A third of the letters wrong is still a slip, more is another word.
    const std::size_t farthest = std::min<std::size_t>(word.size() / 3, 4);
    std::vector<std::pair<std::size_t, std::string_view>> near;
    for (const std::string& name : names) {
        const std::size_t distance = is_part(word, name) ? 0 : edit_distance(word, name);
        if (distance <= farthest)
            near.emplace_back(distance, name);
    }
    std::stable_sort(near.begin(), near.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    if (near.size() > most_suggestions)
        near.resize(most_suggestions);

    std::string out;
    for (std::size_t i = 0; i < near.size(); ++i) {
        out += i == 0 ? "; did you mean `" : i + 1 == near.size() ? " or `" : ", `";
        out += near[i].second;
        out += '`';
    }
    return near.empty() ? out : out + "?";
}

} // namespace iecfront::cli
