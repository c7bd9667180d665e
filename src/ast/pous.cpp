#include <iecfront/ast/pous.hpp>

namespace iecfront::ast {

std::string_view to_string(BodyLanguage language) noexcept {
    switch (language) {
    case BodyLanguage::structured_text: return "structured_text";
    case BodyLanguage::instruction_list: return "instruction_list";
    case BodyLanguage::sequential_function_chart: break;
    }
    return "sequential_function_chart";
}

} // namespace iecfront::ast
