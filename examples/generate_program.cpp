// Makes a program out of a table of signals and prints it: what a configuration tool does with a
// list of inputs and outputs. No text is written by hand, and none can be malformed.
#include <iecfront/iecfront.hpp>

#include <array>
#include <chrono>
#include <cstdio>

namespace ast = iecfront::ast;
namespace build = iecfront::build;

namespace {

// A push button, and the output that follows it after its time.
struct Signal {
    std::string_view name;
    std::uint64_t bit;
    std::chrono::milliseconds delay;
};

constexpr std::array<Signal, 3> signals{{
    {"Pump", 0, std::chrono::seconds(2)},
    {"Mixer", 1, std::chrono::milliseconds(500)},
    {"Heater", 2, std::chrono::minutes(1)},
}};

// `NameStart AT %IX0.bit : BOOL` or `NameOn AT %QX0.bit : BOOL`
build::Declaration located(const std::string& name, char location, std::uint64_t bit) {
    return build::located_variable_declaration(
        name,
        build::location(
            build::direct_variable({.location = location, .size = 'X', .hierarchy = {0, bit}})),
        build::elementary_type_name("BOOL"));
}

// `NameTimer(IN := NameStart AND NOT Stop, PT := delay, Q => NameOn)`
build::Statement timer_call(const std::string& name, std::chrono::nanoseconds delay) {
    const build::Expression enabled = build::binary_expression(
        ast::BinaryOperator::logical_and, build::variable_name(name + "Start"),
        build::unary_expression(ast::UnaryOperator::logical_not, build::variable_name("Stop")));
    return build::fb_invocation(name + "Timer",
                                {build::input_argument("IN", enabled),
                                 build::input_argument("PT", build::duration(delay)),
                                 build::output_argument("Q", build::variable_name(name + "On"))});
}

} // namespace

int main() {
    std::vector<build::Declaration> places{located("Stop", 'I', 7)};
    std::vector<build::Declaration> timers;
    std::vector<build::Statement> calls;
    for (const Signal& signal : signals) {
        const std::string name(signal.name);
        places.push_back(located(name + "Start", 'I', signal.bit));
        places.push_back(located(name + "On", 'Q', signal.bit));
        timers.push_back(
            build::variable_declaration({name + "Timer"}, build::derived_type_name("TON")));
        calls.push_back(timer_call(name, signal.delay));
    }
    const build::LibraryElement program = build::commented(
        build::program_declaration("Start",
                                   {build::variable_declarations(ast::VariableBlock::var, places),
                                    build::variable_declarations(ast::VariableBlock::var, timers)},
                                   build::statement_list(calls)),
        "made of the list of signals");

    const std::optional<iecfront::SyntaxTree> tree = build::library({program}, "start.st");
    if (!tree) {
        std::fprintf(stderr, "%s\n", program.fault().c_str());
        return 1;
    }
    std::fputs(std::string(tree->source().bytes()).c_str(), stdout);
    return tree->diagnostics().empty() ? 0 : 1;
}
