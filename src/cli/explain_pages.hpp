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

/// The text of the page on `code`; empty when there is none.
[[nodiscard]] std::string_view explain_page(std::string_view code) noexcept;

} // namespace iecfront::cli
