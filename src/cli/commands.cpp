#include "cli/commands.hpp"

#include "cli/near_names.hpp"
#include "cli/platform.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <string>

namespace iecfront::cli {
namespace {

// ---- what the values of options mean
// -------------------------------------------------------------

[[nodiscard]] std::string quoted(std::string_view text) {
    return "`" + on_one_line(std::string(text)) + "`";
}

/// Names for the values of an option.
template<class Value>
struct Choice {
    std::string_view name;
    Value value;
};

template<class Value>
[[nodiscard]] Value choose(std::string_view option, std::string_view name,
                           std::span<const Choice<Value>> choices) {
    std::string all;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (choices[i].name == name)
            return choices[i].value;
        all += i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ";
        all += choices[i].name;
    }
    throw UsageError(quoted(name) + " is no value for `" + std::string(option) + "`: " + all);
}

template<std::uint64_t least, std::uint64_t most>
[[nodiscard]] std::uint64_t number(std::string_view option, std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < least || value > most)
        throw UsageError(quoted(text) + " is no value for `" + std::string(option) +
                         "`: a number from " + std::to_string(least) + " to " +
                         std::to_string(most));
    return value;
}

void set_text_or_json(Options& options, std::string_view value) {
    constexpr std::array<Choice<Format>, 2> formats = {
        {{"text", Format::text}, {"json", Format::json}}};
    options.format = choose<Format>("--format", value, formats);
}

void set_text_json_or_sarif(Options& options, std::string_view value) {
    constexpr std::array<Choice<Format>, 3> formats = {
        {{"text", Format::text}, {"json", Format::json}, {"sarif", Format::sarif}}};
    options.format = choose<Format>("--format", value, formats);
}

void set_tree_or_json(Options& options, std::string_view value) {
    constexpr std::array<Choice<Format>, 2> formats = {
        {{"tree", Format::text}, {"json", Format::json}}};
    options.format = choose<Format>("--format", value, formats);
}

void set_statement_format(Options& options, std::string_view value) {
    constexpr std::array<Choice<Format>, 3> formats = {
        {{"text", Format::text}, {"markdown", Format::markdown}, {"json", Format::json}}};
    options.format = choose<Format>("--format", value, formats);
}

void set_colour(Options& options, std::string_view value) {
    constexpr std::array<Choice<Colour>, 3> colours = {
        {{"auto", Colour::automatic}, {"always", Colour::always}, {"never", Colour::never}}};
    options.colour = choose<Colour>("--color", value, colours);
}

void set_encoding(Options& options, std::string_view value) {
    const std::optional<Encoding> encoding = encoding_from_string(value);
    if (!encoding)
        throw UsageError(quoted(value) +
                         " is no value for `--encoding`: utf-8, iso-8859-1 or windows-1252");
    options.encoding = *encoding;
}

// The stack of a thread, 8 MiB and sometimes less, has to hold so many levels, also in a build with
// all checks.
constexpr std::uint64_t most_nesting = 1000;

void set_nesting(Options& options, std::string_view value) {
    options.parse.maximum_nesting =
        static_cast<std::uint32_t>(number<1, most_nesting>("--max-nesting", value));
}

void set_identifier_length(Options& options, std::string_view value) {
    options.parse.maximum_identifier_length =
        static_cast<std::uint32_t>(number<1, UINT32_MAX>("--max-identifier-length", value));
}

void set_diagnostics(Options& options, std::string_view value) {
    options.parse.maximum_diagnostics =
        static_cast<std::uint32_t>(number<1, UINT32_MAX>("--max-diagnostics", value));
}

void set_source_size(Options& options, std::string_view value) {
    options.parse.maximum_source_size =
        static_cast<std::uint32_t>(number<1, UINT32_MAX>("--max-source-size", value));
}

void set_unit_memory(Options& options, std::string_view value) {
    options.parse.maximum_unit_memory =
        static_cast<std::uint32_t>(number<1, UINT32_MAX>("--max-unit-memory", value));
}

void set_jobs(Options& options, std::string_view value) {
    options.jobs = static_cast<unsigned>(number<1, 1024>("--jobs", value));
}

void set_findings(Options& options, std::string_view value) {
    options.maximum_findings =
        static_cast<std::size_t>(number<0, UINT32_MAX>("--max-findings", value));
}

void set_check(Options& options, std::string_view) {
    options.check = true;
}

void set_write(Options& options, std::string_view) {
    options.write = true;
}

void set_keyword_case(Options& options, std::string_view value) {
    constexpr std::array<Choice<KeywordCase>, 3> cases = {{{"upper", KeywordCase::upper},
                                                           {"lower", KeywordCase::lower},
                                                           {"keep", KeywordCase::keep}}};
    options.layout.keyword_case = choose<KeywordCase>("--keyword-case", value, cases);
}

void set_indent(Options& options, std::string_view value) {
    options.layout.indent_width =
        static_cast<std::uint32_t>(number<0, FormatOptions::widest_indent>("--indent", value));
}

void set_line_length(Options& options, std::string_view value) {
    options.layout.line_length =
        static_cast<std::uint32_t>(number<20, FormatOptions::longest_line>("--line-length", value));
}

void set_list(Options& options, std::string_view) {
    options.list = true;
}

[[nodiscard]] std::vector<std::string> severity_names() {
    std::vector<std::string> names = {"violation", "error", "extension", "implementation-dependent",
                                      "limit"};
    for (const DiagnosticInfo& row : diagnostic_catalogue()) {
        names.push_back(code_string(row.id));
        names.emplace_back(row.name);
    }
    return names;
}

void add_severity(Options& options, std::string_view what, Severity severity) {
    SeverityPolicy scratch;
    if (!scratch.set(what, severity))
        throw UsageError(quoted(what) + " is no code, name or class of diagnostics" +
                         did_you_mean(what, severity_names()));
    options.severities.emplace_back(what, severity);
}

void set_warn(Options& options, std::string_view value) {
    add_severity(options, value, Severity::warning);
}

void set_allow(Options& options, std::string_view value) {
    add_severity(options, value, Severity::allow);
}

void set_deny(Options& options, std::string_view value) {
    add_severity(options, value, Severity::error);
}

void set_dialect_name(Options& options, std::string_view value) {
    std::vector<std::string> names;
    for (const Dialect& dialect : dialects())
        names.push_back(dialect.name);
    options.dialect = find_dialect(value);
    if (options.dialect == nullptr)
        throw UsageError(quoted(value) + " is no dialect" + did_you_mean(value, names));
}

// What SeverityPolicy::strict() does, as far as no later option takes it back.
void set_strict(Options& options, std::string_view) {
    for (const DiagnosticClass category :
         {DiagnosticClass::extension, DiagnosticClass::implementation_dependent})
        add_severity(options, to_string(category), Severity::error);
}

// ---- options
// -------------------------------------------------------------------------------------

constexpr OptionRow encoding_row = {
    "--encoding", "NAME", "how the input is encoded: utf-8 (default), iso-8859-1, windows-1252",
    set_encoding};
constexpr OptionRow nesting_row = {
    "--max-nesting", "N", "examine what is nested up to N levels deep (1 to 1000, default 256)",
    set_nesting};
constexpr OptionRow source_size_row = {
    "--max-source-size", "N", "do not examine files of more than N bytes (default 268435456)",
    set_source_size};
constexpr OptionRow unit_memory_row = {
    "--max-unit-memory", "N",
    "do not examine what takes more than N bytes of memory (default 2147483648)", set_unit_memory};
constexpr OptionRow jobs_row = {"--jobs", "N", "read N files at a time (default: one a processor)",
                                set_jobs};
constexpr OptionRow text_or_json_row = {"--format", "text|json", "how to print (default: text)",
                                        set_text_or_json};

constexpr std::array check_options = {
    OptionRow{"--format", "text|json|sarif", "how to print (default: text); SARIF is 2.1.0",
              set_text_json_or_sarif},
    OptionRow{"--dialect", "NAME",
              "take the extensions of a dialect: iec2 (default: none), iec2-tools",
              set_dialect_name},
    OptionRow{"--strict", "", "refuse extensions and reliance on implementation-dependent features",
              set_strict},
    OptionRow{"--warn", "X", "report X as a warning: a code, a name or a class", set_warn},
    OptionRow{"--allow", "X", "do not report X", set_allow},
    OptionRow{"--deny", "X", "report X as an error", set_deny},
    OptionRow{"--max-findings", "N",
              "print at most N findings a file as text (default 1000, 0: all)", set_findings},
    encoding_row,
    nesting_row,
    OptionRow{"--max-identifier-length", "N",
              "report identifiers of more than N bytes (default 4096)", set_identifier_length},
    source_size_row,
    unit_memory_row,
    OptionRow{"--max-diagnostics", "N", "stop after N findings in a file (default 100000)",
              set_diagnostics},
    jobs_row,
    OptionRow{"--color", "WHEN", "auto (default), always or never; NO_COLOR is honoured",
              set_colour},
};
constexpr std::array tokens_options = {text_or_json_row, encoding_row, source_size_row,
                                       unit_memory_row};
constexpr std::array ast_options = {
    OptionRow{"--format", "tree|json", "how to print (default: tree)", set_tree_or_json},
    encoding_row,
    nesting_row,
    source_size_row,
    unit_memory_row,
};
constexpr std::array format_options = {
    OptionRow{"--check", "", "print the names of the files that would change, and nothing else",
              set_check},
    OptionRow{"--write", "", "rewrite the files that change, and print their names", set_write},
    OptionRow{"--keyword-case", "CASE", "spell keywords upper (default), lower, or keep them",
              set_keyword_case},
    OptionRow{"--indent", "N", "blanks a level (0 to 16, default 4)", set_indent},
    OptionRow{"--line-length", "N", "columns of a line (20 to 10000, default 100)",
              set_line_length},
    encoding_row,
    nesting_row,
    source_size_row,
    unit_memory_row,
    jobs_row,
};
constexpr std::array explain_options = {
    OptionRow{"--list", "", "list every code with its name and message", set_list},
};
constexpr std::array compliance_options = {
    OptionRow{"--format", "text|markdown|json", "how to print (default: text)",
              set_statement_format},
};

// ---- commands
// ------------------------------------------------------------------------------------

constexpr std::string_view inputs = "FILE-or-FOLDER...";

constexpr std::string_view check_details =
    R"(Reads every file, prints what is found in it, and says which of the three
determinations of IEC 61131-3:2003, 1.5.1 was reached: no violations,
violations, or none found but the examination is incomplete.

A folder stands for every *.st, *.il, *.sfc, *.iec and *.pou in it and below it,
`-` for standard input, `@file` for the arguments in that file, one a line.

--warn, --allow and --deny take a code (IEC2001), a name (missing-semicolon) or
one of the classes violation, error, extension, implementation-dependent, limit;
they can be repeated, the last one counts, and one for a code or name wins over
one for a class. They win over --dialect, --strict and one for all extensions over
all of it; `iecfront compliance` lists the dialects and their extensions.

exit status:
  0  no violations found: nothing, or what the standard permits
  1  violations were found
  2  wrong usage, or an input could not be read
  3  nothing found, but something in the input was not examined: it is beyond a
     limit
)";

constexpr std::string_view tokens_details =
    R"(Prints `line:column kind "text"` for each token, comment and pragma, in the order
of the source; with --format json one object for each file. What is wrong with
the text is left to `iecfront check`.

A folder stands for every *.st, *.il, *.sfc, *.iec and *.pou in it and below it,
`-` for standard input, `@file` for the arguments in that file, one a line.

exit status: 0, or 2 for wrong usage or an input that could not be read
)";

constexpr std::string_view ast_details =
    R"(Prints the syntax tree of each file, with --format json as one object for each.
There is a tree for every text; what is wrong with it is left to `iecfront check`.

A folder stands for every *.st, *.il, *.sfc, *.iec and *.pou in it and below it,
`-` for standard input, `@file` for the arguments in that file, one a line.

exit status: 0, or 2 for wrong usage or an input that could not be read
)";

constexpr std::string_view format_details =
    R"(Prints each file in one agreed layout: a statement a line, four blanks a level,
keywords in upper case, colons and initial values of declarations aligned, long
lines broken. Comments and pragmas stay where they are, and lines of yours inside
of statements and lists as far as possible. Lines with violations of the syntax
stay as they are. What is formatted once stays as it is.

With --write a file is replaced by a new one as a whole, or not at all.

A folder stands for every *.st, *.il, *.sfc, *.iec and *.pou in it and below it,
`-` for standard input, `@file` for the arguments in that file, one a line.

exit status:
  0  done; with --check: nothing would change
  1  with --check: something would change
  2  wrong usage, or a file could not be read or written
)";

constexpr std::string_view explain_details =
    R"(WHAT is a code (IEC2001), a name of a diagnostic or an extension
(missing-semicolon, line-comment), or a feature of the standard's feature
tables: 4.2 is feature 2 of Table 4, 3a.1 feature 1 of Table 3 a).

exit status: 0, or 2 when there is no such thing
)";

constexpr std::string_view compliance_details =
    R"(Prints what IEC 61131-3:2003, 1.5.1 wants told of a product: which features of
the language are supported, how the requirements are met, the values of the
implementation-dependent parameters (Annex D), how each error is treated
(Annex E), and the extensions. It reads no files.

exit status: 0, or 2 for wrong usage
)";

constexpr std::array command_table = {
    Command{"check", inputs, "report what is wrong with source texts", check_details, check_options,
            run_check},
    Command{"tokens", inputs, "print the tokens of source texts", tokens_details, tokens_options,
            run_tokens},
    Command{"ast", inputs, "print the syntax trees of source texts", ast_details, ast_options,
            run_ast},
    Command{"format", inputs, "lay source texts out", format_details, format_options, run_format},
    Command{"explain", "WHAT...", "explain diagnostics, extensions and features", explain_details,
            explain_options, run_explain},
    Command{"compliance", "", "print the compliance statement", compliance_details,
            compliance_options, run_compliance},
};

} // namespace

std::span<const Command> commands() noexcept {
    return command_table;
}

} // namespace iecfront::cli
