#include "benchmark/generated_code.hpp"

#include <algorithm>

namespace iecfront::bench {
namespace {

using namespace std::string_view_literals;

constexpr std::array elements = {
    "Minimum"sv, "Maximum"sv, "Setpoint"sv, "Actual_Value"sv, "Gain"sv, "Offset"sv,
};
constexpr std::array<std::string_view, state_count> states = {
    "State_Idle"sv,     "State_Starting"sv, "State_Running"sv,
    "State_Stopping"sv, "State_Cleaning"sv, "State_Fault"sv,
};
constexpr std::size_t deepest = 3; // nesting of statements

[[nodiscard]] std::string operator+(std::string text, std::string_view more) {
    return text.append(more);
}

} // namespace

std::string_view record_element(Random& random) {
    return random.pick(elements);
}

std::string_view state_name(std::size_t index) {
    return states[index];
}

// ---- Structured Text ----------------------------------------------------------------------------

void CodeWriter::statements(std::size_t lines) {
    end_ = out_.lines() + lines;
    do {
        if (random_.chance(12))
            out_.empty_line();
        if (random_.chance(15))
            out_.comment_line();
        statement(0);
    } while (out_.lines() < end_);
}

void CodeWriter::statement(std::size_t depth) {
    const bool can_nest = depth < deepest && out_.lines() < end_;
    const std::size_t kind = can_nest ? random_.below(100) : 99;
    if (kind < 22)
        if_statement(depth);
    else if (kind < 26)
        case_statement(depth);
    else if (kind < 30)
        for_statement(depth);
    else if (kind < 32)
        while_statement(depth);
    else if (kind < 33)
        repeat_statement(depth);
    else if (kind < 43)
        invocation();
    else if (kind < 45)
        out_.line("RETURN;", 20);
    else
        assignment();
}

void CodeWriter::block_of_statements(std::size_t depth) {
    out_.indent();
    if (random_.chance(10))
        out_.comment_line();
    for (std::size_t i = random_.between(1, depth == 0 ? 5 : 3); i > 0; --i)
        statement(depth + 1);
    out_.outdent();
}

void CodeWriter::assignment() {
    const std::size_t kind = random_.below(100);
    std::string code;
    if (kind < 45)
        code = joined({random_.pick(variables_.flags), " := ", flag_expression(0)});
    else if (kind < 70)
        code = joined({real_variable(), " := ", real_expression(0)});
    else if (kind < 86)
        code = joined({random_.pick(variables_.integers), " := ", integer_expression()});
    else if (kind < 92 && !variables_.states.empty())
        code = joined({random_.pick(variables_.states), " := ", random_.pick(states)});
    else if (kind < 95 && !variables_.texts.empty())
        code = joined({random_.pick(variables_.texts), " := ", make_string(random_)});
    else
        code = joined({random_.pick(variables_.times), " := ", time_expression()});
    out_.line(code + ";", 12);
}

void CodeWriter::invocation() {
    if (!variables_.timers.empty() && random_.chance(60)) {
        out_.line(joined({random_.pick(variables_.timers), "(IN := ", flag_expression(1),
                          ", PT := ", make_duration(random_), ");"}),
                  12);
    } else if (!variables_.counters.empty() && random_.chance(40)) {
        out_.line(joined({random_.pick(variables_.counters), "(CU := ", flag_operand(2),
                          ", R := ", random_.pick(variables_.flags),
                          ", PV := ", make_integer(random_), ");"}));
    } else if (!variables_.devices.empty()) {
        out_.line(joined({random_.pick(variables_.devices), "(", make_name(random_),
                          " := ", flag_operand(1), ","}));
        out_.line(joined({"    ", make_name(random_), " := ", real_expression(1), ","}));
        out_.line(
            joined({"    ", make_name(random_), " => ", random_.pick(variables_.flags), ");"}));
    } else {
        assignment();
    }
}

void CodeWriter::if_statement(std::size_t depth) {
    out_.line("IF " + flag_expression(0) + " THEN", 8);
    block_of_statements(depth);
    for (std::size_t i = random_.chance(25) ? random_.between(1, 3) : 0; i > 0; --i) {
        out_.line("ELSIF " + flag_expression(0) + " THEN", 8);
        block_of_statements(depth);
    }
    if (random_.chance(40)) {
        out_.line("ELSE");
        block_of_statements(depth);
    }
    out_.line("END_IF;");
}

void CodeWriter::case_statement(std::size_t depth) {
    const bool by_state = !variables_.states.empty() && random_.chance(70);
    out_.line("CASE " + random_.pick(by_state ? variables_.states : variables_.integers) + " OF");
    std::size_t label = random_.below(10);
    const std::size_t count = random_.between(2, state_count);
    for (std::size_t i = 0; i < count; ++i, label += random_.between(3, 10)) {
        std::string labels(by_state ? states[i] : std::to_string(label));
        if (!by_state && random_.chance(20))
            labels += ".." + std::to_string(label + 2);
        out_.line(labels + ":", 15);
        block_of_statements(depth);
    }
    if (random_.chance(50)) {
        out_.line("ELSE");
        block_of_statements(depth);
    }
    out_.line("END_CASE;");
}

void CodeWriter::for_statement(std::size_t depth) {
    out_.line(joined({"FOR ", random_.pick(variables_.integers), " := ", make_integer(random_),
                      " TO ", integer_expression(), random_.chance(15) ? " BY 2" : "", " DO"}),
              8);
    block_of_statements(depth);
    if (random_.chance(15)) {
        out_.line("    IF " + flag_expression(1) + " THEN");
        out_.line("        EXIT;");
        out_.line("    END_IF;");
    }
    out_.line("END_FOR;");
}

void CodeWriter::while_statement(std::size_t depth) {
    out_.line("WHILE " + flag_expression(0) + " DO");
    block_of_statements(depth);
    out_.line("END_WHILE;");
}

void CodeWriter::repeat_statement(std::size_t depth) {
    out_.line("REPEAT");
    block_of_statements(depth);
    out_.line("UNTIL " + flag_expression(0));
    out_.line("END_REPEAT;");
}

// ---- expressions --------------------------------------------------------------------------------

std::string CodeWriter::flag_expression(std::size_t depth) {
    std::string code = flag_operand(depth);
    while (random_.chance(depth == 0 ? 38 : 25)) {
        const std::size_t kind = random_.below(20);
        code += kind < 12 ? " AND " : kind < 18 ? " OR " : kind < 19 ? " & " : " XOR ";
        code += flag_operand(depth);
    }
    return code;
}

std::string CodeWriter::flag_operand(std::size_t depth) {
    const std::size_t kind = random_.below(100);
    if (kind < 15)
        return "NOT " + random_.pick(variables_.flags);
    if (kind < 22 && !variables_.timers.empty())
        return random_.pick(variables_.timers) + ".Q";
    if (kind < 36)
        return comparison();
    if (kind < 46 && depth < 2)
        return "(" + flag_expression(depth + 1) + ")";
    if (kind < 51)
        return random_.chance(50) ? "TRUE" : "FALSE";
    return random_.pick(variables_.flags);
}

std::string CodeWriter::comparison() {
    static constexpr std::array operators = {" > "sv, " < "sv, " >= "sv, " <= "sv,
                                             " = "sv, " = "sv, " <> "sv};
    const std::string_view sign = random_.pick(operators);
    if (!variables_.states.empty() && random_.chance(25))
        return joined({random_.pick(variables_.states), " = ", random_.pick(states)});
    if (random_.chance(50))
        return joined({real_variable(), sign, real_operand(2)});
    return joined({random_.pick(variables_.integers), sign, make_integer(random_)});
}

std::string CodeWriter::real_expression(std::size_t depth) {
    static constexpr std::array operators = {" + "sv, " - "sv, " * "sv, " / "sv, " * "sv, " ** "sv};
    std::string code = random_.chance(4) ? "-" + real_variable() : real_operand(depth);
    while (random_.chance(depth == 0 ? 38 : 25))
        code += joined({random_.pick(operators), real_operand(depth)});
    return code;
}

std::string CodeWriter::real_operand(std::size_t depth) {
    const std::size_t kind = depth < 2 ? random_.below(100) : random_.between(30, 99);
    if (kind < 10)
        return "(" + real_expression(depth + 1) + ")";
    if (kind < 15)
        return joined(
            {"LIMIT(", make_real(random_), ", ", real_variable(), ", ", make_real(random_), ")"});
    if (kind < 20)
        return "INT_TO_REAL(" + random_.pick(variables_.integers) + ")";
    if (kind < 25)
        return joined({"SEL(", flag_operand(2), ", ", real_variable(), ", ", real_operand(2), ")"});
    if (kind < 30)
        return joined({make_name(random_), "(", make_name(random_), " := ", real_operand(2), ", ",
                       make_name(random_), " := ", make_integer(random_), ")"});
    if (kind < 55)
        return make_real(random_);
    return real_variable();
}

std::string CodeWriter::real_variable() {
    const std::size_t kind = random_.below(100);
    if (kind < 15 && !variables_.arrays.empty())
        return joined(
            {random_.pick(variables_.arrays), "[", random_.pick(variables_.integers), "]"});
    if (kind < 30 && !variables_.records.empty())
        return joined({random_.pick(variables_.records), ".", random_.pick(elements)});
    return random_.pick(variables_.reals);
}

std::string CodeWriter::integer_expression() {
    const std::size_t kind = random_.below(100);
    const std::string& variable = random_.pick(variables_.integers);
    if (kind < 35)
        return make_integer(random_);
    if (kind < 70)
        return joined({variable, random_.chance(60) ? " + " : " - ", make_integer(random_)});
    if (kind < 80)
        return joined({"(", variable, " MOD ", make_integer(random_), ") * ",
                       random_.pick(variables_.integers)});
    if (kind < 88)
        return "REAL_TO_INT(" + real_expression(1) + ")";
    return variable;
}

std::string CodeWriter::time_expression() {
    if (!variables_.timers.empty() && random_.chance(40))
        return random_.pick(variables_.timers) + ".ET";
    if (random_.chance(40))
        return joined({random_.pick(variables_.times), " + ", make_duration(random_)});
    return make_duration(random_);
}

// ---- Instruction List ---------------------------------------------------------------------------

void CodeWriter::instruction(std::string_view operation, std::string_view operand) {
    std::string code(operation);
    if (!operand.empty()) {
        code.resize(std::max<std::size_t>(code.size() + 1, 8), ' ');
        code += operand;
    }
    out_.line(code, 15);
}

void CodeWriter::instructions(std::size_t lines) {
    const std::size_t end = out_.lines() + lines;
    out_.indent();
    do {
        if (random_.chance(30))
            out_.comment_line();
        const std::size_t kind = random_.below(100);
        if (kind < 50)
            logic_network();
        else if (kind < 75)
            arithmetic_network();
        else if (kind < 90)
            call_network();
        else
            jump_network();
        out_.empty_line();
    } while (out_.lines() < end);
    out_.outdent();
}

void CodeWriter::logic_network() {
    static constexpr std::array operators = {"AND"sv, "ANDN"sv, "OR"sv, "ORN"sv, "XOR"sv, "AND"sv};
    const std::string_view load = random_.chance(30) ? "LDN" : "LD";
    instruction(load, random_.pick(variables_.flags));
    for (std::size_t i = random_.between(1, 5); i > 0; --i) {
        const std::string_view operation = random_.pick(operators);
        instruction(operation, random_.pick(variables_.flags));
    }
    if (random_.chance(25)) {
        instruction("OR(", random_.pick(variables_.flags));
        instruction("ANDN", random_.pick(variables_.flags));
        instruction(")", "");
    }
    const std::string_view store = random_.chance(20) ? "S" : "ST";
    instruction(store, random_.pick(variables_.flags));
}

void CodeWriter::arithmetic_network() {
    static constexpr std::array operators = {"ADD"sv, "SUB"sv, "MUL"sv, "DIV"sv};
    instruction("LD", random_.pick(variables_.reals));
    for (std::size_t i = random_.between(1, 3); i > 0; --i) {
        const std::string_view operation = random_.pick(operators);
        instruction(operation,
                    random_.chance(40) ? make_real(random_) : random_.pick(variables_.reals));
    }
    instruction("ST", random_.pick(variables_.reals));
    instruction("LD", random_.pick(variables_.integers));
    const std::string_view relation = random_.chance(50) ? "GT" : "LE";
    instruction(relation, make_integer(random_));
    instruction("ST", random_.pick(variables_.flags));
}

void CodeWriter::call_network() {
    if (variables_.timers.empty())
        return logic_network();
    const std::string& timer = random_.pick(variables_.timers);
    out_.line("CAL     " + timer + "(");
    out_.line("        IN := " + random_.pick(variables_.flags) + ",");
    out_.line("        PT := " + make_duration(random_));
    out_.line("        )");
    instruction("LD", timer + ".Q");
    instruction("ST", random_.pick(variables_.flags));
}

void CodeWriter::jump_network() {
    const std::string label = "Lab_" + std::to_string(++labels_);
    instruction("LD", random_.pick(variables_.flags));
    instruction(random_.chance(50) ? "JMPC" : "JMPCN", label);
    logic_network();
    out_.unindented_line(label + ":");
    logic_network();
}

// ---- charts -------------------------------------------------------------------------------------

void CodeWriter::chart(std::size_t lines) {
    // A step, its transition and its action are about 18 lines.
    const std::size_t count = std::max<std::size_t>(3, lines / 18);
    std::vector<std::string> steps;
    std::vector<std::string> actions;
    for (std::size_t i = 0; i < count; ++i) {
        steps.push_back("Step_" + make_name(random_) + "_" + std::to_string(i));
        actions.push_back("Do_" + make_name(random_) + "_" + std::to_string(i));
    }
    for (std::size_t i = 0; i < count; ++i) {
        out_.line((i == 0 ? "INITIAL_STEP " : "STEP ") + steps[i] + ":", 25);
        step(actions[i], i == 0);
        out_.line("END_STEP");
        out_.empty_line();
        transition(steps[i], steps[(i + 1) % count]);
        out_.empty_line();
    }
    for (const std::string& name : actions)
        action(name);
}

void CodeWriter::step(std::string_view name, bool initial) {
    static constexpr std::array timed = {"L"sv, "D"sv, "SD"sv, "DS"sv, "SL"sv};
    static constexpr std::array plain = {"N"sv, "S"sv, "R"sv, "P"sv, "P0"sv, "P1"sv};
    out_.indent();
    out_.line(std::string(name) + (initial ? "(P1);" : "(N);"));
    if (random_.chance(50))
        out_.line(joined({random_.pick(variables_.flags), "(", random_.pick(plain), ");"}), 20);
    if (random_.chance(20))
        out_.line(joined({random_.pick(variables_.flags), "(", random_.pick(timed), ", ",
                          make_duration(random_), ");"}));
    out_.outdent();
}

void CodeWriter::transition(std::string_view from, std::string_view to) {
    const std::string head = "TRANSITION FROM " + std::string(from) + " TO " + to;
    if (random_.chance(25)) {
        out_.line(head + " :");
        out_.indent();
        out_.indent();
        instruction("LD", random_.pick(variables_.flags));
        instruction("ANDN", random_.pick(variables_.flags));
        out_.outdent();
        out_.outdent();
    } else {
        out_.line(head);
        out_.line("    := " + flag_expression(0) + ";", 15);
    }
    out_.line("END_TRANSITION");
}

void CodeWriter::action(std::string_view name) {
    out_.line("ACTION " + std::string(name) + ":", 20);
    out_.indent();
    if (random_.chance(20))
        instructions(random_.between(4, 9));
    else
        statements(random_.between(2, 9));
    out_.outdent();
    out_.line("END_ACTION");
    out_.empty_line();
}

} // namespace iecfront::bench
