#include "parser/unit_parser.hpp"

#include "diagnostics/sort_by_place.hpp"
#include "lexer/encoding_check.hpp"
#include "parser/parser.hpp"
#include "parser/repair.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <memory_resource>
#include <optional>
#include <utility>

namespace iecfront {
namespace {

/// Tokens that are read at a time: as many as fit the nearest caches, and some units.
constexpr std::size_t tokens_at_a_time = 2048;

/// Of a block for the tokens and nodes of many units.
constexpr std::size_t shared_block = 512 * 1024;

/// Of arena for each token of a unit: enough for most source.
constexpr std::size_t bytes_per_token = 32;

/// Of scratch memory for a unit: enough for most, so that the parser need not ask for any.
constexpr std::size_t usual_scratch = 8 * 1024;

/// True when a diagnostic of the lexer at `range` concerns what stands before `end`, where a unit
/// ends. An empty range marks the place behind a token where something is missing.
[[nodiscard]] bool belongs_before(TextRange range, std::uint32_t end) noexcept {
    return range.begin < end || (range.begin == end && range.empty());
}

/// Bytes that are no text are full of them: the first in a unit speaks for all.
[[nodiscard]] bool is_about_control_character(const Diagnostic& diagnostic) {
    if (diagnostic.id != DiagnosticId::unexpected_character)
        return false;
    const auto character = std::get<char32_t>(diagnostic.arguments.front());
    return character < U' ' || character == U'\x7F';
}

[[nodiscard]] bool is_about_long_identifier(const Diagnostic& diagnostic) noexcept {
    return diagnostic.id == DiagnosticId::identifier_too_long;
}

[[nodiscard]] std::size_t memory_of_findings(const Unit::Parts& parts) noexcept {
    return parts.diagnostics.size() * ParseOptions::memory_of_finding;
}

/// The first one of a unit speaks for all.
void report_long_identifier(std::span<const Token> tokens, std::uint32_t limit,
                            std::vector<Diagnostic>& diagnostics) {
    const auto found = std::ranges::find_if(tokens, [limit](Token token) {
        return token.kind() == TokenKind::identifier && token.length() > limit;
    });
    if (found != tokens.end())
        diagnostics.push_back(
            {DiagnosticId::identifier_too_long, found->range(), {std::uint64_t{limit}}, {}, {}});
}

/// A comment or pragma that is closed says nothing of the tokens around it.
[[nodiscard]] bool is_about_whole_comment(const Diagnostic& diagnostic) noexcept {
    return diagnostic.id == DiagnosticId::line_comment ||
           diagnostic.id == DiagnosticId::c_comment || diagnostic.id == DiagnosticId::pragma;
}

/// Makes the tree as the text is. Nothing when statements were presumed where there are none.
[[nodiscard]] std::optional<Reading> read_unrepaired(const ParserInput& input, ParserArena& arena,
                                                     bool presume_statements) {
    std::array<std::byte, usual_scratch> block;
    std::pmr::monotonic_buffer_resource scratch(block.data(), block.size(),
                                                std::pmr::new_delete_resource());
    Parser parser(input.text, input.tokens, input.lexical, input.opener, arena, input.options,
                  scratch);
    if (input.balanced)
        parser.know_balanced();
    if (presume_statements)
        parser.presume_statements();
    Reading reading{parser.parse_fragment(input.options.read_as), {}};
    reading.reports = parser.take_diagnostics();
    return parser.misjudged() ? std::nullopt : std::optional(std::move(reading));
}

/// Makes the tree. Where a single token is out of place, it is that of the repaired text. Nothing
/// when there was not enough room.
[[nodiscard]] std::optional<Reading> read(const ParserInput& input, ParserArena& arena) {
    const std::size_t kept = arena.used();
    // What the lexer has reported the parser does not report again, and would not ask for it.
    const bool may_presume = std::ranges::all_of(input.lexical, is_about_whole_comment);
    std::optional<Reading> reading = read_unrepaired(input, arena, may_presume);
    if (!reading && !arena.full()) {
        arena.rewind(kept);
        reading = read_unrepaired(input, arena, false);
    }
    if (reading && !arena.full())
        if (std::optional<Reading> repaired = repair(input, reading->reports, arena, kept))
            reading = std::move(repaired);
    return arena.full() ? std::nullopt : std::move(reading);
}

[[nodiscard]] bool holds_line_end(std::string_view text) noexcept {
    return text.find_first_of("\r\n") != std::string_view::npos;
}

} // namespace

void leave_unexamined(Unit::Parts& parts, Diagnostic report) {
    parts.arena = Arena(sizeof(ast::LibraryUnit) + sizeof(Trivia));
    parts.tokens = {};
    parts.trivia = {};
    const auto size = static_cast<std::uint32_t>(parts.text.size());
    const Trivia all{{0, size}, TriviaKind::comment};
    if (size > 0)
        parts.trivia = parts.arena.copy(std::span(&all, 1));
    parts.root = parts.arena.create<ast::LibraryUnit>();
    parts.diagnostics.clear();
    parts.diagnostics.push_back(std::move(report));
}

UnitReader::UnitReader(std::shared_ptr<const std::string> buffer, Encoding encoding,
                       bool at_file_start, const ParseOptions& options, UnitMemory memory)
    : buffer_(std::move(buffer)),
      encoding_(encoding),
      options_(options),
      memory_(memory),
      lexer_(*buffer_, encoding, at_file_start) {}

bool UnitReader::next() {
    if (last_)
        return false;
    begin_ = end_;
    token_ = cut_.end_token;
    trivia_ = trivia_end_;
    diagnostic_ = diagnostic_end_;
    open_end_ = open_end_end_;
    read_cut();
    last_ = lexer_.done() && cut_.end_token + 1 == lexer_.tokens().size();
    end_ = last_ ? static_cast<std::uint32_t>(buffer_->size()) : end_of_cut();

    const auto pass = [this](auto row, std::size_t& at, auto&& begin_of) {
        while (at < row.size() && begin_of(row[at]) < end_)
            ++at;
    };
    pass(lexer_.trivia(), trivia_end_, [](const Trivia& one) { return one.range.begin; });
    pass(lexer_.open_ends(), open_end_end_, [](const OpenEnd& one) { return one.begin; });
    const std::span<const Diagnostic> diagnostics = lexer_.diagnostics();
    while (diagnostic_end_ < diagnostics.size() &&
           (last_ || belongs_before(diagnostics[diagnostic_end_].range, end_)))
        ++diagnostic_end_;
    return true;
}

void UnitReader::read_cut() {
    if (options_.read_as != FragmentKind::library) {
        lexer_.read(std::numeric_limits<std::size_t>::max());
        const auto end = static_cast<std::uint32_t>(lexer_.tokens().size() - 1);
        cut_ = {end, end, false};
        return;
    }
    for (;;) {
        if (const auto cut = cutter_.next(lexer_.tokens(), lexer_.done())) {
            cut_ = *cut;
            return;
        }
        read_more();
    }
}

/// Drops what stands before the unit, and reads on: the longer the unit the more, so that none is
/// moved often.
void UnitReader::read_more() {
    const std::size_t left = lexer_.tokens().size() - token_;
    lexer_.drop(token_, trivia_, diagnostic_, open_end_);
    cutter_.drop(token_);
    token_ = 0;
    trivia_end_ -= std::exchange(trivia_, 0);
    diagnostic_end_ -= std::exchange(diagnostic_, 0);
    open_end_end_ -= std::exchange(open_end_, 0);
    lexer_.read(2 * left + tokens_at_a_time);
}

/// The end of the last token with the comments and pragmas that begin on its line, unless the next
/// token stands there as well: then they are taken to speak of that.
std::uint32_t UnitReader::end_of_cut() const noexcept {
    const std::string_view text = *buffer_;
    const std::uint32_t token_end = lexer_.tokens()[cut_.end_token - 1].end();
    const std::uint32_t next_token = lexer_.tokens()[cut_.end_token].offset();
    const std::span<const Trivia> all = lexer_.trivia();
    auto trivia = std::lower_bound(
        all.begin() + static_cast<std::ptrdiff_t>(trivia_), all.end(), token_end,
        [](const Trivia& one, std::uint32_t place) { return one.range.begin < place; });
    std::uint32_t end = token_end;
    for (; trivia != all.end() && trivia->range.begin < next_token; ++trivia) {
        if (holds_line_end(text.substr(end, trivia->range.begin - end)))
            return end;
        end = trivia->range.end;
        if (holds_line_end(text.substr(trivia->range.begin, trivia->range.size())))
            return end;
    }
    return holds_line_end(text.substr(end, next_token - end)) ? end : token_end;
}

bool UnitReader::depends_on_rest() const noexcept {
    const auto ends = lexer_.open_ends().subspan(open_end_, open_end_end_ - open_end_);
    return std::ranges::any_of(ends, [this](const OpenEnd& one) { return one.looked_to > end_; });
}

std::uint32_t UnitReader::looked_to(std::uint32_t place) const noexcept {
    std::uint32_t result = 0;
    for (const OpenEnd& one : lexer_.open_ends().subspan(open_end_))
        if (one.begin < place)
            result = std::max(result, one.looked_to);
    return result;
}

void UnitReader::take_text(Unit::Parts& parts) const {
    parts.encoding = encoding_;
    if (memory_ == UnitMemory::shared) {
        parts.buffer = buffer_;
        parts.text = std::string_view(*buffer_).substr(begin_, end_ - begin_);
    } else {
        parts.buffer = std::make_shared<const std::string>(*buffer_, begin_, end_ - begin_);
        parts.text = *parts.buffer;
    }
}

std::shared_ptr<const Unit> UnitReader::parse() {
    Unit::Parts parts;
    take_text(parts);
    parts.depends_on_rest = depends_on_rest();
    parts.diagnostics = take_diagnostics();
    if (auto broken = check_encoding(parts.text, parts.encoding))
        parts.diagnostics.push_back(std::move(*broken));
    if (!parse_into(parts))
        leave_unexamined(parts, {DiagnosticId::unit_too_large,
                                 {},
                                 {std::uint64_t{options_.maximum_unit_memory}},
                                 {},
                                 {}});
    sort_by_place(parts.diagnostics);
    return std::make_shared<const Unit>(std::move(parts));
}

/// False when it takes more memory than is allowed: this depends on the unit alone, and not on how
/// much room there is at first.
bool UnitReader::parse_into(Unit::Parts& parts) {
    const std::size_t least = tokens().size_bytes() + sizeof(Token) + trivia().size_bytes();
    if (least + memory_of_findings(parts) > options_.maximum_unit_memory)
        return false;
    if (parse_in_shared_room(parts)) {
        if (!is_allowed(shared_room_, parts))
            return false;
        parts.arena = shared_room_.split();
        return true;
    }
    if (!parse_in_own_room(parts) || !is_allowed(own_room_, parts))
        return false;
    move_out(parts);
    return true;
}

bool UnitReader::is_allowed(const ParserArena& room, const Unit::Parts& parts) const noexcept {
    return room.used() + memory_of_findings(parts) <= options_.maximum_unit_memory;
}

/// False when there is no block for it, or not enough room in it. What is lost of a block is less
/// than `most_of_a_unit`.
bool UnitReader::parse_in_shared_room(Unit::Parts& parts) {
    constexpr std::size_t most_of_a_unit = shared_block / 4;
    const std::size_t usual = usual_room();
    if (memory_ == UnitMemory::own || usual > most_of_a_unit ||
        most_room() < shared_block) // there it could have more room than alone
        return false;
    if (shared_room_.capacity() < usual) {
        if (buffer_->size() - begin_ < shared_block / 2) // the tree of the rest may not fill one
            return false;
        shared_room_ = ParserArena(shared_block);
    }
    if (parse_in(shared_room_, parts))
        return true;
    if (shared_room_.capacity() < most_of_a_unit)
        shared_room_ = ParserArena();
    return false;
}

/// False when it takes more than can be allowed.
bool UnitReader::parse_in_own_room(Unit::Parts& parts) {
    if (own_room_.capacity() < usual_room())
        own_room_ = ParserArena(usual_room());
    while (!parse_in(own_room_, parts)) {
        const std::size_t capacity = own_room_.capacity();
        if (capacity >= most_room() || own_room_.refused())
            return false;
        own_room_ = ParserArena(); // first, so that both are not there at once
        own_room_ = ParserArena(std::min(2 * capacity, most_room()));
    }
    return true;
}

/// For a unit as large as is allowed, read once and once more with a token repaired, and as deep.
std::size_t UnitReader::most_room() const noexcept {
    // A relative pointer reaches as far.
    constexpr std::uint64_t addressable =
        std::min<std::uint64_t>(std::numeric_limits<std::size_t>::max() / 4, (1ULL << 33U) - 8);
    const std::uint64_t levels = std::uint64_t{options_.maximum_nesting} + 1;
    return static_cast<std::size_t>(std::min(2 * std::uint64_t{options_.maximum_unit_memory} +
                                                 ParserArena::reserve_of_unit +
                                                 levels * ParserArena::reserve_of_level,
                                             addressable));
}

/// What most units of so many tokens need.
std::size_t UnitReader::usual_room() const noexcept {
    const std::size_t usual = (tokens().size() + 1) * bytes_per_token + trivia().size_bytes() +
                              ParserArena::usual_reserve;
    return std::min(usual, most_room());
}

/// False when there is not enough room.
bool UnitReader::parse_in(ParserArena& room, Unit::Parts& parts) {
    room.clear();
    const std::span<Token> tokens = copy_tokens(room);
    const std::span<const Trivia> trivia = copy_trivia(room);
    std::vector<Diagnostic>& lexical = parts.diagnostics;
    std::erase_if(lexical, is_about_long_identifier); // reported when there was not enough room
    if (lengths_ > options_.maximum_identifier_length)
        report_long_identifier(tokens, options_.maximum_identifier_length, lexical);
    sort_by_place(lexical);
    std::optional<Reading> reading =
        read({parts.text, tokens, lexical, opener(), balanced(), options_}, room);
    if (!reading)
        return false;
    std::ranges::move(reading->reports, std::back_inserter(lexical));
    parts.tokens = tokens.first(tokens.size() - 1);
    parts.trivia = trivia;
    parts.root = reading->root;
    return true;
}

/// To a block that is just large enough.
void UnitReader::move_out(Unit::Parts& parts) const {
    parts.arena = own_room_.trimmed();
    parts.tokens = {parts.arena.counterpart(parts.tokens.data(), own_room_), parts.tokens.size()};
    if (!parts.trivia.empty())
        parts.trivia = {parts.arena.counterpart(parts.trivia.data(), own_room_),
                        parts.trivia.size()};
    parts.root = parts.arena.counterpart(parts.root, own_room_);
}

/// With end_of_unit behind them.
std::span<Token> UnitReader::copy_tokens(ParserArena& room) {
    const std::span<const Token> from = tokens();
    auto* const to =
        static_cast<Token*>(room.allocate((from.size() + 1) * sizeof(Token), alignof(Token)));
    const std::uint32_t begin = begin_;
    std::uint32_t lengths = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        to[i] = from[i].moved_back(begin);
        lengths |= to[i].length();
    }
    lengths_ = lengths;
    to[from.size()] = Token(TokenKind::end_of_unit, end_ - begin, 0, true);
    return {to, from.size() + 1};
}

std::span<const Trivia> UnitReader::copy_trivia(ParserArena& room) const {
    const std::span<const Trivia> from = trivia();
    if (from.empty())
        return {};
    auto* const to = static_cast<Trivia*>(room.allocate(from.size_bytes(), alignof(Trivia)));
    for (std::size_t i = 0; i < from.size(); ++i)
        to[i] = {{from[i].range.begin - begin_, from[i].range.end - begin_}, from[i].kind};
    return {to, from.size()};
}

std::vector<Diagnostic> UnitReader::take_diagnostics() {
    std::vector<Diagnostic> diagnostics;
    bool control_found = false;
    for (Diagnostic& here :
         lexer_.diagnostics().subspan(diagnostic_, diagnostic_end_ - diagnostic_)) {
        const bool control = is_about_control_character(here);
        if (!control || !control_found)
            diagnostics.push_back(shifted(std::move(here), 0U - begin_));
        control_found = control_found || control;
    }
    return diagnostics;
}

} // namespace iecfront
