#include "support/edit_faults.hpp"

#include "support/sanitized.hpp"
#include "support/tree_faults.hpp"

#include <iecfront/ast/syntax_tree.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace iecfront::test {
namespace {

/// A text up to this many bytes is edited in places all over it.
constexpr std::size_t small_size = 400;
/// So many edits of one kind at most are tried in a small text: a longer one is edited at every
/// second place, every third, and so on. Chosen so that all case files take seconds, not minutes.
constexpr std::size_t places_of_small = sanitized ? 10 : 60;
/// From one byte that is taken out of a small text to the next.
constexpr std::size_t bytes_between = sanitized ? 3 : 1;
constexpr std::size_t edits_of_large = sanitized ? 20 : 40;
constexpr std::size_t edits_in_chain = 24;
constexpr std::size_t mutations_of_a_kind = sanitized ? 12 : 24;

/// What changes most about the text behind it.
constexpr std::array<std::string_view, 20> insertions = {
    ";",
    "(*",
    "*)",
    "'",
    "\n",
    " END_IF",
    "\nFUNCTION f : INT\n",
    "\nEND_FUNCTION\n",
    "{",
    "}",
    ".5",
    "TYPE ",
    "\"",
    "%",
    "|",
    "//",
    "#",
    " ",
    "_",
    "END_FUNCTION FUNCTION g : INT ",
};

/// Draws numbers; the same ones in every run and with every library.
class Dice {
public:
    [[nodiscard]] std::size_t below(std::size_t end) { return end == 0 ? 0 : engine_() % end; }

private:
    std::mt19937 engine_{20030101};
};

[[nodiscard]] std::string in_words(const TextEdit& edit) {
    return "replacing " + std::to_string(edit.range.begin) + ".." + std::to_string(edit.range.end) +
           " by " + quoted(edit.replacement);
}

/// Edits a text and compares with reading the new one.
class Editor {
public:
    Editor(const SourceText& source, const ParseOptions& options)
        : encoding_(source.encoding()),
          options_(options),
          text_(source.bytes()),
          tree_(parse(source, options)) {}

    [[nodiscard]] std::string_view text() const { return text_; }

    /// What is wrong after `edit`; `keep` makes the next edit follow upon this one.
    [[nodiscard]] std::string fault_of(const TextEdit& edit, bool keep = false) {
        std::string text = text_;
        text.replace(edit.range.begin, edit.range.size(), edit.replacement);
        SyntaxTree edited = tree_.edited(edit.range, edit.replacement);
        std::string fault = tree_fault(edited, text);
        if (fault.empty() && !same(edited, parse(SourceText(text, {}, encoding_), options_)))
            fault = "the edited tree differs from a fresh one";
        if (!fault.empty())
            return fault + "\nafter " + in_words(edit) + "\nin " + quoted(text_);
        if (keep) {
            text_ = std::move(text);
            tree_ = std::move(edited);
        }
        return "";
    }

private:
    [[nodiscard]] static bool same(const SyntaxTree& a, const SyntaxTree& b) {
        return a == b &&
               std::equal(a.slots().begin(), a.slots().end(), b.slots().begin(),
                          [](const auto& x, const auto& y) {
                              return x.unit->depends_on_rest() == y.unit->depends_on_rest();
                          });
    }

    Encoding encoding_;
    ParseOptions options_;
    std::string text_;
    SyntaxTree tree_;
};

[[nodiscard]] TextRange range_at(std::size_t begin, std::size_t size) {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + size)};
}

/// Each byte taken out, and each insertion everywhere; fewer where each takes long.
[[nodiscard]] std::string fault_anywhere(Editor& editor) {
    const std::size_t size = editor.text().size();
    const std::size_t step = size / places_of_small + 1;
    std::size_t turn = 0; // so that the insertions do not all fall on the same places
    for (std::size_t at = size % bytes_between; at < size; at += bytes_between)
        if (std::string fault = editor.fault_of({range_at(at, 1), ""}); !fault.empty())
            return fault;
    for (const std::string_view insertion : insertions) {
        for (std::size_t at = turn++ % step; at <= size; at += step) {
            const TextEdit edit{range_at(at, 0), std::string(insertion)};
            if (std::string fault = editor.fault_of(edit); !fault.empty())
                return fault;
        }
    }
    return "";
}

/// An edit that takes out, puts in, or repeats a piece from elsewhere.
[[nodiscard]] TextEdit drawn_edit(Dice& dice, std::string_view text) {
    const std::size_t at = dice.below(text.size() + 1);
    const std::size_t taken = dice.below(3) == 0 ? 0 : dice.below(30);
    const TextRange range = range_at(at, std::min(taken, text.size() - at));
    switch (dice.below(3)) {
    case 0: return {range, ""};
    case 1: return {range, std::string(insertions[dice.below(insertions.size())])};
    default: {
        const std::size_t from = dice.below(text.size() + 1);
        return {range, std::string(text.substr(from, dice.below(60)))};
    }
    }
}

[[nodiscard]] std::string fault_of_drawn(Editor& editor, Dice& dice, std::size_t count,
                                         bool chain) {
    for (std::size_t i = 0; i < count; ++i)
        if (std::string fault = editor.fault_of(drawn_edit(dice, editor.text()), chain);
            !fault.empty())
            return fault;
    return "";
}

/// Each stretch of the text taken out, or replaced by each insertion.
[[nodiscard]] std::string fault_of_every_edit(Editor& editor) {
    const std::size_t size = editor.text().size();
    for (std::size_t begin = 0; begin <= size; ++begin)
        for (std::size_t end = begin; end <= size; ++end) {
            std::string fault = editor.fault_of({range_at(begin, end - begin), ""});
            for (const std::string_view insertion : insertions)
                if (fault.empty())
                    fault = editor.fault_of({range_at(begin, end - begin), std::string(insertion)});
            if (!fault.empty())
                return fault;
        }
    return "";
}

// ---- mutations ----------------------------------------------------------------------------------

/// The ranges of all tokens, counted from the start of the file.
[[nodiscard]] std::vector<TextRange> tokens_of(const SyntaxTree& tree) {
    std::vector<TextRange> ranges;
    for (const SyntaxTree::Slot& slot : tree.slots())
        for (const Token token : slot.unit->tokens())
            ranges.push_back(token.range().shifted(slot.offset));
    return ranges;
}

[[nodiscard]] std::string without(std::string_view text, TextRange range) {
    return std::string(text.substr(0, range.begin)) + std::string(text.substr(range.end));
}

[[nodiscard]] std::string doubled(std::string_view text, TextRange range) {
    const std::string_view token = text.substr(range.begin, range.size());
    return std::string(text.substr(0, range.end)) + ' ' + std::string(token) +
           std::string(text.substr(range.end));
}

[[nodiscard]] std::string swapped(std::string_view text, TextRange a, TextRange b) {
    std::string result(text.substr(0, a.begin));
    result += text.substr(b.begin, b.size());
    result += text.substr(a.end, b.begin - a.end);
    result += text.substr(a.begin, a.size());
    result += text.substr(b.end);
    return result;
}

/// The mutated versions of a text around one of its tokens.
[[nodiscard]] std::array<std::string, 4>
mutated(std::string_view text, const std::vector<TextRange>& tokens, std::size_t token) {
    const TextRange here = tokens[token];
    const TextRange next = tokens[std::min(token + 1, tokens.size() - 1)];
    return {without(text, here), doubled(text, here),
            next == here ? std::string(text) : swapped(text, here, next),
            std::string(text.substr(0, here.end))};
}

void append_quoted(std::string& out, char c) {
    constexpr std::string_view digits = "01234567";
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n') {
        out += "\\n";
    } else if (c == '"' || c == '\\') {
        out += '\\';
        out += c;
    } else if (byte < 0x20 || byte >= 0x7F) { // in octal: three digits and no more are read
        out += '\\';
        out += digits[byte / 64];
        out += digits[byte / 8 % 8];
        out += digits[byte % 8];
    } else {
        out += c;
    }
}

} // namespace

std::string edit_fault(const SourceText& source, const ParseOptions& options) {
    Editor editor(source, options);
    Dice dice;
    const bool small = source.bytes().size() <= small_size;
    std::string fault =
        small ? fault_anywhere(editor) : fault_of_drawn(editor, dice, edits_of_large, false);
    return fault.empty() ? fault_of_drawn(editor, dice, edits_in_chain, true) : fault;
}

std::string every_edit_fault(const SourceText& source, const ParseOptions& options) {
    Editor editor(source, options);
    return fault_of_every_edit(editor);
}

std::string random_edits_fault(const SourceText& source, const ParseOptions& options,
                               std::size_t count) {
    Editor single(source, options);
    Dice dice;
    std::string fault = fault_of_drawn(single, dice, count / 2, false);
    for (std::size_t i = 0; i < count / 2 && fault.empty(); i += edits_in_chain) {
        Editor chain(source, options); // anew: after many edits little of the text is left
        fault = fault_of_drawn(chain, dice, edits_in_chain, true);
    }
    return fault;
}

std::string mutation_fault(const SourceText& source, const ParseOptions& options) {
    const std::vector<TextRange> tokens = tokens_of(parse(source, options));
    Dice dice;
    const std::size_t count = std::min(tokens.size(), mutations_of_a_kind);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t token = count == tokens.size() ? i : dice.below(tokens.size());
        for (std::string& text : mutated(source.bytes(), tokens, token)) {
            const SourceText changed(std::move(text), {}, source.encoding());
            const std::string fault = tree_fault(parse(changed, options), changed.bytes());
            if (!fault.empty())
                return fault + "\nin " + quoted(changed.bytes());
        }
    }
    return "";
}

std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text)
        append_quoted(result, c);
    return result + '"';
}

} // namespace iecfront::test
