#include "fuzz/numbers.hpp"
#include "fuzz/targets.hpp"
#include "support/json.hpp"
#include "support/sarif_faults.hpp"

#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/diagnostics/render_sarif.hpp>
#include <iecfront/diagnostics/render_text.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <set>

// What is written of findings is well-formed, whatever the bytes of the text and of its name.

namespace iecfront::test {
namespace {

/// Well-formed UTF-8 without control characters: nothing in a text can steer a terminal.
[[nodiscard]] bool is_plain(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const DecodedCharacter character = decode_character(text, i, Encoding::utf8);
        const bool control = character.code_point < 0x20 ||
                             (character.code_point >= 0x7F && character.code_point < 0xA0);
        if (!character.valid || (control && character.code_point != '\n'))
            return false;
        i += character.size;
    }
    return true;
}

/// The findings of one text, rendered in each way.
class Renderer {
public:
    explicit Renderer(const SourceText& source)
        : source_(source), lines_(source.bytes()), found_(parse(source).diagnostics()) {}

    [[nodiscard]] std::string fault() const {
        // Of a name the exact bytes are shown: a file is opened by them.
        if (!is_plain(render_text(
                found_, SourceText(std::string(source_.bytes()), "x.st", source_.encoding()))))
            return "the findings as text are not plain UTF-8";
        if (!read_json(json()))
            return "the findings as JSON are not well-formed";
        const std::optional<JsonValue> log = read_json(sarif());
        if (!log)
            return "the log is not well-formed";
        const std::vector<std::string> faults = sarif_faults(*log);
        return faults.empty() ? "" : faults.front();
    }

private:
    template<class Render>
    [[nodiscard]] std::string joined(const Render& render) const {
        std::string out;
        for (const Diagnostic& diagnostic : found_) {
            out += out.empty() ? "" : ",\n";
            (void)render(out, diagnostic, Severity::warning, source_, lines_);
        }
        return out;
    }
    [[nodiscard]] std::string json() const { return "[" + joined(render_json) + "]"; }
    [[nodiscard]] std::string sarif() const {
        std::set<DiagnosticId> ids;
        for (const Diagnostic& diagnostic : found_)
            ids.insert(diagnostic.id);
        SarifRun run;
        run.tool_name = "iecfront " + source_.name();
        run.tool_version = "0.1.0";
        for (const DiagnosticId id : ids)
            run.rules.push_back({id, source_.name()});
        run.problems = {"in " + source_.name()};
        run.not_examined = {"of " + source_.name()};
        return begin_sarif_log(run) + joined(render_sarif) + std::string(end_sarif_log());
    }

    const SourceText& source_;
    LineTable lines_;
    std::vector<Diagnostic> found_;
};

} // namespace

std::string render_fault(std::string_view bytes) {
    NumbersFromEnd numbers(bytes);
    const auto encoding = static_cast<Encoding>(numbers.below(3));
    const std::string_view name = bytes.substr(bytes.size() - numbers.below(bytes.size() + 1));
    const SourceText source(std::string(bytes), std::string(name), encoding);
    return Renderer(source).fault();
}

} // namespace iecfront::test
