#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::test {

struct JsonMember;

/// A JSON value, for looking at what the library and the command write.
struct JsonValue {
    enum class Kind { null, boolean, number, string, array, object };

    Kind kind = Kind::null;
    std::string text; ///< of a string, decoded; of a number or Boolean as it is written
    std::vector<JsonValue> items;
    std::vector<JsonMember> members; ///< in the order of the text

    /// The member of that name; a null value when there is none.
    [[nodiscard]] const JsonValue& operator[](std::string_view name) const;
    /// The item of that number; a null value when there is none.
    [[nodiscard]] const JsonValue& operator[](std::size_t index) const;
    /// The names of the members, with a blank between.
    [[nodiscard]] std::string names() const;
};

/// A member of an object.
struct JsonMember {
    std::string name;
    JsonValue value;
};

/// Reads exactly one JSON value (RFC 8259) with white space around it. Strict: the text has to be
/// UTF-8, and no object may have two members of a name. Nothing when it is anything else.
[[nodiscard]] std::optional<JsonValue> read_json(std::string_view text);

} // namespace iecfront::test
