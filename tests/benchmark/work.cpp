// Does one step once, for programs that count instructions or time a whole process:
//
//     iecfront_work STEP TEXT SIZE
//
// TEXT is `generated` or the name of a shape; `iecfront_work shapes` lists these. Each step but
// `text` and `lex_cut` parses, so that differences are what a step alone takes.

#include "benchmark/count_nodes.hpp"
#include "benchmark/generator.hpp"
#include "benchmark/shapes.hpp"
#include "parser/unit_parser.hpp"

#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/diagnostics/render_text.hpp>
#include <iecfront/format/formatter.hpp>
#include <iecfront/format/writer.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::bench {
namespace {

[[nodiscard]] std::size_t count_units(const SourceText& source) {
    const ParseOptions options;
    UnitReader reader(source.buffer(), source.encoding(), true, options);
    std::size_t units = 0;
    while (reader.next())
        ++units;
    return units;
}

/// Puts a letter behind a token in so many places, each time in the tree as it was.
[[nodiscard]] std::size_t edit_everywhere(const SyntaxTree& tree) {
    constexpr std::uint32_t places = 200; // as many as iecfront_bench draws
    std::size_t sum = 0;
    for (std::uint32_t i = 0; i < places; ++i) {
        const auto somewhere = static_cast<std::uint32_t>(std::uint64_t{tree.size()} * i / places);
        const SyntaxTree::Slot& slot = tree.slot_at(somewhere);
        const auto tokens = slot.unit->tokens();
        const auto behind = std::ranges::find_if(
            tokens, [&](Token token) { return slot.offset + token.end() > somewhere; });
        const std::uint32_t place =
            behind == tokens.end() ? somewhere : slot.offset + behind->end();
        sum += tree.edited({place, place}, "x").size();
    }
    return sum;
}

[[nodiscard]] std::size_t size_as_json(const std::vector<Diagnostic>& diagnostics,
                                       const SourceText& source) {
    const LineTable lines(source.bytes(), source.encoding());
    std::string out;
    for (const Diagnostic& diagnostic : diagnostics)
        render_json(out, diagnostic, Severity::error, source, lines);
    return out.size();
}

/// A number that depends on all that was done.
[[nodiscard]] std::size_t do_step(std::string_view step, const SourceText& source) {
    if (step == "text")
        return source.bytes().size();
    if (step == "lex_cut")
        return count_units(source);
    const SyntaxTree tree = parse(source);
    if (step == "parse")
        return tree.slots().size();
    if (step == "walk")
        return count_nodes(tree);
    if (step == "nodes")
        return count_stored_nodes(tree);
    if (step == "edit")
        return edit_everywhere(tree);
    if (step == "format")
        return format(tree).size();
    if (step == "write")
        return write(tree).text.size();
    if (step == "json")
        return size_as_json(tree.diagnostics(), source);
    return render_text(tree.diagnostics(), source).size(); // report
}

[[nodiscard]] std::string text_of(std::string_view name, std::size_t size) {
    const auto found = std::ranges::find(shapes(), name, &Shape::name);
    return found == shapes().end() ? generate_source(size) : found->text(size);
}

void list_shapes() {
    for (const Shape& shape : shapes())
        std::printf("%s\n", std::string(shape.name).c_str());
}

int run(std::string_view step, std::string_view name, std::string_view size_word) {
    std::size_t size = 0;
    std::from_chars(size_word.data(), size_word.data() + size_word.size(), size);
    const SourceText source(std::make_shared<const std::string>(text_of(name, size)), "text");
    std::printf("%zu\n", do_step(step, source));
    return 0;
}

} // namespace
} // namespace iecfront::bench

int main(int count, char** arguments) {
    using namespace iecfront::bench;
    if (count == 4)
        return run(arguments[1], arguments[2], arguments[3]);
    if (count == 2 && std::string_view(arguments[1]) == "shapes") {
        list_shapes();
        return 0;
    }
    std::fputs("usage: iecfront_work STEP TEXT SIZE\n"
               "       iecfront_work shapes\n"
               "steps: text lex_cut parse walk nodes edit report json format write\n",
               stderr);
    return 2;
}
