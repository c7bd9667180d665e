#include "parser/parser.hpp"
#include "parser/parser_arena.hpp"
#include "parser/unit_parser.hpp"
#include "support/case_file.hpp"
#include "support/case_outcome.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace iecfront;
using iecfront::test::all_case_files;
using iecfront::test::Case;
using iecfront::test::CaseFile;

namespace {

TEST(ParserArena, HoldsBackMoreForEachLevel) {
    ParserArena arena(100'000);
    EXPECT_EQ(arena.try_allocate(90'000, 1), nullptr);
    EXPECT_NE(arena.try_allocate(80'000, 1), nullptr);
    arena.enter_level();
    EXPECT_EQ(arena.try_allocate(1, 1), nullptr);
    arena.leave_level();
    EXPECT_NE(arena.try_allocate(1, 1), nullptr);
    EXPECT_FALSE(arena.full());
}

TEST(ParserArena, GivesTheReserveWhenItIsOpened) {
    ParserArena arena(20'000);
    arena.enter_level();
    EXPECT_EQ(arena.try_allocate(10'000, 1), nullptr);
    arena.open_reserve();
    EXPECT_TRUE(arena.full());
    EXPECT_NE(arena.try_allocate(10'000, 1), nullptr);
    arena.leave_level();
    arena.clear();
    EXPECT_FALSE(arena.full());
    EXPECT_EQ(arena.used(), 0U);
    EXPECT_EQ(arena.try_allocate(10'000, 1), nullptr);
}

// A unit with all that the parser wants of it.
struct UnitText {
    std::string_view text;
    std::vector<Token> tokens;
    std::uint32_t opener;
};

std::vector<UnitText> units_of(const SourceText& source, const ParseOptions& options) {
    std::vector<UnitText> units;
    UnitReader reader(source.buffer(), source.encoding(), true, options);
    while (reader.next()) {
        UnitText unit{source.bytes().substr(reader.begin(), reader.end() - reader.begin()),
                      {},
                      reader.opener()};
        for (const Token token : reader.tokens())
            unit.tokens.push_back(token.moved_back(reader.begin()));
        unit.tokens.emplace_back(TokenKind::end_of_unit, reader.end() - reader.begin(), 0, true);
        units.push_back(std::move(unit));
    }
    return units;
}

// What the parser takes of `room` bytes beside the reserve; nothing when they do not suffice.
std::optional<std::size_t> used_of(UnitText unit, std::size_t room, const ParseOptions& options) {
    ParserArena arena(ParserArena::reserve_of_unit + room);
    Parser parser(unit.text, unit.tokens, {}, unit.opener, arena, options);
    (void)parser.parse_fragment(options.read_as);
    return arena.full() ? std::nullopt : std::optional(arena.used());
}

// Whatever the parser is about when there is no more room, it finds its way out.
TEST(ParserArena, CanBeFullAtAnyNode) {
    for (const CaseFile& file : all_case_files())
        for (const Case& one : file.cases) {
            const SourceText source = test::source_text_of(one);
            const ParseOptions options = test::options_of(one);
            for (const UnitText& unit : units_of(source, options)) {
                const auto needed = used_of(unit, 10'000'000, options);
                ASSERT_TRUE(needed.has_value()) << file.path << ": " << one.title;
                const std::size_t step = std::max<std::size_t>(4, *needed / 64 / 4 * 4);
                for (std::size_t room = 0; room < *needed; room += step)
                    ASSERT_FALSE(used_of(unit, room, options).has_value())
                        << file.path << ": " << one.title << ", " << room;
            }
        }
}

} // namespace
