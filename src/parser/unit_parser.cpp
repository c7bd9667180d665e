#include "parser/unit_parser.hpp"

#include "diagnostics/sort_by_place.hpp"
#include "lexer/encoding_check.hpp"
#include "parser/parser.hpp"
#include "parser/repair.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace iecfront {
namespace {

/// Where each unit stands among tokens, trivia and diagnostics, while going through them once.
class UnitParser {
public:
    UnitParser(const LexedUnits& source, const ParseOptions& options)
        : source_(source), options_(options) {}

    [[nodiscard]] std::shared_ptr<const Unit> parse_next() {
        const std::uint32_t end_token = source_.cuts[cut_].end_token;
        const std::uint32_t opener = source_.cuts[cut_].opener - token_;
        const std::uint32_t end = source_.unit_end(cut_);
        const bool last = ++cut_ == source_.cuts.size();

        Unit::Parts parts;
        parts.buffer = source_.buffer;
        parts.encoding = source_.encoding;
        parts.text = std::string_view(*source_.buffer).substr(begin_, end - begin_);
        parts.depends_on_rest = take_open_ended(end);
        parts.arena = Arena(std::size_t{end_token - token_ + 2} * bytes_per_token);
        const std::span<const Token> tokens = take_tokens(end_token, end, parts.arena);
        parts.tokens = tokens.first(tokens.size() - 1);
        parts.trivia = take_trivia(end, parts.arena);
        parts.diagnostics = take_diagnostics(end, last);
        if (auto broken = check_encoding(parts.text, parts.encoding))
            parts.diagnostics.push_back(std::move(*broken));
        if (longest_ > options_.maximum_identifier_length)
            report_long_identifier(tokens, parts.diagnostics);
        sort_by_place(parts.diagnostics);

        parse({parts.text, tokens, parts.diagnostics, opener, options_}, parts);
        sort_by_place(parts.diagnostics);
        begin_ = end;
        return std::make_shared<const Unit>(std::move(parts));
    }

    [[nodiscard]] bool done() const noexcept { return cut_ == source_.cuts.size(); }

private:
    /// Of arena for the tokens and nodes of a unit: less than most source needs, as what is left of
    /// the first chunk is lost, while some more chunks cost little.
    static constexpr std::size_t bytes_per_token = 24;

    std::span<const Token> take_tokens(std::uint32_t end_token, std::uint32_t end, Arena& arena) {
        const std::size_t count = end_token - token_;
        auto* tokens =
            static_cast<Token*>(arena.allocate((count + 1) * sizeof(Token), alignof(Token)));
        longest_ = 0;
        for (std::size_t i = 0; i < count; ++i) {
            tokens[i] = source_.lexed.tokens[token_ + i].moved_back(begin_);
            longest_ = std::max(longest_, tokens[i].length());
        }
        tokens[count] = Token(TokenKind::end_of_unit, end - begin_, 0, true);
        token_ = end_token;
        return {tokens, count + 1};
    }

    std::span<const Trivia> take_trivia(std::uint32_t end, Arena& arena) {
        std::vector<Trivia> trivia;
        for (; trivia_ < source_.lexed.trivia.size(); ++trivia_) {
            const Trivia& here = source_.lexed.trivia[trivia_];
            if (here.range.begin >= end)
                break;
            trivia.push_back({{here.range.begin - begin_, here.range.end - begin_}, here.kind});
        }
        return arena.copy(std::span<const Trivia>(trivia));
    }

    /// True when some comment or pragma of the unit is open-ended.
    bool take_open_ended(std::uint32_t end) {
        const std::size_t before = open_ended_;
        const std::vector<std::uint32_t>& all = source_.lexed.open_ended;
        while (open_ended_ < all.size() && all[open_ended_] < end)
            ++open_ended_;
        return open_ended_ > before;
    }

    std::vector<Diagnostic> take_diagnostics(std::uint32_t end, bool last) {
        std::vector<Diagnostic> diagnostics;
        bool control_found = false;
        for (; diagnostic_ < source_.lexed.diagnostics.size(); ++diagnostic_) {
            const Diagnostic& here = source_.lexed.diagnostics[diagnostic_];
            if (!belongs_before(here.range, end) && !last)
                break;
            const bool control = is_about_control_character(here);
            if (!control || !control_found)
                diagnostics.push_back(shifted(here, 0U - begin_));
            control_found = control_found || control;
        }
        return diagnostics;
    }

    /// The first one of a unit speaks for all.
    void report_long_identifier(std::span<const Token> tokens,
                                std::vector<Diagnostic>& diagnostics) const {
        const std::uint32_t limit = options_.maximum_identifier_length;
        const auto found = std::ranges::find_if(tokens, [limit](Token token) {
            return token.kind() == TokenKind::identifier && token.length() > limit;
        });
        if (found != tokens.end())
            diagnostics.push_back({DiagnosticId::identifier_too_long,
                                   found->range(),
                                   {std::uint64_t{limit}},
                                   {},
                                   {}});
    }

    // Bytes that are no text are full of them: the first in a unit speaks for all.
    static bool is_about_control_character(const Diagnostic& diagnostic) {
        if (diagnostic.id != DiagnosticId::unexpected_character)
            return false;
        const auto character = std::get<char32_t>(diagnostic.arguments.front());
        return character < U' ' || character == U'\x7F';
    }

    /// Makes the tree. Where a single token is out of place, it is that of the repaired text.
    static void parse(const ParserInput& input, Unit::Parts& parts) {
        Parser parser(input.text, input.tokens, input.lexical, input.opener, parts.arena,
                      input.options);
        Reading reading{parser.parse_fragment(input.options.read_as), {}};
        reading.reports = parser.take_diagnostics();
        if (std::optional<Reading> repaired = repair(input, reading.reports, parts.arena))
            reading = std::move(*repaired);
        parts.root = reading.root;
        std::ranges::move(reading.reports, std::back_inserter(parts.diagnostics));
    }

    const LexedUnits& source_;
    const ParseOptions& options_;
    std::size_t cut_ = 0;
    std::uint32_t begin_ = 0;
    std::uint32_t longest_ = 0; // token of the unit
    std::uint32_t token_ = 0;
    std::size_t trivia_ = 0;
    std::size_t open_ended_ = 0;
    std::size_t diagnostic_ = 0;
};

} // namespace

bool belongs_before(TextRange range, std::uint32_t end) noexcept {
    return range.begin < end || (range.begin == end && range.empty());
}

std::uint32_t LexedUnits::unit_end(std::size_t index) const noexcept {
    const std::uint32_t end_token = cuts[index].end_token;
    const bool last = index + 1 == cuts.size();
    return last || end_token == 0 ? size() : end_on_line(end_token);
}

std::uint32_t LexedUnits::end_on_line(std::uint32_t end_token) const noexcept {
    const auto line_ends_in = [this](std::uint32_t begin, std::uint32_t end) {
        return std::string_view(*buffer).substr(begin, end - begin).find_first_of("\r\n") !=
               std::string_view::npos;
    };
    const std::uint32_t token_end = lexed.tokens[end_token - 1].end();
    const std::uint32_t next_token = lexed.tokens[end_token].offset();
    std::uint32_t end = token_end;
    auto trivia = std::ranges::lower_bound(lexed.trivia, end, {},
                                           [](const Trivia& one) { return one.range.begin; });
    for (; trivia != lexed.trivia.end() && trivia->range.begin < next_token; ++trivia) {
        if (line_ends_in(end, trivia->range.begin))
            return end;
        end = trivia->range.end;
        if (line_ends_in(trivia->range.begin, end))
            return end;
    }
    return line_ends_in(end, next_token) ? end : token_end;
}

LexedUnits lex_units(std::shared_ptr<const std::string> buffer, Encoding encoding,
                     bool at_file_start, FragmentKind read_as) {
    LexedUnits result{std::move(buffer), encoding, {}, {}};
    result.lexed = lex(*result.buffer, encoding, at_file_start);
    const auto end = static_cast<std::uint32_t>(result.lexed.tokens.size() - 1);
    if (read_as == FragmentKind::library)
        result.cuts = cut_units(result.lexed.tokens);
    else
        result.cuts.push_back({end, end});
    return result;
}

std::vector<std::shared_ptr<const Unit>> parse_units(const LexedUnits& source,
                                                     const ParseOptions& options) {
    std::vector<std::shared_ptr<const Unit>> units;
    units.reserve(source.cuts.size());
    UnitParser parser(source, options);
    while (!parser.done())
        units.push_back(parser.parse_next());
    return units;
}

} // namespace iecfront
