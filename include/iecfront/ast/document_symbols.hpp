#pragma once

#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/ast/unit.hpp>
#include <iecfront/export.hpp>
#include <iecfront/source/text_range.hpp>

#include <cstdint>
#include <string_view>
#include <vector>

namespace iecfront {

/// What a declared name names.
enum class SymbolKind : std::uint8_t {
    function,          ///< B.1.5.1
    function_block,    ///< B.1.5.2
    program,           ///< B.1.5.3
    data_type,         ///< B.1.3.3
    structure_element, ///< B.1.3.3
    enumerated_value,  ///< B.1.3.3
    variable,          ///< B.1.4.3
    access_path,       ///< in VAR_ACCESS, B.1.7
    step,              ///< B.1.6
    transition,        ///< B.1.6, with a name
    action,            ///< B.1.6
    label,             ///< of an IL instruction, B.2.1
    configuration,     ///< B.1.7
    resource,          ///< B.1.7
    task,              ///< B.1.7
    program_instance,  ///< program_configuration, B.1.7
};

/// `function`, `function_block` and so on.
[[nodiscard]] IECFRONT_API std::string_view to_string(SymbolKind kind) noexcept;

/// A declaration, for an outline.
struct DocumentSymbol {
    SymbolKind kind{};     ///< what is declared
    std::string_view name; ///< a view into the unit; empty when the name is missing
    TextRange range;       ///< of the declaration; of `a, b : INT` for each of its names
    TextRange name_range;  ///< of the name, inside `range`
    std::vector<DocumentSymbol> children; ///< what is declared inside, in source order
};

/// What is declared in a unit, in source order. Ranges count from the start of the unit. The names
/// live as long as the unit does.
[[nodiscard]] IECFRONT_API std::vector<DocumentSymbol> document_symbols(const Unit& unit);

/// The same for all units of a tree. Ranges count from the start of the file.
[[nodiscard]] IECFRONT_API std::vector<DocumentSymbol> document_symbols(const SyntaxTree& tree);

} // namespace iecfront
