#include "support/json.hpp"

#include "source/utf8.hpp"

#include <iecfront/source/encoding.hpp>

#include <algorithm>
#include <cctype>
#include <utility>

namespace iecfront::test {
namespace {

const JsonValue nothing;

[[nodiscard]] bool is_utf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const DecodedCharacter character = decode_character(text, at, Encoding::utf8);
        if (!character.valid)
            return false;
        at += character.size;
    }
    return true;
}

/// Reads by recursive descent; each function takes one thing, or gives false.
class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    [[nodiscard]] bool read(JsonValue& value) {
        if (!read_value(value))
            return false;
        skip_blanks();
        return at_ == text_.size();
    }

private:
    [[nodiscard]] char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    void skip_blanks() {
        while (next() != '\0' && std::string_view(" \t\r\n").find(next()) != std::string_view::npos)
            ++at_;
    }

    [[nodiscard]] bool accept(char c) {
        skip_blanks();
        if (next() != c)
            return false;
        ++at_;
        return true;
    }

    [[nodiscard]] bool accept_word(std::string_view word, JsonValue::Kind kind, JsonValue& value) {
        if (text_.substr(at_, word.size()) != word)
            return false;
        at_ += word.size();
        value.kind = kind;
        value.text = word;
        return true;
    }

    [[nodiscard]] bool read_value(JsonValue& value) {
        skip_blanks();
        switch (next()) {
        case '{': return read_object(value);
        case '[': return read_array(value);
        case '"': value.kind = JsonValue::Kind::string; return read_string(value.text);
        case 't': return accept_word("true", JsonValue::Kind::boolean, value);
        case 'f': return accept_word("false", JsonValue::Kind::boolean, value);
        case 'n': return accept_word("null", JsonValue::Kind::null, value);
        default: return read_number(value);
        }
    }

    [[nodiscard]] bool read_object(JsonValue& value) {
        value.kind = JsonValue::Kind::object;
        ++at_;
        if (accept('}'))
            return true;
        do {
            std::string name;
            skip_blanks();
            if (!read_string(name) || has_member(value, name) || !accept(':'))
                return false;
            value.members.push_back({std::move(name), {}});
            if (!read_value(value.members.back().value))
                return false;
        } while (accept(','));
        return accept('}');
    }

    [[nodiscard]] static bool has_member(const JsonValue& value, std::string_view name) {
        return std::any_of(value.members.begin(), value.members.end(),
                           [&](const auto& member) { return member.name == name; });
    }

    [[nodiscard]] bool read_array(JsonValue& value) {
        value.kind = JsonValue::Kind::array;
        ++at_;
        if (accept(']'))
            return true;
        do {
            value.items.emplace_back();
            if (!read_value(value.items.back()))
                return false;
        } while (accept(','));
        return accept(']');
    }

    [[nodiscard]] bool read_digits() {
        const std::size_t begin = at_;
        while (std::isdigit(static_cast<unsigned char>(next())) != 0)
            ++at_;
        return at_ > begin;
    }

    [[nodiscard]] bool read_number(JsonValue& value) {
        const std::size_t begin = at_;
        if (next() == '-')
            ++at_;
        const bool zero = next() == '0';
        const std::size_t first = at_;
        if (!read_digits() || (zero && at_ > first + 1))
            return false;
        if (next() == '.' && (++at_, !read_digits()))
            return false;
        if (next() == 'e' || next() == 'E') {
            ++at_;
            if (next() == '+' || next() == '-')
                ++at_;
            if (!read_digits())
                return false;
        }
        value.kind = JsonValue::Kind::number;
        value.text = text_.substr(begin, at_ - begin);
        return true;
    }

    [[nodiscard]] bool read_string(std::string& out) {
        if (next() != '"')
            return false;
        for (++at_; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '"') {
                ++at_;
                return true;
            }
            if (static_cast<unsigned char>(c) < 0x20 || (c == '\\' && !read_escape(out)))
                return false;
            if (c != '\\')
                out += c;
        }
        return false;
    }

    // Leaves the reader on the last character of the escape.
    [[nodiscard]] bool read_escape(std::string& out) {
        constexpr std::string_view letters = "\"\\/bfnrt";
        constexpr std::string_view meant = "\"\\/\b\f\n\r\t";
        ++at_;
        if (next() == 'u')
            return read_code_point(out);
        const std::size_t found = next() == '\0' ? std::string_view::npos : letters.find(next());
        if (found == std::string_view::npos)
            return false;
        out += meant[found];
        return true;
    }

    [[nodiscard]] bool read_code_point(std::string& out) {
        char32_t code = 0;
        if (!read_code_unit(code))
            return false;
        if (code >= 0xD800 && code < 0xDC00) { // the first half of a pair
            char32_t second = 0;
            if (text_.substr(at_ + 1, 2) != "\\u")
                return false;
            at_ += 2;
            if (!read_code_unit(second) || second < 0xDC00 || second > 0xDFFF)
                return false;
            code = 0x10000 + ((code - 0xD800) << 10U) + (second - 0xDC00);
        } else if (code >= 0xDC00 && code <= 0xDFFF) {
            return false;
        }
        append_utf8(out, code);
        return true;
    }

    [[nodiscard]] bool read_code_unit(char32_t& code) {
        for (int i = 0; i < 4; ++i) {
            ++at_;
            if (std::isxdigit(static_cast<unsigned char>(next())) == 0)
                return false;
            code =
                code * 16 + static_cast<char32_t>(std::stoi(std::string(1, next()), nullptr, 16));
        }
        return true;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

} // namespace

const JsonValue& JsonValue::operator[](std::string_view name) const {
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&](const auto& member) { return member.name == name; });
    return found == members.end() ? nothing : found->value;
}

const JsonValue& JsonValue::operator[](std::size_t index) const {
    return index < items.size() ? items[index] : nothing;
}

std::string JsonValue::names() const {
    std::string result;
    for (const auto& [name, value] : members)
        result += (result.empty() ? "" : " ") + name;
    return result;
}

std::optional<JsonValue> read_json(std::string_view text) {
    JsonValue value;
    if (!is_utf8(text) || !Reader(text).read(value))
        return std::nullopt;
    return value;
}

} // namespace iecfront::test
