#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "cli/position_counter.hpp"
#include "cli/reading.hpp"

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/lexer/token.hpp>
#include <iecfront/parser/parse.hpp>

#include <cstdint>
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

/// Writes the elements of one file, a line each.
class TokenWriter {
public:
    TokenWriter(const SourceText& source, Format format)
        : source_(source), format_(format), counter_(source.bytes(), source.encoding()) {}

    void write(const SyntaxTree& tree) {
        begin();
        for (const SyntaxTree::Slot& slot : tree.slots())
            for (const Element& element : elements_of(slot))
                write(element);
        out_ += format_ == Format::json ? "\n]}\n" : "";
        print(out_);
    }

private:
    void begin() {
        if (format_ == Format::text)
            return;
        out_ += "{\"file\": ";
        append_json_string(out_, source_.name());
        out_ += ", \"tokens\": [\n";
    }

    void write(const Element& element) {
        const Position position = counter_.advance(element.range.begin);
        if (format_ == Format::json)
            append_object(element, position);
        else
            append_line(element, position);
        if (out_.size() > buffer_size) {
            print(out_);
            out_.clear();
        }
    }

    void append_line(const Element& element, Position position) {
        append_number(position.line);
        out_ += ':';
        append_number(position.column);
        out_ += ' ';
        out_ += element.kind;
        out_ += ' ';
        append_text(element);
        out_ += '\n';
    }

    void append_object(const Element& element, Position position) {
        out_ += first_ ? "{\"kind\": \"" : ",\n{\"kind\": \"";
        first_ = false;
        out_ += element.kind;
        out_ += "\", \"line\": ";
        append_number(position.line);
        out_ += ", \"column\": ";
        append_number(position.column);
        out_ += ", \"offset\": ";
        append_number(element.range.begin);
        out_ += ", \"endOffset\": ";
        append_number(element.range.end);
        out_ += ", \"text\": ";
        append_text(element);
        out_ += '}';
    }

    void append_text(const Element& element) {
        const TextRange range = element.range;
        append_json_string(out_, source_.bytes().substr(range.begin, range.size()),
                           source_.encoding());
    }

    void append_number(std::uint32_t number) { out_ += std::to_string(number); }

    static constexpr std::size_t buffer_size = std::size_t{1} << 16U;

    const SourceText& source_;
    Format format_;
    PositionCounter counter_;
    std::string out_;
    bool first_ = true;
};

} // namespace

Status run_tokens(const Options& options) {
    const std::vector<Input> inputs = find_inputs(options.operands);
    return read_each(inputs, options, [&](const SourceText& source, const Input&) {
        const SyntaxTree tree = parse(source, options.parse);
        if (options.format == Format::text && inputs.size() > 1)
            print(source.name() + ":\n");
        TokenWriter(source, options.format).write(tree);
    });
}

} // namespace iecfront::cli
