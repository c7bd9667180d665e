#pragma once

#include <string>
#include <string_view>

namespace iecfront::test {

/// An S-expression on several lines: a group that does not fit its line is broken behind its head,
/// and each of its children stands on a line of its own, indented by two columns.
[[nodiscard]] std::string laid_out(std::string_view s_expression);

} // namespace iecfront::test
