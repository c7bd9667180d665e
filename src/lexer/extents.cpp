#include "lexer/extents.hpp"

#include "lexer/keywords.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>

namespace iecfront {

namespace {

struct CharacterRange {
    char32_t first;
    char32_t last;
};

// Characters beyond ASCII that nobody takes for a part of a word: controls, spaces, punctuation,
// symbols, and what is not to be seen. The pound sign is not among them: where it stands for the
// number sign, it is inside a word (Table 1, feature 3b).
constexpr std::array symbols = {
    CharacterRange{0x0080, 0x00A2}, CharacterRange{0x00A4, 0x00A9}, CharacterRange{0x00AB, 0x00B1},
    CharacterRange{0x00B4, 0x00B4}, CharacterRange{0x00B6, 0x00B8}, CharacterRange{0x00BB, 0x00BF},
    CharacterRange{0x00D7, 0x00D7}, CharacterRange{0x00F7, 0x00F7}, CharacterRange{0x1680, 0x1680},
    CharacterRange{0x180E, 0x180E}, CharacterRange{0x2000, 0x206F}, CharacterRange{0x20A0, 0x20CF},
    CharacterRange{0x2190, 0x2BFF}, CharacterRange{0x3000, 0x303F}, CharacterRange{0xFEFF, 0xFEFF},
    CharacterRange{0xFF01, 0xFF0F}, CharacterRange{0xFF1A, 0xFF20}, CharacterRange{0xFF3B, 0xFF3E},
    CharacterRange{0xFF5B, 0xFF65}};

[[nodiscard]] bool is_symbol(char32_t c) noexcept {
    return std::any_of(symbols.begin(), symbols.end(), [c](const CharacterRange& range) {
        return range.first <= c && c <= range.last;
    });
}

} // namespace

DecodedCharacter Extents::decode(const char* p) const noexcept {
    return decode_character({begin_, size_}, static_cast<std::size_t>(p - begin_), encoding_);
}

std::uint32_t Extents::foreign_letter_size(const char* p) const noexcept {
    const DecodedCharacter character = decode(p);
    return character.valid && is_symbol(character.code_point) ? 0 : character.size;
}

const char* Extents::word_end(const char* p) const noexcept {
    for (;;) {
        while (is_word_part(*p))
            ++p;
        if (is_ascii(*p))
            return p;
        const std::uint32_t size = foreign_letter_size(p);
        if (size == 0)
            return p;
        p += size;
    }
}

const char* Extents::digits_end(const char* p) noexcept {
    while (is_digit(*p) || *p == '_')
        ++p;
    return p;
}

const char* Extents::blanks_end(const char* p) noexcept {
    while (*p == ' ' || *p == '\t')
        ++p;
    return p;
}

namespace {

// Null when no comment or pragma begins here, or when there is something wrong with it.
[[nodiscard]] const char* remark_end(const char* p) noexcept {
    const bool pragma = *p == '{';
    if (!pragma && (*p != '(' || p[1] != '*'))
        return nullptr;
    for (p += pragma ? 1 : 2; *p != '\0' && class_of(*p) != CharacterClass::line_end; ++p) {
        if (pragma ? *p == '}' : *p == '*' && p[1] == ')')
            return p + (pragma ? 1 : 2);
        if (!pragma && *p == '(' && p[1] == '*')
            return nullptr;
    }
    return nullptr;
}

// `5m` in `T#1h-5m`: nothing else of the language looks so.
[[nodiscard]] bool begins_with_part_of_duration(const char* p) noexcept {
    const auto is_one_of = [](char c, std::string_view letters) {
        return letters.find(fold(c)) != std::string_view::npos;
    };
    if (!is_digit(*p))
        return false;
    p = Extents::digits_end(p);
    if (*p == '.' && is_digit(p[1]))
        p = Extents::digits_end(p + 1);
    const bool milliseconds = is_one_of(*p, "M") && is_one_of(p[1], "S");
    return is_one_of(*p, "DHMS") && (milliseconds || !is_word_start(p[1]) || p[1] == '_');
}

} // namespace

const char* Extents::gap_end(const char* p) noexcept {
    for (p = blanks_end(p);;) {
        const char* const end = remark_end(p);
        if (end == nullptr)
            return p;
        p = blanks_end(end);
    }
}

const char* Extents::exponent_end(const char* p) noexcept {
    if (!is_exponent_letter(*p))
        return nullptr;
    const char* const digits = p + (is_sign(p[1]) ? 2 : 1);
    return is_digit(*digits) ? digits_end(digits) : nullptr;
}

bool Extents::point_begins_fraction(const char* point) noexcept {
    if (*point != '.')
        return false;
    return is_digit(point[1]) || (point[1] == '_' && is_digit(point[2])) ||
           exponent_end(point + 1) != nullptr;
}

bool Extents::ends_with_point(const char* p) noexcept {
    return *p == '.' && p[1] != '.' && !is_word_start(p[1]) && is_ascii(p[1]);
}

const char* Extents::real_end(const char* point) const noexcept {
    const char* p = digits_end(point + 1);
    if (const char* const exponent = exponent_end(p))
        p = exponent;
    else if (is_exponent_letter(*p) && is_sign(p[1]))
        p += 2; // a number that ends in `E+` lacks its digits; no operator is meant
    p = word_end(p);
    while (*p == '.' && is_digit(p[1])) // `1.2.3`
        p = word_end(p + 1);
    return p;
}

// `AND` in `REAL#1.AND x`
static bool begins_with_keyword(const char* p) noexcept {
    const char* end = p;
    while (is_word_part(*end))
        ++end;
    return keyword_kind({p, static_cast<std::size_t>(end - p)}) != TokenKind::identifier;
}

const char* Extents::number_end(const char* p) const noexcept {
    while (is_sign(*p))
        ++p;
    const char* const digits = p;
    p = digits_end(p);
    if (p != digits) {
        if (const char* const exponent = exponent_end(p))
            return word_end(exponent);
        if (point_begins_fraction(p))
            return real_end(p);
        if (*p == '.' && p[1] != '.' && (!is_word_start(p[1]) || begins_with_keyword(p + 1)))
            return p + 1; // `REAL#1.`
    } else if (*p == '.' && is_digit(p[1])) {
        return real_end(p); // `REAL#.5`
    }
    p = word_end(p);
    bool based = false; // `16#F.F` is a number with a fault
    while (*p == '#' ||
           (*p == '.' && p != digits && (based ? is_word_part(p[1]) : is_digit(p[1])))) {
        based = based || *p == '#';
        p = word_end(p + 1 + (*p == '#' && is_sign(p[1]) && is_word_part(p[2]) ? 1 : 0));
    }
    return p;
}

const char* Extents::duration_end(const char* p) const noexcept {
    while (is_sign(*p))
        ++p;
    p = word_end(p);
    while ((*p == '.' && is_word_part(p[1])) ||
           (*p == ',' && is_digit(p[-1]) && begins_with_part_of_duration(p + 1)) || // `T#1,5s`
           (is_sign(*p) && begins_with_part_of_duration(p + 1)))
        p = word_end(p + 1);
    return p;
}

// A separator is taken while the literal still needs it, or when a digit follows: so what is to be
// subtracted from a whole date or time is left alone.
// The second `/` of `/06/25`, from the first one; else null.
[[nodiscard]] static const char* second_slash(const char* p) noexcept {
    if (*p++ != '/' || !is_digit(*p))
        return nullptr;
    while (is_digit(*p))
        ++p;
    return *p == '/' && is_digit(p[1]) ? p : nullptr;
}

const char* Extents::date_end(TokenKind kind, const char* p) const noexcept {
    unsigned dashes = kind == TokenKind::time_of_day ? 0 : 2;
    unsigned colons = kind == TokenKind::date ? 0 : 2;
    if (*p == '+' && is_digit(p[1]))
        ++p;
    for (p = word_end(p);; p = word_end(p)) {
        if (const char* const second = dashes == 2 ? second_slash(p) : nullptr) {
            dashes = 0;
            p = second;
        } else if (*p == '-' && (dashes != 0 || (is_digit(p[1]) && *digits_end(p + 1) != '#')))
            dashes -= dashes != 0 ? 1 : 0;
        else if (*p == ':' && p[1] != '=' && (colons != 0 || is_digit(p[1])))
            colons -= colons != 0 ? 1 : 0;
        else if (*p != '.' || !is_digit(p[1]))
            return ends_with_point(p) ? p + 1 : p;
        ++p;
    }
}

const char* Extents::literal_end(TokenKind kind, const char* body) const noexcept {
    if (class_of(*body) == CharacterClass::quote)
        return string_end(body);
    switch (kind) {
    case TokenKind::duration: return duration_end(body);
    case TokenKind::date:
    case TokenKind::time_of_day:
    case TokenKind::date_and_time: return date_end(kind, body);
    case TokenKind::enumerated_value: return word_end(body);
    default: return number_end(body);
    }
}

const char* Extents::string_end(const char* quote) const noexcept {
    const char* const text_end = begin_ + size_;
    for (const char* p = quote + 1;; ++p) {
        const CharacterClass found = class_of(*p);
        if (found == CharacterClass::line_end || (*p == '\0' && p == text_end))
            return p;
        if (*p == *quote)
            return p + 1;
        // Whatever `$` escapes, it is not the end; but a line end and the end of the text are.
        if (*p == '$' && class_of(p[1]) != CharacterClass::line_end && p + 1 != text_end)
            ++p;
    }
}

const char* Extents::address_end(const char* p) const noexcept {
    p = word_end(p);
    // Neither a member nor a range can follow: `%IX1.a` and `%IX1..2` are addresses with a fault.
    while (*p == '.' && (is_word_part(p[1]) || (p[1] == '.' && is_digit(p[2]))))
        p = word_end(p + (p[1] == '.' ? 2 : 1));
    return ends_with_point(p) ? p + 1 : p; // it lacks a number then
}

const char* Extents::location_end(const char* p) const noexcept {
    const char* const letters = p;
    while (is_word_start(*p))
        ++p;
    while (*p == '*')
        ++p;
    return p == letters && !is_digit(*p) ? word_end(p) : address_end(p);
}

} // namespace iecfront
