#include "lexer/standard_names.hpp"

#include "lexer/keywords.hpp"
#include "lexer/name_table.hpp"

#include <iecfront/lexer/name.hpp>

#include <array>
#include <optional>

namespace iecfront {

namespace {

// For which elementary types a function has typed forms: the members of the generic type in its
// signature (2.3.2, tables 23 to 29).
enum class Typed : std::uint8_t { never, any, magnitude, number, real, integer, bits, string };

struct Function {
    std::string_view name;
    Typed typed;
};

// The names of 2.5.1.5 but for type conversions.
constexpr std::array functions = {
    Function{"ABS", Typed::number},
    Function{"ACOS", Typed::real},
    Function{"ADD", Typed::magnitude}, // ANY_NUM, and TIME by table 30
    Function{"ADD_DT_TIME", Typed::never},
    Function{"ADD_TOD_TIME", Typed::never},
    Function{"AND", Typed::bits},
    Function{"ASIN", Typed::real},
    Function{"ATAN", Typed::real},
    Function{"CONCAT", Typed::string},
    Function{"CONCAT_DATE_TOD", Typed::never},
    Function{"COS", Typed::real},
    Function{"DELETE", Typed::string},
    Function{"DIV", Typed::number},
    Function{"DIVTIME", Typed::never},
    Function{"EQ", Typed::any},
    Function{"EXP", Typed::real},
    Function{"EXPT", Typed::number}, // the base is ANY_REAL, the exponent ANY_NUM
    Function{"FIND", Typed::string},
    Function{"GE", Typed::any},
    Function{"GT", Typed::any},
    Function{"INSERT", Typed::string},
    Function{"LE", Typed::any},
    Function{"LEFT", Typed::string},
    Function{"LEN", Typed::string},
    Function{"LIMIT", Typed::any},
    Function{"LN", Typed::real},
    Function{"LOG", Typed::real},
    Function{"LT", Typed::any},
    Function{"MAX", Typed::any},
    Function{"MID", Typed::string},
    Function{"MIN", Typed::any},
    Function{"MOD", Typed::integer},
    Function{"MOVE", Typed::any},
    Function{"MUL", Typed::number},
    Function{"MULTIME", Typed::never},
    Function{"MUX", Typed::any},
    Function{"NE", Typed::any},
    Function{"NOT", Typed::bits},
    Function{"OR", Typed::bits},
    Function{"REPLACE", Typed::string},
    Function{"RIGHT", Typed::string},
    Function{"ROL", Typed::bits},
    Function{"ROR", Typed::bits},
    Function{"SEL", Typed::any},
    Function{"SHL", Typed::bits},
    Function{"SHR", Typed::bits},
    Function{"SIN", Typed::real},
    Function{"SQRT", Typed::real},
    Function{"SUB", Typed::magnitude},
    Function{"SUB_DATE_DATE", Typed::never},
    Function{"SUB_DT_DT", Typed::never},
    Function{"SUB_DT_TIME", Typed::never},
    Function{"SUB_TOD_TIME", Typed::never},
    Function{"SUB_TOD_TOD", Typed::never},
    Function{"TAN", Typed::real},
    Function{"TRUNC", Typed::never},
    Function{"XOR", Typed::bits},
};

// 2.5.2.3.
constexpr std::array<std::string_view, 22> function_blocks = {
    "CTD",      "CTD_DINT",  "CTD_LINT",  "CTD_UDINT",  "CTD_ULINT",  "CTU",
    "CTUD",     "CTUD_DINT", "CTUD_LINT", "CTUD_UDINT", "CTUD_ULINT", "CTU_DINT",
    "CTU_LINT", "CTU_UDINT", "CTU_ULINT", "F_TRIG",     "RS",         "R_TRIG",
    "SR",       "TOF",       "TON",       "TP",
};

constexpr std::size_t longest_name = std::string_view("DATE_AND_TIME_TO_TIME_OF_DAY").size();

// Both lists as one, functions first.
constexpr std::size_t name_count = functions.size() + function_blocks.size();

constexpr auto names = [] {
    std::array<std::string_view, name_count> all;
    for (std::size_t i = 0; i < name_count; ++i)
        all[i] = i < functions.size() ? functions[i].name : function_blocks[i - functions.size()];
    return all;
}();

constexpr NameTable<name_count> name_table(names);

[[nodiscard]] const Function* find_function(std::string_view name) noexcept {
    const std::size_t index = name_table.find(name, hash_name(name));
    return index < functions.size() ? &functions[index] : nullptr;
}

// An elementary type, with one spelling for the two that have a long and a short one.
[[nodiscard]] std::optional<TokenKind> elementary_type(std::string_view name) noexcept {
    const TokenKind kind = keyword_kind(name);
    if (!is_elementary_type_name(kind))
        return std::nullopt;
    if (kind == TokenKind::kw_time_of_day)
        return TokenKind::kw_tod;
    return kind == TokenKind::kw_date_and_time ? TokenKind::kw_dt : kind;
}

[[nodiscard]] bool is_one_of(TokenKind kind, TokenKind first, TokenKind last) noexcept {
    return kind >= first && kind <= last;
}

[[nodiscard]] bool has_typed_form(Typed typed, TokenKind type) noexcept {
    using enum TokenKind;
    switch (typed) {
    case Typed::never: return false;
    case Typed::any: return true;
    case Typed::magnitude: return is_one_of(type, kw_sint, kw_time);
    case Typed::number: return is_one_of(type, kw_sint, kw_lreal);
    case Typed::real: return is_one_of(type, kw_real, kw_lreal);
    case Typed::integer: return is_one_of(type, kw_sint, kw_ulint);
    case Typed::bits: return type == kw_bool || is_one_of(type, kw_byte, kw_lword);
    case Typed::string: return is_one_of(type, kw_string, kw_wstring);
    }
    return false;
}

// `ADD_INT`: the overloaded name, `_` and an elementary type (2.5.1.4).
[[nodiscard]] bool is_typed_function(std::string_view name) noexcept {
    const std::size_t underscore = name.find('_');
    if (underscore == std::string_view::npos)
        return false;
    const auto type = elementary_type(name.substr(underscore + 1));
    const Function* const function = find_function(name.substr(0, underscore));
    return type && function != nullptr && has_typed_form(function->typed, *type);
}

[[nodiscard]] bool names_end_in(std::string_view name, std::string_view suffix) noexcept {
    return name.size() >= suffix.size() &&
           names_equal(name.substr(name.size() - suffix.size()), suffix);
}

// BCD is held in the bit strings of whole bytes, and goes to and from unsigned integers (table 22).
[[nodiscard]] bool is_bcd_pair(std::string_view bits, std::string_view integer) noexcept {
    const auto from = elementary_type(bits);
    const auto to = elementary_type(integer);
    return from && to && is_one_of(*from, TokenKind::kw_byte, TokenKind::kw_lword) &&
           is_one_of(*to, TokenKind::kw_usint, TokenKind::kw_ulint);
}

[[nodiscard]] bool is_conversion(std::string_view from, std::string_view to) noexcept {
    constexpr std::string_view bcd_suffix = "_BCD";
    constexpr std::string_view bcd_prefix = "BCD_";
    if (names_end_in(from, bcd_suffix))
        return is_bcd_pair(from.substr(0, from.size() - bcd_suffix.size()), to);
    if (names_equal(to.substr(0, bcd_prefix.size()), bcd_prefix))
        return is_bcd_pair(to.substr(bcd_prefix.size()), from);
    const auto from_type = elementary_type(from);
    const auto to_type = elementary_type(to);
    return from_type && to_type && *from_type != *to_type;
}

// `INT_TO_REAL`, `WORD_BCD_TO_UINT`, `UINT_TO_BCD_WORD` (2.5.1.5.1).
[[nodiscard]] bool is_conversion(std::string_view name) noexcept {
    constexpr std::string_view middle = "_TO_";
    for (std::size_t i = 1; i + middle.size() < name.size(); ++i)
        if (names_equal(name.substr(i, middle.size()), middle))
            return is_conversion(name.substr(0, i), name.substr(i + middle.size()));
    return false;
}

// The names that are built from others end in a type; DAY is the end of TIME_OF_DAY.
[[nodiscard]] bool ends_in_type(std::string_view name) noexcept {
    constexpr std::size_t longest = std::string_view("WSTRING").size();
    for (std::size_t size = 2; size <= longest && size < name.size(); ++size)
        if (name[name.size() - size - 1] == '_') {
            const std::string_view last = name.substr(name.size() - size);
            return is_elementary_type_name(keyword_kind(last)) || names_equal(last, "DAY");
        }
    return false;
}

} // namespace

constexpr detail::LengthsByHash detail::lengths_of_standard_names(names);

StandardName find_standard_name(std::string_view name, std::uint32_t hash) noexcept {
    if (name.size() > longest_name)
        return StandardName::none;
    if (const std::size_t index = name_table.find(name, hash); index != name_count)
        return index < functions.size() ? StandardName::function : StandardName::function_block;
    if (detail::last_letters_of_types.end(name) && ends_in_type(name) &&
        (is_typed_function(name) || is_conversion(name)))
        return StandardName::function;
    return StandardName::none;
}

StandardName standard_name(std::string_view name) noexcept {
    return find_standard_name(name, hash_name(name));
}

} // namespace iecfront
