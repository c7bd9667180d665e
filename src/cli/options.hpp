#pragma once

#include "cli/usage_error.hpp"

#include <iecfront/compliance/dialects.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/format/formatter.hpp>
#include <iecfront/parser/parse.hpp>
#include <iecfront/source/encoding.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace iecfront::cli {

enum class Format { text, json, sarif, markdown };
enum class Colour { automatic, always, never };

/// What a command was told.
struct Options {
    std::vector<std::string> operands; ///< what is not an option, in order
    Format format = Format::text;
    Colour colour = Colour::automatic;
    Encoding encoding = Encoding::utf8;
    ParseOptions parse;
    unsigned jobs = 0; ///< 0: as many as the machine has processors
    /// How many findings of a file are printed as text; 0 stands for all. No reader wants the
    /// hundred thousand lines that a file of another kind gives.
    std::size_t maximum_findings = 1000;
    const Dialect* dialect = nullptr; ///< null: the default one
    /// Of --warn, --allow, --deny and --strict, in order.
    std::vector<std::pair<std::string, Severity>> severities;
    FormatOptions layout;
    bool check = false; ///< only name what is not formatted
    bool write = false; ///< rewrite it
    bool list = false;
    bool help = false;

    [[nodiscard]] SeverityPolicy policy() const;
    /// How many files are read at a time.
    [[nodiscard]] unsigned job_count() const noexcept;
};

/// An option of a command.
struct OptionRow {
    std::string_view name;  ///< `--format`
    std::string_view value; ///< what its value is called in the help; empty: it takes none
    std::string_view help;
    /// Takes the option over into `options`; throws `UsageError` when its value makes no sense.
    void (*apply)(Options& options, std::string_view value);
};

/// Reads the arguments behind a command's name. `@file` stands for the lines of a file, an argument
/// a line. Throws `UsageError`.
[[nodiscard]] Options parse_options(std::span<const OptionRow> rows,
                                    std::span<const std::string> arguments);

} // namespace iecfront::cli
