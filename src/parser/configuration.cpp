#include "parser/misspelling.hpp"
#include "parser/parser.hpp"

#include <iecfront/lexer/name.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace iecfront {
namespace {

constexpr TokenSet element_words =
    block_openers | TokenSet{TokenKind::kw_resource,          TokenKind::kw_task,
                             TokenKind::kw_program,           TokenKind::kw_end_resource,
                             TokenKind::kw_end_configuration, TokenKind::end_of_unit};

/// The parts of a configuration or resource in the order of B.1.7.
enum class Part : std::uint8_t { globals, resource, task, program, access, config };

constexpr std::array<std::string_view, 6> part_names{"VAR_GLOBAL", "RESOURCE",   "TASK",
                                                     "PROGRAM",    "VAR_ACCESS", "VAR_CONFIG"};

std::optional<Part> part_of(const ast::Node& node) noexcept {
    if (const auto* block = ast::as<ast::VariableDeclarations>(&node)) {
        switch (block->block) {
        case ast::VariableBlock::var_global: return Part::globals;
        case ast::VariableBlock::var_access: return Part::access;
        case ast::VariableBlock::var_config: return Part::config;
        default: return std::nullopt;
        }
    }
    switch (node.kind) {
    case ast::NodeKind::resource_declaration: return Part::resource;
    case ast::NodeKind::task_configuration: return Part::task;
    case ast::NodeKind::program_configuration: return Part::program;
    default: return std::nullopt;
    }
}

constexpr std::array<std::string_view, 3> task_words{"SINGLE", "INTERVAL", "PRIORITY"};

std::string part_name(Part part) {
    return std::string(part_names[static_cast<std::size_t>(part)]);
}

/// What a path of names is made of.
struct PathForm {
    std::uint32_t names = 1;
    bool subscripts = false;
    bool begins_with_member = false; ///< the first name and another one
    bool call = false;
};

PathForm form_of(const ast::Expression& path) noexcept {
    PathForm form;
    const ast::Expression* part = &path;
    for (;;) {
        if (const auto* field = ast::as<ast::StructuredVariable>(part)) {
            part = field->record_variable;
            form.begins_with_member = true;
            ++form.names;
        } else if (const auto* element = ast::as<ast::ArrayVariable>(part)) {
            part = element->subscripted_variable;
            form.begins_with_member = false;
            form.subscripts = true;
        } else if (const auto* target = ast::as<ast::DereferencedVariable>(part)) {
            part = target->reference;
        } else {
            form.call = part->kind == ast::NodeKind::function_call;
            return form;
        }
    }
}

} // namespace

// ---- configurations and resources ---------------------------------------------------------------

// configuration_declaration = "CONFIGURATION" configuration_name
//                             [ global_var_declarations ]
//                             ( single_resource_declaration
//                             | ( resource_declaration { resource_declaration } ) )
//                             [ access_declarations ]
//                             [ instance_specific_initializations ]
//                             "END_CONFIGURATION" ;
const ast::ConfigurationDeclaration* Parser::parse_configuration_declaration() {
    auto* node = make<ast::ConfigurationDeclaration>();
    place_ = Place::configuration;
    open_block(TokenKind::kw_end_configuration, advance());
    node->name = parse_configuration_name();
    accept_extra_semicolon();
    node->elements = parse_configuration_elements(place_);
    close_block("");
    check_configuration_order(node->elements.children(), node->first_token, place_);
    return finish(node);
}

// configuration_name = identifier ;
/// A keyword before the first element is the name, which would be missing otherwise.
const ast::Identifier* Parser::parse_configuration_name() {
    static constexpr TokenSet elements =
        block_openers | TokenSet{TokenKind::kw_resource, TokenKind::kw_task, TokenKind::kw_program};
    const bool keyword = is_keyword(kind()) && !at(block_openers) && elements.contains(peek());
    return keyword ? take_reserved_word() : parse_declared_name("the name of a configuration");
}

// resource_declaration = "RESOURCE" resource_name "ON" resource_type_name
//                        [ global_var_declarations ]
//                        single_resource_declaration
//                        "END_RESOURCE" ;
// resource_name = identifier ;
// resource_type_name = identifier ;
const ast::ResourceDeclaration* Parser::parse_resource_declaration() {
    auto* node = make<ast::ResourceDeclaration>();
    open_block(TokenKind::kw_end_resource, at_);
    if (at_resource_without_word()) {
        change_unclosed(TokenKind::kw_end_resource, 1);
        report_missing(DiagnosticId::missing_token, {"`RESOURCE`"})
            .insert(token().offset(), "RESOURCE ");
    } else {
        advance();
    }
    node->name = parse_declared_name("the name of a resource");
    if (!at(TokenKind::kw_on) && !at(TokenKind::identifier)) {
        report_missing(DiagnosticId::missing_token, {"`ON` with a resource type"});
        node->type = make_missing<ast::Identifier>();
    } else {
        expect(TokenKind::kw_on);
        node->type = at(element_words) ? make_missing_identifier("the name of a resource type")
                                       : parse_name("the name of a resource type");
    }
    accept_extra_semicolon();
    node->elements = parse_configuration_elements(Place::resource);
    close_block("");
    check_configuration_order(node->elements.children(), node->first_token, Place::resource);
    finish(node);
    accept_extra_semicolon();
    return node;
}

/// At `cpu ON plc` without RESOURCE: an END_RESOURCE closes nothing otherwise.
bool Parser::at_resource_without_word() {
    return at(TokenKind::identifier) && peek() == TokenKind::kw_on &&
           peek_second() == TokenKind::identifier && unclosed(TokenKind::kw_end_resource) < 0;
}

// single_resource_declaration = { task_configuration ";" }
//                               program_configuration ";" { program_configuration ";" } ;
Parser::Children<ast::Node> Parser::parse_configuration_elements(Place place) {
    ListBuilder<ast::Node> elements(*this);
    while (!at_end_of_configuration_elements(place))
        add_in_loop(elements, [&] { return parse_configuration_element(place); });
    return elements.finish();
}

bool Parser::at_end_of_configuration_elements(Place place) {
    if (at(TokenKind::end_of_unit) || at_library_element_closer() || at_misspelt_closer() ||
        at_foreign_closer() || at_unknown_closer_for_innermost())
        return true;
    if (at(TokenKind::kw_end_resource)) // it can stand for END_CONFIGURATION at the very end
        return place == Place::resource ||
               (unclosed(TokenKind::kw_end_configuration) > 0 && peek() == TokenKind::end_of_unit);
    if (place != Place::resource)
        return false;
    return misspelt_configuration_word() == TokenKind::kw_resource ||
           ((at(TokenKind::kw_var_access) || at(TokenKind::kw_var_config)) &&
            unclosed(TokenKind::kw_end_resource) > 0);
}

/// `END_TASK`, which no edition has.
bool Parser::at_unknown_closer() const noexcept {
    return at(TokenKind::identifier) && names_equal(text(at_).substr(0, 4), "END_") &&
           (peek() == TokenKind::semicolon || tokens_[next(at_)].first_on_line());
}

/// Such a word where the closing word of the resource or configuration is missing.
bool Parser::at_unknown_closer_for_innermost() {
    static constexpr TokenSet of_parts{TokenKind::kw_end_resource, TokenKind::kw_end_configuration};
    return at_unknown_closer() && of_parts.contains(open_.back().closer) &&
           unclosed(open_.back().closer) > 0;
}

/// Part of configuration_declaration, resource_declaration: one of what they hold, in any order.
const ast::Node* Parser::parse_configuration_element(Place place) {
    if (at(block_openers) || at_declarations_without_opener())
        return parse_variable_declarations(place);
    if (at_resource_without_word())
        return parse_resource_declaration();
    const TokenKind meant = misspelt_configuration_word();
    if (at(TokenKind::identifier) && meant != TokenKind::end_of_unit) {
        const std::string word(spelling(meant));
        report_at(at_, DiagnosticId::misspelt_word, {text(at_), word})
            .replace(token().range(), word);
    }
    switch (meant) {
    case TokenKind::kw_resource:
        change_unclosed(TokenKind::kw_end_resource, at(TokenKind::identifier) ? 1 : 0);
        return parse_resource_declaration();
    case TokenKind::kw_task: {
        const auto* task = parse_task_configuration();
        expect_semicolon_of_configuration();
        return task;
    }
    case TokenKind::kw_program: {
        const auto* program = parse_program_configuration();
        expect_semicolon_of_configuration();
        return program;
    }
    default: break;
    }
    auto* skipped = make<ast::SkippedText>();
    if (at(TokenKind::kw_end_resource) || at_unknown_closer()) {
        Report stray = report_at(at_, DiagnosticId::stray_closing_word, {text(at_)});
        advance();
        accept(TokenKind::semicolon);
        finish(skipped);
        stray.remove(token_range(skipped->first_token, skipped->end_token));
        return skipped;
    }
    report_at(at_, DiagnosticId::not_a_declaration,
              {"RESOURCE, TASK, PROGRAM or a declaration block", describe(at_)});
    advance();
    while (!at(element_words) && !accept(TokenKind::semicolon) && !at_library_element_closer())
        advance();
    return finish(skipped);
}

/// The word at the cursor that begins a resource, task or program, also a misspelt one; end_of_unit
/// when it is none.
TokenKind Parser::misspelt_configuration_word() const noexcept {
    if (at(element_words))
        return kind();
    const bool qualified = peek() == TokenKind::kw_retain || peek() == TokenKind::kw_non_retain;
    if (!at(TokenKind::identifier) || (!qualified && peek() != TokenKind::identifier))
        return TokenKind::end_of_unit;
    switch (qualified ? TokenKind::kw_with : peek_second()) {
    case TokenKind::kw_on:
        return is_misspelling(text(at_), "RESOURCE") ? TokenKind::kw_resource
                                                     : TokenKind::end_of_unit;
    case TokenKind::left_parenthesis:
        return is_misspelling(text(at_), "TASK") ? TokenKind::kw_task : TokenKind::end_of_unit;
    case TokenKind::colon:
    case TokenKind::kw_with:
        return is_misspelling(text(at_), "PROGRAM") ? TokenKind::kw_program
                                                    : TokenKind::end_of_unit;
    default: return TokenKind::end_of_unit;
    }
}

void Parser::expect_semicolon_of_configuration() {
    if (accept_semicolon())
        return;
    if (at(element_words) || token().first_on_line() || at_library_element_closer()) {
        report_missing_semicolon();
        return;
    }
    report_unexpected("`;`");
    while (!at(element_words) && !at(TokenKind::semicolon) && !at_library_element_closer())
        skip_balanced();
    accept(TokenKind::semicolon);
}

/// The order of the parts, that there is a program, and that resources and the contents of a single
/// one do not stand side by side. When the closing word is missing, parts may be missing with it.
void Parser::check_configuration_order(Children<ast::Node> elements, std::uint32_t head,
                                       Place place) {
    const bool unclosed = std::exchange(closer_assumed_, false);
    std::optional<Part> last;
    std::array<const ast::Node*, part_names.size()> first{};
    bool resources = false;
    bool programs = false;
    bool skipped = false;
    for (const ast::Node* element : elements) {
        const std::optional<Part> part = part_of(*element);
        skipped = skipped || !part;
        if (!part)
            continue;
        const bool single = *part == Part::task || *part == Part::program;
        if ((single && resources) || (*part == Part::resource && programs))
            report_at(element->first_token, DiagnosticId::programs_beside_resources);
        else if (last && *part < *last)
            report_at(element->first_token, DiagnosticId::configuration_order,
                      {part_name(*part), part_name(*last)});
        const ast::Node*& before = first[static_cast<std::size_t>(*part)];
        if (before != nullptr && *part == Part::globals)
            report_at(element->first_token, DiagnosticId::several_global_blocks,
                      {place == Place::resource ? "resource" : "configuration"})
                .label(LabelId::first_given, before->first_token);
        if (before != nullptr && (*part == Part::access || *part == Part::config))
            report_at(element->first_token, DiagnosticId::repeated_part, {part_name(*part)})
                .label(LabelId::first_given, before->first_token);
        else if (before == nullptr)
            before = element;
        resources = resources || *part == Part::resource;
        programs = programs || *part == Part::program;
        last = part;
    }
    if (resources || programs || skipped || unclosed)
        return;
    report(DiagnosticId::configuration_without_program, tokens_[head].range(),
           {place == Place::resource ? "a resource" : "a configuration",
            place == Place::resource ? "PROGRAM" : "RESOURCE or PROGRAM"});
}

// ---- tasks --------------------------------------------------------------------------------------

// task_configuration = "TASK" task_name task_initialization ;
// task_name = identifier ;
const ast::TaskConfiguration* Parser::parse_task_configuration() {
    auto* node = make<ast::TaskConfiguration>();
    const std::size_t reports = diagnostics_.size();
    advance();
    node->name = parse_declared_name("the name of a task");
    if (at_next_declaration()) {
        report_unfinished(DiagnosticId::missing_token, {"`(` with a priority"});
        return finish(node);
    }
    std::optional<Report> missing;
    if (task_word(at_) < task_words.size() && peek() == TokenKind::assign)
        missing.emplace(
            report_missing(DiagnosticId::missing_token, {"`(`"}).insert(previous_end(), " ("));
    if (missing || (!at(TokenKind::semicolon) && expect(TokenKind::left_parenthesis))) {
        ListBuilder<ast::TaskInitialization> initializations(*this);
        if (!at(TokenKind::right_parenthesis)) {
            do
                initializations.add(parse_task_initialization());
            while (accept(TokenKind::comma) || accept_missing_comma(true));
        }
        if (missing && !at(TokenKind::right_parenthesis))
            missing->also_insert(previous_end(), ")");
        else
            expect_closing(TokenKind::right_parenthesis);
        node->initializations = initializations.finish();
    }
    finish(node);
    if (diagnostics_.size() == reports) // else a part may have been passed over
        check_task(*node);
    return node;
}

/// Which of the words of a task stands at a token, also misspelt; their number when none does.
std::size_t Parser::task_word(std::uint32_t token) const noexcept {
    std::size_t index = 0;
    while (index < task_words.size() && (tokens_[token].kind() != TokenKind::identifier ||
                                         !is_misspelling(text(token), task_words[index])))
        ++index;
    return index;
}

// task_initialization = "(" [ "SINGLE" ":=" data_source "," ]
//                       [ "INTERVAL" ":=" data_source "," ]
//                       "PRIORITY" ":=" integer ")" ;
/// One of the three parts; the parentheses belong to the task.
const ast::TaskInitialization* Parser::parse_task_initialization() {
    auto* node = make<ast::TaskInitialization>();
    if (at_next_declaration()) {
        node->name = make_missing_identifier("SINGLE, INTERVAL or PRIORITY");
        node->value = make_missing<ast::ErrorExpression>();
        return finish(node);
    }
    const std::size_t word = task_word(at_);
    const bool priority = word == task_words.size() - 1;
    if (word == task_words.size()) {
        report_unexpected("SINGLE, INTERVAL or PRIORITY");
    } else if (!at_word(task_words[word])) {
        const std::string meant(task_words[word]);
        report_at(at_, DiagnosticId::misspelt_word, {text(at_), meant})
            .replace(token().range(), meant);
    }
    node->name = parse_name("SINGLE, INTERVAL or PRIORITY");
    expect_assign();
    node->value = priority ? parse_integer("a priority") : parse_data_source();
    return finish(node);
}

void Parser::check_task(const ast::TaskConfiguration& task) {
    std::array<const ast::TaskInitialization*, task_words.size()> parts{};
    std::size_t expected = 0;
    bool known = true;
    bool priority = false;
    for (const ast::TaskInitialization* part : task.initializations) {
        if (part->name->missing)
            return;
        const std::size_t index = task_word(part->name->first_token);
        known = known && index < task_words.size();
        if (!known)
            continue;
        if (parts[index] != nullptr)
            report_at(part->first_token, DiagnosticId::repeated_part, {task_words[index]})
                .label(LabelId::first_given, parts[index]->first_token);
        else if (index < expected)
            report_at(part->first_token, DiagnosticId::task_initialization_order,
                      {task_words[index], task_words[expected - 1]});
        parts[index] = part;
        expected = std::max(expected, index + 1);
        priority = priority || index + 1 == task_words.size();
    }
    if (known && !priority)
        report(DiagnosticId::task_without_priority,
               token_range(task.name->first_token, task.name->end_token));
}

// data_source = constant | global_var_reference | program_output_reference | direct_variable ;
const ast::Expression* Parser::parse_data_source() {
    const ast::Expression* source = parse_connection_operand("a source", true);
    if (source->kind == ast::NodeKind::enumerated_value)
        report_node(*source, DiagnosticId::unexpected_token,
                    {"a variable or a constant", quoted(source->first_token)});
    return source;
}

// prog_data_source = constant | enumerated_value | global_var_reference | direct_variable ;
const ast::Expression* Parser::parse_prog_data_source() {
    return parse_connection_operand("a source", false);
}

// data_sink = global_var_reference | direct_variable ;
const ast::Expression* Parser::parse_data_sink() {
    const ast::Expression* sink = parse_connection_operand("a sink", false);
    if (ast::is<ast::Constant>(sink->kind) || sink->kind == ast::NodeKind::enumerated_value)
        report_node(*sink, DiagnosticId::unexpected_token, {"a variable after `=>`", "a constant"});
    return sink;
}

/// Part of data_source, prog_data_source, data_sink: what they have in common; expressions are an
/// extension (6.1 D31).
const ast::Expression* Parser::parse_connection_operand(std::string_view what,
                                                        bool program_output) {
    if (at_next_declaration())
        return parse_missing_expression();
    if (at(TokenKind::direct_variable))
        return parse_direct_variable();
    if (at(TokenKind::enumerated_value))
        return parse_enumerated_value();
    if (at(TokenKind::identifier) || (at_operand_keyword() && !at_literal())) {
        const ast::Expression* path = parse_symbolic_variable();
        if (operator_strength(kind()) == 0) {
            check_reference(*path, what, program_output);
            return path;
        }
        const ast::Expression* expression = parse_binary_rest(path, 1);
        report_node(*expression, DiagnosticId::long_reference, {"an expression", what});
        return expression;
    }
    const ast::Expression* value = parse_expression();
    if (!value->missing && !ast::is<ast::Constant>(value->kind) &&
        value->kind != ast::NodeKind::error_expression)
        report_node(*value, DiagnosticId::long_reference, {"an expression", what});
    return value;
}

// symbolic_variable = variable_name | multi_element_variable ;
/// Outside bodies, where EN and ENO are keywords like any other (6.1 D24).
const ast::Expression* Parser::parse_symbolic_variable() {
    if (at(execution_control))
        report_reserved_word(at_);
    return parse_variable();
}

// global_var_reference = [ resource_name "." ] global_var_name [ "." structure_element_name ] ;
// program_output_reference = program_name "." symbolic_variable ;
/// Subscripts and longer paths are an extension otherwise (6.1 D32).
void Parser::check_reference(const ast::Expression& path, std::string_view what,
                             bool program_output) {
    const PathForm form = form_of(path);
    const bool global = !form.subscripts && form.names <= 3;
    if (!form.call && (global || (program_output && form.begins_with_member)))
        return;
    report_node(path, DiagnosticId::long_reference,
                {form.call || form.subscripts
                     ? "a path with subscripts or a call"
                     : "a path of " + std::to_string(form.names) + " names",
                 what});
}

/// A symbolic_variable has no call in it.
void Parser::check_symbolic_variable(const ast::Expression& path) {
    if (form_of(path).call)
        report_node(path, DiagnosticId::unexpected_token, {"a variable", "a call"});
}

// ---- programs -----------------------------------------------------------------------------------

// program_configuration = "PROGRAM" [ "RETAIN" | "NON_RETAIN" ] program_name [ "WITH" task_name ]
//                         ":" program_type_name [ "(" prog_conf_elements ")" ] ;
// program_name = identifier ;
// prog_conf_elements = prog_conf_element { "," prog_conf_element } ;
const ast::ProgramConfiguration* Parser::parse_program_configuration() {
    auto* node = make<ast::ProgramConfiguration>();
    advance();
    if (at(TokenKind::kw_constant))
        report_at(at_, DiagnosticId::qualifier_of_block, {text(at_), "PROGRAM"});
    node->qualifier = parse_block_qualifiers();
    node->name = parse_declared_name("the name of a program");
    if (accept_with())
        node->task = parse_name("the name of a task");
    expect_colon();
    node->type = parse_name("the name of a program type");
    if (accept(TokenKind::left_parenthesis)) {
        ListBuilder<ast::Node> elements(*this);
        do
            elements.add(parse_prog_conf_element());
        while (accept(TokenKind::comma) || accept_missing_comma());
        expect_closing(TokenKind::right_parenthesis);
        node->elements = elements.finish();
    }
    return finish(node);
}

/// WITH, or an ON in its place, as between a resource and its type.
bool Parser::accept_with() {
    if (at(TokenKind::kw_on) && peek() == TokenKind::identifier) {
        accept_as(TokenKind::kw_with);
        return true;
    }
    return accept(TokenKind::kw_with);
}

/// `=>`, also with white space in it.
bool Parser::accept_output_arrow() {
    if (!at(TokenKind::equal) || peek() != TokenKind::greater)
        return accept(TokenKind::output_arrow);
    const TextRange gap{token().end(), tokens_[next(at_)].offset()};
    report(DiagnosticId::white_space_in_delimiter, gap, {"=>"}).replace(gap, {});
    advance();
    advance();
    return true;
}

// prog_conf_element = fb_task | prog_cnxn ;
// fb_task = fb_name "WITH" task_name ;
// prog_cnxn = symbolic_variable ":=" prog_data_source | symbolic_variable "=>" data_sink ;
const ast::Node* Parser::parse_prog_conf_element() {
    const std::uint32_t first = at_;
    const bool begins =
        (at(TokenKind::identifier) || at_operand_keyword()) && !at_next_declaration();
    const ast::Expression* variable =
        begins ? parse_symbolic_variable() : parse_missing_expression();
    if (accept_with()) {
        auto* task = make<ast::FbTask>();
        task->first_token = first;
        task->fb_name = variable;
        if (variable->kind != ast::NodeKind::variable_name)
            report_node(*variable, DiagnosticId::long_reference,
                        {"a nested instance", "the instance of a task"});
        task->task = parse_name("the name of a task");
        return finish(task);
    }
    auto* connection = make<ast::ProgCnxn>();
    connection->first_token = variable->missing ? variable->first_token : first;
    connection->variable = variable;
    connection->output = accept_output_arrow();
    check_symbolic_variable(*variable);
    static constexpr TokenSet behind_element{TokenKind::comma, TokenKind::right_parenthesis};
    if (at(behind_element))
        report_missing(DiagnosticId::missing_token, {"`:=` with a source, `=>` with a sink,"});
    else if (!connection->output && !at_next_declaration())
        expect_assign();
    connection->operand = connection->output ? parse_data_sink() : parse_prog_data_source();
    return finish(connection);
}

// ---- access paths and instance-specific initial values ------------------------------------------

// access_declaration = access_name ":" access_path ":" non_generic_type_name [ direction ] ;
// program_access_decl = access_name ":" symbolic_variable ":" non_generic_type_name [ direction ] ;
// direction = "READ_WRITE" | "READ_ONLY" ;
// access_name = identifier ;
const ast::AccessDeclaration* Parser::parse_access_declaration(Place place) {
    auto* node = make<ast::AccessDeclaration>();
    node->name = parse_declared_name("the name of an access path");
    expect_colon();
    node->path = parse_access_path(place);
    expect_colon();
    node->specification = parse_type_specification();
    check_element_type_of_access(*node->specification);
    const auto accept_direction = [this](TokenKind word) {
        return accept(word) || accept_misspelt_word(word);
    };
    if (accept_direction(TokenKind::kw_read_only))
        node->direction = ast::Direction::read_only;
    else if (accept_direction(TokenKind::kw_read_write))
        node->direction = ast::Direction::read_write;
    finish(node);
    expect_semicolon_of_declaration();
    return node;
}

void Parser::check_element_type_of_access(const ast::TypeSpecification& type) {
    switch (type.kind) {
    case ast::NodeKind::elementary_type_name:
    case ast::NodeKind::derived_type_name:
    case ast::NodeKind::error_type: return;
    default:
        report_node(type, DiagnosticId::long_reference,
                    {"a type written out", "the type of an access path"});
    }
}

// access_path = [ resource_name "." ] direct_variable
//             | [ resource_name "." ] [ program_name "." ] { fb_name "." } symbolic_variable ;
const ast::Expression* Parser::parse_access_path(Place place) {
    if (at(TokenKind::direct_variable)) {
        if (place == Place::program)
            report_unexpected("a variable of the program");
        return parse_direct_variable();
    }
    if (!at(TokenKind::identifier) && !at_operand_keyword())
        return parse_missing_expression();
    if (at(TokenKind::identifier) && peek() == TokenKind::dot &&
        peek_second() == TokenKind::direct_variable)
        return parse_direct_variable_of_resource(place);
    const ast::Expression* path = parse_symbolic_variable();
    check_symbolic_variable(*path);
    return path;
}

// Part of access_path: [ resource_name "." ] direct_variable
const ast::Expression* Parser::parse_direct_variable_of_resource(Place place) {
    const ast::Expression* resource = parse_variable_name();
    auto* node = make_from<ast::StructuredVariable>(resource);
    advance();
    if (place == Place::program)
        report_unexpected("a variable of the program");
    node->record_variable = resource;
    node->field_selector = parse_direct_variable();
    return finish(node);
}

// instance_specific_init = resource_name "." program_name "." { fb_name "." }
//     ( ( variable_name [ location ] ":" located_var_spec_init )
//     | ( fb_name ":" function_block_type_name ":=" structure_initialization ) ) ;
const ast::InstanceSpecificInit* Parser::parse_instance_specific_init() {
    auto* node = make<ast::InstanceSpecificInit>();
    ListBuilder<ast::Identifier> path(*this);
    do
        path.add(parse_name("the path of a variable"));
    while (accept(TokenKind::dot));
    node->path = path.finish();
    if (node->path.size() < 3 && !node->path.back()->missing)
        report(DiagnosticId::incomplete_access_path,
               token_range(node->path.front()->first_token, node->path.back()->end_token),
               {"the path `resource.program.variable`"});
    node->location = parse_optional_location();
    expect_colon();
    node->specification = parse_type_specification();
    if (at(TokenKind::kw_at) && node->path.back()->missing)
        parse_optional_location(); // what it should stand behind is not there
    else if (at(TokenKind::kw_at) && node->location == nullptr)
        parse_location_behind_type(node->first_token, node->path.back()->end_token);
    node->initial_value = parse_optional_initial_value();
    check_initial_value(*node->specification, node->initial_value);
    finish(node);
    if (node->location != nullptr && at_incomplete(*node->location))
        report_node(*node->location, DiagnosticId::incomplete_location);
    expect_semicolon_of_declaration();
    return node;
}

bool Parser::at_incomplete(const ast::Location& location) const noexcept {
    return tokens_[location.end_token - 1].kind() == TokenKind::incomplete_location;
}

} // namespace iecfront
