#pragma once

#include <string>
#include <string_view>

namespace iecfront::layout {

/// `content` between `(*` and `*)`. Where one of these two stands in it, a blank parts it.
[[nodiscard]] std::string as_comment(std::string_view content);

} // namespace iecfront::layout
