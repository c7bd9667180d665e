#include "cli/reading.hpp"

#include "cli/output.hpp"
#include "cli/platform.hpp"

namespace iecfront::cli {

std::string problem_of(const ReadText& text) {
    return text.too_large ? "larger than 4 GiB minus 1" : text.problem;
}

Status read_each(std::span<const Input> inputs, const Options& options,
                 const std::function<void(const SourceText&, const Input&)>& use) {
    Status status = Status::nothing_found;
    for (const Input& input : inputs) {
        const ReadText text = read_input(input, options.encoding);
        const std::string problem = problem_of(text);
        if (problem.empty()) {
            use(text.source, input);
            continue;
        }
        complain(on_one_line(input.name) + ": " + problem);
        status = Status::unusable;
    }
    return status;
}

} // namespace iecfront::cli
