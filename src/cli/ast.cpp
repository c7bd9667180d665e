#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "cli/reading.hpp"

#include <iecfront/ast/dump.hpp>
#include <iecfront/parser/parse.hpp>

#include <string>
#include <vector>

namespace iecfront::cli {
namespace {

void print_lines(const std::string& text) {
    print(text);
    if (!text.ends_with('\n'))
        print("\n");
}

} // namespace

Status run_ast(const Options& options) {
    const std::vector<Input> inputs = find_inputs(options.operands);
    return read_each(inputs, options, [&](const SourceText& source, const Input&) {
        const SyntaxTree tree = parse(source, options.parse);
        if (options.format == Format::json) {
            print_lines(dump_json(tree));
            return;
        }
        if (inputs.size() > 1)
            print(source.name() + ":\n");
        print_lines(dump_tree(tree));
    });
}

} // namespace iecfront::cli
