#pragma once

#include <iecfront/diagnostics/render_json.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace iecfront {

/// Writes the members of one object, with commas where they belong.
class JsonObject {
public:
    explicit JsonObject(std::string& out) : out_(out) { out_ += '{'; }
    void close() { out_ += '}'; }

    void name(std::string_view member) {
        if (!first_)
            out_ += ',';
        first_ = false;
        out_ += '"';
        out_ += member;
        out_ += "\":";
    }
    void member(std::string_view member_name, std::string_view text) {
        name(member_name);
        append_json_string(out_, text);
    }
    void member(std::string_view member_name, std::uint64_t number) {
        name(member_name);
        out_ += std::to_string(number);
    }
    /// Not `member`: a literal would rather be a truth value than a text.
    void truth(std::string_view member_name, bool value) {
        name(member_name);
        out_ += value ? "true" : "false";
    }

private:
    std::string& out_;
    bool first_ = true;
};

/// Writes `[`, what `write` appends for each item with separators between, and `]`.
template<class Items, class Write>
void append_array(std::string& out, const Items& items, Write write,
                  std::string_view separator = ",") {
    out += '[';
    bool first = true;
    for (const auto& item : items) {
        out += first ? "" : separator;
        first = false;
        write(item);
    }
    out += ']';
}

} // namespace iecfront
