#include "benchmark/generator.hpp"

#include "benchmark/generated_code.hpp"

#include <algorithm>

namespace iecfront::bench {
namespace {

using namespace std::string_view_literals;

using Names = std::vector<std::string>;

enum class Element : std::uint8_t {
    types,
    function,
    il_function,
    function_block,
    il_function_block,
    chart_function_block,
    program,
    chart_program,
    configuration,
};

// The elements come in this order, again and again, so that each kind has its share in texts of
// every size.
constexpr std::array order = {
    Element::types,         Element::function,       Element::function_block,
    Element::program,       Element::function_block, Element::function,
    Element::il_function,   Element::function_block, Element::chart_function_block,
    Element::function,      Element::program,        Element::function_block,
    Element::types,         Element::function_block, Element::function,
    Element::configuration, Element::function_block, Element::il_function_block,
    Element::program,       Element::function,       Element::function_block,
    Element::chart_program, Element::function_block, Element::function,
};

constexpr std::size_t declaration_comments = 30; // percent

class Generator {
public:
    explicit Generator(std::uint64_t seed) noexcept : random_(seed), out_(random_) {}

    std::string run(std::size_t size) {
        for (std::size_t i = 0; out_.size() < size; ++i)
            element(order[i % order.size()]);
        return out_.take();
    }

    std::string run_one(std::size_t body_lines) {
        function_block(Element::function_block, body_lines);
        return out_.take();
    }

private:
    void element(Element kind);
    void types();
    void simple_type(const std::string& name);
    void structure(const std::string& name);
    void enumeration(const std::string& name);
    void array_type(const std::string& name);

    void function(bool il);
    void function_block(Element kind, std::size_t body_lines);
    void program(Element kind);
    void body(Element kind, std::size_t lines);
    void end(std::string_view keyword);

    void block(std::string_view keyword, std::size_t count, bool with_instances);
    void variable(std::size_t column, bool with_instances);
    void declare(Names& names, std::string_view type, std::size_t column);
    void array_variable(std::size_t column);
    void record_variable(std::size_t column);
    void instance(std::size_t column);
    void basic_variables();
    void located_block();
    void in_out_block();
    void temporary_block();
    void external_block();
    void constant_block();
    void access_block();

    void configuration();
    void resource(const std::string& name, std::size_t tasks);
    void program_instance(const std::string& name, const std::string& task);

    [[nodiscard]] std::string unit_name(std::string_view prefix) {
        return std::string(prefix) + make_name(random_) + "_" + std::to_string(++units_);
    }
    [[nodiscard]] std::string new_name() {
        return joined({make_name(random_), random_.chance(35) ? std::to_string(++names_) : ""});
    }
    [[nodiscard]] std::string location(std::string_view prefix) {
        return joined(
            {prefix, std::to_string(random_.below(64)), ".", std::to_string(random_.below(8))});
    }
    // `name : type`, with the colon in `column` where the name is not longer.
    [[nodiscard]] static std::string declaration(std::string name, std::size_t column,
                                                 std::string_view type) {
        name.resize(std::max(name.size() + 1, column), ' ');
        return name + ": " + std::string(type);
    }
    void declaration_line(std::string name, std::size_t column, std::string_view type) {
        out_.line(declaration(std::move(name), column, type) + ";", declaration_comments);
    }
    // Most units are short, some are long.
    [[nodiscard]] std::size_t body_lines() {
        return std::min(random_.between(16, 330), random_.between(16, 330));
    }

    Random random_;
    LineWriter out_;
    Variables variables_;
    Names type_names_{"Plant_Record_0"};
    Names state_types_{"Plant_State_0"};
    std::size_t units_ = 0;
    std::size_t names_ = 0;
};

void Generator::element(Element kind) {
    variables_ = {};
    names_ = 0;
    switch (kind) {
    case Element::types: types(); break;
    case Element::function: function(false); break;
    case Element::il_function: function(true); break;
    case Element::function_block:
    case Element::il_function_block:
    case Element::chart_function_block: function_block(kind, body_lines()); break;
    case Element::program:
    case Element::chart_program: program(kind); break;
    case Element::configuration: configuration(); break;
    }
    out_.empty_line();
}

// ---- types --------------------------------------------------------------------------------------

void Generator::types() {
    out_.head_comment("types");
    out_.line("TYPE");
    out_.indent();
    for (std::size_t i = random_.between(4, 14); i > 0; --i) {
        const std::string name = unit_name("T_");
        const std::size_t kind = random_.below(10);
        if (kind < 4)
            structure(name);
        else if (kind < 6)
            enumeration(name);
        else if (kind < 8)
            array_type(name);
        else
            simple_type(name);
    }
    out_.outdent();
    out_.line("END_TYPE");
}

void Generator::simple_type(const std::string& name) {
    const std::size_t kind = random_.below(4);
    const std::string low = std::to_string(random_.below(9));
    if (kind == 0)
        declaration_line(name, 24, "REAL := " + make_real(random_));
    else if (kind == 1)
        declaration_line(name, 24, "INT (" + low + "..4095) := " + low);
    else if (kind == 2)
        declaration_line(name, 24, "STRING[40] := " + make_string(random_));
    else
        declaration_line(name, 24, random_.pick(type_names_));
}

void Generator::structure(const std::string& name) {
    static constexpr std::array types = {"BOOL"sv, "INT"sv, "TIME"sv, "WORD"sv, "DATE_AND_TIME"sv};
    out_.line(name + " : STRUCT", 30);
    out_.indent();
    for (std::size_t i = random_.between(2, 6); i > 0; --i) {
        const std::string_view element = record_element(random_);
        declaration_line(std::string(element), 20,
                         random_.chance(50) ? "REAL := " + make_real(random_) : "REAL");
    }
    for (std::size_t i = random_.between(2, 12); i > 0; --i) {
        const std::string_view type = random_.pick(types);
        declaration_line(new_name(), 20, type);
    }
    const std::string_view state_type = random_.pick(state_types_);
    declaration_line(new_name(), 20, state_type);
    out_.outdent();
    out_.line("END_STRUCT;");
    type_names_.push_back(name);
}

void Generator::enumeration(const std::string& name) {
    out_.line(name + " : (", 30);
    for (std::size_t i = 0; i < state_count; ++i)
        out_.line("    " + std::string(state_name(i)) + (i + 1 < state_count ? "," : ""), 20);
    out_.line(random_.chance(50) ? ") := " + std::string(state_name(0)) + ";" : ");");
    state_types_.push_back(name);
}

void Generator::array_type(const std::string& name) {
    const std::string last = std::to_string(random_.between(3, 40));
    if (random_.chance(50))
        declaration_line(name, 24, "ARRAY [0.." + last + "] OF " + random_.pick(type_names_));
    else
        declaration_line(name, 24, "ARRAY [1..8, 0.." + last + "] OF INT := [12(0), 3, 7]");
}

// ---- program organization units -----------------------------------------------------------------

void Generator::function(bool il) {
    const std::string name = unit_name("F_");
    out_.head_comment(name);
    out_.line("FUNCTION " + name + " : REAL");
    variables_.reals.push_back(name);
    block("VAR_INPUT", random_.between(2, 7), false);
    basic_variables();
    block("VAR", random_.between(1, 5), false);
    body(il ? Element::il_function : Element::function, body_lines() / 2);
    end("END_FUNCTION");
}

void Generator::function_block(Element kind, std::size_t body_lines) {
    const std::string name = unit_name("FB_");
    out_.head_comment(name);
    out_.line("FUNCTION_BLOCK " + name);
    block("VAR_INPUT", random_.between(3, 12), false);
    block("VAR_OUTPUT", random_.between(2, 9), false);
    in_out_block();
    basic_variables();
    block("VAR", random_.between(4, 16), true);
    constant_block();
    if (random_.chance(20))
        block("VAR RETAIN", random_.between(1, 4), false);
    if (random_.chance(30))
        temporary_block();
    external_block();
    body(kind, body_lines);
    end("END_FUNCTION_BLOCK");
}

void Generator::program(Element kind) {
    const std::string name = unit_name("P_");
    out_.head_comment(name);
    out_.line("PROGRAM " + name);
    if (random_.chance(60))
        block("VAR_INPUT", random_.between(2, 6), false);
    basic_variables();
    located_block();
    block("VAR", random_.between(6, 24), true);
    external_block();
    access_block();
    body(kind, body_lines());
    end("END_PROGRAM");
}

void Generator::body(Element kind, std::size_t lines) {
    CodeWriter code(random_, out_, variables_);
    const bool indented = random_.chance(60);
    out_.empty_line();
    if (indented)
        out_.indent();
    switch (kind) {
    case Element::il_function:
    case Element::il_function_block: code.instructions(lines); break;
    case Element::chart_function_block:
    case Element::chart_program: code.chart(lines); break;
    default: code.statements(lines); break;
    }
    if (indented)
        out_.outdent();
}

void Generator::end(std::string_view keyword) {
    out_.line(keyword);
    out_.empty_line();
}

// ---- variables ----------------------------------------------------------------------------------

void Generator::block(std::string_view keyword, std::size_t count, bool with_instances) {
    const std::size_t column = random_.chance(65) ? random_.between(14, 22) : 0;
    out_.line(keyword);
    out_.indent();
    for (std::size_t i = 0; i < count; ++i)
        variable(column, with_instances);
    out_.outdent();
    out_.line("END_VAR");
}

void Generator::variable(std::size_t column, bool with_instances) {
    const std::size_t kind = random_.below(100);
    if (with_instances && kind < 25)
        instance(column);
    else if (kind < 50)
        declare(variables_.flags, random_.chance(25) ? "BOOL := TRUE" : "BOOL", column);
    else if (kind < 62)
        declare(variables_.integers, random_.chance(30) ? "DINT := 1" : "INT", column);
    else if (kind < 78)
        declare(variables_.reals, random_.chance(30) ? "REAL := " + make_real(random_) : "REAL",
                column);
    else if (kind < 84)
        declare(variables_.times, "TIME := " + make_duration(random_), column);
    else if (kind < 88)
        array_variable(column);
    else if (kind < 93)
        record_variable(column);
    else if (kind < 96)
        declare(variables_.states, random_.pick(state_types_), column);
    else
        declare(variables_.texts, "STRING[30]", column);
}

void Generator::declare(Names& names, std::string_view type, std::size_t column) {
    std::string all = new_name();
    names.push_back(all);
    while (random_.chance(12)) {
        names.push_back(new_name());
        all += ", " + names.back();
    }
    declaration_line(std::move(all), column, type);
}

void Generator::array_variable(std::size_t column) {
    const std::string last = std::to_string(random_.between(3, 99));
    std::string type = "ARRAY [0.." + last + "] OF REAL";
    if (random_.chance(30))
        type += joined({" := [4(0.0), ", make_real(random_), ", ", make_real(random_), "]"});
    declare(variables_.arrays, type, column);
}

void Generator::record_variable(std::size_t column) {
    std::string type = random_.pick(type_names_);
    if (random_.chance(30))
        type +=
            joined({" := (Gain := ", make_real(random_), ", Offset := ", make_real(random_), ")"});
    declare(variables_.records, type, column);
}

void Generator::instance(std::size_t column) {
    static constexpr std::array timers = {"TON"sv, "TON"sv, "TOF"sv, "TP"sv};
    const std::size_t kind = random_.below(10);
    if (kind < 5)
        declare(variables_.timers, random_.pick(timers), column);
    else if (kind < 7)
        declare(variables_.counters, "CTU", column);
    else
        declare(variables_.devices, "FB_" + make_name(random_), column);
}

// What every body can name.
void Generator::basic_variables() {
    out_.line("VAR");
    out_.indent();
    declare(variables_.flags, "BOOL", 16);
    declare(variables_.integers, "INT", 16);
    declare(variables_.reals, "REAL := 0.0", 16);
    declare(variables_.times, "TIME", 16);
    out_.outdent();
    out_.line("END_VAR");
}

void Generator::located_block() {
    out_.line("VAR");
    out_.indent();
    for (std::size_t i = random_.between(2, 12); i > 0; --i) {
        variables_.flags.push_back(new_name());
        const std::string at = location(random_.chance(60) ? "%IX" : "%QX");
        declaration_line(variables_.flags.back() + " AT " + at, 28, "BOOL");
    }
    variables_.integers.push_back(new_name());
    declaration_line(variables_.integers.back() + " AT %IW" + std::to_string(random_.below(99)), 28,
                     "INT");
    out_.outdent();
    out_.line("END_VAR");
}

void Generator::in_out_block() {
    if (random_.chance(70))
        return;
    out_.line("VAR_IN_OUT");
    out_.indent();
    declare(variables_.records, random_.pick(type_names_), 18);
    declare(variables_.reals, "REAL", 18);
    out_.outdent();
    out_.line("END_VAR");
}

void Generator::temporary_block() {
    out_.line("VAR_TEMP");
    out_.indent();
    declare(variables_.integers, "INT", 18);
    declare(variables_.reals, "REAL", 18);
    declare(variables_.records, random_.pick(type_names_), 18);
    out_.outdent();
    out_.line("END_VAR");
}

void Generator::external_block() {
    if (random_.chance(60))
        return;
    out_.line("VAR_EXTERNAL");
    out_.indent();
    for (std::size_t i = random_.between(1, 6); i > 0; --i) {
        variables_.reals.push_back(new_name());
        declaration_line(variables_.reals.back(), 18, "REAL");
    }
    out_.outdent();
    out_.line("END_VAR");
}

void Generator::constant_block() {
    if (random_.chance(60))
        return;
    out_.line("VAR CONSTANT");
    out_.indent();
    for (std::size_t i = random_.between(1, 6); i > 0; --i) {
        variables_.reals.push_back("C_" + new_name());
        declaration_line(variables_.reals.back(), 18, "REAL := " + make_real(random_));
    }
    declaration_line("C_" + new_name(), 18, "DATE := D#2003-01-15");
    declaration_line("C_" + new_name(), 18, "TIME_OF_DAY := TOD#06:30:00");
    out_.outdent();
    out_.line("END_VAR");
}

void Generator::access_block() {
    if (random_.chance(75))
        return;
    out_.line("VAR_ACCESS");
    out_.indent();
    for (std::size_t i = random_.between(1, 4); i > 0; --i)
        out_.line(joined(
            {"A_", new_name(), " : ", random_.pick(variables_.flags), " : BOOL READ_ONLY;"}));
    out_.outdent();
    out_.line("END_VAR");
}

// ---- configurations -----------------------------------------------------------------------------

void Generator::configuration() {
    const std::string name = unit_name("Plant_");
    out_.head_comment(name);
    out_.line("CONFIGURATION " + name);
    out_.indent();
    block("VAR_GLOBAL", random_.between(4, 30), false);
    const std::size_t resources = random_.between(1, 3);
    for (std::size_t i = 0; i < resources; ++i)
        resource("Cpu_" + std::to_string(i), random_.between(1, 3));
    out_.line("VAR_ACCESS");
    out_.line("    A_" + new_name() + " : Cpu_0.%IX1.1 : BOOL READ_ONLY;", 20);
    out_.line(joined({"    A_", new_name(), " : Cpu_0.Run_0.", new_name(), " : REAL READ_WRITE;"}));
    out_.line("END_VAR");
    out_.line("VAR_CONFIG");
    out_.line("    Cpu_0.Run_0." + new_name() + " AT %QX1.1 : BOOL := FALSE;", 20);
    out_.line(joined({"    Cpu_0.Run_0.", new_name(), ".", new_name(), " : INT := 12;"}));
    out_.line("END_VAR");
    out_.outdent();
    end("END_CONFIGURATION");
}

void Generator::resource(const std::string& name, std::size_t tasks) {
    out_.line("RESOURCE " + name + " ON Controller", 30);
    out_.indent();
    for (std::size_t i = 0; i < tasks; ++i)
        out_.line("TASK Task_" + std::to_string(i) + " (INTERVAL := " + make_duration(random_) +
                      ", PRIORITY := " + std::to_string(i + 1) + ");",
                  30);
    for (std::size_t i = 0; i < tasks + 2; ++i)
        program_instance("Run_" + std::to_string(i),
                         "Task_" + std::to_string(random_.below(tasks)));
    out_.outdent();
    out_.line("END_RESOURCE");
}

void Generator::program_instance(const std::string& name, const std::string& task) {
    out_.line("PROGRAM " + name + " WITH " + task + " : P_" + make_name(random_) + " (", 20);
    for (std::size_t i = random_.between(1, 5); i > 0; --i)
        out_.line(joined({"    ", new_name(), " := ",
                          random_.chance(50) ? location("%IX") : "G_" + make_name(random_), ","}));
    out_.line(joined({"    ", new_name(), " => ", location("%QX"), ");"}));
}

} // namespace

std::string generate_source(std::size_t size, std::uint64_t seed) {
    return Generator(seed).run(size);
}

std::string generate_function_block(std::size_t body_lines, std::uint64_t seed) {
    return Generator(seed).run_one(body_lines);
}

} // namespace iecfront::bench
