#pragma once

#include <string>
#include <string_view>

namespace iecfront::test {

/// `text` with every line as it is and without blanks at line ends and blank lines at the end.
[[nodiscard]] std::string trimmed(std::string_view text);

/// What is to change to make `actual` of `expected`: all lines of both, with `-` before those that
/// are expected only, `+` before those that came only, and two blanks before the others.
[[nodiscard]] std::string line_diff(std::string_view expected, std::string_view actual);

} // namespace iecfront::test
