#pragma once

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>

/// The few things that standard C++ leaves to the system.
namespace iecfront::cli {

/// Makes standard input and output pass bytes as they are, and lets writing to a closed pipe fail
/// as any other write instead of ending the program.
void prepare_standard_streams();

/// True when somebody looks at `stream`.
[[nodiscard]] bool is_terminal(std::FILE* stream);

/// Opens a file for reading bytes; null, and the reason in `errno`, when that fails.
[[nodiscard]] std::FILE* open_for_reading(const std::filesystem::path& path);

/// Makes a file and opens it for writing bytes; null, and the reason in `errno`, when that fails,
/// also because it is there.
[[nodiscard]] std::FILE* open_new_file(const std::filesystem::path& path);

/// Gives `file` the owner and the group of `like`, where the system has these and lets it.
void copy_owner(const std::filesystem::path& like, const std::filesystem::path& file) noexcept;

/// The signals that end a program at the wish of its user.
inline constexpr std::array interruptions = {
    SIGINT,
    SIGTERM,
#ifndef _WIN32
    SIGHUP,
    SIGQUIT,
#endif
};

/// While one is there, the program is not interrupted: that happens at the end of its life. One at
/// a time.
class Uninterrupted {
public:
    Uninterrupted();
    ~Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    Uninterrupted& operator=(const Uninterrupted&) = delete;

private:
    using Handler = void (*)(int);
    std::array<Handler, interruptions.size()> before_{};
};

/// The system's words for an error number (`errno`).
[[nodiscard]] std::string system_message(int error);

/// Bytes that move the terminal's cursor or end the line spelled out as `\x1B`, so that a file name
/// stays on one line.
[[nodiscard]] std::string on_one_line(std::string text);

} // namespace iecfront::cli
