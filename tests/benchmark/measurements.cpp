#include "benchmark/measurements.hpp"

#include "benchmark/count_nodes.hpp"
#include "benchmark/counted_memory.hpp"
#include "benchmark/generated_words.hpp"
#include "benchmark/stopwatch.hpp"
#include "parser/unit_parser.hpp"

#include <iecfront/format/formatter.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

namespace iecfront::bench {
namespace {

constexpr std::size_t key_strokes = 200;

/// What is computed ends up here, so that no compiler leaves the computation out.
volatile std::size_t sink;

/// A plain loop, a byte at a time: as it does not know where it ends, no compiler makes vector
/// instructions of it.
[[nodiscard]] std::size_t sum_of_bytes(const char* text) {
    std::size_t sum = 0;
    for (; *text != '\0'; ++text)
        sum += static_cast<unsigned char>(*text);
    return sum;
}

class Measurement {
public:
    Measurement(const Options& options, const std::string& name, std::string text)
        : options_(options),
          buffer_(std::make_shared<const std::string>(std::move(text))),
          source_(buffer_, name),
          tree_(parse(source_)),
          letters_(buffer_->size(), 'x') {
        for (const SyntaxTree::Slot& slot : tree_.slots())
            tokens_ += slot.unit->tokens().size();
        lines_ = static_cast<std::size_t>(std::ranges::count(*buffer_, '\n'));
    }

    Table run() {
        table_.text = source_.name() + ": " + std::to_string(buffer_->size()) + " bytes, " +
                      std::to_string(lines_) + " lines, " + std::to_string(tokens_) + " tokens, " +
                      std::to_string(tree_.slots().size()) + " units, " +
                      std::to_string(count_nodes(tree_)) + " nodes";
        measure_plain_loops();
        measure_steps();
        if (options_.wants("memory"))
            measure_memory();
        if (options_.wants("edit"))
            measure_edits();
        if (options_.wants("check"))
            for (Row& row : measure_command(options_, *buffer_))
                table_.rows.push_back(std::move(row));
        return std::move(table_);
    }

private:
    void measure_plain_loops() {
        std::string copy(buffer_->size(), ' ');
        measure_always("memcpy", [&] {
            std::memcpy(copy.data(), buffer_->data(), buffer_->size());
            sink = static_cast<unsigned char>(copy[copy.size() / 2]);
        });
        measure_always("byte loop", [this] { sink = sum_of_bytes(letters_.c_str()); });
    }

    void measure_steps() {
        measure("lex", [this] { sink = lex(*buffer_, source_.encoding()).tokens.size(); });
        measure("lex_cut", [this] {
            const ParseOptions options;
            UnitReader reader(buffer_, source_.encoding(), true, options);
            std::size_t units = 0;
            while (reader.next())
                ++units;
            sink = units;
        });
        measure("parse", [this] { sink = parse(source_).slots().size(); });
        measure("walk", [this] { sink = count_nodes(tree_); });
        measure("nodes", [this] { sink = count_stored_nodes(tree_); });
        measure("format", [this] { sink = format(tree_).size(); });
    }

    template<class Work>
    void measure(std::string_view step, Work work) {
        if (options_.wants(step))
            measure_always(std::string(step), work);
    }

    // The byte loop runs before each run of a step: a machine has other speeds at other times. What
    // is compared are the least of both, which other programs disturbed the least.
    template<class Work>
    void measure_always(std::string step, Work work) {
        std::vector<double> seconds;
        std::vector<double> beside;
        for (std::size_t i = 0; i < options_.runs; ++i) {
            beside.push_back(seconds_of([this] { sink = sum_of_bytes(letters_.c_str()); }));
            seconds.push_back(seconds_of(work));
        }
        add(std::move(step), spread_of(std::move(seconds)), spread_of(std::move(beside)).least);
    }

    void add(std::string step, const Spread& seconds, double loop_seconds) {
        const auto bytes = static_cast<double>(buffer_->size());
        if (copy_seconds_ == 0)
            copy_seconds_ = seconds.least;
        table_.rows.push_back(
            {std::move(step),
             {{"median ms", seconds.median * 1e3, 2},
              {"min ms", seconds.least * 1e3, 2},
              {"max ms", seconds.most * 1e3, 2},
              {"MB/s", bytes / 1e6 / seconds.median},
              {"x byte loop", seconds.least / loop_seconds},
              {"x memcpy", seconds.least / copy_seconds_},
              {"ns/token", seconds.median * 1e9 / static_cast<double>(tokens_)},
              {"Mlines/s", static_cast<double>(lines_) / 1e6 / seconds.median, 2}}});
    }

    void measure_memory() {
        start_counting_memory();
        const SyntaxTree tree = parse(source_);
        const MemoryCounts counts = stop_counting_memory();
        std::size_t units = 0;
        for (const SyntaxTree::Slot& slot : tree.slots())
            units += slot.unit->memory_bytes();
        const auto bytes = static_cast<double>(buffer_->size());
        table_.rows.push_back(
            {"memory",
             {{"live B/B", static_cast<double>(counts.live) / bytes, 2},
              {"of units", static_cast<double>(units) / bytes, 2},
              {"peak with text", static_cast<double>(counts.peak) / bytes + 1, 2},
              {"allocations/unit",
               static_cast<double>(counts.allocations) / static_cast<double>(tree.slots().size()),
               2}}});
    }

    void measure_edits() {
        Random random(options_.seed);
        std::vector<double> runs;
        for (std::size_t i = 0; i < key_strokes; ++i) {
            const std::uint32_t place = end_of_some_token(random);
            runs.push_back(seconds_of([&] { sink = tree_.edited({place, place}, "x").size(); }));
        }
        add_edit("edit: key stroke", spread_of(runs));
        add_edit("edit: open comment", timed(options_.runs, [this] {
                     sink = tree_.edited({0, 0}, "(*").size();
                 }));
    }

    /// One in a unit where there are some, for units are what edits read.
    [[nodiscard]] std::uint32_t end_of_some_token(Random& random) const {
        for (;;) {
            const SyntaxTree::Slot& slot =
                tree_.slot_at(static_cast<std::uint32_t>(random.below(buffer_->size())));
            const auto tokens = slot.unit->tokens();
            if (!tokens.empty() || tokens_ == 0)
                return slot.offset + (tokens.empty() ? 0 : random.pick(tokens).end());
        }
    }

    void add_edit(std::string step, const Spread& seconds) {
        table_.rows.push_back({std::move(step),
                               {{"median us", seconds.median * 1e6},
                                {"min us", seconds.least * 1e6},
                                {"95 % us", seconds.percentile_95 * 1e6},
                                {"max us", seconds.most * 1e6}}});
    }

    const Options& options_;
    std::shared_ptr<const std::string> buffer_;
    SourceText source_;
    SyntaxTree tree_;
    std::size_t tokens_ = 0;
    std::size_t lines_ = 0;
    std::string letters_; // as many as the text has bytes, for the byte loop
    double copy_seconds_ = 0;
    Table table_;
};

} // namespace

Table measure(const Options& options, const std::string& name, std::string text) {
    return Measurement(options, name, std::move(text)).run();
}

} // namespace iecfront::bench
