#include "grammar/markdown.hpp"

#include "support/repository_files.hpp"

#include <algorithm>

namespace iecfront::test {
namespace {

[[nodiscard]] std::string trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    const std::size_t end = text.find_last_not_of(' ') + 1;
    return std::string(text.substr(begin, end - std::min(begin, end)));
}

/// The cells of `| a | b |`.
[[nodiscard]] std::vector<std::string> cells_of(std::string_view row) {
    std::vector<std::string> cells;
    for (std::size_t begin = 1, end = row.find(" |"); end != std::string_view::npos;
         begin = end + 2, end = row.find(" |", begin))
        cells.push_back(trimmed(row.substr(begin, end - begin)));
    return cells;
}

} // namespace

std::vector<std::vector<std::string>> table_rows(std::string_view document,
                                                 std::string_view heading) {
    std::vector<std::vector<std::string>> rows;
    bool below = false;
    bool in_body = false;
    for (const std::string_view line : lines_of(document)) {
        if (line.starts_with('#'))
            below = line.substr(std::min(line.find_first_not_of("# "), line.size())) == heading;
        else if (!below)
            continue;
        else if (line.starts_with("| ---"))
            in_body = true;
        else if (!line.starts_with("| "))
            in_body = false;
        else if (in_body)
            rows.push_back(cells_of(line));
    }
    return rows;
}

std::string code_in(std::string_view cell) {
    const std::size_t begin = cell.find('`');
    const std::size_t end = cell.rfind('`');
    return std::string(begin == end ? cell : cell.substr(begin + 1, end - begin - 1));
}

} // namespace iecfront::test
