// Measures how fast texts are read, and how much memory their trees take.

#include "parser/unit_parser.hpp"
#include "support/repository_files.hpp"

#include <iecfront/format/formatter.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>

namespace {

using namespace iecfront;

constexpr std::size_t default_size = 10'000'000;
constexpr std::size_t runs = 5;

/// What is computed ends up here, so that no compiler leaves the computation out.
volatile std::size_t sink;

/// MB of `text` a second, as the median of several runs of `work`.
template<class Work>
[[nodiscard]] double speed(std::string_view text, Work work) {
    std::array<double, runs> seconds{};
    for (double& one : seconds) {
        const auto begin = std::chrono::steady_clock::now();
        sink = work();
        one = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    std::sort(seconds.begin(), seconds.end());
    return static_cast<double>(text.size()) / 1e6 / seconds[runs / 2];
}

[[nodiscard]] std::size_t sum_of_bytes(std::string_view text) {
    std::size_t sum = 0;
    for (const char c : text)
        sum = sum * 31 + static_cast<unsigned char>(c); // each step needs the one before
    return sum;
}

/// The example programs, repeated up to `default_size`.
[[nodiscard]] std::string example_text() {
    std::string once;
    for (const test::RepositoryFile& file : test::example_programs())
        once += file.text;
    std::string text;
    while (!once.empty() && text.size() < default_size)
        text += once;
    return text;
}

void measure(const std::string& name, std::string bytes) {
    const auto buffer = std::make_shared<const std::string>(std::move(bytes));
    const SourceText source(buffer, name);
    const double loop = speed(*buffer, [&] { return sum_of_bytes(*buffer); });
    const double lexing = speed(*buffer, [&] {
        return lex_units(buffer, Encoding::utf8, true, FragmentKind::library).cuts.size();
    });
    const double parsing = speed(*buffer, [&] { return parse(source).slots().size(); });
    const SyntaxTree tree = parse(source);
    const double formatting = speed(*buffer, [&] { return format(tree).size(); });
    std::size_t memory = 0;
    for (const SyntaxTree::Slot& slot : tree.slots())
        memory += slot.unit->memory_bytes();
    std::printf("%s, %zu bytes\n", name.c_str(), buffer->size());
    std::printf("  %-20s %8.1f MB/s\n", "byte loop", loop);
    std::printf("  %-20s %8.1f MB/s  %6.1f times the byte loop\n", "lexing and cutting", lexing,
                loop / lexing);
    std::printf("  %-20s %8.1f MB/s  %6.1f times the byte loop\n", "parsing", parsing,
                loop / parsing);
    std::printf("  %-20s %8.1f MB/s  %6.1f times the parsing\n", "formatting", formatting,
                parsing / formatting);
    std::printf("  %-20s %8.1f bytes a byte of source\n", "memory",
                static_cast<double>(memory) / static_cast<double>(buffer->size()));
}

} // namespace

int main(int count, char** arguments) {
    if (count == 1)
        measure("example programs", example_text());
    for (int i = 1; i < count; ++i) {
        std::ifstream file(arguments[i], std::ios::binary);
        std::string bytes{std::istreambuf_iterator<char>(file), {}};
        if (!file.is_open() || bytes.empty()) {
            std::fprintf(stderr, "iecfront_bench: %s is empty or cannot be read\n", arguments[i]);
            return 1;
        }
        measure(arguments[i], std::move(bytes));
    }
    return 0;
}
