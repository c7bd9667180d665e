#pragma once

#include <iecfront/export.hpp>

#include <cstdint>
#include <string_view>

namespace iecfront {

/// What Annex C reserves a name for, beyond the keywords that are token kinds of their own.
enum class StandardName : std::uint8_t {
    none,           ///< free for the user
    function,       ///< a standard function of 2.5.1.5, overloaded (`ADD`), typed (`ADD_INT`), or a
                    ///< type conversion (`INT_TO_REAL`, `WORD_BCD_TO_UINT`)
    function_block, ///< a standard function block of 2.5.2.3 (`TON`, `CTU_DINT`)
};

/// What `name` is in the standard, in any case of its letters. AND, OR, XOR, NOT and MOD are
/// functions here, though their tokens are keywords.
[[nodiscard]] IECFRONT_API StandardName standard_name(std::string_view name) noexcept;

} // namespace iecfront
