#include "benchmark/figures.hpp"

#include <algorithm>
#include <cstdio>

namespace iecfront::bench {
namespace {

constexpr std::size_t step_width = 22;

[[nodiscard]] std::string number(double value, int digits) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
    return buffer;
}

[[nodiscard]] std::string left(std::string text, std::size_t width) {
    text.resize(std::max(text.size(), width), ' ');
    return text;
}

[[nodiscard]] std::string right(const std::string& text, std::size_t width) {
    return std::string(std::max(text.size(), width) - text.size(), ' ') + text;
}

[[nodiscard]] std::size_t width_of(const Figure& figure) {
    return std::max<std::size_t>(figure.name.size(), 8) + 2;
}

[[nodiscard]] bool same_names(const Row& a, const Row& b) {
    return std::ranges::equal(a.figures, b.figures, {}, &Figure::name, &Figure::name);
}

[[nodiscard]] std::string names_line(const Row& row) {
    std::string line(step_width, ' ');
    for (const Figure& figure : row.figures)
        line += right(std::string(figure.name), width_of(figure));
    return line + '\n';
}

[[nodiscard]] std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += '\\';
        result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return result + '"';
}

[[nodiscard]] std::string json_of(const Row& row) {
    std::string text;
    for (const Figure& figure : row.figures)
        text += (text.empty() ? "" : ", ") + quoted(figure.name) + ": " + number(figure.value, 4);
    return quoted(row.step) + ": {" + text + "}";
}

} // namespace

Spread spread_of(std::vector<double> runs) {
    std::ranges::sort(runs);
    const std::size_t last = runs.size() - 1;
    return {runs[last / 2], runs.front(), runs.back(), runs[last * 95 / 100]};
}

std::string to_text(const Table& table) {
    std::string text = table.text + '\n';
    const Row* before = nullptr;
    for (const Row& row : table.rows) {
        if (before == nullptr || !same_names(*before, row))
            text += names_line(row);
        before = &row;
        text += left("  " + row.step, step_width);
        for (const Figure& figure : row.figures)
            text += right(number(figure.value, figure.digits), width_of(figure));
        text += '\n';
    }
    return text;
}

std::string to_json(const std::vector<Table>& tables) {
    std::string text;
    for (const Table& table : tables) {
        text += text.empty() ? "[" : ",\n ";
        text += "{\"text\": " + quoted(table.text) + ", \"steps\": {";
        for (const Row& row : table.rows)
            text += (&row == &table.rows.front() ? "\n  " : ",\n  ") + json_of(row);
        text += "}}";
    }
    return text + "]\n";
}

} // namespace iecfront::bench
