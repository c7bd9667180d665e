#include "cli/output.hpp"

#include "cli/platform.hpp"

#include <cerrno>
#include <cstdio>
#include <string>

namespace iecfront::cli {
namespace {

[[noreturn]] void fail() {
    const int error = errno;
    const std::string what = "standard output: " + system_message(error);
    if (error == EPIPE)
        throw OutputClosed(what);
    throw OutputError(what);
}

} // namespace

void print(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
        fail();
}

void flush_output() {
    if (std::fflush(stdout) != 0)
        fail();
}

void complain(std::string_view text) {
    // Whether it went well shows at the next write.
    std::fflush(stdout);
    const std::string line = "iecfront: " + std::string(text) + "\n";
    std::fwrite(line.data(), 1, line.size(), stderr);
}

} // namespace iecfront::cli
