#pragma once

#include "support/json.hpp"

#include <string>
#include <vector>

namespace iecfront::test {

/// What is wrong with `log` as a SARIF 2.1.0 log, by the rules of the published schema for the
/// objects that the library writes, and by those of the text: an id of a rule names one of the
/// rules, a base of URIs is one of the bases, a region does not end before it begins. One line
/// each.
[[nodiscard]] std::vector<std::string> sarif_faults(const JsonValue& log);

} // namespace iecfront::test
