#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "cli/platform.hpp"
#include "cli/reading.hpp"
#include "cli/replace_file.hpp"

#include <iecfront/format/formatter.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace iecfront::cli {
namespace {

// A name a line, as `--check` and `--write` list them.
void print_name(const Input& input) {
    print(on_one_line(input.name) + "\n");
}

[[nodiscard]] Status rewrite(const Input& input, const std::string& text) {
    const std::string problem = replace_file(input.path, text);
    if (problem.empty()) {
        print_name(input);
        return Status::nothing_found;
    }
    complain(on_one_line(input.name) + ": " + problem);
    return Status::unusable;
}

void check_usage(const Options& options, const std::vector<Input>& inputs) {
    if (options.check && options.write)
        throw UsageError("`--check` and `--write` cannot stand together");
    if (options.write && std::ranges::any_of(inputs, &Input::standard_input))
        throw UsageError("standard input cannot be rewritten");
}

} // namespace

Status run_format(const Options& options) {
    const std::vector<Input> inputs = find_inputs(options.operands);
    check_usage(options, inputs);
    Status worst = Status::nothing_found;
    const Status reading =
        read_each(inputs, options, [&](const SourceText& source, const Input& input) {
            const std::string text = format(parse(source, options.parse), options.layout);
            if (!options.check && !options.write)
                return print(text);
            if (text == source.bytes())
                return;
            if (options.check)
                print_name(input);
            const Status status = options.check ? Status::violations : rewrite(input, text);
            worst = std::max(worst, status);
        });
    return std::max(worst, reading);
}

} // namespace iecfront::cli
