#include "cli/check_file.hpp"
#include "cli/commands.hpp"
#include "cli/explain_pages.hpp"
#include "cli/output.hpp"
#include "cli/parallel.hpp"
#include "cli/platform.hpp"
#include "cli/progress.hpp"

#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/diagnostics/render_sarif.hpp>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace iecfront::cli {
namespace {

[[nodiscard]] bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

[[nodiscard]] bool wants_colour(Colour colour) {
    if (colour != Colour::automatic)
        return colour == Colour::always;
    const char* terminal = std::getenv("TERM");
    const bool dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
    return !is_set("NO_COLOR") && !dumb && is_terminal(stdout);
}

/// Collects the reports of the files, in order, and says what comes out.
class CheckRun {
public:
    CheckRun(const Options& options, std::vector<Input> inputs)
        : settings_{options, options.policy(), {wants_colour(options.colour), true}},
          inputs_(std::move(inputs)),
          progress_(inputs_.size()) {}

    [[nodiscard]] Status run() {
        work_in_order(
            inputs_.size(), settings_.options.job_count(),
            [&](std::size_t i) { return check_file(inputs_[i], settings_); },
            [&](std::size_t i, const FileReport& report) { take(i, report); });
        progress_.clear();
        if (findings_.files == 0 && findings_.determination == Determination::no_violations)
            findings_.determination = Determination::incomplete;
        switch (settings_.options.format) {
        case Format::markdown: // no format of this command
        case Format::text: print(summary()); break;
        case Format::json: print_json(); break;
        case Format::sarif: print_sarif(); break;
        }
        return status();
    }

private:
    void take(std::size_t i, const FileReport& report) {
        if (!report.problem.empty())
            take_problem(on_one_line(inputs_[i].name) + ": " + report.problem);
        findings_.add(report.findings);
        if (settings_.options.format != Format::text) {
            diagnostics_ += diagnostics_.empty() || report.text.empty() ? "" : ",\n";
            diagnostics_ += report.text;
        } else if (!report.text.empty()) {
            progress_.clear();
            print(report.text);
        }
        progress_.show(i + 1);
    }

    void take_problem(std::string problem) {
        progress_.clear();
        complain(problem);
        problems_.push_back(std::move(problem));
        Findings nothing;
        nothing.determination = Determination::incomplete;
        findings_.add(nothing);
    }

    // Lines that say which limits were hit, and of which parameter of Annex D.
    [[nodiscard]] std::vector<std::string> limits() const {
        std::vector<std::string> lines;
        for (const DiagnosticId id : findings_.limits) {
            std::string line = code_string(id) + " " + std::string(diagnostic_info(id).name);
            if (const AnnexDParameter* const parameter = find_parameter(id))
                line += " (Annex D, " + std::string(parameter->subclause) + ": " +
                        std::string(parameter->parameter) + ")";
            lines.push_back(std::move(line));
        }
        return lines;
    }

    // Lines that say what in this input was left out.
    [[nodiscard]] std::vector<std::string> left_out() const {
        std::vector<std::string> lines = problems_;
        for (std::string& line : limits())
            lines.push_back(std::move(line));
        return lines;
    }

    [[nodiscard]] std::string summary() const {
        std::string out = counted(findings_.files, "file");
        if (findings_.errors > 0)
            out += ", " + counted(findings_.errors, "error");
        if (findings_.warnings > 0)
            out += ", " + counted(findings_.warnings, "warning");
        out += conclusion();
        for (const std::string& line : left_out())
            out += "  not examined: " + line + "\n";
        if (findings_.files > 0 && findings_.determination == Determination::incomplete)
            for (const std::string_view line : never_examined())
                out += "  never examined by this version: " + std::string(line) + "\n";
        return out;
    }

    [[nodiscard]] std::string_view conclusion() const {
        switch (findings_.determination) {
        case Determination::no_violations: return ": no violations\n";
        case Determination::violations: return ": violations were found\n";
        case Determination::incomplete: break;
        }
        return findings_.files == 0 ? ": nothing was examined\n"
                                    : ": no violations found, but the examination is incomplete\n";
    }

    // The diagnostics may be most of the memory there is: they are not copied once more.
    void print_json() const {
        std::vector<std::string> not_examined = left_out();
        for (const std::string_view line : never_examined())
            not_examined.emplace_back(line);
        std::string head = "{\"determination\": ";
        append_json_string(head, to_string(findings_.determination));
        head += ",\n\"notExamined\": [";
        const char* separator = "";
        for (const std::string& line : not_examined) {
            head += separator;
            append_json_string(head, line);
            separator = ", ";
        }
        head += "],\n\"files\": " + std::to_string(findings_.files) + ",\n\"diagnostics\": [";
        print(head);
        print(diagnostics_.empty() ? "" : "\n");
        print(diagnostics_);
        print(diagnostics_.empty() ? "]}\n" : "\n]}\n");
    }

    void print_sarif() const {
        SarifRun run{"iecfront", IECFRONT_VERSION, {}, findings_.determination,
                     problems_,  limits()};
        for (const DiagnosticId id : findings_.reported)
            run.rules.push_back({id, std::string(explain_page(code_string(id)))});
        for (const std::string_view line : never_examined())
            run.not_examined.emplace_back(line);
        print(begin_sarif_log(run));
        print(diagnostics_.empty() ? "" : "\n");
        print(diagnostics_);
        print(end_sarif_log());
        print("\n");
    }

    // What could not be read counts most: it may hold anything.
    [[nodiscard]] Status status() const {
        if (!problems_.empty())
            return Status::unusable;
        if (findings_.determination == Determination::violations)
            return Status::violations;
        return findings_.limits.empty() ? Status::nothing_found : Status::incomplete;
    }

    CheckSettings settings_;
    std::vector<Input> inputs_;
    Progress progress_;
    Findings findings_;
    std::vector<std::string> problems_;
    std::string diagnostics_; // objects of JSON or SARIF
};

} // namespace

Status run_check(const Options& options) {
    return CheckRun(options, find_inputs(options.operands)).run();
}

} // namespace iecfront::cli
