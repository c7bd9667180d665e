#pragma once

#include "benchmark/generated_words.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace iecfront::bench {

/// What the body of a program organization unit can name, by what can be done with it. The first
/// four are never empty.
struct Variables {
    std::vector<std::string> flags;
    std::vector<std::string> integers;
    std::vector<std::string> reals;
    std::vector<std::string> times;
    std::vector<std::string> arrays;  // of REAL, by an integer
    std::vector<std::string> records; // whose types have the elements of `record_elements`
    std::vector<std::string> states;  // of an enumeration with the values of `state_names`
    std::vector<std::string> texts;
    std::vector<std::string> timers; // instances of TON, TOF or TP
    std::vector<std::string> counters;
    std::vector<std::string> devices; // instances of function blocks of the text itself
};

/// Elements that every generated structure has, each of type REAL.
[[nodiscard]] std::string_view record_element(Random& random);

/// The enumerated values that every generated enumeration has.
[[nodiscard]] std::string_view state_name(std::size_t index);
inline constexpr std::size_t state_count = 6;

/// Writes bodies in each language.
class CodeWriter {
public:
    CodeWriter(Random& random, LineWriter& out, const Variables& variables) noexcept
        : random_(random), out_(out), variables_(variables) {}

    /// About `lines` lines, and one statement at least.
    void statements(std::size_t lines);
    void instructions(std::size_t lines);
    void chart(std::size_t lines);

private:
    void statement(std::size_t depth);
    void block_of_statements(std::size_t depth);
    void assignment();
    void invocation();
    void if_statement(std::size_t depth);
    void case_statement(std::size_t depth);
    void for_statement(std::size_t depth);
    void while_statement(std::size_t depth);
    void repeat_statement(std::size_t depth);

    [[nodiscard]] std::string flag_expression(std::size_t depth);
    [[nodiscard]] std::string flag_operand(std::size_t depth);
    [[nodiscard]] std::string comparison();
    [[nodiscard]] std::string real_expression(std::size_t depth);
    [[nodiscard]] std::string real_operand(std::size_t depth);
    [[nodiscard]] std::string real_variable();
    [[nodiscard]] std::string integer_expression();
    [[nodiscard]] std::string time_expression();

    void instruction(std::string_view operation, std::string_view operand);
    void logic_network();
    void arithmetic_network();
    void call_network();
    void jump_network();

    void step(std::string_view name, bool initial);
    void transition(std::string_view from, std::string_view to);
    void action(std::string_view name);

    Random& random_;
    LineWriter& out_;
    const Variables& variables_;
    std::size_t labels_ = 0;
    std::size_t end_ = 0; // the line from which on statements hold no others
};

} // namespace iecfront::bench
