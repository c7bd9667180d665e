#pragma once

#include <iecfront/ast/node.hpp>

/// Constants (B.1.2). The value of one: decode the text of its `literal_token`, see `literals.hpp`.
namespace iecfront::ast {

/// `12`, `-5`, `16#FF`, `INT#7` (B.1.2.1). Untyped ones may turn out to be bit strings or Booleans.
struct IntegerLiteral : Constant {
    static constexpr NodeKind node_kind = NodeKind::integer_literal;
    IntegerLiteral() noexcept : Constant(node_kind) {}
};

/// `1.5`, `-1.0E3`, `REAL#0.1` (B.1.2.1).
struct RealLiteral : Constant {
    static constexpr NodeKind node_kind = NodeKind::real_literal;
    RealLiteral() noexcept : Constant(node_kind) {}
};

/// A literal typed BYTE, WORD, DWORD or LWORD (B.1.2.1).
struct BitStringLiteral : Constant {
    static constexpr NodeKind node_kind = NodeKind::bit_string_literal;
    BitStringLiteral() noexcept : Constant(node_kind) {}
};

/// `TRUE`, `FALSE`, `BOOL#1` (B.1.2.1).
struct BooleanLiteral : Constant {
    static constexpr NodeKind node_kind = NodeKind::boolean_literal;
    BooleanLiteral() noexcept : Constant(node_kind) {}
};

/// `'abc'`, `"abc"`, `STRING#'abc'` (B.1.2.2).
struct CharacterString : Constant {
    static constexpr NodeKind node_kind = NodeKind::character_string;
    CharacterString() noexcept : Constant(node_kind) {}
};

/// `T#5s` (B.1.2.3.1).
struct Duration : Constant {
    static constexpr NodeKind node_kind = NodeKind::duration;
    Duration() noexcept : Constant(node_kind) {}
};

/// `TOD#15:36:55.36` (B.1.2.3.2).
struct TimeOfDay : Constant {
    static constexpr NodeKind node_kind = NodeKind::time_of_day;
    TimeOfDay() noexcept : Constant(node_kind) {}
};

/// `D#1984-06-25` (B.1.2.3.2).
struct Date : Constant {
    static constexpr NodeKind node_kind = NodeKind::date;
    Date() noexcept : Constant(node_kind) {}
};

/// `DT#1984-06-25-15:36:55.36` (B.1.2.3.2).
struct DateAndTime : Constant {
    static constexpr NodeKind node_kind = NodeKind::date_and_time;
    DateAndTime() noexcept : Constant(node_kind) {}
};

} // namespace iecfront::ast
