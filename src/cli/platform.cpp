#include "cli/platform.hpp"

#include <algorithm>
#include <system_error>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#else
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace iecfront::cli {
namespace {

[[nodiscard]] bool is_control(char c) noexcept {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

// The signal that came while there was an `Uninterrupted`; 0 for none.
volatile std::sig_atomic_t noted_signal = 0;

extern "C" void note_signal(int signal) {
    noted_signal = signal;
}

} // namespace

void prepare_standard_streams() {
#ifdef _WIN32
    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
#endif
#ifdef SIGPIPE
    std::signal(SIGPIPE, SIG_IGN);
#endif
}

bool is_terminal(std::FILE* stream) {
#ifdef _WIN32
    return _isatty(_fileno(stream)) != 0;
#else
    return isatty(fileno(stream)) != 0;
#endif
}

std::FILE* open_for_reading(const std::filesystem::path& path) {
#ifdef _WIN32
    return _wfopen(path.c_str(), L"rb");
#else
    return std::fopen(path.c_str(), "rb");
#endif
}

std::FILE* open_new_file(const std::filesystem::path& path) {
#ifdef _WIN32
    return _wfopen(path.c_str(), L"wbx");
#else
    return std::fopen(path.c_str(), "wbx");
#endif
}

void copy_owner(const std::filesystem::path& like, const std::filesystem::path& file) noexcept {
#ifdef _WIN32
    static_cast<void>(like);
    static_cast<void>(file);
#else
    struct stat status = {};
    if (stat(like.c_str(), &status) != 0)
        return;
    // If it may not be given away, it stays the user's, as if the user had made it.
    [[maybe_unused]] const int failed = chown(file.c_str(), status.st_uid, status.st_gid);
#endif
}

Uninterrupted::Uninterrupted() {
    std::ranges::transform(interruptions, before_.begin(),
                           [](int signal) { return std::signal(signal, note_signal); });
}

Uninterrupted::~Uninterrupted() {
    for (std::size_t i = 0; i < interruptions.size(); ++i)
        std::signal(interruptions[i], before_[i]);
    if (noted_signal != 0)
        std::raise(noted_signal);
}

std::string system_message(int error) {
    return std::error_code(error, std::generic_category()).message();
}

std::string on_one_line(std::string text) {
    if (std::none_of(text.begin(), text.end(), is_control))
        return text;
    std::string out;
    for (const char c : text) {
        if (!is_control(c)) {
            out += c;
            continue;
        }
        constexpr std::string_view digits = "0123456789ABCDEF";
        const auto byte = static_cast<unsigned char>(c);
        out += "\\x";
        out += digits[byte >> 4U];
        out += digits[byte & 0xFU];
    }
    return out;
}

} // namespace iecfront::cli
