#include "support/case_file.hpp"

#include "support/repository_files.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <utility>

namespace iecfront::test {
namespace {

constexpr std::string_view title_mark = "=== ";
constexpr std::string_view section_mark = "--- ";
constexpr std::string_view directive_mark = ": ";

constexpr std::array<std::string_view, 4> section_names{"diagnostics", "tree", "fixed",
                                                        "formatted"};

[[nodiscard]] std::string_view without_line_end(std::string_view line) {
    return line.ends_with('\n') ? line.substr(0, line.size() - 1) : line;
}

/// The lines of `text` with their ends.
[[nodiscard]] std::vector<std::string_view> whole_lines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return lines;
}

/// Moves the blank lines at the end of the section's text out of it.
void split_blank_lines(Case::Section& section) {
    std::size_t end = section.text.size();
    while (end > 0 && section.text[end - 1] == '\n' && (end == 1 || section.text[end - 2] == '\n'))
        --end;
    section.blank_lines = section.text.substr(end) + section.blank_lines;
    section.text.resize(end);
}

/// Reads a case file line by line.
class Reader {
public:
    explicit Reader(std::string path) { file_.path = std::move(path); }

    CaseFile read(std::string_view text) {
        for (const std::string_view line : whole_lines(text)) {
            ++line_;
            if (line.starts_with(title_mark))
                begin_case(line);
            else if (file_.cases.empty())
                file_.preamble += line;
            else if (in_header_ && line.starts_with(directive_mark))
                read_directive(line);
            else
                read_content(line);
        }
        for (Case& one : file_.cases)
            for (Case::Section& section : one.sections)
                split_blank_lines(section);
        return std::move(file_);
    }

private:
    [[nodiscard]] Case& current() { return file_.cases.back(); }

    void fault(std::string_view what) {
        file_.faults.push_back(file_.path + ':' + std::to_string(line_) + ": " + std::string(what));
    }

    void begin_case(std::string_view line) {
        file_.cases.emplace_back();
        current().title = without_line_end(line.substr(title_mark.size()));
        current().line = line_;
        current().header = line;
        in_header_ = true;
    }

    void read_directive(std::string_view line) {
        current().header += line;
        std::istringstream words{std::string(line.substr(directive_mark.size()))};
        std::string name;
        words >> name;
        std::string rest;
        std::getline(words >> std::ws, rest);
        if (!take_directive(name, rest))
            fault("`: " + name + "` is not known");
    }

    [[nodiscard]] bool take_directive(std::string_view name, const std::string& rest) {
        if (name == "tags") {
            std::istringstream tags(rest);
            for (std::string tag; tags >> tag;)
                current().tags.push_back(tag);
        } else if (name == "encoding") {
            current().encoding = rest;
        } else if (name == "max-nesting") {
            current().maximum_nesting = rest;
        } else if (name == "max-identifier-length") {
            current().maximum_identifier_length = rest;
        } else if (name == "max-source-size") {
            current().maximum_source_size = rest;
        } else if (name == "max-unit-memory") {
            current().maximum_unit_memory = rest;
        } else if (name == "max-diagnostics") {
            current().maximum_diagnostics = rest;
        } else if (name == "report") {
            current().report.push_back(rest);
        } else if (name == "fixes-leave") {
            current().fixes_leave = rest;
        } else if (name == "escapes") {
            current().escapes = true;
        } else {
            return false;
        }
        return true;
    }

    void read_content(std::string_view line) {
        in_header_ = false;
        if (line.starts_with(section_mark))
            begin_section(line);
        else if (current().sections.empty())
            current().raw_source += line;
        else
            current().sections.back().text += line;
    }

    void begin_section(std::string_view line) {
        const std::string name(without_line_end(line.substr(section_mark.size())));
        const auto* known = std::find(section_names.begin(), section_names.end(), name);
        if (known == section_names.end())
            fault("`--- " + name + "` is not known");
        if (current().find(name) != nullptr)
            fault("`--- " + name + "` is there twice");
        current().sections.push_back({name, std::string(line), {}, {}});
    }

    CaseFile file_;
    std::size_t line_ = 0;
    bool in_header_ = false;
};

// ---- escapes
// -------------------------------------------------------------------------------------

[[nodiscard]] char escaped(char c) {
    switch (c) {
    case 'r': return '\r';
    case 'n': return '\n';
    case 't': return '\t';
    case '0': return '\0';
    default: return c;
    }
}

[[nodiscard]] std::string decoded(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\' || i + 1 == text.size()) {
            result += text[i];
            continue;
        }
        ++i;
        if (text[i] == 'x') {
            result += static_cast<char>(std::stoi(std::string(text.substr(i + 1, 2)), nullptr, 16));
            i += 2;
        } else if (text[i] != '\n') {
            result += escaped(text[i]);
        }
    }
    return result;
}

void append_hex(std::string& out, char c) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    out += "\\x";
    out += digits[byte / 16];
    out += digits[byte % 16];
}

void append_encoded(std::string& out, char c, bool ends_line) {
    if (c == '\\')
        out += "\\\\";
    else if (c == '\r')
        out += "\\r";
    else if (c == '\t')
        out += "\\t";
    else if (c == '\0')
        out += "\\0";
    else if (c != '\n' && (c < ' ' || c > '~' || (c == ' ' && ends_line)))
        append_hex(out, c);
    else
        out += c;
}

[[nodiscard]] std::string encoded(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i)
        append_encoded(result, text[i], i + 1 == text.size() || text[i + 1] == '\n');
    if (!text.empty() && !text.ends_with('\n'))
        result += "\\\n";
    return result;
}

} // namespace

std::string Case::source() const {
    return escapes ? decoded(raw_source) : raw_source;
}

std::string Case::written(std::string_view text) const {
    return escapes ? encoded(text) : std::string(text);
}

const Case::Section* Case::find(std::string_view name) const {
    const auto found = std::find_if(sections.begin(), sections.end(),
                                    [&](const Section& one) { return one.name == name; });
    return found == sections.end() ? nullptr : &*found;
}

std::string_view Case::expected(std::string_view name) const {
    const Section* section = find(name);
    return section == nullptr ? std::string_view() : section->text;
}

void Case::replace(std::string_view name, std::string text) {
    for (Section& section : sections) {
        if (section.name != name)
            continue;
        section.text = std::move(text);
        split_blank_lines(section);
        if (section.blank_lines.size() > 1)
            section.blank_lines = "\n";
    }
}

void Case::set_diagnostics(std::string text) {
    constexpr std::string_view name = "diagnostics";
    if (text.empty())
        std::erase_if(sections, [&](const Section& one) { return one.name == name; });
    else if (find(name) == nullptr)
        sections.insert(sections.begin(), {std::string(name), "--- diagnostics\n", text, {}});
    else
        replace(name, std::move(text));
}

CaseFile read_case_file(std::string path, std::string_view text) {
    return Reader(std::move(path)).read(text);
}

std::string write_case_file(const CaseFile& file) {
    std::string text = file.preamble;
    for (const Case& one : file.cases) {
        text += one.header + one.raw_source;
        for (const Case::Section& section : one.sections)
            text += section.heading + section.text + section.blank_lines;
    }
    return text;
}

std::vector<CaseFile> all_case_files() {
    std::vector<CaseFile> files;
    for (const RepositoryFile& file : repository_files({"tests/cases"}, {".txt"}))
        if (!file.path.ends_with("/required_tags.txt"))
            files.push_back(read_case_file(file.path, file.text));
    return files;
}

} // namespace iecfront::test
