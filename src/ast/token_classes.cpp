#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/token_classes.hpp>
#include <iecfront/ast/visitor.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace iecfront {
namespace {

constexpr std::array<std::string_view, 24> class_names = {"keyword",
                                                          "type_name",
                                                          "library_element",
                                                          "function",
                                                          "variable",
                                                          "field",
                                                          "parameter",
                                                          "enumerated_value",
                                                          "configuration_element",
                                                          "step",
                                                          "action",
                                                          "transition",
                                                          "label",
                                                          "il_operator",
                                                          "number",
                                                          "boolean",
                                                          "string",
                                                          "time",
                                                          "direct_variable",
                                                          "operator_sign",
                                                          "delimiter",
                                                          "comment",
                                                          "pragma",
                                                          "unknown"};

[[nodiscard]] TokenClass class_of_keyword(TokenKind kind) noexcept {
    switch (kind) {
    case TokenKind::kw_and:
    case TokenKind::kw_or:
    case TokenKind::kw_xor:
    case TokenKind::kw_not:
    case TokenKind::kw_mod: return TokenClass::operator_sign;
    case TokenKind::kw_true:
    case TokenKind::kw_false: return TokenClass::boolean;
    case TokenKind::kw_en:
    case TokenKind::kw_eno: return TokenClass::variable;
    default:
        return is_elementary_type_name(kind) || is_generic_type_name(kind) ? TokenClass::type_name
                                                                           : TokenClass::keyword;
    }
}

[[nodiscard]] TokenClass class_of_delimiter(TokenKind kind) noexcept {
    switch (kind) {
    case TokenKind::left_parenthesis:
    case TokenKind::right_parenthesis:
    case TokenKind::left_bracket:
    case TokenKind::right_bracket:
    case TokenKind::comma:
    case TokenKind::semicolon:
    case TokenKind::colon:
    case TokenKind::dot:
    case TokenKind::dot_dot: return TokenClass::delimiter;
    default: return TokenClass::operator_sign;
    }
}

/// What a token is by its kind alone.
[[nodiscard]] TokenClass class_of(TokenKind kind) noexcept {
    if (is_keyword(kind))
        return class_of_keyword(kind);
    if (is_delimiter(kind))
        return class_of_delimiter(kind);
    switch (kind) {
    case TokenKind::identifier: return TokenClass::variable;
    case TokenKind::enumerated_value: return TokenClass::enumerated_value;
    case TokenKind::integer:
    case TokenKind::based_integer:
    case TokenKind::real:
    case TokenKind::typed_literal: return TokenClass::number;
    case TokenKind::single_byte_string:
    case TokenKind::double_byte_string: return TokenClass::string;
    case TokenKind::duration:
    case TokenKind::time_of_day:
    case TokenKind::date:
    case TokenKind::date_and_time: return TokenClass::time;
    case TokenKind::direct_variable:
    case TokenKind::part_selector:
    case TokenKind::incomplete_location: return TokenClass::direct_variable;
    default: return TokenClass::unknown;
    }
}

/// The name that a path of names begins with; null when it begins with something else.
[[nodiscard]] const ast::Node* head_of(const ast::Expression& path) noexcept {
    const ast::Expression* part = &path;
    for (;;) {
        if (const auto* field = ast::as<ast::StructuredVariable>(part))
            part = field->record_variable;
        else if (const auto* element = ast::as<ast::ArrayVariable>(part))
            part = element->subscripted_variable;
        else if (const auto* target = ast::as<ast::DereferencedVariable>(part))
            part = target->reference;
        else
            return part->kind == ast::NodeKind::variable_name ? part : nullptr;
    }
}

/// Sets the class of each name from the node that it is a part of.
class NameClassifier : public ast::Visitor<NameClassifier> {
public:
    NameClassifier(const Unit& unit, std::vector<TokenClass>& classes)
        : unit_(unit), classes_(classes) {}

    ast::Walk visit(const ast::Node&) { return ast::Walk::into; }
    ast::Walk visit(const ast::FunctionDeclaration& node) {
        return set(node.name, TokenClass::function);
    }
    ast::Walk visit(const ast::FunctionBlockDeclaration& node) {
        return set(node.name, TokenClass::library_element);
    }
    ast::Walk visit(const ast::ProgramDeclaration& node) {
        return set(node.name, TokenClass::library_element);
    }
    ast::Walk visit(const ast::ConfigurationDeclaration& node) {
        return set(node.name, TokenClass::library_element);
    }
    ast::Walk visit(const ast::TypeDeclaration& node) {
        return set(node.name, TokenClass::type_name);
    }
    ast::Walk visit(const ast::DerivedTypeName& node) { return set(&node, TokenClass::type_name); }
    ast::Walk visit(const ast::EnumeratedValueDeclaration& node) {
        return set(node.name, TokenClass::enumerated_value);
    }
    ast::Walk visit(const ast::EnumeratedValue& node) {
        return set(&node, TokenClass::enumerated_value);
    }
    ast::Walk visit(const ast::StructureElementDeclaration& node) {
        for (const ast::Identifier* name : node.names)
            set(name, TokenClass::field);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::StructureElementInitialization& node) {
        return set(node.name, TokenClass::field);
    }
    ast::Walk visit(const ast::StructuredVariable& node) {
        if (node.field_selector->kind == ast::NodeKind::identifier)
            set(node.field_selector, TokenClass::field);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::BooleanLiteral& node) { return set(&node, TokenClass::boolean); }
    ast::Walk visit(const ast::FunctionCall& node) {
        if (node.function->kind == ast::NodeKind::variable_name)
            set(node.function, TokenClass::function);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::InputArgument& node) {
        return set(node.name, TokenClass::parameter);
    }
    ast::Walk visit(const ast::OutputArgument& node) {
        return set(node.name, TokenClass::parameter);
    }

    ast::Walk visit(const ast::Step& node) { return set(node.name, TokenClass::step); }
    ast::Walk visit(const ast::Steps& node) {
        for (const ast::Identifier* name : node.names)
            set(name, TokenClass::step);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::ActionAssociation& node) {
        return set(node.action_name, TokenClass::action);
    }
    ast::Walk visit(const ast::ActionQualifier& node) {
        return set_first(node, TokenClass::keyword);
    }
    ast::Walk visit(const ast::Action& node) { return set(node.name, TokenClass::action); }
    ast::Walk visit(const ast::Transition& node) {
        if (node.priority != nullptr && node.priority->first_token >= node.first_token + 2)
            set_priority(node.priority->first_token - 2);
        return set(node.name, TokenClass::transition);
    }

    ast::Walk visit(const ast::ResourceDeclaration& node) {
        set(node.type, TokenClass::type_name);
        return set(node.name, TokenClass::configuration_element);
    }
    ast::Walk visit(const ast::TaskConfiguration& node) {
        return set(node.name, TokenClass::configuration_element);
    }
    ast::Walk visit(const ast::TaskInitialization& node) {
        return set(node.name, TokenClass::parameter);
    }
    ast::Walk visit(const ast::ProgramConfiguration& node) {
        set(node.task, TokenClass::configuration_element);
        set(node.type, TokenClass::type_name);
        return set(node.name, TokenClass::configuration_element);
    }
    ast::Walk visit(const ast::FbTask& node) {
        return set(node.task, TokenClass::configuration_element);
    }
    ast::Walk visit(const ast::ProgCnxn& node) {
        return set(head_of(*node.variable), TokenClass::parameter);
    }
    ast::Walk visit(const ast::AccessDeclaration& node) {
        return set(node.name, TokenClass::configuration_element);
    }
    ast::Walk visit(const ast::InstanceSpecificInit& node) {
        for (const ast::Identifier* name : node.path)
            set(name, name == node.path.front() ? TokenClass::variable : TokenClass::field);
        return ast::Walk::into;
    }

    ast::Walk visit(const ast::IlInstruction& node) { return set(node.label, TokenClass::label); }
    ast::Walk visit(const ast::IlOperation& node) {
        return set_first(node, TokenClass::il_operator);
    }
    ast::Walk visit(const ast::IlSimpleOperation& node) {
        return set_operator(node, node.function_name, node.modifier);
    }
    ast::Walk visit(const ast::IlExpression& node) {
        return set_operator(node, nullptr, node.modifier);
    }
    ast::Walk visit(const ast::IlFormalFunctCall& node) {
        return set(node.function_name, TokenClass::function);
    }
    ast::Walk visit(const ast::IlJumpOperation& node) {
        set(node.label, TokenClass::label);
        return set_first(node, TokenClass::il_operator);
    }

private:
    ast::Walk set(const ast::Node* name, TokenClass token_class) {
        if (name != nullptr)
            for (std::uint32_t i = name->first_token; i < name->end_token; ++i)
                classes_[i] = token_class;
        return ast::Walk::into;
    }
    ast::Walk set_first(const ast::Node& node, TokenClass token_class) {
        if (node.first_token != node.end_token)
            classes_[node.first_token] = token_class;
        return ast::Walk::into;
    }

    // The word of `PRIORITY := 1` has no node of its own.
    void set_priority(std::uint32_t word) {
        if (unit_.tokens()[word].kind() == TokenKind::identifier)
            classes_[word] = TokenClass::parameter;
    }
    // `&N` is two tokens, which adjoin.
    ast::Walk set_operator(const ast::Node& node, const ast::Identifier* function,
                           ast::IlModifier modifier) {
        if (function != nullptr)
            return set(function, TokenClass::function);
        const bool split = modifier != ast::IlModifier::none &&
                           unit_.tokens()[node.first_token].kind() == TokenKind::ampersand;
        if (split)
            classes_[node.first_token + 1] = TokenClass::il_operator;
        return set_first(node, TokenClass::il_operator);
    }

    const Unit& unit_;
    std::vector<TokenClass>& classes_;
};

} // namespace

std::string_view to_string(TokenClass token_class) noexcept {
    return class_names[static_cast<std::size_t>(token_class)];
}

std::vector<ClassifiedToken> token_classes(const Unit& unit) {
    const std::span<const Token> tokens = unit.tokens();
    std::vector<TokenClass> classes;
    classes.reserve(tokens.size());
    for (const Token token : tokens)
        classes.push_back(class_of(token.kind()));
    NameClassifier(unit, classes).traverse(unit.root());

    std::vector<ClassifiedToken> result;
    result.reserve(tokens.size() + unit.trivia().size());
    std::size_t token = 0;
    for (const Trivia& trivia : unit.trivia()) {
        for (; token < tokens.size() && tokens[token].offset() < trivia.range.begin; ++token)
            result.push_back({tokens[token].range(), classes[token]});
        result.push_back({trivia.range, trivia.kind == TriviaKind::pragma ? TokenClass::pragma
                                                                          : TokenClass::comment});
    }
    for (; token < tokens.size(); ++token)
        result.push_back({tokens[token].range(), classes[token]});
    return result;
}

} // namespace iecfront
