#include "fuzz/numbers.hpp"
#include "fuzz/targets.hpp"
#include "support/tree_faults.hpp"

#include <iecfront/ast/visitor.hpp>
#include <iecfront/builder/builder.hpp>
#include <iecfront/parser/parse.hpp>

#include <algorithm>
#include <array>

// The bytes choose what functions of the builder make, and what becomes of a tree by it.

namespace iecfront::test {
namespace {

using namespace build;

class Chooser {
protected:
    explicit Chooser(Numbers& numbers) : numbers_(numbers) {}

    template<class Enumeration>
    [[nodiscard]] Enumeration any_of(std::size_t count) {
        return static_cast<Enumeration>(numbers_.below(count));
    }
    [[nodiscard]] bool flip() { return numbers_.below(2) == 1; }
    template<class Make>
    [[nodiscard]] auto maybe(const Make& make) {
        std::optional<decltype(make())> result;
        if (flip())
            result = make();
        return result;
    }
    /// None of them now and then, where some are needed.
    template<class Element, class Make>
    [[nodiscard]] std::vector<Element> many(const Make& make) {
        std::vector<Element> result;
        for (std::size_t count = (numbers_.below(16) + 5) / 6; count > 0; --count)
            result.push_back(make());
        return result;
    }

    Numbers& numbers_;
};

/// Makes parts of all kinds as deep as is left.
class Maker : Chooser {
public:
    explicit Maker(Numbers& numbers) : Chooser(numbers) {}

    [[nodiscard]] LibraryElement element() {
        switch (numbers_.below(5)) {
        case 0:
            return data_type_declaration(many<Part<ast::TypeDeclaration>>([this] {
                return type_declaration(name(), type(4), maybe([this] { return initial(3); }));
            }));
        case 1: return function_declaration(name(), type(2), blocks(), body(4));
        case 2: return function_block_declaration(name(), blocks(), body(4));
        case 3: return program_declaration(name(), blocks(), body(4));
        default: return configuration_declaration(name(), configuration_elements(true));
        }
    }

    [[nodiscard]] Expression expression(int depth) {
        if (depth == 0 || numbers_.done())
            return variable_name(name());
        switch (numbers_.below(9)) {
        case 0: return constant();
        case 1:
            return binary_expression(any_of<ast::BinaryOperator>(15), expression(depth - 1),
                                     expression(depth - 1));
        case 2: return unary_expression(any_of<ast::UnaryOperator>(3), expression(depth - 1));
        case 3: return parenthesized_expression(expression(depth - 1));
        case 4: return enumerated_value(name(), flip() ? name() : "");
        case 5: return function_call(name(), arguments(depth - 1));
        case 6: return direct();
        case 7:
            return array_variable(expression(depth - 1),
                                  many<Expression>([&] { return expression(depth - 1); }));
        default: return structured_variable(expression(depth - 1), name());
        }
    }

    [[nodiscard]] Statement statement(int depth) {
        if (depth == 0 || numbers_.done())
            return assignment_statement(expression(1), expression(1));
        switch (numbers_.below(9)) {
        case 0: return empty_statement();
        case 1: return fb_invocation(name(), arguments(2));
        case 2: return return_statement();
        case 3:
            return if_statement(expression(2), list(depth), many<Part<ast::ElsifClause>>([&] {
                                    return elsif_clause(expression(1), list(depth));
                                }),
                                maybe([&] { return list(depth); }));
        case 4: return choice(depth);
        case 5:
            return for_statement(name(), expression(1), expression(1), expression(1), list(depth));
        case 6: return while_statement(expression(2), list(depth));
        case 7: return repeat_statement(list(depth), expression(2));
        default: return exit_statement();
        }
    }

    [[nodiscard]] Declaration declaration() {
        switch (numbers_.below(5)) {
        case 0: return edge_declaration(names(), any_of<ast::Edge>(3));
        case 1:
            return located_variable_declaration(flip() ? name() : "", location(direct()), type(2),
                                                maybe([this] { return initial(2); }));
        case 2:
            return access_declaration(name(), expression(2), type(1), any_of<ast::Direction>(3));
        case 3:
            return instance_specific_init(names(), maybe([this] { return location(direct()); }),
                                          type(1), maybe([this] { return initial(2); }));
        default:
            return variable_declaration(names(), type(3), maybe([this] { return initial(2); }));
        }
    }

    [[nodiscard]] Part<ast::VariableDeclarations> block() {
        return variable_declarations(any_of<ast::VariableBlock>(9),
                                     many<Declaration>([this] { return declaration(); }),
                                     any_of<ast::BlockQualifier>(4));
    }

    [[nodiscard]] TypeSpecification type(int depth) {
        if (depth == 0)
            return derived_type_name(name());
        switch (numbers_.below(6)) {
        case 0: return subrange_specification(type(depth - 1), range());
        case 1:
            return enumerated_specification(many<Part<ast::EnumeratedValueDeclaration>>(
                [this] { return enumerated_value_declaration(name(), flip() ? name() : ""); }));
        case 2:
            return array_specification(many<Part<ast::Subrange>>([this] { return range(); }),
                                       type(depth - 1));
        case 3: return string_specification(any_of<StringWidth>(2), expression(1));
        case 4:
            return structure_declaration(
                many<Part<ast::StructureElementDeclaration>>([this, depth] {
                    return structure_element_declaration(name(), type(depth - 1),
                                                         maybe([this] { return initial(2); }));
                }));
        default: return elementary_type_name(name());
        }
    }

    [[nodiscard]] Argument argument(int depth) {
        switch (numbers_.below(4)) {
        case 0: return output_argument(name(), expression(depth), flip());
        case 1: return expression(depth);
        case 2: return input_argument(name(), instructions(1));
        default: return input_argument(name(), expression(depth));
        }
    }

    [[nodiscard]] std::string_view name() {
        static constexpr std::array<std::string_view, 24> usual{
            "a",   "B7",     "x_y",      "INT", "BOOL",   "TRUE", "EN",  "IF",
            "AND", "T",      "D",        "LD",  "S1",     "N",    "MOD", "NOT",
            "ADD", "SINGLE", "PRIORITY", "TON", "R_EDGE", "a.b",  "",    "TIME"};
        const std::size_t choice = numbers_.below(usual.size() + 1);
        return choice < usual.size() ? usual[choice] : numbers_.text(numbers_.below(9));
    }

private:
    [[nodiscard]] std::vector<std::string_view> names() {
        return many<std::string_view>([this] { return name(); });
    }
    [[nodiscard]] std::vector<Argument> arguments(int depth) {
        return many<Argument>([&] { return argument(depth); });
    }
    [[nodiscard]] std::int64_t whole_number() {
        const auto high = static_cast<std::uint64_t>(numbers_.next()) << numbers_.below(40);
        return static_cast<std::int64_t>(flip() ? ~high : high);
    }

    [[nodiscard]] DateValue day() {
        return {static_cast<std::uint16_t>(numbers_.below(10001)),
                static_cast<std::uint8_t>(numbers_.below(14)),
                static_cast<std::uint8_t>(numbers_.below(33))};
    }
    [[nodiscard]] TimeOfDayValue clock() {
        return {static_cast<std::uint8_t>(numbers_.below(25)),
                static_cast<std::uint8_t>(numbers_.below(61)),
                static_cast<std::uint8_t>(numbers_.below(61)), numbers_.next() % 1'000'000'001U};
    }
    [[nodiscard]] Expression constant() {
        const std::string_view type = flip() ? name() : "";
        switch (numbers_.below(9)) {
        case 0: return integer_literal(whole_number(), type);
        case 1:
            return based_integer_literal(static_cast<std::uint64_t>(whole_number()),
                                         static_cast<unsigned>(numbers_.below(17)), type);
        case 2:
            return real_literal(static_cast<double>(whole_number()) / (1.0 + numbers_.next()),
                                type);
        case 3: return bit_string_literal(static_cast<std::uint64_t>(whole_number()), type);
        case 4: return boolean_literal(flip());
        case 5: return character_string(numbers_.text(numbers_.below(9)), any_of<StringWidth>(2));
        case 6: return duration(std::chrono::nanoseconds(whole_number()));
        case 7: return time_of_day(clock());
        default: return flip() ? Expression(date(day())) : date_and_time({day(), clock()});
        }
    }
    [[nodiscard]] Part<ast::DirectVariable> direct() {
        static constexpr std::string_view letters = "IQMXBWDLx";
        DirectVariableValue value;
        value.location = letters[numbers_.below(letters.size())];
        value.size = letters[numbers_.below(letters.size())];
        value.incomplete = numbers_.below(4) == 0;
        value.hierarchy = many<std::uint64_t>([this] { return numbers_.next(); });
        return direct_variable(value);
    }
    [[nodiscard]] Part<ast::Subrange> range() { return subrange(expression(1), expression(1)); }
    [[nodiscard]] Expression initial(int depth) {
        if (depth == 0 || numbers_.done())
            return expression(2);
        switch (numbers_.below(4)) {
        case 0: return array_initialization(many<Expression>([&] { return initial(depth - 1); }));
        case 1:
            return array_initial_elements(expression(1), maybe([&] { return initial(depth - 1); }));
        case 2:
            return structure_initialization(many<Part<ast::StructureElementInitialization>>(
                [&] { return structure_element_initialization(name(), initial(depth - 1)); }));
        default: return expression(2);
        }
    }

    [[nodiscard]] Part<ast::StatementList> list(int depth) {
        return statement_list(many<Statement>([&] { return statement(depth - 1); }));
    }
    [[nodiscard]] Part<ast::CaseStatement> choice(int depth) {
        const auto labels = [this] {
            return many<CaseLabel>(
                [this] { return flip() ? CaseLabel(range()) : CaseLabel(expression(1)); });
        };
        return case_statement(expression(1), many<Part<ast::CaseElement>>([&] {
                                  return case_element(labels(), list(depth));
                              }),
                              maybe([&] { return list(depth); }));
    }

    [[nodiscard]] std::vector<Part<ast::VariableDeclarations>> blocks() {
        return many<Part<ast::VariableDeclarations>>([this] { return block(); });
    }
    [[nodiscard]] Body body(int depth) {
        switch (numbers_.below(3)) {
        case 0: return instructions(2);
        case 1:
            if (depth > 0)
                return chart(depth - 1);
            [[fallthrough]];
        default: return list(depth + 1);
        }
    }

    [[nodiscard]] Part<ast::InstructionList> instructions(int depth) {
        return instruction_list(many<Part<ast::IlInstruction>>([&] {
            return flip() ? il_instruction(operation(depth))
                          : il_instruction(name(), maybe([&] { return operation(depth); }));
        }));
    }
    [[nodiscard]] IlOperation operation(int depth) {
        const auto op = any_of<ast::IlOperator>(31);
        const auto modifier = any_of<ast::IlModifier>(4);
        const auto operands = [this] { return many<Expression>([this] { return expression(1); }); };
        switch (numbers_.below(depth > 0 ? 7 : 5)) {
        case 0: return il_simple_operation(op, operands(), modifier);
        case 1: return il_simple_operation(name(), operands());
        case 2: return il_jump_operation(name(), modifier);
        case 3: return il_return_operation(modifier);
        case 4: return il_fb_call(name(), arguments(1), modifier);
        case 5: return il_formal_funct_call(name(), arguments(1));
        default:
            return il_expression(op, maybe([this] { return expression(1); }),
                                 instructions(depth - 1), modifier);
        }
    }

    [[nodiscard]] Part<ast::SequentialFunctionChart> chart(int depth) {
        return sequential_function_chart(many<Part<ast::SfcNetwork>>(
            [&] { return sfc_network(many<ChartElement>([&] { return chart_element(depth); })); }));
    }
    [[nodiscard]] ChartElement chart_element(int depth) {
        const auto associations = [this] {
            return many<Part<ast::ActionAssociation>>([this] { return association(); });
        };
        switch (numbers_.below(4)) {
        case 0: return initial_step(name(), associations());
        case 1: return step(name(), associations());
        case 2:
            return transition(flip() ? name() : "", steps(names()), steps(names()),
                              flip() ? transition_condition(instructions(1))
                                     : transition_condition(expression(2)),
                              maybe([this] { return expression(1); }));
        default: return action(name(), body(depth));
        }
    }
    [[nodiscard]] Part<ast::ActionAssociation> association() {
        return action_association(name(), maybe([this] {
                                      return action_qualifier(
                                          any_of<ast::ActionQualifierKind>(12),
                                          maybe([this] { return expression(1); }));
                                  }),
                                  many<Expression>([this] { return expression(1); }));
    }

    [[nodiscard]] std::vector<ConfigurationElement> configuration_elements(bool resources) {
        return many<ConfigurationElement>([&]() -> ConfigurationElement {
            switch (numbers_.below(resources ? 4 : 3)) {
            case 0: return block();
            case 1:
                return task_configuration(name(), many<Part<ast::TaskInitialization>>([this] {
                                              return task_initialization(name(), expression(1));
                                          }));
            case 2:
                return program_configuration(
                    name(), flip() ? name() : "", name(),
                    many<ProgConfElement>([this] { return prog_conf_element(); }),
                    any_of<ast::BlockQualifier>(4));
            default: return resource_declaration(name(), name(), configuration_elements(false));
            }
        });
    }
    [[nodiscard]] ProgConfElement prog_conf_element() {
        if (flip())
            return fb_task(expression(1), name());
        return prog_cnxn(expression(1), expression(1), flip());
    }
};

/// True for what is wrong with tokens: what the functions of the builder rule out.
[[nodiscard]] bool is_lexical_violation(const Diagnostic& diagnostic) {
    const DiagnosticInfo& info = diagnostic_info(diagnostic.id);
    return info.code < 2000 && info.category == DiagnosticClass::violation;
}

[[nodiscard]] std::string fault_of(const SyntaxTree& tree) {
    const std::string text(tree.source().bytes());
    std::string fault = tree_fault(tree, text);
    if (fault.empty() && !(tree == parse(tree.source(), tree.options())))
        fault = "what was made differs from a fresh tree of its text";
    return fault.empty() ? "" : fault + "\nin\n" + text;
}

[[nodiscard]] std::string lexical_fault(const SyntaxTree& tree) {
    for (const Diagnostic& diagnostic : tree.diagnostics())
        if (is_lexical_violation(diagnostic))
            return message(diagnostic, Encoding::utf8) + "\nin\n" +
                   std::string(tree.source().bytes());
    return {};
}

/// Calls `change(slot, node)` for some nodes of a tree.
template<class Change>
void for_some_nodes(const SyntaxTree& tree, Numbers& numbers, const Change& change) {
    for (const SyntaxTree::Slot& slot : tree.slots())
        ast::walk(slot.unit->root(), [&](const ast::Node& node) {
            if (numbers.below(8) == 0)
                change(slot, node);
            return ast::Walk::into;
        });
}

/// Something for the place of a node, by what it is.
void change(Changes& changes, const SyntaxTree::Slot& slot, const ast::Node& node, Maker& maker,
            Numbers& numbers) {
    const std::size_t way = numbers.below(3);
    if (const auto* expression = ast::as<ast::Expression>(&node)) {
        changes.replace(slot, *expression, maker.expression(2));
    } else if (const auto* list = ast::as<ast::StatementList>(&node)) {
        if (way == 0 || list->statements.empty())
            return changes.append(slot, *list, maker.statement(2));
        const ast::Statement& at = *list->statements[numbers.below(list->statements.size())];
        if (way == 1)
            return changes.remove(slot, at);
        changes.insert_before(slot, at, maker.statement(2));
        changes.insert_after(slot, at, maker.statement(1));
    } else if (const auto* block = ast::as<ast::VariableDeclarations>(&node)) {
        if (way == 0 || block->declarations.empty())
            return changes.append(slot, *block, maker.declaration());
        changes.remove(slot, *block->declarations[numbers.below(block->declarations.size())]);
    } else if (const auto* call = ast::as<ast::FbInvocation>(&node)) {
        for (const ast::Node* one : call->arguments)
            if (const auto* argument = ast::as<ast::InputArgument>(one))
                changes.insert_after(slot, *argument, maker.argument(1));
    } else if (const auto* program = ast::as<ast::ProgramDeclaration>(&node)) {
        changes.append(slot, *program, maker.block());
    } else if (const auto* type = ast::as<ast::TypeSpecification>(&node)) {
        changes.replace(slot, *type, maker.type(2));
    }
}

[[nodiscard]] std::string changes_fault(const SyntaxTree& tree, Maker& maker, Numbers& numbers) {
    Changes changes(tree);
    for_some_nodes(tree, numbers, [&](const SyntaxTree::Slot& slot, const ast::Node& node) {
        change(changes, slot, node, maker, numbers);
    });
    const std::optional<SyntaxTree> changed = changes.tree();
    if (changed.has_value() != changes.fault().empty())
        return "a tree and a fault, or neither: " + changes.fault();
    return changed ? fault_of(*changed) : "";
}

} // namespace

std::string build_fault(std::string_view bytes) {
    Numbers numbers(bytes);
    Maker maker(numbers);
    std::vector<LibraryElement> elements;
    for (std::size_t count = 1 + numbers.below(3); count > 0; --count)
        elements.push_back(maker.element());
    const bool sound = std::ranges::all_of(
        elements, [](const LibraryElement& element) { return element.fault().empty(); });
    const std::optional<SyntaxTree> tree = library(elements);
    if (tree.has_value() != sound)
        return "a library and a fault, or neither";
    std::string fault = tree ? fault_of(*tree) : "";
    if (fault.empty() && tree)
        fault = lexical_fault(*tree);
    if (fault.empty())
        fault = changes_fault(tree ? *tree : parse(SourceText(std::string(bytes))), maker, numbers);
    return fault;
}

} // namespace iecfront::test
