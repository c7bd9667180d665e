#pragma once

#include <iecfront/ast/unit.hpp>
#include <iecfront/export.hpp>
#include <iecfront/source/text_range.hpp>

#include <cstdint>
#include <string_view>
#include <vector>

namespace iecfront {

/// What a token is by its place in the syntax, for highlighting. Names are classed by where they
/// stand; what they are declared as is not looked up.
enum class TokenClass : std::uint8_t {
    keyword,
    type_name,       ///< elementary, generic or derived
    library_element, ///< the name of a function block, program or configuration that is declared
    function,        ///< where it is declared or called
    variable,        ///< also an instance that is called, and an enumerated value without its type
    field,           ///< a structure element, or an output behind a point
    parameter,       ///< before `:=` or `=>` in an argument list
    enumerated_value,
    configuration_element, ///< a resource, task, program instance or access path
    step,
    action,
    transition,
    label,
    il_operator, ///< in the operator field of an instruction
    number,
    boolean,
    string,
    time,            ///< a duration, date, time of day, or date and time
    direct_variable, ///< `%IX1.0`
    operator_sign,   ///< also AND, OR, XOR, NOT and MOD
    delimiter,
    comment,
    pragma,
    unknown,
};

/// `keyword`, `type_name` and so on.
[[nodiscard]] IECFRONT_API std::string_view to_string(TokenClass token_class) noexcept;

/// A token, comment or pragma with its class. The range counts from the start of the unit.
struct ClassifiedToken {
    TextRange range;          ///< with the delimiters of a comment or pragma
    TokenClass token_class{}; ///< `unknown` for what could not be read

    friend constexpr bool operator==(const ClassifiedToken&,
                                     const ClassifiedToken&) noexcept = default;
};

/// All tokens, comments and pragmas of a unit, in source order. As a unit that an edit does not
/// touch is shared by both trees, what was found for it can be kept.
[[nodiscard]] IECFRONT_API std::vector<ClassifiedToken> token_classes(const Unit& unit);

} // namespace iecfront
