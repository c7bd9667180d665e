#include <iecfront/ast/il.hpp>

#include <array>
#include <cstddef>

namespace iecfront::ast {
namespace {

// In the order of the enumerators.
constexpr std::array<std::string_view, 31> operators{
    "none", "LD",  "ST",  "S",   "R",  "AND", "OR", "XOR", "NOT", "ADD", "SUB",
    "MUL",  "DIV", "MOD", "GT",  "GE", "EQ",  "NE", "LE",  "LT",  "JMP", "CAL",
    "RET",  "S1",  "R1",  "CLK", "CU", "CD",  "PV", "IN",  "PT"};
static_assert(operators.size() == static_cast<std::size_t>(IlOperator::pt) + 1);

} // namespace

std::string_view to_string(IlOperator op) noexcept {
    return operators[static_cast<std::size_t>(op)];
}

std::string_view to_string(IlModifier modifier) noexcept {
    switch (modifier) {
    case IlModifier::none: return "none";
    case IlModifier::negated: return "N";
    case IlModifier::conditional: return "C";
    case IlModifier::conditional_negated: break;
    }
    return "CN";
}

} // namespace iecfront::ast
