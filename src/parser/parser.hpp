#pragma once

#include "lexer/standard_names.hpp"
#include "parser/keyword_sets.hpp"
#include "parser/parser_arena.hpp"

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/ast/unit.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/standard_names.hpp>
#include <iecfront/lexer/token.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory_resource>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace iecfront {

struct IlOperatorRow;
struct OperatorReading;

/// The languages a body can be written in (1.4.3).
enum class BodyLanguage : std::uint8_t {
    structured_text,
    instruction_list,
    sequential_function_chart
};

/// The recursive-descent parser of one unit. A production is the comment of the function that reads
/// it; other parse functions say which one they read a part of, or what in its place. The functions
/// stand in one source file per chapter of Annex B.
///
/// Four contracts:
///   parse_x            called where an x must stand; always gives a node
///   parse_optional_x   may give null, and has then consumed nothing
///   accept             takes a token if it is there
///   expect             takes a token, or reports that it is missing and goes on as if it were
///   there
class Parser {
public:
    /// `tokens` ends in an end_of_unit token, which `opener` is as well when the unit cutter found
    /// none. `lexical` is what the lexer reported, ordered by place. Nodes are made in `arena`;
    /// what the parser keeps of unfinished lists and open blocks takes memory of `scratch`.
    Parser(std::string_view text, std::span<Token> tokens, std::span<const Diagnostic> lexical,
           std::uint32_t opener, ParserArena& arena, const ParseOptions& options,
           std::pmr::memory_resource& scratch = *std::pmr::new_delete_resource());

    /// Says that as many blocks of each kind begin as are closed, so that nobody counts them again.
    void know_balanced() noexcept {
        balances_known_ = true;
        balanced_ = true;
    }

    /// Lets it take each body that begins with an assignment or a block of statements for
    /// statements, and ask its lines only when there is something to report in it.
    void presume_statements() noexcept { presumes_statements_ = true; }
    /// True when its lines then say that it is none: what is read is of no use.
    [[nodiscard]] bool misjudged() const noexcept { return misjudged_; }

    // ---- library.cpp: B.0
    const ast::LibraryUnit* parse_library_unit();

    // ---- fragment.cpp
    const ast::LibraryUnit* parse_fragment(FragmentKind kind);

    [[nodiscard]] std::vector<Diagnostic> take_diagnostics() { return std::move(diagnostics_); }

    /// Goes to the end as soon as a report is made that `expected` does not hold: what is read then
    /// is of no use.
    void expect_reports(const std::vector<Diagnostic>& expected) noexcept { expected_ = &expected; }
    [[nodiscard]] static bool holds(const std::vector<Diagnostic>& reports,
                                    const Diagnostic& report) noexcept;
    /// Where that was; nothing when all reports were expected.
    [[nodiscard]] std::optional<std::uint32_t> stopped_at() const noexcept { return stopped_at_; }

private:
    // ---- cursor.cpp: tokens ---------------------------------------------------------------------
    [[nodiscard]] TokenKind kind() const noexcept { return kind_; }
    [[nodiscard]] const Token& token() const noexcept { return tokens_[at_]; }
    [[nodiscard]] bool at(TokenKind kind) const noexcept { return kind_ == kind; }
    [[nodiscard]] bool at(const TokenSet& set) const noexcept { return set.contains(kind_); }
    [[nodiscard]] bool at_end() const noexcept { return at(TokenKind::end_of_unit); }
    /// Index of the token behind `index`; tokens that the lexer could not read are passed over.
    [[nodiscard]] std::uint32_t next(std::uint32_t index) const noexcept {
        if (tokens_[index].kind() == TokenKind::end_of_unit)
            return index;
        do
            ++index;
        while (tokens_[index].kind() == TokenKind::unknown);
        return index;
    }
    [[nodiscard]] TokenKind peek() const noexcept { return tokens_[next(at_)].kind(); }
    [[nodiscard]] TokenKind peek_second() const noexcept { return tokens_[next(next(at_))].kind(); }
    [[nodiscard]] std::string_view text(std::uint32_t index) const noexcept {
        return {text_.data() + tokens_[index].offset(), tokens_[index].length()};
    }
    /// True when the current token is an identifier spelt `word` (in upper case) in any case.
    [[nodiscard]] bool at_word(std::string_view word) const noexcept;
    /// No byte stands between the current token and the next.
    [[nodiscard]] bool adjoins_next() const noexcept;
    /// So many tokens further on in a line it is looked for what a mistake at its start may mean.
    /// Far more than a line has, and a bound for the time that one of megabytes takes.
    static constexpr std::uint32_t furthest_on_line = 100;
    [[nodiscard]] bool on_same_line(std::uint32_t first, std::uint32_t second) const noexcept;
    /// 0-based distance in bytes from the start of its line.
    [[nodiscard]] std::uint32_t column(std::uint32_t index) const noexcept;

    std::uint32_t advance() noexcept {
        const std::uint32_t index = at_;
        if (!at_end())
            pass();
        return index;
    }
    /// The same of a token that is not the end. A report may have gone there: see expect_reports.
    void pass() noexcept {
        std::uint32_t behind = at_ + 1;
        end_ = behind;
        while (tokens_[behind].kind() == TokenKind::unknown)
            ++behind;
        move_to(behind);
    }
    void move_to(std::uint32_t index) noexcept {
        at_ = index;
        kind_ = tokens_[index].kind();
    }
    /// Leaves all that follows unread.
    void move_to_end() noexcept {
        end_ = count_;
        move_to(count_);
    }
    /// Takes all tokens up to `index`, and that one.
    void advance_past(std::uint32_t index) noexcept {
        while (at_ <= index && !at_end())
            advance();
    }
    bool accept(TokenKind kind) noexcept {
        if (!at(kind))
            return false;
        advance();
        return true;
    }
    /// Takes a delimiter or keyword, or reports it missing behind the token before. One intruder
    /// that stands before it is dropped.
    bool expect(TokenKind kind) { return accept(kind) || expect_missing(kind); }
    bool expect_missing(TokenKind kind);

    // ---- cursor.cpp: nodes ----------------------------------------------------------------------
    /// What is made of a name; of a `variable` it is told by the `(` behind it whether it is
    /// called.
    enum class NameUse : std::uint8_t { declaration, type, call, variable, other };
    template<class T>
    T* create() {
        void* memory = arena_.try_allocate(sizeof(T), alignof(T));
        if (memory == nullptr)
            memory = allocate_from_reserve(sizeof(T), alignof(T));
        return ::new (memory) T();
    }
    void make_room_for_pending();
    void* allocate_from_reserve(std::size_t size, std::size_t alignment);
    void open_reserve();
    template<class T>
    T* make() {
        T* node = create<T>();
        node->first_token = at_;
        node->end_token = at_;
        return node;
    }
    /// A node of the current token alone, which is taken.
    template<class T>
    T* take() {
        T* node = create<T>();
        node->first_token = at_;
        advance();
        node->end_token = end_;
        return node;
    }
    /// The same of a word that is not looked at any further.
    template<class T>
    T* take_word() {
        const std::uint32_t hash = hash_name(text(at_));
        T* node = take<T>();
        node->hash = hash;
        return node;
    }
    /// The same of a name, which may not be one of the standard but for some uses.
    template<class T, NameUse use>
    const T* take_name() {
        T* node = create<T>();
        const Token word = token();
        node->first_token = at_;
        node->end_token = at_ + 1;
        pass();
        const NameLook look = look_at_name(text_.data(), word.offset(), word.length());
        node->hash = look.hash;
        if (look.may_be_standard) [[unlikely]]
            return static_cast<const T*>(check_name(node, look.hash, use));
        return node;
    }
    /// A node that begins where `first`, already parsed, does.
    template<class T>
    T* make_from(const ast::Node* first) {
        T* node = create<T>();
        node->first_token = first->first_token;
        return node;
    }
    /// Ends `node` behind the last token that was consumed. When none was, unreadable tokens before
    /// the cursor count as consumed, so that an empty node lies inside the one around it.
    template<class T>
    T* finish(T* node) noexcept {
        if (end_ < node->first_token)
            end_ = node->first_token;
        node->end_token = end_;
        return node;
    }
    /// A node for something that is not there.
    template<class T>
    T* make_missing() {
        end_ = at_;
        T* node = make<T>();
        node->missing = true;
        return node;
    }

    /// What a `List` is made of: children that lie in the arena.
    template<class T>
    using Children = std::span<const ast::Child<T>>;
    /// `nodes`, at least one, as the children of a list, which lies behind them: by that
    /// `ast::StoredNodes` tells it from a node. When there is no room, they are some of them: what
    /// is made is of no use then.
    template<class T>
    Children<T> make_children(std::span<const ast::Node* const> nodes) {
        constexpr std::size_t size = sizeof(ast::Child<T>);
        constexpr std::size_t alignment = alignof(ast::Child<T>);
        void* memory =
            arena_.full() ? nullptr : arena_.try_allocate(nodes.size() * size, alignment);
        if (memory == nullptr) {
            nodes = nodes.first(std::min<std::size_t>(nodes.size(), 16));
            memory = allocate_from_reserve(nodes.size() * size, alignment);
        }
        auto* const children = static_cast<ast::Child<T>*>(memory);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            ::new (children + i) ast::Child<T>(static_cast<const T*>(nodes[i]));
        return {children, nodes.size()};
    }
    /// A list of one.
    template<class T>
    Children<T> list_of(const T* node) {
        const ast::Node* const one = node;
        return make_children<T>(std::span(&one, 1));
    }

    /// Collects children on a common stack, so that only finished lists take memory.
    template<class T>
    class ListBuilder {
    public:
        explicit ListBuilder(Parser& parser) noexcept
            : parser_(parser), begin_(parser.pending_count_) {}
        ListBuilder(const ListBuilder&) = delete;
        ListBuilder& operator=(const ListBuilder&) = delete;
        ~ListBuilder() { parser_.pending_count_ = begin_; }

        void add(const T* node) {
            if (parser_.pending_count_ == parser_.pending_room_) [[unlikely]]
                parser_.make_room_for_pending();
            parser_.pending_[parser_.pending_count_++] = node;
        }
        [[nodiscard]] bool empty() const noexcept { return size() == 0; }
        [[nodiscard]] std::size_t size() const noexcept { return parser_.pending_count_ - begin_; }
        [[nodiscard]] Children<T> finish() {
            if (empty())
                return {};
            return parser_.make_children<T>({parser_.pending_.data() + begin_, size()});
        }

    private:
        Parser& parser_;
        std::size_t begin_;
    };

    /// Adds what `parse` gives, and proves progress: when it took nothing, a token is passed over,
    /// so that no loop over unreadable text goes on for ever. An empty statement takes none of its
    /// own.
    template<class T, class Parse>
    void add_in_loop(ListBuilder<T>& list, Parse parse) {
        const std::uint32_t begin = at_;
        list.add(parse());
        if (at_ == begin && !at(TokenKind::semicolon))
            advance();
    }

    /// Counts nesting; it is `too_deep()` beyond the limit, which is then reported once.
    class NestingGuard {
    public:
        explicit NestingGuard(Parser& parser) noexcept : parser_(parser) {
            ++parser_.nesting_;
            parser_.arena_.enter_level();
        }
        NestingGuard(const NestingGuard&) = delete;
        NestingGuard& operator=(const NestingGuard&) = delete;
        ~NestingGuard() {
            --parser_.nesting_;
            parser_.arena_.leave_level();
        }
        [[nodiscard]] bool too_deep() const {
            return parser_.nesting_ > parser_.options_.maximum_nesting && report();
        }

    private:
        bool report() const; // gives true
        Parser& parser_;
    };

    // ---- cursor.cpp: reports --------------------------------------------------------------------
    /// Adds to a diagnostic that was just reported, or to nothing when it was suppressed.
    class Report {
    public:
        Report(Parser& parser, std::optional<std::size_t> index) noexcept
            : parser_(parser), index_(index) {}
        Report& label(LabelId id, std::uint32_t token);
        Report& insert(std::uint32_t offset, std::string words);
        Report& replace(TextRange range, std::string words);
        Report& remove(TextRange range);
        /// As a part of the fix that was added last.
        Report& also_remove(TextRange range);
        Report& also_insert(std::uint32_t offset, std::string words);
        explicit operator bool() const noexcept { return index_.has_value(); }
        [[nodiscard]] std::size_t index() const noexcept { return *index_; }

    private:
        Parser& parser_;
        std::optional<std::size_t> index_;
    };
    /// For a message, like `DiagnosticArgument`; but words are only copied when the report is made,
    /// and what holds them has to live until then.
    using Argument = std::variant<std::string_view, std::uint64_t, char32_t>;
    using Arguments = std::initializer_list<Argument>;
    [[nodiscard]] static DiagnosticArgument copied(const Argument& argument);

    Report report(DiagnosticId id, TextRange range, Arguments arguments = {});
    /// About one token. A second report at a token is suppressed: one problem, one report.
    Report report_at(std::uint32_t token, DiagnosticId id, Arguments arguments = {});
    /// About tokens `[first, end)`, reported even when another report stands there.
    Report report_node(const ast::Node& node, DiagnosticId id, Arguments arguments = {});
    /// About something missing behind the last token that was consumed.
    Report report_missing(DiagnosticId id, Arguments arguments = {});
    /// The same of something that cannot be guessed: to insert what else is missing there does not
    /// help.
    void report_unfinished(DiagnosticId id, Arguments arguments = {});
    /// "expected {what}, found {the current token}". A closing bracket that no operand follows gets
    /// its removal as a fix.
    Report report_unexpected(std::string_view what);
    [[nodiscard]] std::uint32_t previous_end() const noexcept;
    [[nodiscard]] std::string spaced(std::string words, TextRange range) const;
    [[nodiscard]] TextRange with_blank(TextRange range) const noexcept;
    [[nodiscard]] bool follows_unclosed() const;
    /// True when a character that was reported as having no meaning stands before the token.
    [[nodiscard]] bool follows_unknown(std::uint32_t token) const noexcept {
        return token > 0 && tokens_[token - 1].kind() == TokenKind::unknown &&
               tokens_[token - 1].malformed();
    }
    /// The token in backticks, or in words.
    [[nodiscard]] std::string describe(std::uint32_t index) const;
    [[nodiscard]] std::string quoted(std::uint32_t index) const;
    [[nodiscard]] TextRange token_range(std::uint32_t first, std::uint32_t end) const noexcept;

    // ---- cursor.cpp: names ----------------------------------------------------------------------
    const ast::Identifier* make_identifier();
    const ast::Identifier* make_missing_identifier(std::string_view what);
    /// A name that is used. Keywords in its place are taken for one when nothing else can be meant.
    const ast::Identifier* parse_name(std::string_view what);
    /// A name that is declared; names of standard functions and function blocks are reported.
    const ast::Identifier* parse_declared_name(std::string_view what);
    void report_reserved_word(std::uint32_t token);
    [[nodiscard]] std::string free_suffix(std::string_view word) const;
    const ast::Identifier* take_reserved_word();
    /// About a token, of which `hash` is the hash.
    void check_standard_name(std::uint32_t word, std::uint32_t hash, NameUse use) {
        check_name_of_standard(tokens_[word].range(), hash, use);
    }
    void check_name_of_standard(TextRange range, std::uint32_t hash, NameUse use);
    /// About a name that was made; gives it.
    const ast::Node* check_name(const ast::Node* name, std::uint32_t hash, NameUse use);
    [[nodiscard]] bool used_as_name(TokenKind kind) const noexcept;
    [[nodiscard]] bool at_keyword_for_variable();

    // ---- recovery.cpp ---------------------------------------------------------------------------
    static constexpr std::uint32_t no_token = 0xFFFF'FFFF;
    /// A block that waits for its closing word.
    struct OpenBlock {
        TokenKind closer;
        std::uint32_t opener;
        bool in_else = false; // of IF or CASE: no other part follows
        // Until its column is compared with that of the opener.
        std::uint32_t first_statement = no_token;
        // Of its opener, when its statements are indented: none of them begins in it, or before it.
        std::uint32_t column = not_indented;
        std::uint32_t label = no_token; // of CASE: the last one, when it begins a line

        static constexpr std::uint32_t not_indented = no_token;
    };
    void open_block(TokenKind closer, std::uint32_t opener) { open_.push_back({closer, opener}); }
    /// Ends the innermost block: takes its closing word, or a misspelt or mismatched one, or
    /// reports it missing. `terminator` goes with the closing word in a fix-it.
    void close_block(std::string_view terminator);
    void close_doubtful_block(std::string_view terminator);
    void report_missing_closer(std::string_view terminator);
    bool join_missing_closer(const std::string& words);
    [[nodiscard]] bool is_open(TokenKind closer) const noexcept;
    [[nodiscard]] bool closes_outer_block() const noexcept;
    [[nodiscard]] bool at_misspelt_closer() const noexcept;
    [[nodiscard]] bool at_split_word(std::string_view closer) const noexcept;
    [[nodiscard]] std::uint32_t second_of_split_word() const noexcept;
    [[nodiscard]] bool closes_open_bracket() const noexcept;
    [[nodiscard]] bool brackets_balance() const noexcept;
    [[nodiscard]] bool at_foreign_closer();
    [[nodiscard]] bool at_mismatched_closer();
    /// How many more blocks of this kind begin in the unit than are closed.
    [[nodiscard]] std::int32_t unclosed(TokenKind closer) noexcept {
        if (!balances_known_)
            find_balances();
        return unclosed_[static_cast<std::size_t>(closer)];
    }
    /// As many blocks of each kind begin in the unit as are closed: no word is meant for one that
    /// is missing or too many.
    [[nodiscard]] bool balanced() noexcept {
        if (!balances_known_)
            find_balances();
        return balanced_;
    }
    void find_balances() noexcept;
    /// When what stands in the unit turns out to mean something else.
    void change_unclosed(TokenKind closer, std::int32_t by) noexcept;
    void count_as_name(TokenKind word);
    /// `opener` is a word that opens what has a closing word of its own.
    [[nodiscard]] static TokenKind closer_of(TokenKind opener) noexcept;
    [[nodiscard]] bool opens_block(TokenKind word);
    [[nodiscard]] bool at_declaration_start() const noexcept;
    [[nodiscard]] bool at_next_declaration() const noexcept;
    [[nodiscard]] bool at_next_configuration_part() const noexcept;
    [[nodiscard]] bool begins_type(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_statement_start() const noexcept;
    void skip_balanced();
    void skip_to(const TokenSet& stop);
    const ast::ErrorStatement* skip_statement();
    void skip_declaration();
    [[nodiscard]] bool at_semicolon_look_alike() const noexcept;
    /// A `;`, or at the end of the line another delimiter in its place.
    bool accept_semicolon() {
        return accept(TokenKind::semicolon) || accept_semicolon_look_alike();
    }
    bool accept_semicolon_look_alike();
    [[nodiscard]] std::uint32_t end_of_declaration_with_stray_word();
    void skip_stray_word_in_declaration(std::uint32_t end);
    void drop_word_before_declaration(std::string_view what);
    void expect_semicolon_of_declaration() {
        if (!accept_semicolon())
            report_no_semicolon_of_declaration();
    }
    void report_no_semicolon_of_declaration();
    void report_missing_semicolon();
    void report_left_out_semicolon();

    // ---- constants.cpp: B.1.2
    const ast::Expression* parse_constant();
    const ast::Expression* parse_literal(std::uint32_t first);
    const ast::Expression* parse_typed_literal(std::uint32_t first);
    template<class T>
    const ast::Expression* take_literal(std::uint32_t first) {
        T* node = take<T>();
        node->literal_token = node->first_token;
        node->first_token = first;
        return node;
    }
    [[nodiscard]] bool at_literal() const noexcept { return at(literals); }
    [[nodiscard]] bool at_signed_number() const noexcept;
    [[nodiscard]] bool is_signed_integer(const ast::Expression& expression) const noexcept;
    const ast::Expression* parse_constant_expression(std::string_view what);
    [[nodiscard]] bool at_sign_apart_from_number() const noexcept;
    const ast::Expression* parse_constant_behind_gap();
    [[nodiscard]] bool is_faulty(const ast::Expression& expression,
                                 std::size_t reports) const noexcept;
    const ast::Expression* parse_integer(std::string_view what);
    void report_not_plain(const ast::Expression& expression, std::string_view what);

    // ---- types.cpp: B.1.3
    enum class StructureUse { named, anonymous };
    const ast::DataTypeDeclaration* parse_data_type_declaration();
    const ast::Node* parse_type_declaration();
    const ast::TypeDeclaration* parse_struct_before_name();
    [[nodiscard]] bool at_next_structure();
    [[nodiscard]] bool at_misspelt_struct();
    [[nodiscard]] bool at_stray_struct();
    [[nodiscard]] bool at_element_without_struct();
    void skip_block_words(std::optional<Report>& report);
    const ast::TypeSpecification* parse_type_behind_struct(StructureUse use);
    void parse_structure_elements(ast::StructureDeclaration& structure, std::uint32_t opener);
    const ast::ErrorDeclaration* parse_error_declaration(std::string_view what);
    void report_empty_block(std::uint32_t opener);
    void expect_colon() {
        if (token().first_on_line() || !accept(TokenKind::colon))
            report_missing_colon();
    }
    void report_missing_colon();
    [[nodiscard]] bool colon_follows_on_line() const noexcept;
    void expect_closing(TokenKind bracket);
    Report accept_as(TokenKind meant);
    std::optional<Report> accept_parenthesis_for_bracket();
    void close_parenthesis_for_bracket(Report report);
    void check_element_type(const ast::TypeSpecification& type);
    void check_no_function_block(const ast::TypeSpecification& type, const char* of);
    void skip_structure();
    const ast::TypeSpecification* parse_too_deep_type();
    const ast::Expression* as_enumerated_value(const ast::Expression& name);
    const ast::TypeSpecification*
    parse_type_specification(StructureUse use = StructureUse::anonymous);
    const ast::TypeSpecification* parse_missing_type();
    const ast::TypeSpecification* parse_type_name();
    [[nodiscard]] bool is_plain_type() const noexcept;
    const ast::TypeSpecification* parse_elementary_type();
    const ast::TypeSpecification* parse_derived_type();
    [[nodiscard]] bool at_pointer_type() const noexcept;
    const ast::TypeSpecification* parse_pointer_type();
    const ast::TypeSpecification* parse_string_specification(const ast::Node* keyword);
    const ast::TypeSpecification* parse_subrange_specification(const ast::TypeSpecification* base);
    const ast::Subrange* parse_subrange();
    [[nodiscard]] bool at_bounds_with_dash() const noexcept;
    [[nodiscard]] bool at_bounds_as_real() const noexcept;
    bool accept_between_bounds();
    bool accept_semicolon_for_comma(TokenKind bracket, std::optional<Report>& first);
    void take_semicolon_for_comma(std::optional<Report>& first);
    [[nodiscard]] bool list_closes_on_line(TokenKind bracket) const noexcept;
    const ast::TypeSpecification* parse_enumerated_specification();
    Children<ast::EnumeratedValueDeclaration> parse_enumerated_value_list();
    const ast::TypeSpecification* parse_enumeration_of(const ast::TypeSpecification* base);
    const ast::EnumeratedValueDeclaration* parse_enumerated_value_declaration();
    [[nodiscard]] bool at_initial_value_behind_open_list() const noexcept;
    const ast::TypeSpecification* parse_array_specification();
    Children<ast::Subrange> parse_subranges();
    bool accept_comma_look_alike();
    const ast::TypeSpecification* parse_structure_declaration();
    const ast::Node* parse_structure_element_declaration();
    const ast::Expression* parse_optional_initial_value();
    void check_initial_value(const ast::TypeSpecification& type, const ast::Expression* value);
    [[nodiscard]] bool has_width_of(const ast::Expression& value,
                                    const ast::StringSpecification& type) const noexcept;
    bool report_braces();
    [[nodiscard]] bool at_equal_in_structure() const noexcept;
    [[nodiscard]] TokenKind separator_in_parentheses() const noexcept;
    const ast::Expression* parse_initial_value();
    const ast::Expression* parse_enumerated_value();
    void check_enumerated_value_names(std::uint32_t token);
    const ast::Expression* parse_array_initialization();
    const ast::Expression* parse_array_initial_elements();
    const ast::Expression* parse_structure_initialization();
    const ast::StructureElementInitialization* parse_structure_element_initialization();

    // ---- variables.cpp: B.1.4
    /// Whose declarations are being read; `anywhere` for blocks that stand alone.
    enum class Place {
        function,
        function_block,
        program,
        configuration,
        resource,
        library,
        anywhere
    };
    const ast::VariableDeclarations* parse_variable_declarations(Place place);
    [[nodiscard]] bool at_plain_declaration() const noexcept;
    [[nodiscard]] bool at_whole_declaration() const noexcept;
    /// Such a one, of a variable or of an element of a structure.
    template<class T>
    const T* parse_whole_declaration() {
        auto* node = make<T>();
        node->names = list_of(take_name<ast::Identifier, NameUse::declaration>());
        // Where nodes have no room, all tokens behind are gone.
        accept(TokenKind::colon);
        node->specification = is_elementary_type_name(kind()) ? take<ast::ElementaryTypeName>()
                                                              : parse_missing_type();
        finish(node);
        accept(TokenKind::semicolon);
        return node;
    }
    [[nodiscard]] bool at_named_declaration();
    [[nodiscard]] bool at_end_of_declarations();
    [[nodiscard]] bool at_declarations_without_opener();
    [[nodiscard]] bool at_block_of_location();
    [[nodiscard]] bool at_configuration_part() const noexcept;
    [[nodiscard]] bool at_unknown_block() const noexcept;
    [[nodiscard]] TokenKind misspelt_block_opener() const noexcept;
    void parse_block_head(ast::VariableDeclarations& block, Place place);
    TokenKind accept_split_block_opener();
    void accept_misspelt(TokenKind meant);
    void report_swapped(std::uint32_t second, std::string_view between = " ");
    [[nodiscard]] TokenKind misspelt_qualifier() const noexcept;
    [[nodiscard]] bool at_unknown_qualifier() const noexcept;
    const ast::Node* parse_type_before_names();
    void accept_qualifier_of_declaration(const ast::VariableDeclarations& block);
    void drop_qualifier_behind_type();
    void parse_location_behind_type(std::uint32_t declaration, std::uint32_t names_end);
    const ast::VariableDeclaration* parse_names_only(ast::VariableDeclaration* node);
    void check_block(const ast::VariableDeclarations& block, std::uint32_t qualifier, Place place);
    ast::BlockQualifier parse_block_qualifiers();
    void check_qualifier(const ast::VariableDeclarations& block, std::uint32_t qualifier,
                         Place place);
    const ast::Node* parse_declaration(const ast::VariableDeclarations& block, Place place);
    const ast::VariableDeclaration*
    parse_variable_declaration(const ast::VariableDeclarations& block, Place place);
    void parse_declared_names(ListBuilder<ast::Identifier>& names,
                              const ast::VariableDeclarations& block);
    const ast::Identifier* parse_variable_name(const ast::VariableDeclarations& block);
    [[nodiscard]] bool at_location() const noexcept;
    const ast::Location* parse_optional_location();
    [[nodiscard]] std::uint32_t end_of_location_without_sign() const noexcept;
    void check_declaration(const ast::VariableDeclaration& declaration,
                           const ast::VariableDeclarations& block, Place place);
    void check_initial_value_in_block(const ast::VariableDeclaration& declaration,
                                      const ast::VariableDeclarations& block);
    [[nodiscard]] bool has_derivable_value(const ast::VariableDeclaration& declaration,
                                           const ast::VariableDeclarations& block) const noexcept;
    void check_location(const ast::VariableDeclaration& declaration,
                        const ast::VariableDeclarations& block, Place place);
    void check_mixed(const ast::VariableDeclarations& block);
    [[nodiscard]] bool is_incomplete(const ast::Location& location) const noexcept;
    [[nodiscard]] bool names_function_block(const ast::TypeSpecification& type) const noexcept;
    ast::Edge parse_optional_edge(const ast::VariableDeclarations& block, Place place,
                                  const ast::TypeSpecification& type);
    const ast::Expression* parse_direct_variable();

    // ---- pous.cpp: B.1.5
    const ast::FunctionDeclaration* parse_function_declaration();
    const ast::FunctionBlockDeclaration* parse_function_block_declaration();
    const ast::ProgramDeclaration* parse_program_declaration();
    Children<ast::VariableDeclarations> parse_declaration_blocks(Place place);
    [[nodiscard]] bool at_type_before_name() const noexcept;
    const ast::Identifier* parse_unit_name(std::string_view what);
    [[nodiscard]] bool at_keyword_for_unit_name();
    const ast::TypeSpecification* parse_result_type();
    void skip_parameters();
    void skip_rest_of_head();
    const ast::Body* parse_body();
    [[nodiscard]] bool at_presumable_statements();
    const ast::Body* parse_presumed_statements();
    const ast::Body* parse_empty_body();
    [[nodiscard]] BodyLanguage body_language(); // body_language.cpp
    class BodySurvey;
    /// A body that is read as statements, and whose lines were not asked yet.
    struct PresumedBody {
        std::uint32_t begin;
        TokenKind closer;
    };
    void ask_presumed_body();
    [[nodiscard]] std::uint32_t chart_element_end(std::uint32_t index) const noexcept;
    enum class LineKind { operation, application, other };
    [[nodiscard]] LineKind line_kind(std::uint32_t index, LineKind before) const noexcept;
    [[nodiscard]] bool begins_deferred_operation(std::uint32_t index) const noexcept;
    [[nodiscard]] bool ends_operator(std::uint32_t index) const noexcept;
    [[nodiscard]] bool begins_chart_element(std::uint32_t index) const noexcept {
        return chart_openers.contains(tokens_[index].kind()) && is_chart_element_head(index);
    }
    [[nodiscard]] bool is_chart_element_head(std::uint32_t index) const noexcept;
    [[nodiscard]] bool body_begins_in_head();

    // ---- sequential_function_chart.cpp: B.1.6
    const ast::SequentialFunctionChart* parse_sequential_function_chart();
    void check_initial_steps(const ast::SequentialFunctionChart& chart); // initial_steps.cpp
    const ast::SfcNetwork* parse_sfc_network();
    [[nodiscard]] bool at_end_of_chart();
    const ast::Node* parse_chart_element(TokenKind opener);
    [[nodiscard]] TokenKind chart_element_opener() noexcept;
    [[nodiscard]] bool at_chart_word() const noexcept;
    [[nodiscard]] TokenKind misspelt_chart_word() const noexcept;
    [[nodiscard]] TokenKind missing_chart_word() noexcept;
    [[nodiscard]] std::uint32_t next_chart_word() noexcept;
    void open_chart_element(TokenKind opener);
    [[nodiscard]] bool at_end_of_chart_element();
    [[nodiscard]] bool at_chart_structure();
    bool skip_chart_element();
    const ast::SkippedText* skip_text_in_chart();
    void expect_colon_of_chart();
    const ast::Step* parse_step(TokenKind opener);
    Children<ast::ActionAssociation> parse_action_associations();
    [[nodiscard]] bool at_element_in_step();
    const ast::ActionAssociation* parse_action_association();
    bool expect_qualifier_parenthesis();
    void skip_association();
    void expect_semicolon_of_association();
    const ast::ActionQualifier* parse_action_qualifier();
    void report_unknown_qualifier();
    const ast::Expression* parse_time_of_qualifier();
    const ast::Expression* parse_action_time();
    const ast::Expression* parse_indicator();
    const ast::Expression* parse_parameter_of_action(std::string_view what);
    const ast::Transition* parse_transition();
    const ast::Identifier* parse_optional_transition_name();
    [[nodiscard]] bool begins_priority(std::uint32_t index) const noexcept;
    [[nodiscard]] std::uint32_t behind_priority(std::uint32_t index) const noexcept;
    [[nodiscard]] bool begins_from(std::uint32_t index) const noexcept;
    const ast::Expression* parse_optional_priority();
    void expect_priority_word();
    void report_missing_parentheses(std::uint32_t first, std::string_view around);
    const ast::Steps* parse_steps_behind(TokenKind word);
    bool accept_misspelt_part(TokenKind word);
    bool accept_arrow();
    const ast::Steps* parse_steps();
    const ast::TransitionCondition* parse_transition_condition();
    [[nodiscard]] bool instructions_follow_colon() const noexcept;
    void expect_semicolon_of_condition();
    void skip_rest_of_transition(bool reported);
    const ast::Action* parse_action();
    const ast::Body* parse_too_deep_body();

    // ---- configuration.cpp: B.1.7
    const ast::ConfigurationDeclaration* parse_configuration_declaration();
    const ast::Identifier* parse_configuration_name();
    [[nodiscard]] TokenKind misspelt_configuration_word() const noexcept;
    [[nodiscard]] bool at_unknown_closer() const noexcept;
    [[nodiscard]] bool at_unknown_closer_for_innermost();
    const ast::ResourceDeclaration* parse_resource_declaration();
    [[nodiscard]] bool at_resource_without_word();
    bool accept_with();
    bool accept_output_arrow();
    Children<ast::Node> parse_configuration_elements(Place place);
    [[nodiscard]] bool at_end_of_configuration_elements(Place place);
    const ast::Node* parse_configuration_element(Place place);
    void check_configuration_order(Children<ast::Node> elements, std::uint32_t head, Place place);
    void expect_semicolon_of_configuration();
    const ast::Expression* parse_access_path(Place place);
    void check_element_type_of_access(const ast::TypeSpecification& type);
    [[nodiscard]] bool at_incomplete(const ast::Location& location) const noexcept;
    const ast::TaskConfiguration* parse_task_configuration();
    [[nodiscard]] std::size_t task_word(std::uint32_t token) const noexcept;
    const ast::TaskInitialization* parse_task_initialization();
    void check_task(const ast::TaskConfiguration& task);
    const ast::ProgramConfiguration* parse_program_configuration();
    const ast::Node* parse_prog_conf_element();
    const ast::Expression* parse_data_source();
    const ast::Expression* parse_prog_data_source();
    const ast::Expression* parse_data_sink();
    const ast::Expression* parse_connection_operand(std::string_view what, bool program_output);
    const ast::Expression* parse_symbolic_variable();
    void check_reference(const ast::Expression& path, std::string_view what, bool program_output);
    void check_symbolic_variable(const ast::Expression& path);
    const ast::Expression* parse_direct_variable_of_resource(Place place);
    const ast::AccessDeclaration* parse_access_declaration(Place place);
    const ast::InstanceSpecificInit* parse_instance_specific_init();

    // ---- expressions.cpp: B.3.1
    const ast::Expression* parse_expression();
    const ast::Expression* parse_condition();
    const ast::Expression* parse_binary(unsigned minimum);
    OperatorReading accept_doubtful_operator(unsigned minimum);
    [[nodiscard]] bool at_operator() const noexcept;
    [[nodiscard]] bool may_be_at_operator(unsigned minimum) const noexcept;
    [[nodiscard]] bool at_plain_operand() const noexcept;
    const ast::Expression* parse_plain_operand();
    [[nodiscard]] bool at_plain_variable() const noexcept;
    const ast::Expression* parse_binary_rest(const ast::Expression* left, unsigned minimum);
    const ast::Expression* parse_unary();
    const ast::Expression* parse_doubtful_unary();
    [[nodiscard]] TokenKind split_operator() const noexcept;
    void accept_split_operator(TokenKind meant);
    const ast::Expression* parse_primary();
    const ast::Expression* parse_parenthesized();
    const ast::Expression* parse_operator_call();
    const ast::Expression* parse_variable();
    const ast::Expression* parse_variable_name();
    const ast::Expression* parse_plain_name();
    const ast::Expression* parse_selectors(const ast::Expression* head);
    const ast::Expression* parse_subscripts(const ast::Expression* head);
    const ast::Expression* parse_field(const ast::Expression* head);
    const ast::PartSelector* parse_part_selector();
    [[nodiscard]] bool at_dereference() const noexcept;
    const ast::Expression* parse_dereference(const ast::Expression* reference);
    [[nodiscard]] bool at_caret_for_power() const noexcept;
    [[nodiscard]] bool at_doubled_dot() const noexcept;
    [[nodiscard]] bool at_arrow_for_dot() const noexcept;
    const ast::Expression* parse_arrow(const ast::Expression* head);
    [[nodiscard]] bool at_early_end_if();
    void skip_early_end_if();
    [[nodiscard]] bool follows_operator(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_formal_argument_behind_comma() const noexcept;
    const ast::Expression* parse_call(const ast::Expression* callee);
    [[nodiscard]] bool has_no_parts(const ast::Expression& variable) const noexcept;
    void check_has_parts(const ast::Expression& variable);
    Children<ast::Node> parse_arguments();
    const ast::Node* parse_argument(std::uint32_t open);
    [[nodiscard]] static bool is_formal(const ast::Node& argument) noexcept;
    void check_arguments(Children<ast::Node> arguments);
    const ast::Expression* parse_missing_expression();
    [[nodiscard]] bool at_assignment_on_new_line() const noexcept;
    [[nodiscard]] bool statement_ends(std::uint32_t i) const noexcept;
    [[nodiscard]] bool at_misspelt_not() const noexcept;
    [[nodiscard]] bool names_type(std::uint32_t index) const noexcept;
    void report_conversion(std::uint32_t first, std::uint32_t end, TokenKind type);
    const ast::Expression* parse_cast();
    [[nodiscard]] bool at_shift() const noexcept;
    const ast::Expression* parse_shift(const ast::Expression* left);
    void report_call_of_member(const ast::Expression& callee);
    const ast::Expression* parse_too_deep_expression();
    const ast::Expression* check_function_call(const ast::Expression* operand);
    const ast::Identifier* parse_argument_name();
    const ast::Expression* parse_output_variable();
    [[nodiscard]] bool formal_list_follows() const noexcept;
    [[nodiscard]] static unsigned operator_strength(TokenKind kind) noexcept;
    bool accept_missing_comma(bool named = false);
    bool accept_semicolon_of_arguments(bool formal, std::optional<Report>& first);
    [[nodiscard]] bool semicolons_separate(bool formal) const noexcept;
    std::optional<Report> accept_doubled_parenthesis();
    bool accept_argument_comma(std::uint32_t open, bool formal);
    [[nodiscard]] bool stands_right_of_line(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_end_of_unfinished_call(std::uint32_t open) const noexcept;
    [[nodiscard]] bool stands_below_call(std::uint32_t open) const noexcept;
    [[nodiscard]] std::uint32_t line_begin(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_output_slip(std::uint32_t open) const noexcept;
    [[nodiscard]] bool lacks_assign(const ast::Node& value, std::uint32_t open) const noexcept;
    [[nodiscard]] bool at_equal_for_assign(std::uint32_t open) const noexcept;
    [[nodiscard]] bool at_colon_for_assign(std::uint32_t open) const noexcept;
    [[nodiscard]] bool has_formal_argument(std::uint32_t open) const noexcept;
    [[nodiscard]] bool argument_list_closes(std::uint32_t i) const noexcept;
    [[nodiscard]] bool at_expression_start() const noexcept;
    [[nodiscard]] bool at_operand_keyword() const noexcept;

    // ---- statements.cpp: B.3.2
    const ast::StatementList* parse_statement_list(std::string_view where);
    void parse_statements(ListBuilder<ast::Statement>& statements);
    const ast::Statement* parse_statement_or_stray_word(ListBuilder<ast::Statement>& statements);
    [[nodiscard]] bool at_plain_assignment() const noexcept;
    [[nodiscard]] bool at_end_of_statements();
    [[nodiscard]] bool at_outdented_statement() noexcept;
    [[nodiscard]] bool at_split_closer() const noexcept;
    void skip_stray_word(bool first_in_list);
    [[nodiscard]] std::uint32_t first_indented_above() const noexcept;
    bool report_missing_head(TokenKind closer);
    [[nodiscard]] bool belongs_to_outer_if() noexcept;
    [[nodiscard]] bool at_misspelt_elsif() const noexcept;
    [[nodiscard]] bool at_missing_elsif() noexcept;
    [[nodiscard]] bool at_misspelt_else() const noexcept;
    [[nodiscard]] bool at_misspelt_until() const noexcept;
    [[nodiscard]] bool at_while_for_until();
    [[nodiscard]] bool at_condition_without_until() const noexcept;
    void open_statement(TokenKind opener, TokenKind closer);
    [[nodiscard]] TokenKind missing_opener();
    [[nodiscard]] std::uint32_t find_on_line(TokenKind word) const noexcept;
    [[nodiscard]] bool joined_by_operator(std::uint32_t index) const noexcept;
    [[nodiscard]] bool begins_operand_on_line(std::uint32_t index) const noexcept;
    [[nodiscard]] static bool begins_operand(TokenKind kind) noexcept; // body_language.cpp
    const ast::StatementList* parse_else_list();
    const ast::Statement* parse_label_after_else();
    void parse_for_list(ast::ForStatement& loop);
    bool accept_by();
    [[nodiscard]] bool accept_misspelt_word(TokenKind word);
    const ast::Statement* parse_statement();
    [[nodiscard]] bool at_statement_label() const noexcept;
    [[nodiscard]] bool at_label_without_colon() const noexcept;
    [[nodiscard]] bool name_before_statement(std::uint32_t index) const noexcept;
    [[nodiscard]] bool begins_statement(std::uint32_t index) const noexcept;
    const ast::Statement* parse_misplaced_declarations();
    const ast::Statement* parse_chart_element_for_statement();
    const ast::Statement* parse_too_deep_statement();
    const ast::ErrorStatement* expect_semicolon_of_statement(const ast::Statement& statement);
    [[nodiscard]] bool at_condition_behind_statement();
    const ast::Statement* parse_simple_statement();
    /// `:=`, or what is written instead of it by mistake.
    void expect_assign() {
        if (!accept(TokenKind::assign))
            expect_missing_assign();
    }
    void expect_missing_assign();
    [[nodiscard]] static bool is_variable(const ast::Expression& expression) noexcept;
    const ast::Statement* as_word_statement(const ast::Expression& name);
    [[nodiscard]] bool at_compound_assignment() const noexcept;
    const ast::Statement* parse_compound_assignment(const ast::Expression* variable);
    [[nodiscard]] bool at_prefix_increment() const noexcept;
    const ast::Statement* parse_prefix_increment();
    const ast::Statement* parse_plain_assignment();
    const ast::Statement* parse_assignment(const ast::Expression* variable);
    const ast::Statement* finish_expression_statement(const ast::Expression* expression,
                                                      std::size_t reports);
    const ast::Statement* parse_if_statement();
    const ast::Statement* parse_if_rest(ast::IfStatement* node);
    const ast::Statement* parse_if_without_head();
    const ast::ElsifClause* parse_elsif_clause();
    [[nodiscard]] bool at_else_for_elsif() const noexcept;
    [[nodiscard]] bool at_else_if_for_elsif();
    const ast::Statement* parse_case_statement();
    const ast::Statement* parse_case_rest(ast::CaseStatement* node);
    const ast::Statement* parse_case_without_head();
    [[nodiscard]] bool at_repeated_case();
    void accept_repeated_case();
    const ast::CaseElement* parse_case_element();
    const ast::Node* parse_case_label();
    const ast::Expression* parse_constant_label();
    /// In the place of `call`, which nobody may look at any more.
    const ast::Statement* make_invocation(const ast::FunctionCall& call);
    [[nodiscard]] bool followed_by_end_if_of(std::uint32_t end,
                                             std::uint32_t opener) const noexcept;
    /// A word between the parts of a statement, or another such word in its place.
    void expect_word(TokenKind word) {
        if (!accept(word))
            expect_missing_word(word);
    }
    void expect_missing_word(TokenKind word);
    [[nodiscard]] bool is_semicolon_for_to(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_word_of_other_language(TokenKind word) const noexcept;
    [[nodiscard]] bool at_case_label() const noexcept;
    [[nodiscard]] bool at_label_in_parentheses() const noexcept;
    const ast::Statement* parse_for_statement();
    const ast::Statement* parse_loop(ast::ForStatement* node);
    [[nodiscard]] bool loop_head_of_other_language() const noexcept;
    void skip_loop_head(ast::ForStatement& loop);
    const ast::Statement* parse_while_statement();
    const ast::Statement* parse_repeat_statement();
    const ast::Statement* parse_until_behind_closer(ast::RepeatStatement* node);
    const ast::Statement* parse_word_statement();
    void report_empty_list(std::string_view where);

    // ---- instruction_list.cpp: B.2
    /// Where line ends are missing inside one pair of parentheses.
    struct MissingLineEnds {
        std::string_view where; // the first of them
        std::vector<std::uint32_t> offsets;
    };
    const ast::InstructionList* parse_instruction_list();
    /// `where` says what the instructions stand in; not `closed` when nothing closes that. They are
    /// those of an `argument`, or of an operator.
    const ast::InstructionList* parse_simple_instruction_list(std::string_view where,
                                                              bool closed = true,
                                                              bool argument = false);
    const ast::IlInstruction* parse_il_instruction();
    const ast::IlInstruction* parse_il_simple_instruction(std::string_view where);
    const ast::Identifier* parse_optional_label();
    const ast::IlOperation* parse_il_operation();
    const ast::IlOperation* parse_il_simple_operation(const IlOperatorRow& row);
    const ast::IlOperation* parse_il_function();
    const ast::IlOperation* parse_il_expression(const IlOperatorRow& row);
    const ast::IlOperation* parse_il_jump_operation(const IlOperatorRow& row);
    const ast::IlOperation* parse_il_return_operation(const IlOperatorRow& row);
    const ast::IlOperation* parse_il_fb_call(const IlOperatorRow& row);
    const ast::IlOperation* parse_il_formal_funct_call();
    const ast::IlOperation* parse_operands_in_parentheses(const ast::Identifier* name,
                                                          std::uint32_t open,
                                                          const ast::Expression* first);
    const ast::IlOperation* parse_structured_text_in_il();
    const ast::IlOperation* parse_il_error_operation();
    const ast::IlOperation* parse_too_deep_operation(std::uint32_t depth = 0);
    const ast::Expression* expect_il_operand(std::string_view after);
    const ast::Expression* parse_missing_il_operand(std::string_view after);
    const ast::Expression* parse_il_operand();
    const ast::Expression* parse_next_il_operand();
    const ast::Expression* report_expression(const ast::Expression* expression);
    const ast::Expression* parse_il_variable();
    void add_il_operands(ListBuilder<ast::Expression>& operands);
    bool accept_il_comma();
    const ast::Expression* parse_called_instance();
    void report_missing_instance(std::uint32_t word);
    const ast::Identifier* make_identifier_of(std::uint32_t token);
    [[nodiscard]] const IlOperatorRow* il_operator(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_ampersand_n(std::uint32_t index) const noexcept {
        return tokens_[index].kind() == TokenKind::ampersand && is_ampersand_n(index);
    }
    [[nodiscard]] bool is_ampersand_n(std::uint32_t index) const noexcept;
    void advance_operator() noexcept;
    [[nodiscard]] bool begins_line(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_line_end() const noexcept;
    [[nodiscard]] bool at_end_of_instructions();
    [[nodiscard]] bool at_end_of_operands() noexcept;
    [[nodiscard]] bool at_structured_text() const noexcept;
    [[nodiscard]] bool begins_inner_instruction(std::uint32_t index) const noexcept;
    [[nodiscard]] bool is_expression_operator(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_unknown_expression() const noexcept;
    [[nodiscard]] bool follows_skipped_parenthesis() const noexcept;
    [[nodiscard]] bool at_operator_field() const noexcept;
    [[nodiscard]] bool stands_outside_parentheses(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_arguments_without_call() const noexcept;
    const ast::IlOperation* parse_arguments_without_call();
    std::uint32_t accept_parenthesis_of_instructions();
    [[nodiscard]] bool lacks_parenthesis_of_instructions(std::uint32_t index) const noexcept;
    [[nodiscard]] bool begins_instruction_on_line() const noexcept;
    [[nodiscard]] bool at_return_for_name() const noexcept;
    [[nodiscard]] bool begins_outer_instruction(bool begun) const noexcept;
    [[nodiscard]] bool at_invocation_statement() const noexcept;
    [[nodiscard]] std::uint32_t closing_parenthesis(std::uint32_t open) const noexcept;
    [[nodiscard]] bool parenthesis_closes(std::uint32_t open) const noexcept {
        return closing_parenthesis(open) != count_;
    }
    /// From a token to the end of its line.
    struct RestOfLine {
        std::uint32_t parentheses = 0; ///< opened and not closed
        std::uint32_t brackets = 0;    ///< the same for `[`
        bool closed = false;           ///< it closes a parenthesis that it did not open
        TokenKind last = TokenKind::end_of_unit;
        std::uint32_t end = 0; ///< the first token of the next line
    };
    [[nodiscard]] RestOfLine rest_of_line(std::uint32_t i) const noexcept;
    [[nodiscard]] static bool wants_operand(TokenKind kind) noexcept;
    [[nodiscard]] bool expression_ends_on_line() const noexcept;
    [[nodiscard]] bool variable_breaks_off() const noexcept;
    void expect_line_end();
    void report_semicolon();
    void expect_line_end_in(MissingLineEnds& missing, std::string_view where);
    void report_line_ends(const MissingLineEnds& missing);
    void report_line_end();
    void report_operand_of(const IlOperatorRow& row);
    void close_il_parenthesis(std::uint32_t open, MissingLineEnds& missing,
                              std::string_view closing = "\n)");
    void check_variable(std::string_view writer, const ast::Expression& operand);
    void check_il_subscripts(const ast::Expression& variable);
    void skip_line();

    // ---- instruction_arguments.cpp: B.2.1, what stands in the parentheses of a call
    Children<ast::Node> parse_il_arguments(std::uint32_t open, const ast::Expression* first);
    void expect_parenthesis_of_arguments();
    [[nodiscard]] bool argument_lines_follow(std::uint32_t index) const noexcept;
    [[nodiscard]] bool statement_begins_in_parentheses(std::uint32_t open) const noexcept;
    [[nodiscard]] bool at_argument_lines() const noexcept;
    [[nodiscard]] bool has_mark_on_line(std::uint32_t index) const noexcept;
    [[nodiscard]] bool opens_line(std::uint32_t index) const noexcept;
    Children<ast::Node> parse_il_param_list(std::uint32_t open, bool function);
    void check_il_arguments(Children<ast::Node> arguments, std::uint32_t open);
    void expect_end_of_argument(MissingLineEnds& missing, bool closed, bool reported);
    void report_parenthesis_for_comma();
    void drop_intruder(std::string_view expected);
    void skip_argument();
    const ast::Node* parse_il_argument(bool formal);
    const ast::Identifier* parse_il_argument_name();
    void expect_argument_mark(TokenKind mark);
    const ast::Node* parse_il_output_argument();
    const ast::Node* parse_il_argument_value();
    void drop_intruder_before_operand();
    const ast::Node* parse_il_argument_list(std::uint32_t open);
    [[nodiscard]] bool at_formal_argument(std::uint32_t index) const noexcept;
    [[nodiscard]] bool begins_argument_line(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_argument_with_intruder() const noexcept;
    [[nodiscard]] bool at_stray_parenthesis_in_instructions(bool argument) const noexcept;
    [[nodiscard]] bool begins_name(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_end_of_il_arguments(bool closed);
    [[nodiscard]] bool at_stray_parenthesis() const noexcept;
    [[nodiscard]] bool at_intruder_before_argument() const noexcept;
    [[nodiscard]] bool has_mark(std::uint32_t name) const noexcept;
    [[nodiscard]] bool has_output_mark(std::uint32_t name) const noexcept;
    [[nodiscard]] bool lacks_mark(std::uint32_t name) const noexcept;
    [[nodiscard]] bool stands_for_mark(std::uint32_t index) const noexcept;
    /// Delimiters in the place of `:=` or `=>`.
    struct MarkSlip {
        TokenKind meant = TokenKind::end_of_unit;
        std::uint32_t end = 0; ///< the first token behind them; 0 when there are none
    };
    [[nodiscard]] MarkSlip mark_slip(std::uint32_t index) const noexcept;
    void accept_mark_slip(const MarkSlip& slip);
    [[nodiscard]] bool at_inner_instruction_of_argument(std::uint32_t index) const noexcept;
    [[nodiscard]] bool opens_instructions(std::uint32_t index) const noexcept;
    [[nodiscard]] std::int32_t surplus_parentheses() const noexcept;
    [[nodiscard]] bool lacks_parenthesis(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_stand_in_for_parenthesis() const noexcept;
    [[nodiscard]] bool at_end_of_argument_list() const noexcept;

    // ---- foreign_constructs.cpp
    bool report_foreign_element();
    [[nodiscard]] bool at_next_foreign_element() const noexcept;
    [[nodiscard]] bool at_foreign_member() const noexcept;
    void skip_foreign_member();
    void accept_foreign_modifiers();
    [[nodiscard]] bool at_foreign_clause() const noexcept;
    void skip_foreign_clauses();
    [[nodiscard]] bool at_reference_assignment() const noexcept;
    const ast::Statement* parse_reference_assignment(const ast::Expression* reference);
    const ast::TypeSpecification* parse_qualified_type_name();
    void accept_foreign_overlap();

    // ---- fragment.cpp
    void parse_elements_of_fragment(ListBuilder<ast::Node>& elements, FragmentKind kind);
    void add_missing_fragment(ListBuilder<ast::Node>& elements, FragmentKind kind);

    // ---- library.cpp
    const ast::Node* parse_library_element();
    bool accept_split_opener();
    void skip_stray_text(ListBuilder<ast::Node>& elements, std::uint32_t end);
    void parse_misspelt_elements(ListBuilder<ast::Node>& elements);
    [[nodiscard]] std::uint32_t find_misspelt_opener() const noexcept;
    [[nodiscard]] bool ends_library_element(std::uint32_t index) const noexcept;
    [[nodiscard]] TokenKind misspelt_opener(std::uint32_t index) const noexcept;
    [[nodiscard]] bool at_library_element_closer() const noexcept;
    void accept_extra_semicolon();
    void accept_extra_semicolon_before_body();

    std::string_view text_;
    Token* tokens_;                       // the last one is end_of_unit
    std::uint32_t count_;                 // without end_of_unit
    std::span<const Diagnostic> lexical_; // what the lexer reported
    std::uint32_t opener_;                // see UnitCut
    std::uint32_t at_ = 0;                // current token; only move_to() changes it
    TokenKind kind_{};                    // its kind, which nearly all questions are about
    std::uint32_t end_ = 0;               // one past the last token consumed
    std::uint32_t nesting_ = 0;
    bool nesting_reported_ = false;
    bool in_condition_ = false;            // `:=` is taken for `=`
    bool in_instructions_ = false;         // an expression ends with its line
    bool in_chart_ = false;                // the body, or what it is in an action of
    bool between_chart_elements_ = false;  // in statements that stand there
    bool members_unclosed_ = false;        // some METHOD lacks its closing word: none is looked for
    bool closer_assumed_ = false;          // the last closing word was missing, and its `;` with it
    std::uint32_t reported_at_ = no_token; // token of the last report
    std::optional<std::uint32_t> comma_assumed_at_;
    std::optional<std::uint32_t> invocation_; // the `(` of the last call that began a statement
    std::uint32_t il_parentheses_ = 0;        // of instructions, that are open
    std::uint32_t skipped_parentheses_ = 0;   // opened in lines of IL that were passed over
    Place place_ = Place::library;            // whose declarations and body are being read

    ParserArena& arena_;
    const ParseOptions& options_;
    std::pmr::vector<const ast::Node*> pending_; // of unfinished lists, the first `pending_count_`
    std::size_t pending_count_ = 0;
    std::size_t pending_room_ = 0;
    std::vector<Diagnostic> diagnostics_;
    const std::vector<Diagnostic>* expected_ = nullptr; // see expect_reports()
    std::optional<std::uint32_t> stopped_at_;
    std::optional<PresumedBody> presumed_body_;
    bool presumes_statements_ = false;
    bool misjudged_ = false;
    std::pmr::vector<OpenBlock> open_;

    struct ReservedWord {
        TokenKind kind;
        std::size_t diagnostic;
        std::string suffix; // that makes it a name of its own
    };
    std::vector<ReservedWord> reserved_words_;              // keywords used as names in this unit
    std::vector<std::uint32_t> standard_names_;             // the same for standard names: hashes
    std::array<std::int32_t, token_kind_count> unclosed_{}; // by closing word, see unclosed()
    bool balances_known_ = false;
    bool balanced_ = false;               // see balanced()
    std::uint32_t else_if_chain_end_ = 0; // last chain that was looked at, see at_else_if_for_elsif
    std::uint32_t else_if_block_ = 0;
    bool else_if_means_elsif_ = false;
    std::uint32_t chart_word_sought_from_ = no_token; // see next_chart_word()
    std::uint32_t chart_word_ = 0;
    std::uint64_t surveyed_ = 0; // tokens, by all surveys of bodies
};

} // namespace iecfront
