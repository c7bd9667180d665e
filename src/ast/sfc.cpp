#include <iecfront/ast/sfc.hpp>

namespace iecfront::ast {

std::string_view to_string(ActionQualifierKind kind) noexcept {
    switch (kind) {
    case ActionQualifierKind::non_stored: return "N";
    case ActionQualifierKind::overriding_reset: return "R";
    case ActionQualifierKind::set: return "S";
    case ActionQualifierKind::time_limited: return "L";
    case ActionQualifierKind::time_delayed: return "D";
    case ActionQualifierKind::pulse: return "P";
    case ActionQualifierKind::stored_and_time_delayed: return "SD";
    case ActionQualifierKind::delayed_and_stored: return "DS";
    case ActionQualifierKind::stored_and_time_limited: return "SL";
    case ActionQualifierKind::pulse_rising_edge: return "P1";
    case ActionQualifierKind::pulse_falling_edge: return "P0";
    case ActionQualifierKind::unknown: break;
    }
    return "unknown";
}

} // namespace iecfront::ast
