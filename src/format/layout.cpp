#include "format/layout.hpp"

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/visitor.hpp>

#include <span>

namespace iecfront::layout {
namespace {

// Columns from the operator of an instruction to its operand, and to its arguments.
constexpr std::int32_t operand_column = 6;

// ---- what a token says by its kind alone -------------------------------------------------------

[[nodiscard]] bool glued_to_left(TokenKind kind) noexcept {
    switch (kind) {
    case TokenKind::comma:
    case TokenKind::semicolon:
    case TokenKind::colon:
    case TokenKind::right_parenthesis:
    case TokenKind::right_bracket:
    case TokenKind::dot:
    case TokenKind::caret:
    case TokenKind::dot_dot: return true;
    default: return false;
    }
}

[[nodiscard]] bool glued_to_right(TokenKind kind) noexcept {
    return kind == TokenKind::left_parenthesis || kind == TokenKind::left_bracket ||
           kind == TokenKind::dot || kind == TokenKind::dot_dot;
}

// Words that close what stands in lines of its own above them.
[[nodiscard]] bool closes_block(TokenKind kind) noexcept {
    switch (kind) {
    case TokenKind::kw_end_type:
    case TokenKind::kw_end_function:
    case TokenKind::kw_end_function_block:
    case TokenKind::kw_end_program:
    case TokenKind::kw_end_configuration:
    case TokenKind::kw_end_struct:
    case TokenKind::kw_end_var:
    case TokenKind::kw_end_resource:
    case TokenKind::kw_end_step:
    case TokenKind::kw_end_transition:
    case TokenKind::kw_end_action:
    case TokenKind::kw_elsif:
    case TokenKind::kw_else:
    case TokenKind::kw_end_if:
    case TokenKind::kw_end_case:
    case TokenKind::kw_end_for:
    case TokenKind::kw_end_while:
    case TokenKind::kw_until:
    case TokenKind::kw_end_repeat: return true;
    default: return false;
    }
}

[[nodiscard]] TokenLayout by_kind(TokenKind before, TokenKind kind) noexcept {
    TokenLayout layout;
    layout.space = !glued_to_left(kind) && !glued_to_right(before);
    layout.begins_line = closes_block(kind);
    layout.closes = layout.begins_line;
    layout.may_break = before == TokenKind::comma;
    layout.word = is_keyword(kind);
    return layout;
}

// How far apart the operands of an operator may be torn: weak operators are broken at first.
[[nodiscard]] std::uint8_t rank_of(ast::BinaryOperator op) noexcept {
    using enum ast::BinaryOperator;
    switch (op) {
    case logical_or: return 1;
    case exclusive_or: return 2;
    case logical_and: return 3;
    case equal:
    case not_equal: return 4;
    case less:
    case greater:
    case less_equal:
    case greater_equal: return 5;
    case add:
    case subtract: return 6;
    case multiply:
    case divide:
    case modulo: return 7;
    case power: return 8;
    }
    return 8;
}

// ---- what a token says by its place in the tree ------------------------------------------------

/// One function a kind of node. The functions of the parents are called first, and what a child
/// says holds.
class Rules : public ast::Visitor<Rules> {
public:
    Rules(const Unit& unit, std::uint32_t indent_width)
        : tokens_(unit.tokens()), width_(static_cast<std::int32_t>(indent_width)) {
        rows_.reserve(tokens_.size());
        TokenKind before = TokenKind::end_of_unit;
        for (const Token token : tokens_) {
            rows_.push_back(by_kind(before, token.kind()));
            before = token.kind();
        }
    }

    std::vector<TokenLayout> finish() && {
        std::int32_t level = 0;
        for (TokenLayout& row : rows_) {
            level += row.level; // until here the difference to the token before
            row.level = level < 0 ? 0 : level;
        }
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (rows_[i].in_instructions) {
                rows_[i].begins_line = tokens_[i].first_on_line();
                rows_[i].may_break = false;
            }
        return std::move(rows_);
    }

    ast::Walk visit(const ast::Node&) { return ast::Walk::into; }

    // ---- names, literals, words ----------------------------------------------------------------

    ast::Walk visit(const ast::Identifier& node) { return name(node); }
    ast::Walk visit(const ast::VariableName& node) { return name(node); }
    ast::Walk visit(const ast::DerivedTypeName& node) { return name(node); }
    ast::Walk visit(const ast::EnumeratedValue& node) { return name(node); }
    ast::Walk visit(const ast::Constant& node) {
        if (node.has_sign())
            no_space(node.literal_token);
        return ast::Walk::into;
    }

    // ---- library elements (B.0, B.1.5) ---------------------------------------------------------

    ast::Walk visit(const ast::LibraryUnit& node) {
        for (const ast::Node* element : node.elements)
            line(element->first_token);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::FunctionDeclaration& node) {
        spaced_colon_before(node.result_type);
        return organization_unit(node);
    }
    ast::Walk visit(const ast::FunctionBlockDeclaration& node) { return organization_unit(node); }
    ast::Walk visit(const ast::ProgramDeclaration& node) { return organization_unit(node); }
    ast::Walk visit(const ast::DataTypeDeclaration& node) {
        at(node.first_token).blank_before = true;
        return block(node, node.declarations);
    }

    // ---- types (B.1.3) -------------------------------------------------------------------------

    ast::Walk visit(const ast::TypeDeclaration& node) {
        return declaration(node, node.specification, node.initial_value);
    }
    ast::Walk visit(const ast::StructureDeclaration& node) { return block(node, node.elements); }
    ast::Walk visit(const ast::StructureElementDeclaration& node) {
        return declaration(node, node.specification, node.initial_value);
    }
    ast::Walk visit(const ast::EnumeratedSpecification& node) {
        if (!node.values.empty())
            open_list(node.values.front()->first_token);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::StringSpecification& node) {
        return no_space(node.first_token + 1); // STRING[20]
    }
    ast::Walk visit(const ast::ArrayInitialization& node) {
        return open_list(node.first_token + 1);
    }
    ast::Walk visit(const ast::ArrayInitialElements& node) {
        return no_space(node.count->end_token); // 3(0)
    }
    ast::Walk visit(const ast::StructureInitialization& node) {
        return open_list(node.first_token + 1);
    }
    ast::Walk visit(const ast::StructureElementInitialization& node) {
        return argument(node, node.name->end_token);
    }

    // ---- variables (B.1.4) ---------------------------------------------------------------------

    ast::Walk visit(const ast::VariableDeclarations& node) {
        return block(node, node.declarations);
    }
    ast::Walk visit(const ast::Location& node) { return cell(node.first_token, Cell::location); }
    ast::Walk visit(const ast::VariableDeclaration& node) {
        return declaration(node, node.specification, node.initial_value);
    }
    ast::Walk visit(const ast::AccessDeclaration& node) {
        declaration(node, node.path, nullptr);
        return cell(spaced_colon_before(node.specification), Cell::value);
    }
    ast::Walk visit(const ast::InstanceSpecificInit& node) {
        return declaration(node, node.specification, node.initial_value);
    }
    ast::Walk visit(const ast::ArrayVariable& node) {
        return no_space(node.subscripted_variable->end_token); // a[1]
    }

    // ---- expressions (B.3.1) -------------------------------------------------------------------

    ast::Walk visit(const ast::BinaryExpression& node) {
        if (node.right->first_token > node.left->end_token)
            can_break(operator_before(node.right), rank_of(node.op));
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::UnaryExpression& node) {
        // `- 5` is an operation, and `-5` a constant.
        const bool constant = ast::is<ast::Constant>(node.operand->kind);
        if (node.op != ast::UnaryOperator::logical_not && !constant)
            no_space(node.operand->first_token);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::FunctionCall& node) {
        return call(node.function->end_token, node.end_token);
    }
    ast::Walk visit(const ast::InputArgument& node) {
        if (const auto* list = ast::as<ast::InstructionList>(node.value))
            indent(list->first_token, list->end_token, operand_column);
        return node.name != nullptr ? argument(node, node.name->end_token) : ast::Walk::into;
    }
    ast::Walk visit(const ast::OutputArgument& node) {
        return argument(node, node.name->end_token);
    }

    // ---- statements (B.3.2) --------------------------------------------------------------------

    ast::Walk visit(const ast::StatementList& node) {
        for (const ast::Statement* statement : node.statements)
            line(statement->first_token);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::FbInvocation& node) {
        return call(node.fb_name->end_token, node.end_token);
    }
    ast::Walk visit(const ast::IfStatement& node) {
        indent(node.then_list);
        return indent(node.else_list);
    }
    ast::Walk visit(const ast::ElsifClause& node) { return indent(node.statements); }
    ast::Walk visit(const ast::CaseStatement& node) {
        if (!node.elements.empty())
            indent(node.elements.front()->first_token, node.elements.back()->end_token, width_);
        return indent(node.else_list);
    }
    ast::Walk visit(const ast::CaseElement& node) {
        line(node.first_token);
        const ast::List<ast::Statement>& statements = node.statements->statements;
        if (statements.size() == 1 && stays_behind_label(*statements.front())) {
            at(node.first_token).row = true;
            cell(statements.front()->first_token, Cell::value);
            stay_on_line(statements.front()->first_token);
        }
        return indent(node.statements);
    }
    ast::Walk visit(const ast::ForStatement& node) { return indent(node.statements); }
    ast::Walk visit(const ast::WhileStatement& node) { return indent(node.statements); }
    ast::Walk visit(const ast::RepeatStatement& node) { return indent(node.statements); }
    ast::Walk visit(const ast::ContinueStatement& node) { return word(node.first_token); }

    // ---- sequential function charts (B.1.6) ----------------------------------------------------

    ast::Walk visit(const ast::SfcNetwork& node) {
        for (const ast::Node* element : node.elements)
            line(element->first_token);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::Step& node) { return block(node, node.actions); }
    ast::Walk visit(const ast::ActionAssociation& node) {
        return no_space(node.action_name->end_token);
    }
    ast::Walk visit(const ast::ActionQualifier& node) { return word(node.first_token); }
    ast::Walk visit(const ast::Transition& node) {
        if (node.priority != nullptr && node.priority->first_token >= node.first_token + 2)
            word(node.priority->first_token - 2);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::TransitionCondition& node) {
        space(node.first_token);
        if (ast::as<ast::InstructionList>(node.condition) != nullptr)
            indent(node.condition);
        else
            can_break(node.first_token, 0);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::Action& node) { return indent(node.body); }

    // ---- configurations (B.1.7) ----------------------------------------------------------------

    ast::Walk visit(const ast::ConfigurationDeclaration& node) {
        at(node.first_token).blank_before = true;
        return block(node, node.elements);
    }
    ast::Walk visit(const ast::ResourceDeclaration& node) { return block(node, node.elements); }
    ast::Walk visit(const ast::TaskInitialization& node) {
        return word(node.name->first_token); // SINGLE, INTERVAL, PRIORITY
    }
    ast::Walk visit(const ast::ProgramConfiguration& node) {
        spaced_colon_before(node.type);
        if (!node.elements.empty()) {
            can_break(node.elements.front()->first_token - 1, 0);
            open_list(node.elements.front()->first_token);
        }
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::FbTask& node) { return argument(node, node.end_token); }
    ast::Walk visit(const ast::ProgCnxn& node) { return argument(node, node.variable->end_token); }

    // ---- Instruction List (B.2) ----------------------------------------------------------------

    ast::Walk visit(const ast::InstructionList& node) {
        if (node.first_token == node.end_token || at(node.first_token).in_instructions)
            return ast::Walk::into;
        for (std::uint32_t i = node.first_token; i < node.end_token; ++i)
            at(i).in_instructions = true;
        return indent(&node);
    }
    ast::Walk visit(const ast::IlInstruction& node) {
        if (node.label == nullptr)
            return ast::Walk::into;
        indent(node.label->first_token, node.label->end_token + 1, -2 * width_);
        if (node.operation != nullptr)
            stop(node.operation->first_token, 0);
        return ast::Walk::into;
    }
    ast::Walk visit(const ast::IlSimpleOperation& node) {
        if (!node.operands.empty())
            stop(node.operands.front()->first_token, operand_column);
        return node.function_name == nullptr ? il_operator(node) : ast::Walk::into;
    }
    ast::Walk visit(const ast::IlExpression& node) {
        const std::uint32_t open = il_operator_end(node.first_token, node.end_token);
        no_space(open);
        if (node.operand != nullptr)
            stop(node.operand->first_token, operand_column);
        return il_operator(node);
    }
    ast::Walk visit(const ast::IlJumpOperation& node) {
        stop(node.label->first_token, operand_column);
        return il_operator(node);
    }
    ast::Walk visit(const ast::IlReturnOperation& node) { return il_operator(node); }
    ast::Walk visit(const ast::IlFbCall& node) {
        stop(node.fb_name->first_token, operand_column);
        il_operator(node);
        return il_call(node.fb_name->end_token, node.end_token);
    }
    ast::Walk visit(const ast::IlFormalFunctCall& node) {
        return il_call(node.function_name->end_token, node.end_token);
    }

private:
    // ---- in which words the rules are told -----------------------------------------------------

    // A node may stand for nothing, even at the end of the unit.
    TokenLayout& at(std::uint32_t token) { return token < rows_.size() ? rows_[token] : nowhere_; }
    [[nodiscard]] TokenKind kind(std::uint32_t token) const {
        return token < tokens_.size() ? tokens_[token].kind() : TokenKind::end_of_unit;
    }

    ast::Walk line(std::uint32_t token) {
        at(token).begins_line = !at(token).stays_on_line;
        return ast::Walk::into;
    }
    ast::Walk stay_on_line(std::uint32_t token) {
        at(token).stays_on_line = true;
        return space(token);
    }
    ast::Walk space(std::uint32_t token) {
        at(token).space = true;
        return ast::Walk::into;
    }
    ast::Walk cell(std::uint32_t token, Cell cell) {
        at(token).cell = cell;
        return ast::Walk::into;
    }
    ast::Walk no_space(std::uint32_t token) {
        at(token).space = false;
        return ast::Walk::into;
    }
    // Where a word belongs another token can stand, of which the case may matter.
    ast::Walk word(std::uint32_t token) {
        at(token).word = kind(token) == TokenKind::identifier || is_keyword(kind(token));
        return ast::Walk::into;
    }
    // A keyword where it is a name (an extension) is spelt as a name is.
    ast::Walk name(const ast::Node& node) {
        if (node.first_token < node.end_token && is_keyword(kind(node.first_token)))
            at(node.first_token).word = false;
        return ast::Walk::into;
    }
    ast::Walk can_break(std::uint32_t token, std::uint8_t rank) {
        at(token).may_break = true;
        at(token).rank = rank;
        return ast::Walk::into;
    }
    // A list can be broken behind its parenthesis, and is broken there when the user did.
    ast::Walk open_list(std::uint32_t first) { return can_break(first, 0); }
    ast::Walk stop(std::uint32_t token, std::int32_t column) {
        at(token).stop = static_cast<std::int8_t>(column);
        return ast::Walk::into;
    }

    ast::Walk indent(std::uint32_t first, std::uint32_t end, std::int32_t columns) {
        if (first < end) {
            at(first).level += columns;
            at(end).level -= columns;
        }
        return ast::Walk::into;
    }
    ast::Walk indent(const ast::Node* node) {
        return node != nullptr ? indent(node->first_token, node->end_token, width_)
                               : ast::Walk::into;
    }

    // Where the closing word stands, or would.
    [[nodiscard]] std::uint32_t end_of_contents(const ast::Node& node) const {
        const bool closed =
            node.first_token < node.end_token && closes_block(kind(node.end_token - 1));
        return closed ? node.end_token - 1 : node.end_token;
    }
    // `first` and all behind it up to the closing word, a level further right.
    ast::Walk contents(const ast::Node& node, std::uint32_t first) {
        line(first);
        return indent(first, end_of_contents(node), width_);
    }
    template<class T>
    ast::Walk block(const ast::Node& node, const ast::List<T>& parts) {
        for (const ast::Node* part : parts)
            line(part->first_token);
        return parts.empty() ? ast::Walk::into : contents(node, parts.front()->first_token);
    }
    template<class PouDeclaration>
    ast::Walk organization_unit(const PouDeclaration& node) {
        at(node.first_token).blank_before = true;
        for (const ast::VariableDeclarations* declarations : node.declarations)
            line(declarations->first_token);
        line(node.body->first_token);
        return contents(node, node.declarations.empty() ? node.body->first_token
                                                        : node.declarations.front()->first_token);
    }

    // `name : type := value`, aligned with those above and below.
    ast::Walk declaration(const ast::Node& node, const ast::Node* specification,
                          const ast::Node* value) {
        at(node.first_token).row = true;
        cell(spaced_colon_before(specification), Cell::colon);
        if (value != nullptr && value->first_token > node.first_token &&
            kind(value->first_token - 1) == TokenKind::assign) {
            cell(value->first_token - 1, Cell::value);
            can_break(value->first_token - 1, 0);
        }
        return ast::Walk::into;
    }
    // The number of the colon; of the type when there is no colon.
    std::uint32_t spaced_colon_before(const ast::Node* node) {
        if (node == nullptr || node->first_token == 0 ||
            kind(node->first_token - 1) != TokenKind::colon)
            return static_cast<std::uint32_t>(tokens_.size());
        space(node->first_token - 1);
        return node->first_token - 1;
    }

    // `name(` and arguments, up to the token before `end`.
    ast::Walk call(std::uint32_t open, std::uint32_t end) {
        no_space(open);
        if (open + 2 < end)
            open_list(open + 1);
        return ast::Walk::into;
    }
    // `name := value` or `name => variable`, in a list of them.
    ast::Walk argument(const ast::Node& node, std::uint32_t sign) {
        at(node.first_token).row = true;
        if (kind(sign) == TokenKind::assign || kind(sign) == TokenKind::output_arrow)
            cell(sign, Cell::value);
        return ast::Walk::into;
    }

    // A statement that the user has put behind a case label can stay there, when it is a short one.
    [[nodiscard]] bool stays_behind_label(const ast::Statement& statement) const {
        switch (statement.kind) {
        case ast::NodeKind::empty_statement:
        case ast::NodeKind::assignment_statement:
        case ast::NodeKind::fb_invocation:
        case ast::NodeKind::return_statement:
        case ast::NodeKind::exit_statement:
        case ast::NodeKind::continue_statement:
        case ast::NodeKind::expression_statement:
            return statement.first_token < tokens_.size() &&
                   !tokens_[statement.first_token].first_on_line();
        default: return false;
        }
    }

    // The operator stands directly before its right operand.
    [[nodiscard]] static std::uint32_t operator_before(const ast::Expression* right) {
        return right->first_token - 1;
    }

    // `ANDN` is one token, `&N` two that adjoin.
    [[nodiscard]] std::uint32_t il_operator_end(std::uint32_t first, std::uint32_t end) const {
        const bool split = kind(first) == TokenKind::ampersand && first + 1 < end &&
                           tokens_[first].end() == tokens_[first + 1].offset() &&
                           kind(first + 1) == TokenKind::identifier;
        return first + (split ? 2 : 1);
    }
    ast::Walk il_operator(const ast::Node& node) {
        const std::uint32_t end = il_operator_end(node.first_token, node.end_token);
        for (std::uint32_t i = node.first_token; i < end; ++i)
            word(i);
        if (end == node.first_token + 2)
            no_space(node.first_token + 1);
        return ast::Walk::into;
    }
    // The arguments stand on lines of their own, with the parenthesis that closes them.
    ast::Walk il_call(std::uint32_t open, std::uint32_t end) {
        no_space(open);
        return indent(open + 1, end, operand_column);
    }

    std::span<const Token> tokens_;
    std::int32_t width_;
    std::vector<TokenLayout> rows_;
    TokenLayout nowhere_;
};

} // namespace

std::vector<TokenLayout> lay_out(const Unit& unit, std::uint32_t indent_width) {
    Rules rules(unit, indent_width);
    rules.traverse(unit.root());
    return std::move(rules).finish();
}

} // namespace iecfront::layout
