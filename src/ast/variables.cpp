#include <iecfront/ast/variables.hpp>

namespace iecfront::ast {

std::string_view to_string(VariableBlock block) noexcept {
    switch (block) {
    case VariableBlock::var: return "var";
    case VariableBlock::var_input: return "var_input";
    case VariableBlock::var_output: return "var_output";
    case VariableBlock::var_in_out: return "var_in_out";
    case VariableBlock::var_temp: return "var_temp";
    case VariableBlock::var_external: return "var_external";
    case VariableBlock::var_global: return "var_global";
    case VariableBlock::var_access: return "var_access";
    case VariableBlock::var_config: break;
    }
    return "var_config";
}

std::string_view to_string(BlockQualifier qualifier) noexcept {
    switch (qualifier) {
    case BlockQualifier::none: return "none";
    case BlockQualifier::constant: return "constant";
    case BlockQualifier::retain: return "retain";
    case BlockQualifier::non_retain: break;
    }
    return "non_retain";
}

std::string_view to_string(Edge edge) noexcept {
    switch (edge) {
    case Edge::none: return "none";
    case Edge::rising: return "rising";
    case Edge::falling: break;
    }
    return "falling";
}

std::string_view to_string(Direction direction) noexcept {
    switch (direction) {
    case Direction::none: return "none";
    case Direction::read_only: return "read_only";
    case Direction::read_write: break;
    }
    return "read_write";
}

} // namespace iecfront::ast
