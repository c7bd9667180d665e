#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "cli/position_counter.hpp"
#include "cli/reading.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/lexer/token.hpp>
#include <iecfront/parser/parse.hpp>

#include <string>
#include <vector>

namespace iecfront::cli {
namespace {

/// A token, comment or pragma, counted from the start of the file.
struct Element {
    std::string_view kind;
    TextRange range;
};

// The tokens and the trivia of a unit are ordered each; here they become one row.
[[nodiscard]] std::vector<Element> elements_of(const SyntaxTree::Slot& slot) {
    std::vector<Element> elements;
    auto trivia = slot.unit->trivia().begin();
    const auto add_trivia_before = [&](std::uint32_t offset) {
        for (; trivia != slot.unit->trivia().end() && trivia->range.begin < offset; ++trivia)
            elements.push_back({to_string(trivia->kind), trivia->range.shifted(slot.offset)});
    };
    for (const Token token : slot.unit->tokens()) {
        if (token.kind() == TokenKind::end_of_unit)
            continue;
        add_trivia_before(token.offset());
        elements.push_back({to_string(token.kind()), token.range().shifted(slot.offset)});
    }
    add_trivia_before(UINT32_MAX);
    return elements;
}

/// Writes the elements of one file.
class TokenWriter {
public:
    explicit TokenWriter(const SourceText& source)
        : source_(source), counter_(source.bytes(), source.encoding()) {}

    [[nodiscard]] std::string text_line(const Element& element) {
        const Position position = counter_.advance(element.range.begin);
        std::string out = std::to_string(position.line) + ":" + std::to_string(position.column) +
                          " " + std::string(element.kind) + " ";
        append_text(out, element);
        return out + "\n";
    }

    [[nodiscard]] std::string json_object(const Element& element) {
        const Position position = counter_.advance(element.range.begin);
        std::string out = "{\"kind\": ";
        append_json_string(out, element.kind);
        out += ", \"line\": " + std::to_string(position.line) +
               ", \"column\": " + std::to_string(position.column) +
               ", \"offset\": " + std::to_string(element.range.begin) +
               ", \"endOffset\": " + std::to_string(element.range.end) + ", \"text\": ";
        append_text(out, element);
        return out + "}";
    }

private:
    void append_text(std::string& out, const Element& element) const {
        append_json_string(out, source_.bytes().substr(element.range.begin, element.range.size()),
                           source_.encoding());
    }

    const SourceText& source_;
    PositionCounter counter_;
};

void print_text(const SyntaxTree& tree, const SourceText& source) {
    TokenWriter writer(source);
    for (const SyntaxTree::Slot& slot : tree.slots())
        for (const Element& element : elements_of(slot))
            print(writer.text_line(element));
}

void print_json(const SyntaxTree& tree, const SourceText& source) {
    TokenWriter writer(source);
    std::string out = "{\"file\": ";
    append_json_string(out, source.name());
    out += ", \"tokens\": [";
    std::string_view separator = "\n";
    for (const SyntaxTree::Slot& slot : tree.slots()) {
        for (const Element& element : elements_of(slot)) {
            out += separator;
            out += writer.json_object(element);
            print(out);
            out.clear();
            separator = ",\n";
        }
    }
    print(out + "\n]}\n");
}

} // namespace

Status run_tokens(const Options& options) {
    const std::vector<Input> inputs = find_inputs(options.operands);
    return read_each(inputs, options, [&](const SourceText& source) {
        const SyntaxTree tree = parse(source, options.parse);
        if (options.format == Format::json) {
            print_json(tree, source);
            return;
        }
        if (inputs.size() > 1)
            print(source.name() + ":\n");
        print_text(tree, source);
    });
}

} // namespace iecfront::cli
