#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::bench {

/// Of several runs.
struct Spread {
    double median = 0;
    double least = 0;
    double most = 0;
    double percentile_95 = 0;
};

/// There is at least one run.
[[nodiscard]] Spread spread_of(std::vector<double> runs);

/// A figure with its name, which says its unit as well.
struct Figure {
    std::string_view name;
    double value;
    int digits = 1; // behind the point, in text
};

/// The figures of one step.
struct Row {
    std::string step;
    std::vector<Figure> figures;
};

/// All figures of a text.
struct Table {
    std::string text; ///< which one
    std::vector<Row> rows;
};

/// For people: a line for each step, under a line of names wherever these change.
[[nodiscard]] std::string to_text(const Table& table);

/// For programs: `{"text": ..., "steps": {"lex": {"median_ms": ...}}}` in a row of all tables.
[[nodiscard]] std::string to_json(const std::vector<Table>& tables);

} // namespace iecfront::bench
