#pragma once

#include <stdexcept>
#include <string_view>

namespace iecfront::cli {

/// Standard output took no more: its device is full, say.
class OutputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Nobody reads standard output any longer, as behind `| head`: no mistake to tell anybody of.
class OutputClosed : public OutputError {
public:
    using OutputError::OutputError;
};

/// Writes to standard output; throws `OutputError` or `OutputClosed` when that fails.
void print(std::string_view text);

/// Lets everything printed reach its place; throws as `print` does when that fails.
void flush_output();

/// Writes the line `iecfront: <text>` to standard error, behind what was printed before it.
void complain(std::string_view text);

} // namespace iecfront::cli
