// Measures recovery: puts single faults into valid texts, and prints for each kind of fault how
// many reports there are, where they lie, and how much of the tree is as it was.

#include "benchmark/recovery_faults.hpp"
#include "benchmark/recovery_outcome.hpp"
#include "grammar/formal_syntax.hpp"
#include "support/case_file.hpp"
#include "support/repository_files.hpp"

#include <iecfront/diagnostics/render_text.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {
namespace {

constexpr std::string_view usage =
    "usage: iecfront_recovery [--faults N] [--seed N] [--show N] [FILE...]\n"
    "  --faults N   faults of each kind in a text, at most; less in short ones (100)\n"
    "  --seed N     of the generator that draws the faults (1)\n"
    "  --show N     print the first N faults of each kind without exactly one report, there, or "
    "felt elsewhere (0)\n"
    "Without files, the example programs and the cases without findings are taken.\n";

struct Options {
    std::uint32_t faults = 100;
    std::uint32_t seed = 1;
    std::uint32_t show = 0;
    std::vector<std::string> files;
};

struct Text {
    std::string name;
    std::string bytes;
};

/// Sums over all faults of a kind.
struct Figures {
    std::size_t valid = 0; // not counted in the others
    std::size_t faults = 0;
    std::size_t silent = 0;
    std::size_t reports = 0;
    std::size_t with_one = 0;
    std::size_t located = 0;
    std::size_t statements = 0;
    std::size_t equal_statements = 0;
    std::size_t units = 0;
    std::size_t equal_units = 0;

    void add(const Outcome& outcome) {
        ++faults;
        silent += outcome.reports.empty() ? 1 : 0;
        reports += outcome.reports.size();
        with_one += outcome.reports.size() == 1 ? 1 : 0;
        located += outcome.located ? 1 : 0;
        statements += outcome.other_statements;
        equal_statements += outcome.equal_statements;
        units += outcome.other_units;
        equal_units += outcome.equal_units;
    }

    Figures& operator+=(const Figures& other) {
        valid += other.valid;
        faults += other.faults;
        silent += other.silent;
        reports += other.reports;
        with_one += other.with_one;
        located += other.located;
        statements += other.statements;
        equal_statements += other.equal_statements;
        units += other.units;
        equal_units += other.equal_units;
        return *this;
    }
};

[[nodiscard]] std::optional<Options> options_of(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        std::uint32_t* const value = argument == "--faults" ? &options.faults
                                     : argument == "--seed" ? &options.seed
                                     : argument == "--show" ? &options.show
                                                            : nullptr;
        if (value == nullptr) {
            if (argument.starts_with('-'))
                return std::nullopt;
            options.files.emplace_back(argument);
            continue;
        }
        if (++i == count)
            return std::nullopt;
        const std::string_view number = arguments[i];
        const auto read = std::from_chars(number.data(), number.data() + number.size(), *value);
        if (read.ec != std::errc() || read.ptr != number.data() + number.size())
            return std::nullopt;
    }
    return options;
}

/// The examples, and the cases in which nothing is found.
[[nodiscard]] std::vector<Text> own_texts() {
    std::vector<Text> texts;
    for (RepositoryFile& file : example_programs())
        texts.push_back({std::move(file.path), std::move(file.text)});
    for (const CaseFile& file : all_case_files())
        for (const Case& one : file.cases)
            if (one.expected("diagnostics").empty() && one.encoding.empty() &&
                one.maximum_nesting.empty())
                texts.push_back({file.path + ": " + one.title, one.source()});
    return texts;
}

[[nodiscard]] std::vector<Text> texts_of(const Options& options) {
    if (options.files.empty())
        return own_texts();
    std::vector<Text> texts;
    for (const std::string& path : options.files) {
        std::ifstream file(path, std::ios::binary);
        if (!file)
            std::fprintf(stderr, "iecfront_recovery: %s cannot be read\n", path.c_str());
        else
            texts.push_back({path, {std::istreambuf_iterator<char>(file), {}}});
    }
    return texts;
}

/// True when the text with the fault in it is still of the language.
[[nodiscard]] bool leaves_valid(const Text& text, const TextEdit& fault) {
    return formal_syntax().derives(apply_edits(text.bytes, {&fault, 1}));
}

/// Prints what a fault was and what was said about it.
void show(const Text& text, FaultKind kind, const TextEdit& fault, const Outcome& outcome) {
    const SourceText source(apply_edits(text.bytes, {&fault, 1}), text.name);
    const SyntaxTree valid = parse(SourceText(text.bytes));
    const Position position = valid.position(fault.range.begin);
    std::printf("---- %s, %s:%u:%u: `%s` by `%s`\n", std::string(to_string(kind)).c_str(),
                text.name.c_str(), position.line, position.column,
                text.bytes.substr(fault.range.begin, std::min(fault.range.size(), 60U)).c_str(),
                fault.replacement.c_str());
    std::fputs(render_text(outcome.reports, source).c_str(), stdout);
}

void print_heading() {
    std::printf("%-22s %7s %7s %7s %8s %9s %8s %11s %7s\n", "fault", "valid", "faults", "silent",
                "reports", "just one", "located", "statements", "units");
}

[[nodiscard]] double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 100 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

void print(std::string_view name, const Figures& figures) {
    const double mean = figures.faults == 0 ? 0
                                            : static_cast<double>(figures.reports) /
                                                  static_cast<double>(figures.faults);
    std::printf("%-22s %7zu %7zu %7zu %8.2f %8.1f%% %7.1f%% %10.2f%% %6.2f%%\n",
                std::string(name).c_str(), figures.valid, figures.faults, figures.silent, mean,
                percent(figures.with_one, figures.faults), percent(figures.located, figures.faults),
                percent(figures.equal_statements, figures.statements),
                percent(figures.equal_units, figures.units));
}

class Measurement {
public:
    explicit Measurement(const Options& options) : options_(options) {}

    void add(const Text& text) {
        const ValidText valid(parse(SourceText(text.bytes)));
        if (!reports_of(valid.tree()).empty()) {
            if (!options_.files.empty())
                std::fprintf(stderr, "iecfront_recovery: %s is left out: it is not valid\n",
                             text.name.c_str());
            return;
        }
        constexpr std::size_t bytes_per_fault = 40; // a short text has few places of interest
        const std::size_t count =
            std::min<std::size_t>(options_.faults, 1 + text.bytes.size() / bytes_per_fault);
        FaultMaker maker(valid.tree(), options_.seed);
        for (std::size_t i = 0; i < all_fault_kinds.size(); ++i)
            for (const TextEdit& fault : maker.make(all_fault_kinds[i], count))
                add(i, text, fault, valid.outcome_of(fault));
    }

    void print_table() const {
        print_heading();
        Figures all;
        for (std::size_t i = 0; i < all_fault_kinds.size(); ++i) {
            print(to_string(all_fault_kinds[i]), figures_[i]);
            all += figures_[i];
        }
        print("all", all);
    }

private:
    void add(std::size_t kind, const Text& text, const TextEdit& fault, const Outcome& outcome) {
        if (leaves_valid(text, fault)) {
            ++figures_[kind].valid;
            return;
        }
        figures_[kind].add(outcome);
        const bool other_units_felt_it = outcome.equal_units != outcome.other_units;
        if ((outcome.reports.size() != 1 || !outcome.located || other_units_felt_it) &&
            shown_[kind] < options_.show) {
            ++shown_[kind];
            show(text, all_fault_kinds[kind], fault, outcome);
        }
    }

    Options options_;
    std::array<Figures, all_fault_kinds.size()> figures_;
    std::array<std::uint32_t, all_fault_kinds.size()> shown_{};
};

} // namespace
} // namespace iecfront::test

int main(int count, char** arguments) {
    using namespace iecfront::test;
    const std::optional<Options> options = options_of(count, arguments);
    if (!options) {
        std::fputs(std::string(usage).c_str(), stderr);
        return 2;
    }
    Measurement measurement(*options);
    for (const Text& text : texts_of(*options))
        measurement.add(text);
    measurement.print_table();
    return 0;
}
