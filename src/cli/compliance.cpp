#include "cli/commands.hpp"
#include "cli/output.hpp"

#include <iecfront/compliance/statement.hpp>

namespace iecfront::cli {
namespace {

[[nodiscard]] StatementFormat statement_format(Format format) noexcept {
    switch (format) {
    case Format::markdown: return StatementFormat::markdown;
    case Format::json: return StatementFormat::json;
    case Format::text:
    case Format::sarif: break; // no format of this command
    }
    return StatementFormat::text;
}

} // namespace

Status run_compliance(const Options& options) {
    if (!options.operands.empty())
        throw UsageError("`compliance` reads no files");
    print(compliance_statement(statement_format(options.format), "iecfront " IECFRONT_VERSION));
    return Status::nothing_found;
}

} // namespace iecfront::cli
