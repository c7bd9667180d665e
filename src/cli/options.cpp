#include "cli/options.hpp"

#include "cli/input.hpp"
#include "cli/near_names.hpp"
#include "cli/platform.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <thread>

namespace iecfront::cli {
namespace {

// Response files can name others; more than this many inside one another are a circle.
constexpr int deepest_response_file = 16;
// Far more than anybody has; those that name others several times soon have more than can be read.
constexpr int most_response_files = 10'000;
constexpr std::size_t most_arguments = 10'000'000;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

[[nodiscard]] std::vector<std::string> lines_of_response_file(const std::string& name) {
    const ReadText text = read_input({name, name, {}, false}, Encoding::utf8);
    if (!text.problem.empty())
        throw UsageError("response file " + on_one_line(name) + ": " + text.problem);
    std::string_view rest = text.source.bytes();
    if (rest.starts_with(byte_order_mark))
        rest.remove_prefix(byte_order_mark.size());
    std::vector<std::string> lines;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
        if (end > 0)
            lines.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return lines;
}

/// Reads arguments one after another.
class ArgumentReader {
public:
    explicit ArgumentReader(std::span<const OptionRow> rows) : rows_(rows) {}

    void read(std::span<const std::string> arguments, int depth = 0) {
        for (const std::string& argument : arguments) {
            if (++arguments_ > most_arguments)
                throw UsageError("more than " + std::to_string(most_arguments) + " arguments");
            read(argument, depth);
        }
    }

    [[nodiscard]] Options finish() {
        if (pending_ != nullptr)
            throw UsageError("`" + std::string(pending_->name) + "` needs a value: `" +
                             std::string(pending_->name) + " " + std::string(pending_->value) +
                             "`");
        return std::move(options_);
    }

private:
    void read(const std::string& argument, int depth) {
        if (pending_ != nullptr)
            std::exchange(pending_, nullptr)->apply(options_, argument);
        else if (only_operands_ || argument == "-" || argument.empty())
            options_.operands.push_back(argument);
        else if (argument == "--")
            only_operands_ = true;
        else if (argument.front() == '@')
            read_response_file(argument.substr(1), depth + 1);
        else if (argument.front() == '-')
            read_option(argument);
        else
            options_.operands.push_back(argument);
    }

    void read_response_file(const std::string& name, int depth) {
        if (depth > deepest_response_file)
            throw UsageError("response file " + on_one_line(name) + " includes itself");
        if (++response_files_ > most_response_files)
            throw UsageError("more than " + std::to_string(most_response_files) +
                             " response files are read");
        read(lines_of_response_file(name), depth);
    }

    // `--name`, whose value comes next when it takes one, or `--name=value`.
    void read_option(std::string_view argument) {
        const std::size_t equal_sign = std::min(argument.find('='), argument.size());
        const std::string_view name = argument.substr(0, equal_sign);
        if (name == "--help" || name == "-h") {
            options_.help = true;
            return;
        }
        const OptionRow& row = find(name);
        const bool has_value = equal_sign < argument.size();
        if (has_value && row.value.empty())
            throw UsageError("`" + std::string(name) + "` takes no value");
        if (!has_value && !row.value.empty())
            pending_ = &row;
        else
            row.apply(options_, has_value ? argument.substr(equal_sign + 1) : "");
    }

    [[nodiscard]] const OptionRow& find(std::string_view name) const {
        for (const OptionRow& row : rows_)
            if (row.name == name)
                return row;
        std::vector<std::string> names = {"--help"};
        for (const OptionRow& row : rows_)
            names.emplace_back(row.name);
        throw UsageError("unknown option `" + on_one_line(std::string(name)) + "`" +
                         did_you_mean(name, names));
    }

    std::span<const OptionRow> rows_;
    Options options_;
    const OptionRow* pending_ = nullptr; // waits for its value
    bool only_operands_ = false;
    int response_files_ = 0;
    std::size_t arguments_ = 0;
};

} // namespace

unsigned Options::job_count() const noexcept {
    return jobs != 0 ? jobs : std::max(1U, std::thread::hardware_concurrency());
}

SeverityPolicy Options::policy() const {
    SeverityPolicy policy;
    const std::string_view all_extensions = to_string(DiagnosticClass::extension);
    const bool by_class = std::ranges::any_of(
        severities, [&](const auto& one) { return names_equal(one.first, all_extensions); });
    if (dialect != nullptr && !by_class)
        set_dialect(policy, *dialect);
    for (const auto& [what, severity] : severities)
        static_cast<void>(policy.set(what, severity)); // known: checked when it was read
    return policy;
}

Options parse_options(std::span<const OptionRow> rows, std::span<const std::string> arguments) {
    ArgumentReader reader(rows);
    reader.read(arguments);
    return reader.finish();
}

} // namespace iecfront::cli
