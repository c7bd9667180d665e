#pragma once

#include <string>
#include <string_view>

namespace iecfront {

/// The registries as one JSON object.
[[nodiscard]] std::string json_statement(std::string_view product);

} // namespace iecfront
