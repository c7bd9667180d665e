#include "builder/rebuild.hpp"

#include <iecfront/ast/dump.hpp>
#include <iecfront/builder/builder.hpp>
#include <iecfront/lexer/literals.hpp>
#include <iecfront/lexer/name.hpp>

namespace iecfront::test {
namespace {

using namespace build;

/// Makes the nodes of one unit anew.
class Rebuilder {
public:
    explicit Rebuilder(const Unit& unit) : unit_(unit) {}

    [[nodiscard]] LibraryElement element(const ast::Node& node) const {
        switch (node.kind) {
        case ast::NodeKind::data_type_declaration:
            return types(*ast::as<ast::DataTypeDeclaration>(&node));
        case ast::NodeKind::function_declaration: {
            const auto& function = *ast::as<ast::FunctionDeclaration>(&node);
            return function_declaration(text(*function.name), type(*function.result_type),
                                        blocks(function.declarations), body(*function.body));
        }
        case ast::NodeKind::function_block_declaration: {
            const auto& block = *ast::as<ast::FunctionBlockDeclaration>(&node);
            return function_block_declaration(text(*block.name), blocks(block.declarations),
                                              body(*block.body));
        }
        case ast::NodeKind::program_declaration: {
            const auto& program = *ast::as<ast::ProgramDeclaration>(&node);
            return program_declaration(text(*program.name), blocks(program.declarations),
                                       body(*program.body));
        }
        default: return configuration(*ast::as<ast::ConfigurationDeclaration>(&node));
        }
    }

private:
    [[nodiscard]] std::string_view text(const ast::Node& node) const { return unit_.text(node); }

    /// `make` of each element.
    template<class Part, class T, class Make>
    [[nodiscard]] static std::vector<Part> each(const ast::List<T>& list, const Make& make) {
        std::vector<Part> parts;
        for (const T* element : list)
            parts.push_back(make(*element));
        return parts;
    }
    [[nodiscard]] std::vector<std::string_view>
    names(const ast::List<ast::Identifier>& list) const {
        return each<std::string_view>(list, [this](const ast::Node& n) { return text(n); });
    }

    // ---- types ---------------------------------------------------------------------------------

    [[nodiscard]] LibraryElement types(const ast::DataTypeDeclaration& declaration) const {
        return data_type_declaration(each<Part<ast::TypeDeclaration>>(
            declaration.declarations, [this](const ast::Node& node) {
                const auto& one = *ast::as<ast::TypeDeclaration>(&node);
                return type_declaration(text(*one.name), type(*one.specification),
                                        optional(one.initial_value));
            }));
    }

    [[nodiscard]] Part<ast::Subrange> range(const ast::Subrange& range) const {
        return subrange(expression(*range.lower), expression(*range.upper));
    }

    [[nodiscard]] TypeSpecification type(const ast::TypeSpecification& node) const {
        switch (node.kind) {
        case ast::NodeKind::elementary_type_name: return elementary_type_name(text(node));
        case ast::NodeKind::derived_type_name: return derived_type_name(text(node));
        case ast::NodeKind::subrange_specification: {
            const auto& specification = *ast::as<ast::SubrangeSpecification>(&node);
            return subrange_specification(type(*specification.base), range(*specification.range));
        }
        case ast::NodeKind::enumerated_specification:
            return enumerated_specification(each<Part<ast::EnumeratedValueDeclaration>>(
                ast::as<ast::EnumeratedSpecification>(&node)->values,
                [this](const ast::EnumeratedValueDeclaration& value) {
                    const EnumeratedValueName name = split_enumerated_value(text(*value.name));
                    return enumerated_value_declaration(name.value, name.type);
                }));
        case ast::NodeKind::array_specification: {
            const auto& array = *ast::as<ast::ArraySpecification>(&node);
            return array_specification(
                each<Part<ast::Subrange>>(array.subranges,
                                          [this](const ast::Subrange& one) { return range(one); }),
                type(*array.element_type));
        }
        case ast::NodeKind::string_specification: {
            const auto& string = *ast::as<ast::StringSpecification>(&node);
            return string_specification(string.double_byte ? StringWidth::double_byte
                                                           : StringWidth::single_byte,
                                        expression(*string.length));
        }
        default: return structure(*ast::as<ast::StructureDeclaration>(&node));
        }
    }

    [[nodiscard]] TypeSpecification structure(const ast::StructureDeclaration& structure) const {
        return structure_declaration(each<Part<ast::StructureElementDeclaration>>(
            structure.elements, [this](const ast::Node& node) {
                const auto& one = *ast::as<ast::StructureElementDeclaration>(&node);
                return structure_element_declaration(text(*one.names[0]), type(*one.specification),
                                                     optional(one.initial_value));
            }));
    }

    // ---- variables -----------------------------------------------------------------------------

    [[nodiscard]] std::vector<Part<ast::VariableDeclarations>>
    blocks(const ast::List<ast::VariableDeclarations>& list) const {
        return each<Part<ast::VariableDeclarations>>(
            list, [this](const ast::VariableDeclarations& one) { return block(one); });
    }

    [[nodiscard]] Part<ast::VariableDeclarations>
    block(const ast::VariableDeclarations& block) const {
        return variable_declarations(
            block.block,
            each<Declaration>(block.declarations,
                              [this](const ast::Node& one) { return declaration(one); }),
            block.qualifier);
    }

    [[nodiscard]] Declaration declaration(const ast::Node& node) const {
        if (const auto* access = ast::as<ast::AccessDeclaration>(&node))
            return access_declaration(text(*access->name), expression(*access->path),
                                      type(*access->specification), access->direction);
        if (const auto* init = ast::as<ast::InstanceSpecificInit>(&node))
            return instance_specific_init(names(init->path), location_of(init->location),
                                          type(*init->specification),
                                          optional(init->initial_value));
        const auto& variable = *ast::as<ast::VariableDeclaration>(&node);
        if (variable.edge != ast::Edge::none)
            return edge_declaration(names(variable.names), variable.edge);
        if (variable.location != nullptr)
            return located_variable_declaration(
                variable.names.empty() ? std::string_view() : text(*variable.names[0]),
                *location_of(variable.location), type(*variable.specification),
                optional(variable.initial_value));
        return variable_declaration(names(variable.names), type(*variable.specification),
                                    optional(variable.initial_value));
    }

    [[nodiscard]] std::optional<Part<ast::Location>> location_of(const ast::Location* node) const {
        if (node == nullptr)
            return std::nullopt;
        return location(direct(*ast::as<ast::DirectVariable>(node->variable)));
    }

    [[nodiscard]] Part<ast::DirectVariable> direct(const ast::DirectVariable& node) const {
        const Part<ast::DirectVariable> made = direct_variable(*direct_variable_value(text(node)));
        return names_equal(made.text(), text(node)) ? made : copy(unit_, node);
    }

    // ---- expressions ---------------------------------------------------------------------------

    [[nodiscard]] std::optional<Expression> optional(const ast::Expression* node) const {
        return node == nullptr ? std::nullopt : std::optional(expression(*node));
    }
    [[nodiscard]] std::vector<Expression> all(const ast::List<ast::Expression>& list) const {
        return each<Expression>(list, [this](const ast::Expression& e) { return expression(e); });
    }

    [[nodiscard]] Expression expression(const ast::Expression& node) const {
        switch (node.kind) {
        case ast::NodeKind::enumerated_value: {
            const EnumeratedValueName name = split_enumerated_value(text(node));
            return enumerated_value(name.value, name.type);
        }
        case ast::NodeKind::direct_variable: return direct(*ast::as<ast::DirectVariable>(&node));
        case ast::NodeKind::variable_name: return variable_name(text(node));
        case ast::NodeKind::array_variable: {
            const auto& array = *ast::as<ast::ArrayVariable>(&node);
            return array_variable(expression(*array.subscripted_variable), all(array.subscripts));
        }
        case ast::NodeKind::structured_variable: {
            const auto& record = *ast::as<ast::StructuredVariable>(&node);
            if (const auto* place = ast::as<ast::DirectVariable>(record.field_selector))
                return structured_variable(expression(*record.record_variable), direct(*place));
            return structured_variable(expression(*record.record_variable),
                                       text(*record.field_selector));
        }
        case ast::NodeKind::binary_expression: {
            const auto& binary = *ast::as<ast::BinaryExpression>(&node);
            return binary_expression(binary.op, expression(*binary.left),
                                     expression(*binary.right));
        }
        case ast::NodeKind::unary_expression: {
            const auto& unary = *ast::as<ast::UnaryExpression>(&node);
            return unary_expression(unary.op, expression(*unary.operand));
        }
        case ast::NodeKind::parenthesized_expression:
            return parenthesized_expression(
                expression(*ast::as<ast::ParenthesizedExpression>(&node)->expression));
        case ast::NodeKind::function_call: {
            const auto& call = *ast::as<ast::FunctionCall>(&node);
            return function_call(text(*call.function), arguments(call.arguments));
        }
        default: return initial_value(node);
        }
    }

    [[nodiscard]] Expression initial_value(const ast::Expression& node) const {
        if (const auto* array = ast::as<ast::ArrayInitialization>(&node))
            return array_initialization(all(array->elements));
        if (const auto* repeated = ast::as<ast::ArrayInitialElements>(&node))
            return array_initial_elements(
                expression(*repeated->count),
                optional(repeated->elements.empty() ? nullptr : repeated->elements[0]));
        if (const auto* structure = ast::as<ast::StructureInitialization>(&node))
            return structure_initialization(each<Part<ast::StructureElementInitialization>>(
                structure->elements, [this](const ast::StructureElementInitialization& one) {
                    return structure_element_initialization(text(*one.name),
                                                            expression(*one.value));
                }));
        return copy(unit_, node);
    }

    [[nodiscard]] std::vector<Argument> arguments(const ast::List<ast::Node>& list) const {
        return each<Argument>(list, [this](const ast::Node& one) { return argument(one); });
    }

    [[nodiscard]] Argument argument(const ast::Node& node) const {
        if (const auto* output = ast::as<ast::OutputArgument>(&node))
            return output_argument(text(*output->name), expression(*output->variable),
                                   output->negated);
        const auto& input = *ast::as<ast::InputArgument>(&node);
        if (input.name == nullptr)
            return expression(*ast::as<ast::Expression>(input.value));
        return input_argument(text(*input.name), condition(*input.value));
    }

    [[nodiscard]] Condition condition(const ast::Node& node) const {
        if (const auto* list = ast::as<ast::InstructionList>(&node))
            return instructions(*list);
        return expression(*ast::as<ast::Expression>(&node));
    }

    // ---- bodies --------------------------------------------------------------------------------

    [[nodiscard]] Body body(const ast::Body& node) const {
        if (const auto* list = ast::as<ast::StatementList>(&node))
            return statements(*list);
        if (const auto* list = ast::as<ast::InstructionList>(&node))
            return instructions(*list);
        const auto& chart = *ast::as<ast::SequentialFunctionChart>(&node);
        return sequential_function_chart(
            each<Part<ast::SfcNetwork>>(chart.networks, [this](const ast::SfcNetwork& network) {
                return sfc_network(
                    each<ChartElement>(network.elements, [this](const ast::Node& element) {
                        return chart_element(element);
                    }));
            }));
    }

    [[nodiscard]] Part<ast::StatementList> statements(const ast::StatementList& list) const {
        return statement_list(each<Statement>(
            list.statements, [this](const ast::Statement& one) { return statement(one); }));
    }
    [[nodiscard]] std::optional<Part<ast::StatementList>>
    statements(const ast::StatementList* list) const {
        return list == nullptr ? std::nullopt : std::optional(statements(*list));
    }

    [[nodiscard]] Statement statement(const ast::Statement& node) const {
        switch (node.kind) {
        case ast::NodeKind::empty_statement: return empty_statement();
        case ast::NodeKind::assignment_statement: {
            const auto& assignment = *ast::as<ast::AssignmentStatement>(&node);
            return assignment_statement(expression(*assignment.variable),
                                        expression(*assignment.expression));
        }
        case ast::NodeKind::fb_invocation: {
            const auto& invocation = *ast::as<ast::FbInvocation>(&node);
            return fb_invocation(text(*invocation.fb_name), arguments(invocation.arguments));
        }
        case ast::NodeKind::return_statement: return return_statement();
        case ast::NodeKind::exit_statement: return exit_statement();
        case ast::NodeKind::if_statement: return if_of(*ast::as<ast::IfStatement>(&node));
        case ast::NodeKind::case_statement: return case_of(*ast::as<ast::CaseStatement>(&node));
        case ast::NodeKind::for_statement: return for_of(*ast::as<ast::ForStatement>(&node));
        case ast::NodeKind::while_statement: {
            const auto& loop = *ast::as<ast::WhileStatement>(&node);
            return while_statement(expression(*loop.condition), statements(*loop.statements));
        }
        default: {
            const auto& loop = *ast::as<ast::RepeatStatement>(&node);
            return repeat_statement(statements(*loop.statements), expression(*loop.condition));
        }
        }
    }

    [[nodiscard]] Statement if_of(const ast::IfStatement& node) const {
        return if_statement(expression(*node.condition), statements(*node.then_list),
                            each<Part<ast::ElsifClause>>(node.elsif_clauses,
                                                         [this](const ast::ElsifClause& clause) {
                                                             return elsif_clause(
                                                                 expression(*clause.condition),
                                                                 statements(*clause.statements));
                                                         }),
                            statements(node.else_list));
    }

    [[nodiscard]] Statement case_of(const ast::CaseStatement& node) const {
        const auto label = [this](const ast::Node& one) -> CaseLabel {
            if (const auto* subrange = ast::as<ast::Subrange>(&one))
                return range(*subrange);
            return expression(*ast::as<ast::Expression>(&one));
        };
        return case_statement(expression(*node.selector),
                              each<Part<ast::CaseElement>>(
                                  node.elements,
                                  [&](const ast::CaseElement& element) {
                                      return case_element(each<CaseLabel>(element.labels, label),
                                                          statements(*element.statements));
                                  }),
                              statements(node.else_list));
    }

    [[nodiscard]] Statement for_of(const ast::ForStatement& node) const {
        const std::string_view variable = text(*node.control_variable);
        const Expression from = expression(*node.from);
        const Expression to = expression(*node.to);
        if (node.by == nullptr)
            return for_statement(variable, from, to, statements(*node.statements));
        return for_statement(variable, from, to, expression(*node.by),
                             statements(*node.statements));
    }

    // ---- Instruction List ----------------------------------------------------------------------

    [[nodiscard]] Part<ast::InstructionList> instructions(const ast::InstructionList& list) const {
        return instruction_list(each<Part<ast::IlInstruction>>(
            list.instructions, [this](const ast::IlInstruction& one) {
                if (one.label == nullptr)
                    return il_instruction(operation(*one.operation));
                std::optional<IlOperation> made;
                if (one.operation != nullptr)
                    made = operation(*one.operation);
                return il_instruction(text(*one.label), made);
            }));
    }

    [[nodiscard]] IlOperation operation(const ast::IlOperation& node) const {
        switch (node.kind) {
        case ast::NodeKind::il_simple_operation: {
            const auto& simple = *ast::as<ast::IlSimpleOperation>(&node);
            if (simple.function_name != nullptr)
                return il_simple_operation(text(*simple.function_name), all(simple.operands));
            return il_simple_operation(simple.op, all(simple.operands), simple.modifier);
        }
        case ast::NodeKind::il_expression: {
            const auto& nested = *ast::as<ast::IlExpression>(&node);
            return il_expression(nested.op, optional(nested.operand),
                                 instructions(*nested.instructions), nested.modifier);
        }
        case ast::NodeKind::il_jump_operation: {
            const auto& jump = *ast::as<ast::IlJumpOperation>(&node);
            return il_jump_operation(text(*jump.label), jump.modifier);
        }
        case ast::NodeKind::il_fb_call: {
            const auto& call = *ast::as<ast::IlFbCall>(&node);
            return il_fb_call(text(*call.fb_name), arguments(call.arguments), call.modifier);
        }
        case ast::NodeKind::il_formal_funct_call: {
            const auto& call = *ast::as<ast::IlFormalFunctCall>(&node);
            return il_formal_funct_call(text(*call.function_name), arguments(call.arguments));
        }
        default: return il_return_operation(ast::as<ast::IlReturnOperation>(&node)->modifier);
        }
    }

    // ---- charts --------------------------------------------------------------------------------

    [[nodiscard]] ChartElement chart_element(const ast::Node& node) const {
        if (const auto* one = ast::as<ast::Step>(&node))
            return step_of(*one);
        if (const auto* one = ast::as<ast::Action>(&node))
            return action(text(*one->name), body(*one->body));
        const auto& one = *ast::as<ast::Transition>(&node);
        return transition(one.name == nullptr ? std::string_view() : text(*one.name),
                          steps(names(one.from->names)), steps(names(one.to->names)),
                          transition_condition(condition(*one.condition->condition)),
                          optional(one.priority));
    }

    [[nodiscard]] ChartElement step_of(const ast::Step& node) const {
        const auto actions = each<Part<ast::ActionAssociation>>(
            node.actions, [this](const ast::ActionAssociation& one) {
                std::optional<Part<ast::ActionQualifier>> qualifier;
                if (one.qualifier != nullptr)
                    qualifier =
                        action_qualifier(one.qualifier->qualifier, optional(one.qualifier->time));
                return action_association(text(*one.action_name), qualifier, all(one.indicators));
            });
        return node.initial ? initial_step(text(*node.name), actions)
                            : step(text(*node.name), actions);
    }

    // ---- configurations ------------------------------------------------------------------------

    [[nodiscard]] LibraryElement configuration(const ast::ConfigurationDeclaration& node) const {
        return configuration_declaration(text(*node.name), elements(node.elements));
    }

    [[nodiscard]] std::vector<ConfigurationElement>
    elements(const ast::List<ast::Node>& list) const {
        return each<ConfigurationElement>(
            list, [this](const ast::Node& one) { return configuration_element(one); });
    }

    [[nodiscard]] ConfigurationElement configuration_element(const ast::Node& node) const {
        if (const auto* one = ast::as<ast::VariableDeclarations>(&node))
            return block(*one);
        if (const auto* one = ast::as<ast::ResourceDeclaration>(&node))
            return resource_declaration(text(*one->name), text(*one->type),
                                        elements(one->elements));
        if (const auto* one = ast::as<ast::TaskConfiguration>(&node))
            return task_configuration(
                text(*one->name),
                each<Part<ast::TaskInitialization>>(
                    one->initializations, [this](const ast::TaskInitialization& init) {
                        return task_initialization(text(*init.name), expression(*init.value));
                    }));
        const auto& program = *ast::as<ast::ProgramConfiguration>(&node);
        return program_configuration(
            text(*program.name), program.task == nullptr ? std::string_view() : text(*program.task),
            text(*program.type),
            each<ProgConfElement>(program.elements,
                                  [this](const ast::Node& one) { return conf_element(one); }),
            program.qualifier);
    }

    [[nodiscard]] ProgConfElement conf_element(const ast::Node& node) const {
        if (const auto* task = ast::as<ast::FbTask>(&node))
            return fb_task(expression(*task->fb_name), text(*task->task));
        const auto& connection = *ast::as<ast::ProgCnxn>(&node);
        return prog_cnxn(expression(*connection.variable), expression(*connection.operand),
                         connection.output);
    }

    const Unit& unit_;
};

[[nodiscard]] std::string shape(const SyntaxTree& tree) {
    std::string out;
    for (const SyntaxTree::Slot& slot : tree.slots())
        for (const ast::Node* element : slot.unit->root().elements)
            out += s_expression(*slot.unit, *element) + '\n';
    return folded(out);
}

} // namespace

std::string rebuild_fault(const SyntaxTree& tree) {
    std::vector<LibraryElement> elements;
    for (const SyntaxTree::Slot& slot : tree.slots())
        for (const ast::Node* element : slot.unit->root().elements) {
            elements.push_back(Rebuilder(*slot.unit).element(*element));
            if (!elements.back().fault().empty())
                return elements.back().fault();
        }
    const std::optional<SyntaxTree> made = library(elements);
    if (!made)
        return "no tree";
    if (shape(*made) == shape(tree))
        return {};
    return "read:  " + shape(tree) + "built: " + shape(*made);
}

} // namespace iecfront::test
