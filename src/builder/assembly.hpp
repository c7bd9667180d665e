#pragma once

#include <iecfront/builder/part.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace iecfront::build {

/// How tightly expressions hold together, weakest first (Table 55).
namespace strength {
inline constexpr std::uint8_t any = 0;
inline constexpr std::uint8_t unary = 8;
inline constexpr std::uint8_t primary = 9;
} // namespace strength

/// That of an expression with this operator between its operands.
[[nodiscard]] std::uint8_t strength_of(ast::BinaryOperator op) noexcept;

/// For a fault: between back quotes.
[[nodiscard]] std::string quoted(std::string_view text);

/// True for what a `;` stands behind that is no part of it: statements, declarations.
[[nodiscard]] bool has_semicolon(ast::NodeKind kind) noexcept;

/// ` RETAIN` and so on, nothing for none.
[[nodiscard]] std::string_view keyword_of(ast::BlockQualifier qualifier) noexcept;

/// What words can be a name.
enum class NameKind : std::uint8_t {
    identifier, ///< an `identifier`
    variable,   ///< besides EN and ENO
    function,   ///< besides AND, OR, XOR, NOT and MOD
};

/// Puts a part together from left to right, and notes the first thing that is wrong with it.
class Assembly {
public:
    /// Text that is right by itself.
    Assembly& text(std::string_view text);
    /// A name that a user gave.
    Assembly& name(std::string_view name, NameKind kind = NameKind::identifier);
    /// Names with a comma between each two; at least one.
    Assembly& names(const std::vector<std::string_view>& names, std::string_view separator = ", ");
    /// `type#value`, or the value alone without a `type`.
    Assembly& enumerated_value(std::string_view value, std::string_view type);
    /// A literal whose text is right when the lexer takes it for one.
    Assembly& literal(std::string_view text);
    Assembly& part(const AnyPart& part);
    /// In parentheses when it holds together less than `least`.
    Assembly& operand(const AnyPart& part, std::uint8_t least);
    /// The same behind a unary operator. A sign before a number would belong to the constant.
    Assembly& operand(const AnyPart& part, ast::UnaryOperator op);
    /// A variable before a `.` or a `[`. To an operation they would go with its last operand.
    Assembly& variable(const AnyPart& part);
    /// `before`, and the part, when there is one.
    template<class P>
    Assembly& optional(std::string_view before, const std::optional<P>& part);
    /// Parts with a separator between each two.
    template<class P>
    Assembly& list(const std::vector<P>& parts, std::string_view separator = ", ");
    /// On lines of their own below, a level further in, each with the `;` that belongs behind it.
    template<class P>
    Assembly& lines(const std::vector<P>& parts);
    Assembly& indented(const AnyPart& part, std::string_view behind = {});

    /// Notes what is wrong unless `right`.
    Assembly& require(bool right, std::string_view fault);

    template<class Kind>
    [[nodiscard]] Part<Kind> finish(std::uint8_t strength = strength::primary) && {
        return detail::PartAccess::part<Kind>(std::move(*this).finish(Kind::node_kind, strength));
    }
    [[nodiscard]] AnyPart finish(ast::NodeKind kind, std::uint8_t strength) && {
        return AnyPart(kind, std::move(text_), std::move(fault_), strength);
    }

    [[nodiscard]] static std::uint8_t strength_of(const AnyPart& part) noexcept {
        return part.strength_;
    }

private:
    std::string text_;
    std::string fault_;
};

/// `text` with `blanks` before each of its lines but the first; empty lines stay so.
[[nodiscard]] std::string moved_in(std::string_view text, std::string_view blanks);

template<class P>
Assembly& Assembly::optional(std::string_view before, const std::optional<P>& part) {
    return part ? text(before).part(*part) : *this;
}

template<class P>
Assembly& Assembly::list(const std::vector<P>& parts, std::string_view separator) {
    for (std::size_t i = 0; i < parts.size(); ++i)
        text(i > 0 ? separator : std::string_view()).part(parts[i]);
    return *this;
}

template<class P>
Assembly& Assembly::lines(const std::vector<P>& parts) {
    for (const P& part : parts)
        indented(part, has_semicolon(part.kind()) ? ";" : "");
    return *this;
}

} // namespace iecfront::build
