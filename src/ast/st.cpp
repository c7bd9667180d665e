#include <iecfront/ast/st.hpp>

namespace iecfront::ast {

std::string_view to_string(BinaryOperator op) noexcept {
    switch (op) {
    case BinaryOperator::power: return "**";
    case BinaryOperator::multiply: return "*";
    case BinaryOperator::divide: return "/";
    case BinaryOperator::modulo: return "MOD";
    case BinaryOperator::add: return "+";
    case BinaryOperator::subtract: return "-";
    case BinaryOperator::less: return "<";
    case BinaryOperator::greater: return ">";
    case BinaryOperator::less_equal: return "<=";
    case BinaryOperator::greater_equal: return ">=";
    case BinaryOperator::equal: return "=";
    case BinaryOperator::not_equal: return "<>";
    case BinaryOperator::logical_and: return "AND";
    case BinaryOperator::exclusive_or: return "XOR";
    case BinaryOperator::logical_or: break;
    }
    return "OR";
}

std::string_view to_string(UnaryOperator op) noexcept {
    switch (op) {
    case UnaryOperator::minus: return "-";
    case UnaryOperator::logical_not: return "NOT";
    case UnaryOperator::plus: break;
    }
    return "+";
}

} // namespace iecfront::ast
