// The code of docs/embedding.md.
#include <iecfront/iecfront.hpp>

#include <cstdio>
#include <functional>
#include <future>
#include <gtest/gtest.h>

namespace {

const std::string example = "(* counts *)\n"
                            "FUNCTION_BLOCK Counter\n"
                            "VAR_INPUT final : INT := 16#10; END_VAR\n"
                            "VAR count : INT; END_VAR\n"
                            "    FOR count := 0 TO final DO\n"
                            "        ;\n"
                            "    END_FOR\n"
                            "    count := final;\n"
                            "END_FUNCTION_BLOCK\n";

TEST(Embedding, Parse) {
    iecfront::SourceText source(example, "counter.st");
    iecfront::SyntaxTree tree = iecfront::parse(source);
    for (const iecfront::SyntaxTree::Slot& slot : tree.slots()) {
        const iecfront::Unit& unit = *slot.unit;
        std::printf("%zu tokens, %zu comments and pragmas, %zu findings\n", unit.tokens().size(),
                    unit.trivia().size(), unit.diagnostics().size());
    }

    EXPECT_EQ(tree.slots().size(), 1U);
    EXPECT_EQ(tree.diagnostics().size(), 1U); // no `;` behind END_FOR
}

namespace build = iecfront::build;

TEST(Embedding, Build) {
    build::Expression next =
        build::binary_expression(iecfront::ast::BinaryOperator::add, build::variable_name("count"),
                                 build::integer_literal(1));
    build::Statement step = build::assignment_statement(build::variable_name("count"), next);
    build::Statement loop =
        build::while_statement(build::variable_name("running"), build::statement_list({step}));

    EXPECT_EQ(loop.text(), "WHILE running DO\n    count := count + 1;\nEND_WHILE");

    std::optional<iecfront::SyntaxTree> tree = build::library(
        {build::function_declaration(
            "Twice", build::elementary_type_name("INT"),
            {build::variable_declarations(
                iecfront::ast::VariableBlock::var_input,
                {build::variable_declaration({"x"}, build::elementary_type_name("INT"))})},
            build::statement_list({build::assignment_statement(
                build::variable_name("Twice"),
                build::binary_expression(iecfront::ast::BinaryOperator::multiply,
                                         build::integer_literal(2), build::variable_name("x")))}))},
        "twice.st");

    EXPECT_TRUE(tree && tree->diagnostics().empty());
}

TEST(Embedding, Change) {
    iecfront::SyntaxTree before = iecfront::parse(iecfront::SourceText(example));
    const iecfront::SyntaxTree::Slot& slot = before.slots()[0];
    const iecfront::Unit& unit = *slot.unit;
    const auto* loop = before.node_at(before.offset({5, 9})).find<iecfront::ast::ForStatement>();

    build::Changes changes(before);
    changes.replace(slot, *loop->to,
                    build::binary_expression(iecfront::ast::BinaryOperator::subtract,
                                             build::copy(unit, *loop->to),
                                             build::integer_literal(1)));
    changes.append(slot, *loop->statements, build::exit_statement());
    std::optional<iecfront::SyntaxTree> after = changes.tree();

    EXPECT_NE(after->source().bytes().find("TO final - 1 DO\n        EXIT;\n"),
              std::string_view::npos);
}

TEST(Embedding, Keep) {
    std::shared_ptr<const iecfront::Unit> kept;
    const iecfront::ast::LibraryUnit* root = nullptr;
    {
        iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));
        kept = tree.slots()[0].unit;
        root = &kept->root();
    }
    // The tree is gone; the unit lives, and with it the nodes, the tokens and the text.
    std::string_view text = kept->text(*root);

    EXPECT_TRUE(text.starts_with("FUNCTION_BLOCK Counter"));
}

TEST(Embedding, Threads) {
    std::vector<iecfront::SourceText> sources(4, iecfront::SourceText(example));

    std::vector<std::future<iecfront::SyntaxTree>> trees;
    for (const iecfront::SourceText& source : sources)
        trees.push_back(std::async([&source] { return iecfront::parse(source); }));

    for (auto& tree : trees)
        EXPECT_EQ(tree.get(), iecfront::parse(sources[0]));
}

TEST(Embedding, Positions) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));
    const iecfront::SyntaxTree::Slot& slot = tree.slots()[0];
    const iecfront::ast::Node& element = *slot.unit->root().elements.front();

    iecfront::TextRange in_unit = slot.unit->range(element); // bytes from the start of the unit
    iecfront::TextRange in_file = slot.range(element);       // bytes from the start of the file
    iecfront::Position begin = tree.position(in_file.begin); // 1-based, columns in code points
    iecfront::Position for_an_editor =
        tree.position(in_file.begin, iecfront::ColumnUnit::utf16_units);
    std::uint32_t offset = tree.offset({2, 1}); // and back

    EXPECT_EQ(in_unit, in_file);
    EXPECT_EQ(begin, (iecfront::Position{2, 1}));
    EXPECT_EQ(for_an_editor, begin);
    EXPECT_EQ(offset, in_file.begin);
}

// Which variables does a POU declare, and how often does it loop?
class Survey : public iecfront::ast::Visitor<Survey> {
public:
    explicit Survey(const iecfront::Unit& unit) : unit_(unit) {}

    iecfront::ast::Walk visit(const iecfront::ast::VariableDeclaration& declaration) {
        for (const iecfront::ast::Identifier* name : declaration.names)
            names.emplace_back(unit_.text(*name));
        return iecfront::ast::Walk::over; // nothing below is of interest
    }
    iecfront::ast::Walk visit(const iecfront::ast::ForStatement&) {
        ++loops;
        return iecfront::ast::Walk::into;
    }

    std::vector<std::string> names;
    int loops = 0;

private:
    const iecfront::Unit& unit_;
};

TEST(Embedding, Visit) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));

    Survey survey(*tree.slots()[0].unit);
    survey.traverse(tree.slots()[0].unit->root());

    EXPECT_EQ(survey.names, (std::vector<std::string>{"final", "count"}));
    EXPECT_EQ(survey.loops, 1);
}

TEST(Embedding, Walk) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));
    const iecfront::ast::Node& root = tree.slots()[0].unit->root();

    int depth = 0;
    int deepest = 0;
    iecfront::ast::walk(
        root,
        [&](const iecfront::ast::Node&) {
            deepest = std::max(deepest, ++depth);
            return iecfront::ast::Walk::into;
        },
        [&](const iecfront::ast::Node&) { --depth; });

    EXPECT_GT(deepest, 3);
}

TEST(Embedding, Nodes) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));
    const iecfront::Unit& unit = *tree.slots()[0].unit;

    // How often is a variable named?
    int uses = 0;
    for (const iecfront::ast::Node& node : unit.nodes())
        if (const auto* name = iecfront::ast::as<iecfront::ast::VariableName>(&node))
            uses += iecfront::names_equal(unit.text(*name), "final") ? 1 : 0;

    EXPECT_EQ(uses, 2);
}

TEST(Embedding, NodeAt) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));
    std::uint32_t cursor = tree.offset({5, 9});

    iecfront::SyntaxTree::Path path = tree.node_at(cursor); // from the root to the innermost node
    if (const auto* loop = path.find<iecfront::ast::ForStatement>()) {
        const std::string_view variable = path.slot->unit->text(*loop->control_variable);
        std::printf("in the loop over %.*s\n", static_cast<int>(variable.size()), variable.data());
    }

    EXPECT_NE(path.find<iecfront::ast::ForStatement>(), nullptr);

    EXPECT_TRUE(iecfront::ast::is<iecfront::ast::VariableName>(path.nodes.back()->kind));
}

// Which variables does an instruction list write?
class Written : public iecfront::ast::Visitor<Written> {
public:
    explicit Written(const iecfront::Unit& unit) : unit_(unit) {}

    iecfront::ast::Walk visit(const iecfront::ast::IlSimpleOperation& operation) {
        using enum iecfront::ast::IlOperator;
        if (operation.op == store || operation.op == set || operation.op == reset)
            for (const iecfront::ast::Expression* operand : operation.operands)
                names.emplace_back(unit_.text(*operand));
        return iecfront::ast::Walk::over;
    }

    std::vector<std::string> names;

private:
    const iecfront::Unit& unit_;
};

TEST(Embedding, InstructionList) {
    iecfront::SyntaxTree tree =
        iecfront::parse(iecfront::SourceText("PROGRAM p\nVAR a, b : BOOL; END_VAR\n    LD a\n    "
                                             "ANDN b\n    ST a\n    S b\nEND_PROGRAM\n"));
    Written written(*tree.slots()[0].unit);
    written.traverse(tree.slots()[0].unit->root());
    EXPECT_EQ(written.names, (std::vector<std::string>{"a", "b"}));
}

// The value of `16#FF` or `-5`, when it is one that fits.
std::optional<std::int64_t> value_of(const iecfront::Unit& unit,
                                     const iecfront::ast::IntegerLiteral& literal) {
    const std::string_view text = unit.text(unit.tokens()[literal.literal_token]);
    const std::optional<iecfront::IntegerValue> value = iecfront::integer_value(text);
    if (!value || value->overflow)
        return std::nullopt;
    const bool minus = literal.has_sign() && unit.text(literal).front() == '-';
    const bool negative = minus != value->negative;
    if (value->magnitude > std::uint64_t{INT64_MAX} + (negative ? 1 : 0))
        return std::nullopt;
    return static_cast<std::int64_t>(negative ? 0 - value->magnitude : value->magnitude);
}

TEST(Embedding, Literals) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));
    const iecfront::Unit& unit = *tree.slots()[0].unit;
    std::vector<std::int64_t> values;
    iecfront::ast::walk(unit.root(), [&](const iecfront::ast::Node& node) {
        if (const auto* literal = iecfront::ast::as<iecfront::ast::IntegerLiteral>(&node))
            values.push_back(value_of(unit, *literal).value_or(-1));
        return iecfront::ast::Walk::into;
    });
    EXPECT_EQ(values, (std::vector<std::int64_t>{16, 0}));
}

TEST(Embedding, Diagnostics) {
    iecfront::SourceText source(example, "counter.st");
    iecfront::SyntaxTree tree = iecfront::parse(source);
    std::string list;

    iecfront::SeverityPolicy policy; // the software switch of 1.5.1
    for (const iecfront::Diagnostic& found : tree.diagnostics()) {
        if (policy.severity(found.id) == iecfront::Severity::allow)
            continue;
        const iecfront::DiagnosticInfo& info = iecfront::diagnostic_info(found.id);
        const iecfront::Position place = tree.position(found.range.begin);
        list += iecfront::code_string(found.id) + " " + std::string(info.name) + " in line " +
                std::to_string(place.line) + ": " + message(found, tree.encoding()) + "\n";
        for (const iecfront::DiagnosticFix& fix : found.fixes)
            list += "  to do: " + description(fix, source.bytes(), tree.encoding()) + "\n";
    }

    EXPECT_TRUE(list.starts_with("IEC2006 missing-semicolon in line 7: ")) << list;
    EXPECT_NE(list.find("to do: insert `;`"), std::string::npos) << list;
}

TEST(Embedding, Fixes) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));

    std::string text(tree.source().bytes());
    const std::vector<iecfront::Diagnostic> found = tree.diagnostics();
    if (!found.empty() && !found[0].fixes.empty())
        text = iecfront::apply_edits(text, found[0].fixes[0].edits);

    EXPECT_TRUE(iecfront::parse(iecfront::SourceText(text)).diagnostics().empty());
}

TEST(Embedding, Determination) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));

    iecfront::SeverityPolicy policy;
    if (const iecfront::Dialect* dialect = iecfront::find_dialect("iec2-tools"))
        set_dialect(policy, *dialect);
    policy.set(iecfront::DiagnosticClass::implementation_dependent, iecfront::Severity::warning);
    bool known = policy.set("missing-semicolon", iecfront::Severity::warning);
    iecfront::Determination determination = iecfront::determine(tree.diagnostics(), policy);

    EXPECT_TRUE(known);
    EXPECT_EQ(determination, iecfront::Determination::violations);
}

TEST(Embedding, Edits) {
    iecfront::SourceText source(example + example);
    iecfront::SyntaxTree before = iecfront::parse(source);
    auto place = static_cast<std::uint32_t>(source.bytes().find("final"));

    iecfront::SyntaxTree after = before.edited({place, place + 5}, "bound");

    EXPECT_NE(after.slots()[0].unit, before.slots()[0].unit); // touched, and read again
    EXPECT_EQ(after, iecfront::parse(after.source()));
}

TEST(Embedding, EditorQueries) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));
    std::string outline;
    std::vector<std::string> variables;

    for (const iecfront::DocumentSymbol& symbol : iecfront::document_symbols(tree))
        outline += std::string(to_string(symbol.kind)) + ' ' + std::string(symbol.name) + '\n';

    const iecfront::Unit& unit = *tree.slots()[0].unit;
    for (const iecfront::ClassifiedToken& token : iecfront::token_classes(unit))
        if (token.token_class == iecfront::TokenClass::variable)
            variables.emplace_back(unit.text(token.range));

    EXPECT_EQ(outline, "function_block Counter\n");
    EXPECT_EQ(variables,
              (std::vector<std::string>{"final", "count", "count", "final", "count", "final"}));
}

TEST(Embedding, FormattingAndWriting) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText("TYPE t:INT; END_TYPE"));

    iecfront::FormatOptions layout;
    layout.keyword_case = iecfront::KeywordCase::lower;
    std::string text = iecfront::format(tree, layout);

    EXPECT_EQ(text, "type\n    t : int;\nend_type\n");

    iecfront::SyntaxTree german =
        iecfront::parse(iecfront::SourceText("TYPE t : STRING := '\xC3\x84'; END_TYPE"));

    iecfront::WriteOptions options;
    options.comments = iecfront::CommentHandling::keep_iso_646;
    iecfront::WrittenText written = iecfront::write(german, options);
    bool plain = written.beyond_iso_646.empty();

    EXPECT_TRUE(plain);
    EXPECT_EQ(written.text, "TYPE\n    t : STRING := '$C4';\nEND_TYPE\n");
}

TEST(Embedding, Fragments) {
    iecfront::ParseOptions options;
    options.read_as = iecfront::FragmentKind::expression;
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText("count + 1"), options);
    const iecfront::ast::Node* expression = tree.slots()[0].unit->root().elements[0];

    EXPECT_TRUE(iecfront::ast::is<iecfront::ast::BinaryExpression>(expression->kind));

    iecfront::SourceText piece("count + + 1", "plant.xml");
    piece = piece.at({.offset = 2049, .line = 88, .column = 13});
    iecfront::SyntaxTree placed = iecfront::parse(piece, options);
    std::string report = iecfront::render_text(placed.diagnostics(), piece); // plant.xml:88:21

    iecfront::HostPlace place = placed.host_place(8); // 2057, and line 88, column 21

    EXPECT_TRUE(report.starts_with("plant.xml:88:21: ")) << report;
    EXPECT_EQ(place, (iecfront::HostPlace{2057, {88, 21}}));
}

TEST(Embedding, MappedFindings) {
    const iecfront::Diagnostic found{iecfront::DiagnosticId::missing_semicolon, {2, 3}, {}, {}, {}};
    const std::vector<std::uint32_t> offset_in_file{100, 101, 102, 106};

    iecfront::Diagnostic in_file = iecfront::mapped(found, [&](std::uint32_t offset) {
        return offset_in_file[offset]; // begins and ends of ranges
    });

    EXPECT_EQ(in_file.range, (iecfront::TextRange{102, 106}));
}

TEST(Embedding, Comments) {
    iecfront::SyntaxTree tree = iecfront::parse(iecfront::SourceText(example));
    const iecfront::Unit& unit = *tree.slots()[0].unit;
    std::vector<std::string> comments;

    for (const iecfront::Trivia& trivia : unit.trivia())
        if (trivia.kind != iecfront::TriviaKind::pragma)
            comments.emplace_back(unit.text(trivia.range));

    EXPECT_EQ(comments, std::vector<std::string>{"(* counts *)"});
}

TEST(Embedding, Limits) {
    iecfront::SourceText source("PROGRAM p VAR x : INT; END_VAR x := ((((1)))); END_PROGRAM");

    iecfront::ParseOptions options;
    options.maximum_nesting = 3;
    iecfront::SyntaxTree tree = iecfront::parse(source, options);

    ASSERT_EQ(tree.diagnostics().size(), 1U);
    EXPECT_EQ(tree.diagnostics()[0].id, iecfront::DiagnosticId::nesting_too_deep);
}

} // namespace
