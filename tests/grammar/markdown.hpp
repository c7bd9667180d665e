#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// The rows of the tables below the heading, without those that say what the columns are. A cell
/// has no blanks at its ends.
[[nodiscard]] std::vector<std::vector<std::string>> table_rows(std::string_view document,
                                                               std::string_view heading);

/// What stands between the backticks of a cell; what is there when there are none.
[[nodiscard]] std::string code_in(std::string_view cell);

} // namespace iecfront::test
