#include "support/room_faults.hpp"

#include "parser/parser.hpp"
#include "parser/parser_arena.hpp"
#include "parser/unit_parser.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace iecfront::test {
namespace {

constexpr std::size_t enough = 1'000'000; // for any unit of a test, in bytes

/// What the parser reads of the unit where `reader` stands.
struct UnitText {
    std::string_view text;
    std::vector<Token> tokens;
    std::uint32_t opener;
    bool balanced;
};

[[nodiscard]] UnitText unit_at(const UnitReader& reader, std::string_view bytes) {
    const std::uint32_t size = reader.end() - reader.begin();
    UnitText unit{bytes.substr(reader.begin(), size), {}, reader.opener(), reader.balanced()};
    for (const Token token : reader.tokens())
        unit.tokens.push_back(token.moved_back(reader.begin()));
    unit.tokens.emplace_back(TokenKind::end_of_unit, size, 0, true);
    return unit;
}

/// What the nodes take of `room` bytes beside the reserve; nothing when these do not suffice.
[[nodiscard]] std::optional<std::size_t> used_of(UnitText unit, std::size_t room,
                                                 const ParseOptions& options) {
    ParserArena arena(ParserArena::reserve_of_unit + room);
    Parser parser(unit.text, unit.tokens, {}, unit.opener, arena, options);
    if (unit.balanced)
        parser.know_balanced();
    (void)parser.parse_fragment(options.read_as);
    return arena.full() ? std::nullopt : std::optional(arena.used());
}

[[nodiscard]] std::string room_fault(const UnitText& unit, const ParseOptions& options,
                                     std::size_t sizes) {
    const std::optional<std::size_t> needed = used_of(unit, enough, options);
    if (!needed)
        return "the nodes take too much memory";
    const std::size_t step = std::max<std::size_t>(4, *needed / sizes / 4 * 4);
    for (std::size_t room = 0; room < *needed; room += step)
        if (used_of(unit, room, options).has_value())
            return "the parser does with " + std::to_string(room) + " bytes, and takes " +
                   std::to_string(*needed);
    return {};
}

} // namespace

std::string room_fault(const SourceText& source, const ParseOptions& options, std::size_t sizes) {
    ParseOptions unlimited = options; // by anything but the room
    unlimited.maximum_unit_memory = ParseOptions().maximum_unit_memory;
    UnitReader reader(source.buffer(), source.encoding(), true, unlimited);
    std::string fault;
    while (fault.empty() && reader.next())
        fault = room_fault(unit_at(reader, source.bytes()), unlimited, sizes);
    return fault;
}

} // namespace iecfront::test
