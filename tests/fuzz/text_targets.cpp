#include "format/format_faults.hpp"
#include "fuzz/numbers.hpp"
#include "fuzz/targets.hpp"
#include "lexer/lexer.hpp"
#include "support/lexed_faults.hpp"
#include "support/literal_invariants.hpp"
#include "support/room_faults.hpp"
#include "support/tree_faults.hpp"

#include <algorithm>
#include <array>

// The bytes are a text. What else has to be chosen, its end chooses.

namespace iecfront::test {
namespace {

constexpr std::array encodings{Encoding::utf8, Encoding::windows_1252, Encoding::iso_8859_1};
constexpr int edits_in_chain = 4;
constexpr std::size_t sizes_of_room = 4;
constexpr std::uint32_t small_tree = 3000;  // bytes, where a unit beyond it is not read
constexpr std::uint32_t small_source = 300; // bytes, where a text beyond it is not read

[[nodiscard]] ParseOptions chosen_options(NumbersFromEnd& numbers) {
    ParseOptions options;
    options.read_as = static_cast<FragmentKind>(numbers.below(5));
    options.maximum_nesting = static_cast<std::uint32_t>(numbers.below(40));
    options.maximum_identifier_length = static_cast<std::uint32_t>(numbers.below(40));
    options.maximum_diagnostics = static_cast<std::uint32_t>(numbers.below(10));
    if (numbers.below(4) == 0)
        options.maximum_unit_memory = static_cast<std::uint32_t>(numbers.below(small_tree));
    return options;
}

/// A piece of the text, or nothing, takes the place of another.
[[nodiscard]] TextEdit chosen_edit(NumbersFromEnd& numbers, std::string_view text) {
    const std::size_t begin = numbers.below(text.size() + 1);
    const std::size_t end =
        begin + numbers.below(std::min<std::size_t>(text.size() - begin, 32) + 1);
    const std::size_t source = numbers.below(text.size() + 1);
    return {{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)},
            std::string(text.substr(source, numbers.below(32)))};
}

[[nodiscard]] std::string fault_of(const SourceText& source, const ParseOptions& options) {
    const SyntaxTree tree = parse(source, options);
    std::string fault = tree_fault(tree, source.bytes());
    return fault.empty() ? output_fault(tree) : fault;
}

} // namespace

std::string lex_fault(std::string_view bytes) {
    const std::string text(bytes); // a zero byte stands behind it
    std::string fault;
    for (const Encoding encoding : encodings)
        if (fault.empty())
            fault = tiling_fault(text, lex(text, encoding), encoding);
    return fault;
}

std::string parse_fault(std::string_view bytes) {
    const std::string text(bytes);
    std::string fault = fault_of(SourceText(text), {});
    if (!fault.empty())
        return fault;
    NumbersFromEnd numbers(bytes);
    const ParseOptions options = chosen_options(numbers);
    const SourceText source(text, {}, encodings[numbers.below(3)]);
    fault = fault_of(source, options);
    return fault.empty() ? room_fault(source, options, sizes_of_room) : fault;
}

std::string edits_fault(std::string_view bytes) {
    NumbersFromEnd numbers(bytes);
    std::string text(bytes);
    ParseOptions options;
    if (numbers.below(4) == 0)
        options.maximum_source_size = small_source;
    SyntaxTree tree = parse(SourceText(text), options);
    for (int i = 0; i < edits_in_chain; ++i) {
        const TextEdit edit = chosen_edit(numbers, text);
        tree = tree.edited(edit.range, edit.replacement);
        text.replace(edit.range.begin, edit.range.size(), edit.replacement);
        if (std::string fault = tree_fault(tree, text); !fault.empty())
            return fault;
        if (!(tree == parse(SourceText(text), options)))
            return "the edited tree differs from a fresh one";
    }
    return {};
}

/// The bytes as a literal of each class, and each literal that the lexer finds in them.
std::string literals_fault(std::string_view bytes) {
    const std::string text(bytes);
    const Encoding encoding = encodings[NumbersFromEnd(bytes).below(3)];
    for (std::size_t i = 0; i < token_kind_count; ++i)
        if (std::string fault = literal_fault(static_cast<TokenKind>(i), text, encoding);
            !fault.empty())
            return fault;
    for (const Token token : lex(text, encoding).tokens) {
        const std::string_view literal = bytes.substr(token.offset(), token.length());
        if (std::string fault = literal_fault(token.kind(), literal, encoding); !fault.empty())
            return fault;
    }
    return {};
}

std::string layout_fault(std::string_view bytes) {
    NumbersFromEnd numbers(bytes);
    const SourceText source{std::string(bytes), {}, encodings[numbers.below(3)]};
    FormatOptions layout;
    layout.line_length = static_cast<std::uint32_t>(numbers.below(120));
    layout.indent_width = static_cast<std::uint32_t>(numbers.below(9));
    std::string fault = format_fault(source, {}, layout);
    WriteOptions writing;
    writing.layout = layout;
    return fault.empty() ? write_fault(source, {}, writing) : fault;
}

} // namespace iecfront::test
