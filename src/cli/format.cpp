#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/output.hpp"
#include "cli/parallel.hpp"
#include "cli/platform.hpp"
#include "cli/reading.hpp"
#include "cli/replace_file.hpp"

#include <iecfront/format/formatter.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace iecfront::cli {
namespace {

/// A file, formatted.
struct FormattedFile {
    std::string problem; ///< why it could not be read; empty when it could
    std::string text;    ///< what it is to be; empty when only changes are asked for, and none is
    bool changed = false;
};

[[nodiscard]] bool prints_texts(const Options& options) noexcept {
    return !options.check && !options.write;
}

[[nodiscard]] FormattedFile format_file(const Input& input, const Options& options) noexcept {
    FormattedFile file;
    try {
        const ReadText read = read_input(input, options.encoding);
        file.problem = problem_of(read);
        if (!file.problem.empty())
            return file;
        std::string text = format(parse(read.source, options.parse), options.layout);
        file.changed = text != read.source.bytes();
        if (file.changed || prints_texts(options))
            file.text = std::move(text);
    } catch (const std::exception& exception) {
        file.problem = exception.what();
    }
    return file;
}

/// Does with formatted files, in order, what the user asks for.
class FormatRun {
public:
    FormatRun(const Options& options, std::vector<Input> inputs)
        : options_(options), inputs_(std::move(inputs)) {}

    [[nodiscard]] Status run() {
        work_in_order(
            inputs_.size(), options_.job_count(),
            [&](std::size_t i) { return format_file(inputs_[i], options_); },
            [&](std::size_t i, const FormattedFile& file) {
                status_ = std::max(status_, take(inputs_[i], file));
            });
        return status_;
    }

private:
    [[nodiscard]] Status take(const Input& input, const FormattedFile& file) {
        if (!file.problem.empty()) {
            complain(on_one_line(input.name) + ": " + file.problem);
            return Status::unusable;
        }
        if (prints_texts(options_))
            print(file.text);
        if (prints_texts(options_) || !file.changed)
            return Status::nothing_found;
        if (options_.write)
            return rewrite(input, file.text);
        print_name(input);
        return Status::violations;
    }

    // A name a line, as `--check` and `--write` list them.
    static void print_name(const Input& input) { print(on_one_line(input.name) + "\n"); }

    [[nodiscard]] Status rewrite(const Input& input, const std::string& text) {
        std::error_code error; // then the name has to do
        const auto path = std::filesystem::canonical(input.path, error);
        if (!rewritten_.insert(error ? input.path : path).second)
            return Status::nothing_found; // named twice
        const std::string problem = replace_file(input.path, text);
        if (problem.empty()) {
            print_name(input);
            return Status::nothing_found;
        }
        complain(on_one_line(input.name) + ": " + problem);
        return Status::unusable;
    }

    const Options& options_;
    std::vector<Input> inputs_;
    std::set<std::filesystem::path> rewritten_;
    Status status_ = Status::nothing_found;
};

void check_usage(const Options& options, const std::vector<Input>& inputs) {
    if (options.check && options.write)
        throw UsageError("`--check` and `--write` cannot stand together");
    if (options.write && std::ranges::any_of(inputs, &Input::standard_input))
        throw UsageError("standard input cannot be rewritten");
}

} // namespace

Status run_format(const Options& options) {
    std::vector<Input> inputs = find_inputs(options.operands);
    check_usage(options, inputs);
    return FormatRun(options, std::move(inputs)).run();
}

} // namespace iecfront::cli
