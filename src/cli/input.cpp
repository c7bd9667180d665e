#include "cli/input.hpp"

#include "cli/platform.hpp"
#include "cli/usage_error.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <system_error>
#include <utility>

namespace iecfront::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> source_extensions = {".st", ".il", ".sfc", ".iec",
                                                               ".pou"};
constexpr std::string_view no_sources = "no *.st, *.il, *.sfc, *.iec or *.pou in this folder";

constexpr std::string_view utf_16_unknown =
    "this is UTF-16, which cannot be read; save it as UTF-8, ISO 8859-1 or Windows-1252";

// What is read at a time when the size of the whole is not known.
constexpr std::size_t chunk_size = std::size_t{1} << 16U;

[[nodiscard]] bool is_source(const fs::path& path) {
    const std::string extension = path.extension().string();
    return std::any_of(
        source_extensions.begin(), source_extensions.end(),
        [&](std::string_view candidate) { return names_equal(extension, candidate); });
}

void add_problem(std::vector<Input>& inputs, const fs::path& path, std::string problem) {
    inputs.push_back({path, path.string(), std::move(problem), false});
}

void add_folder(std::vector<Input>& inputs, const fs::path& folder) {
    std::error_code error;
    std::vector<fs::directory_entry> entries;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        entries.push_back(*it);
    if (error)
        add_problem(inputs, folder, error.message());
    std::sort(entries.begin(), entries.end());

    for (const fs::directory_entry& entry : entries) {
        const fs::file_status own = entry.symlink_status(error);
        if (fs::is_directory(own))
            add_folder(inputs, entry.path());
        else if (is_source(entry.path()) && !fs::is_directory(entry.status(error)))
            inputs.push_back({entry.path(), entry.path().string(), {}, false});
    }
}

struct CloseFile {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// Reads to the end, or to one byte beyond what a text can have.
[[nodiscard]] std::string read_all(std::FILE* file, std::uintmax_t expected_size) {
    constexpr std::uint64_t enough = SourceText::maximum_size + 1;
    std::string bytes;
    std::size_t room = static_cast<std::size_t>(expected_size) + 1; // one more to find the end
    while (bytes.size() < enough) {
        const std::size_t begin = bytes.size();
        room = std::min<std::size_t>(room, enough - begin);
        bytes.resize(begin + room);
        const std::size_t count = std::fread(bytes.data() + begin, 1, room, file);
        bytes.resize(begin + count);
        if (count < room)
            break;
        room = std::max(chunk_size, bytes.size());
    }
    return bytes;
}

[[nodiscard]] ReadText failed(const Input& input, Encoding encoding, std::string problem) {
    return {SourceText(std::string(), input.name, encoding), false, std::move(problem)};
}

// UTF-16 by its byte order mark, or as it is of text in the Latin alphabet.
[[nodiscard]] bool looks_like_utf_16(std::string_view bytes) {
    if (bytes.size() < 4)
        return false;
    const std::string_view mark = bytes.substr(0, 2);
    const auto is_zero = [bytes](std::size_t i) { return bytes[i] == '\0'; };
    return mark == "\xFF\xFE" || mark == "\xFE\xFF" ||
           (!is_zero(0) && is_zero(1) && !is_zero(2) && is_zero(3)) ||
           (is_zero(0) && !is_zero(1) && is_zero(2) && !is_zero(3));
}

[[nodiscard]] ReadText read_stream(const Input& input, Encoding encoding, std::FILE* file,
                                   std::uintmax_t expected_size) {
    errno = 0;
    std::string bytes = read_all(file, expected_size);
    if (std::ferror(file) != 0)
        return failed(input, encoding, system_message(errno));
    if (looks_like_utf_16(bytes))
        return failed(input, encoding, std::string(utf_16_unknown));
    SourceText source(std::move(bytes), input.name, encoding);
    const bool too_large = source.too_large();
    return {std::move(source), too_large, {}};
}

[[nodiscard]] ReadText read_file(const Input& input, Encoding encoding) {
    std::error_code error;
    std::uintmax_t size = 0; // stays 0 for what has none, such as a device
    if (fs::is_regular_file(input.path, error))
        size = fs::file_size(input.path, error);
    if (error)
        return failed(input, encoding, error.message());
    if (size > SourceText::maximum_size)
        return {SourceText(std::string(), input.name, encoding), true, {}};
    const File file(open_for_reading(input.path));
    if (!file)
        return failed(input, encoding, system_message(errno));
    return read_stream(input, encoding, file.get(), size);
}

} // namespace

std::vector<Input> find_inputs(std::span<const std::string> arguments) {
    std::vector<Input> inputs;
    if (arguments.empty())
        throw UsageError("name files or folders to read, or `-` for standard input");
    if (std::count(arguments.begin(), arguments.end(), "") > 0)
        throw UsageError("one of the names is empty");
    if (std::count(arguments.begin(), arguments.end(), "-") > 1)
        throw UsageError("standard input can be read once only");
    for (const std::string& argument : arguments) {
        if (argument == "-") {
            inputs.push_back({{}, "<stdin>", {}, true});
            continue;
        }
        std::error_code error;
        if (!fs::is_directory(argument, error)) {
            inputs.push_back({argument, argument, {}, false});
            continue;
        }
        const std::size_t before = inputs.size();
        add_folder(inputs, argument);
        if (inputs.size() == before)
            add_problem(inputs, argument, std::string(no_sources));
    }
    return inputs;
}

ReadText read_input(const Input& input, Encoding encoding) noexcept {
    if (!input.problem.empty())
        return failed(input, encoding, input.problem);
    try {
        return input.standard_input ? read_stream(input, encoding, stdin, 0)
                                    : read_file(input, encoding);
    } catch (const std::exception& exception) {
        return failed(input, encoding, exception.what());
    }
}

} // namespace iecfront::cli
