#include "format/comment_text.hpp"
#include "format/unit_writer.hpp"

#include <iecfront/format/writer.hpp>
#include <iecfront/lexer/literals.hpp>

#include <algorithm>
#include <deque>
#include <optional>

namespace iecfront {
namespace {

[[nodiscard]] bool in_iso_646(char c) noexcept {
    return static_cast<unsigned char>(c) < 0x80;
}
[[nodiscard]] bool in_iso_646(std::string_view text) noexcept {
    return std::ranges::all_of(text, [](char c) { return in_iso_646(c); });
}

// All characters beyond it.
[[nodiscard]] std::vector<TextRange> places_beyond(std::string_view text) {
    std::vector<TextRange> places;
    for (std::uint32_t begin = 0; begin < text.size(); ++begin) {
        std::uint32_t end = begin;
        while (end < text.size() && !in_iso_646(text[end]))
            ++end;
        if (end != begin)
            places.push_back({begin, end});
        begin = end;
    }
    return places;
}

// `$C4`, or `$00C4` in a double-byte string.
void append_escape(std::string& out, std::uint16_t code, bool double_byte) {
    constexpr std::string_view hex = "0123456789ABCDEF";
    out += '$';
    for (std::uint32_t shift = double_byte ? 16 : 8; shift > 0; shift -= 4)
        out += hex[(code >> (shift - 4)) & 0xFU];
}

// Nothing when the literal has no value.
[[nodiscard]] std::optional<std::string> escaped(std::string_view literal, Encoding encoding) {
    const std::optional<StringValue> value = string_value(literal, encoding);
    if (!value)
        return std::nullopt;
    std::string out;
    std::uint32_t at = 0;
    for (const StringElement& element : value->elements) {
        const std::string_view source = literal.substr(element.source.begin, element.source.size());
        if (in_iso_646(source))
            continue;
        out += literal.substr(at, element.source.begin - at);
        append_escape(out, element.code, value->double_byte);
        at = element.source.end;
    }
    out += literal.substr(at);
    return out;
}

// `// x` and `/* x */` as `(* x *)`.
[[nodiscard]] std::string in_standard_form(Trivia trivia, std::string_view text) {
    text.remove_prefix(2);
    if (trivia.kind == TriviaKind::c_comment)
        return layout::as_comment(text.substr(0, text.size() - (text.ends_with("*/") ? 2 : 0)));
    return layout::as_comment(std::string(text.substr(0, text.find_last_not_of(" \t") + 1)) + ' ');
}

/// What ISO 646 makes of the text of one unit.
class Iso646 : public layout::TextRule {
public:
    Iso646(const Unit& unit, CommentHandling comments) : unit_(unit), comments_(comments) {}

    std::string_view token(Token token, std::string_view text) override {
        if (in_iso_646(text))
            return text;
        if (auto literal = escaped(text, unit_.encoding()); literal && in_iso_646(*literal))
            return keep(std::move(*literal));
        report(token.range());
        return text;
    }

    std::string_view trivia(Trivia trivia, std::string_view text, bool stays) override {
        const bool is_comment = !stays && trivia.kind != TriviaKind::pragma;
        if (is_comment && comments_ == CommentHandling::leave_out)
            return {};
        if (!in_iso_646(text)) {
            report(trivia.range);
            if (is_comment && comments_ == CommentHandling::keep_iso_646)
                return {};
        }
        const bool standard = !is_comment || trivia.kind == TriviaKind::comment;
        return standard ? text : keep(in_standard_form(trivia, text));
    }

    [[nodiscard]] const std::vector<TextRange>& places() const noexcept { return places_; }

private:
    void report(TextRange range) { places_.push_back(range); }
    std::string_view keep(std::string text) { return kept_.emplace_back(std::move(text)); }

    const Unit& unit_;
    CommentHandling comments_;
    std::deque<std::string> kept_;
    std::vector<TextRange> places_;
};

[[nodiscard]] WrittenText as_it_was(const SyntaxTree& tree) {
    WrittenText written{std::string(tree.source().bytes()), {}};
    written.beyond_iso_646 = places_beyond(written.text);
    return written;
}

} // namespace

WrittenText write(const SyntaxTree& tree, const WriteOptions& options) {
    std::vector<TextRange> places;
    layout::UnitWriter writer(tree, options.layout);
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        Iso646 rule(*slot.unit, options.comments);
        const bool laid_out = writer.append(*slot.unit, &rule);
        for (const TextRange place : laid_out ? rule.places() : places_beyond(slot.unit->text()))
            places.push_back(place.shifted(slot.offset));
    }
    std::optional<std::string> text = std::move(writer).finish();
    return text ? WrittenText{*std::move(text), std::move(places)} : as_it_was(tree);
}

} // namespace iecfront
