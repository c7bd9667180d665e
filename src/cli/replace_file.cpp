#include "cli/replace_file.hpp"

#include "cli/platform.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace iecfront::cli {
namespace {

namespace fs = std::filesystem;

// Names that are tried for the new file, before it gets its own.
constexpr int most_attempts = 100;

/// A file that is removed unless it is put in the place of another one.
class NewFile {
public:
    explicit NewFile(const fs::path& beside) {
        for (int i = 0; i < most_attempts && file_ == nullptr; ++i) {
            path_ = beside;
            path_ += ".new" + std::to_string(i);
            file_ = open_new_file(path_);
            error_ = file_ == nullptr ? errno : 0;
            if (error_ != 0 && error_ != EEXIST)
                return;
        }
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile() {
        close();
        std::error_code ignored;
        if (exists_)
            fs::remove(path_, ignored);
    }

    void write(std::string_view bytes) {
        if (error_ != 0)
            return;
        exists_ = true;
        if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
            error_ = errno;
        close();
    }

    /// Gives the reason when something went wrong, here or before.
    [[nodiscard]] std::string replace(const fs::path& path) {
        if (error_ != 0)
            return system_message(error_);
        std::error_code error;
        const fs::perms permissions = fs::status(path, error).permissions();
        copy_owner(path, path_); // first, because it can take away permissions
        if (!error)
            fs::permissions(path_, permissions, error);
        if (!error)
            fs::rename(path_, path, error);
        exists_ = static_cast<bool>(error);
        return error ? error.message() : "";
    }

private:
    void close() {
        if (file_ != nullptr && std::fclose(file_) != 0 && error_ == 0)
            error_ = errno;
        file_ = nullptr;
    }

    fs::path path_;
    std::FILE* file_ = nullptr;
    int error_ = 0;
    bool exists_ = false;
};

} // namespace

std::string replace_file(const fs::path& path, std::string_view bytes) {
    std::error_code error;
    const fs::path target = fs::canonical(path, error);
    if (error)
        return error.message();
    if (!fs::is_regular_file(target, error)) // a pipe would become a file
        return "it is not a file that can be replaced";
    const Uninterrupted until_it_is_removed; // or has its name
    NewFile file(target);
    file.write(bytes);
    return file.replace(target);
}

} // namespace iecfront::cli
