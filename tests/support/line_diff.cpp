#include "support/line_diff.hpp"

#include "support/repository_files.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace iecfront::test {
namespace {

using Lines = std::vector<std::string_view>;

/// For each pair of starts how many lines the two rests have in common at most.
[[nodiscard]] std::vector<std::vector<std::size_t>> common_lengths(const Lines& a, const Lines& b) {
    std::vector<std::vector<std::size_t>> common(a.size() + 1,
                                                 std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = a.size(); i-- > 0;)
        for (std::size_t j = b.size(); j-- > 0;)
            common[i][j] = a[i] == b[j] ? common[i + 1][j + 1] + 1
                                        : std::max(common[i + 1][j], common[i][j + 1]);
    return common;
}

void append_line(std::string& out, std::string_view mark, std::string_view line) {
    out += mark;
    out += line;
    out += '\n';
}

} // namespace

std::string trimmed(std::string_view text) {
    std::string result;
    for (const std::string_view line : lines_of(text)) {
        result += line.substr(0, line.find_last_not_of(' ') + 1);
        result += '\n';
    }
    const std::size_t last = result.find_last_not_of('\n');
    result.erase(last == std::string::npos ? 0 : last + 2);
    return result;
}

std::string line_diff(std::string_view expected, std::string_view actual) {
    const Lines a = lines_of(expected);
    const Lines b = lines_of(actual);
    const auto common = common_lengths(a, b);
    std::string diff;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
        if (i < a.size() && j < b.size() && a[i] == b[j]) {
            append_line(diff, "  ", a[i++]);
            ++j;
        } else if (j == b.size() || (i < a.size() && common[i + 1][j] >= common[i][j + 1])) {
            append_line(diff, "- ", a[i++]);
        } else {
            append_line(diff, "+ ", b[j++]);
        }
    }
    return diff;
}

} // namespace iecfront::test
