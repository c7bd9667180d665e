#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace iecfront {

/// A heading of level 1, 2 or 3.
struct Heading {
    std::size_t level = 1;
    std::string text;
};

/// Text that is broken into lines.
struct Paragraph {
    std::string text;
};

/// Items one below the other.
struct BulletList {
    std::vector<std::string> items;
};

/// Rows of as many cells as there are columns.
struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

/// What a document consists of, from top to bottom. Code stands in backticks in both forms.
using Document = std::vector<std::variant<Heading, Paragraph, BulletList, Table>>;

/// For a terminal.
[[nodiscard]] std::string plain_text(const Document& document);

/// The same as Markdown.
[[nodiscard]] std::string markdown(const Document& document);

} // namespace iecfront
