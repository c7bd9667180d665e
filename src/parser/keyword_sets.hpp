#pragma once

#include "parser/token_set.hpp"

namespace iecfront {

/// Open a block of declarations.
inline constexpr TokenSet block_openers =
    TokenSet::range(TokenKind::kw_var, TokenKind::kw_var_config);

/// Close a library element.
inline constexpr TokenSet library_element_closers{
    TokenKind::kw_end_type, TokenKind::kw_end_function, TokenKind::kw_end_function_block,
    TokenKind::kw_end_program, TokenKind::kw_end_configuration};

/// Where a library element ends, closed or not.
inline constexpr TokenSet unit_ends = library_element_closers | TokenSet{TokenKind::end_of_unit};

/// Open an element of a sequential function chart.
inline constexpr TokenSet chart_openers{TokenKind::kw_initial_step, TokenKind::kw_step,
                                        TokenKind::kw_transition, TokenKind::kw_action};

/// What of charts and configurations is a keyword, but makes a good name.
inline constexpr TokenSet contextual_keywords =
    chart_openers | TokenSet{TokenKind::kw_from,      TokenKind::kw_on,
                             TokenKind::kw_task,      TokenKind::kw_with,
                             TokenKind::kw_resource,  TokenKind::kw_configuration,
                             TokenKind::kw_read_only, TokenKind::kw_read_write};

inline constexpr TokenSet chart_closers{TokenKind::kw_end_step, TokenKind::kw_end_transition,
                                        TokenKind::kw_end_action};

/// Open a statement that has a closing word.
inline constexpr TokenSet block_statements{TokenKind::kw_if, TokenKind::kw_case, TokenKind::kw_for,
                                           TokenKind::kw_while, TokenKind::kw_repeat};

/// Begin a statement.
inline constexpr TokenSet statement_words =
    block_statements | TokenSet{TokenKind::kw_return, TokenKind::kw_exit};

inline constexpr TokenSet statement_closers{TokenKind::kw_end_if, TokenKind::kw_end_case,
                                            TokenKind::kw_end_for, TokenKind::kw_end_while,
                                            TokenKind::kw_end_repeat};

/// Close what is neither a library element nor a statement.
inline constexpr TokenSet other_closers =
    chart_closers |
    TokenSet{TokenKind::kw_end_struct, TokenKind::kw_end_var, TokenKind::kw_end_resource};

/// Stand between the parts of a statement.
inline constexpr TokenSet part_words{TokenKind::kw_then, TokenKind::kw_do, TokenKind::kw_of,
                                     TokenKind::kw_to, TokenKind::kw_by};

/// Execution control of functions, which have names of their own (2.5.1.2).
inline constexpr TokenSet execution_control{TokenKind::kw_en, TokenKind::kw_eno};

/// Constants, of one token but for their sign.
inline constexpr TokenSet literals = TokenSet::range(TokenKind::integer, TokenKind::date_and_time) |
                                     TokenSet{TokenKind::kw_true, TokenKind::kw_false};

/// Operands of one token that need not be looked at.
inline constexpr TokenSet plain_operands = literals | TokenSet{TokenKind::identifier};

/// Delimiters that end something.
inline constexpr TokenSet closing_brackets{TokenKind::right_parenthesis, TokenKind::right_bracket};

} // namespace iecfront
