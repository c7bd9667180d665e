#pragma once

#include <span>
#include <string_view>

namespace iecfront::cli {

/// The page of docs/diagnostics on one code.
struct ExplainPage {
    std::string_view code; ///< `IEC2006`
    std::string_view text; ///< Markdown
};

/// All pages, ordered by code. The source is written by the build, see explain_pages.cmake.
[[nodiscard]] std::span<const ExplainPage> explain_pages() noexcept;

} // namespace iecfront::cli
