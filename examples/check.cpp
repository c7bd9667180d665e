// A minimal linter: prints what is wrong with each file, and says so in its exit status. The
// command `iecfront check` does the same with more comfort.
#include "read_source.hpp"

namespace {

enum ExitStatus { nothing_found = 0, violations = 1, unusable = 2 };

ExitStatus check(const std::string& path, const iecfront::SeverityPolicy& policy) {
    const std::optional<iecfront::SourceText> source = read_source(path);
    if (!source)
        return unusable;
    const std::vector<iecfront::Diagnostic> found = iecfront::parse(*source).diagnostics();
    std::fputs(iecfront::render_text(found, *source, policy).c_str(), stdout);
    const iecfront::Determination determination = iecfront::determine(found, policy);
    std::printf("%s: %s\n", path.c_str(), to_string(determination).data());
    return determination == iecfront::Determination::violations ? violations : nothing_found;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: check FILE...\n", stderr);
        return unusable;
    }
    // The software switch of 1.5.1: here, whoever makes use of an extension is told.
    iecfront::SeverityPolicy policy;
    policy.set(iecfront::DiagnosticClass::extension, iecfront::Severity::warning);

    ExitStatus status = nothing_found;
    for (int i = 1; i < argc; ++i)
        status = std::max(status, check(argv[i], policy));
    return status;
}
