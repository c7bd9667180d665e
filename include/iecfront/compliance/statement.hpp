#pragma once

#include <iecfront/export.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace iecfront {

/// How a statement is written.
enum class StatementFormat : std::uint8_t { text, markdown, json };

/// The documents that 1.5.1 demands, in one: the compliance statement with its tables of features,
/// how each requirement is met, the values of Annex D, the treatments of Annex E with the errors
/// that are not reported, and the extensions. `product` is what the statement is made of, such as
/// `iecfront 0.1.0`. ASCII as far as `product` is, with a line end at its end.
[[nodiscard]] IECFRONT_API std::string compliance_statement(StatementFormat format,
                                                            std::string_view product);

} // namespace iecfront
