#pragma once

#include <iecfront/lexer/token.hpp>

namespace iecfront {

struct BlockWords {
    TokenKind opener;
    TokenKind closer;
};

/// What opens what is closed by a word of its own. Several openers can share a closing word.
inline constexpr BlockWords block_pairs[] = {
    {TokenKind::kw_type, TokenKind::kw_end_type},
    {TokenKind::kw_function, TokenKind::kw_end_function},
    {TokenKind::kw_function_block, TokenKind::kw_end_function_block},
    {TokenKind::kw_program, TokenKind::kw_end_program},
    {TokenKind::kw_configuration, TokenKind::kw_end_configuration},
    {TokenKind::kw_resource, TokenKind::kw_end_resource},
    {TokenKind::kw_struct, TokenKind::kw_end_struct},
    {TokenKind::kw_var, TokenKind::kw_end_var},
    {TokenKind::kw_var_input, TokenKind::kw_end_var},
    {TokenKind::kw_var_output, TokenKind::kw_end_var},
    {TokenKind::kw_var_in_out, TokenKind::kw_end_var},
    {TokenKind::kw_var_temp, TokenKind::kw_end_var},
    {TokenKind::kw_var_external, TokenKind::kw_end_var},
    {TokenKind::kw_var_global, TokenKind::kw_end_var},
    {TokenKind::kw_var_access, TokenKind::kw_end_var},
    {TokenKind::kw_var_config, TokenKind::kw_end_var},
    {TokenKind::kw_if, TokenKind::kw_end_if},
    {TokenKind::kw_case, TokenKind::kw_end_case},
    {TokenKind::kw_for, TokenKind::kw_end_for},
    {TokenKind::kw_while, TokenKind::kw_end_while},
    {TokenKind::kw_repeat, TokenKind::kw_end_repeat},
    {TokenKind::kw_initial_step, TokenKind::kw_end_step},
    {TokenKind::kw_step, TokenKind::kw_end_step},
    {TokenKind::kw_transition, TokenKind::kw_end_transition},
    {TokenKind::kw_action, TokenKind::kw_end_action},
};

/// The library element declarations of B.0; none of them may stand inside another one.
[[nodiscard]] constexpr bool is_library_element(const BlockWords& words) noexcept {
    switch (words.opener) {
    case TokenKind::kw_function:
    case TokenKind::kw_function_block:
    case TokenKind::kw_program:
    case TokenKind::kw_type:
    case TokenKind::kw_configuration: return true;
    default: return false;
    }
}

} // namespace iecfront
