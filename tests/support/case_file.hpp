#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

/// One case of a case file: a source and what is expected of it.
///
///     === title of the case
///     : tags B.1.3.3 table-12.2      free words, one line or several
///     : encoding iso-8859-1          the bytes of the source are read in that encoding
///     : escapes                      \r \n \t \0 \xHH \\ in the source are decoded, and a `\` at
///                                    the end of a line takes the line end away
///     : max-nesting 5                ParseOptions::maximum_nesting
///     : max-identifier-length 8      ParseOptions::maximum_identifier_length
///     : max-diagnostics 2            ParseOptions::maximum_diagnostics
///     : max-source-size 40           ParseOptions::maximum_source_size
///     : max-unit-memory 400          ParseOptions::maximum_unit_memory
///     : report CLASS-OR-CODE         shown though it is allowed by default
///     : fixes-leave reason in words  not all is well when the fixes are applied
///     source lines
///     --- diagnostics                nothing is reported where this section is missing
///     --- tree                       checked where the section is there
///     --- fixed                      the same
///     --- formatted                  the same, in tests/format/layouts
///
/// The sections end at the next line that begins so. Blank lines at the end of a section, and
/// blanks at the end of a line, do not count.
struct Case {
    struct Section {
        std::string name;
        std::string heading; ///< the line itself
        std::string text;
        std::string blank_lines; ///< behind the text
    };

    std::string title;
    std::size_t line = 0;   ///< of the title, 1-based
    std::string header;     ///< the title line and the lines that begin in `:`, as they stand there
    std::string raw_source; ///< as it stands there
    std::vector<Section> sections;

    std::vector<std::string> tags;
    std::string encoding;
    std::string maximum_nesting;
    std::string maximum_identifier_length;
    std::string maximum_diagnostics;
    std::string maximum_source_size;
    std::string maximum_unit_memory;
    std::vector<std::string> report;
    std::optional<std::string> fixes_leave;
    bool escapes = false;

    /// The source with its escapes decoded.
    [[nodiscard]] std::string source() const;
    /// `text` as the source of this case is written.
    [[nodiscard]] std::string written(std::string_view text) const;

    [[nodiscard]] const Section* find(std::string_view name) const;
    /// The text of a section; empty when it is not there.
    [[nodiscard]] std::string_view expected(std::string_view name) const;
    /// Sets the text of a section that is there.
    void replace(std::string_view name, std::string text);
    /// Makes the diagnostics section say `text`; there is none when it is empty.
    void set_diagnostics(std::string text);
};

/// A file of cases, read without loss.
struct CaseFile {
    std::string path;     ///< from the top of the repository
    std::string preamble; ///< what stands before the first case
    std::vector<Case> cases;
    std::vector<std::string> faults; ///< what cannot be read, as `path:line: what`
};

[[nodiscard]] CaseFile read_case_file(std::string path, std::string_view text);

/// The inverse.
[[nodiscard]] std::string write_case_file(const CaseFile& file);

/// All case files of the repository.
[[nodiscard]] std::vector<CaseFile> all_case_files();

} // namespace iecfront::test
