#include "parser/parser_arena.hpp"
#include "support/case_file.hpp"
#include "support/case_outcome.hpp"
#include "support/room_faults.hpp"

#include <gtest/gtest.h>
#include <string>
#include <string_view>

using namespace iecfront;
using namespace iecfront::test;

namespace {

constexpr std::size_t room = 100'000; // beside the reserve

TEST(ParserArena, HoldsBackMoreForEachLevel) {
    ParserArena arena(ParserArena::reserve_of_unit + room);
    EXPECT_EQ(arena.try_allocate(room + 1, 1), nullptr);
    arena.enter_level();
    EXPECT_EQ(arena.try_allocate(room - ParserArena::reserve_of_level + 1, 1), nullptr);
    EXPECT_NE(arena.try_allocate(room - ParserArena::reserve_of_level, 1), nullptr);
    arena.leave_level();
    EXPECT_NE(arena.try_allocate(ParserArena::reserve_of_level, 1), nullptr);
    EXPECT_FALSE(arena.full());
}

TEST(ParserArena, GivesTheReserveWhenItIsOpened) {
    ParserArena arena(ParserArena::reserve_of_unit + room);
    arena.enter_level();
    EXPECT_EQ(arena.try_allocate(room, 1), nullptr);
    arena.open_reserve();
    EXPECT_TRUE(arena.full());
    EXPECT_NE(arena.try_allocate(room + ParserArena::reserve_of_unit, 1), nullptr);
    arena.leave_level();
    arena.clear();
    EXPECT_FALSE(arena.full());
    EXPECT_EQ(arena.used(), 0U);
    EXPECT_EQ(arena.try_allocate(room + 1, 1), nullptr);
}

TEST(ParserArena, HoldsBackAnewWhenItWasSplit) {
    ParserArena arena(2 * (ParserArena::reserve_of_unit + room));
    EXPECT_NE(arena.try_allocate(ParserArena::reserve_of_unit + room, 1), nullptr);
    EXPECT_EQ(arena.split().capacity(), ParserArena::reserve_of_unit + room);
    EXPECT_EQ(arena.try_allocate(room + 1, 1), nullptr);
    EXPECT_NE(arena.try_allocate(room, 1), nullptr);
}

// Whatever the parser is about when there is no more room, it finds its way out.
TEST(ParserArena, CanBeFullWhereverItIs) {
    for (const CaseFile& file : all_case_files())
        for (const Case& one : file.cases)
            ASSERT_EQ(room_fault(source_text_of(one), options_of(one), 64), "")
                << file.path << ": " << one.title;
}

std::string repeated(std::string_view piece, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
        text += piece;
    return text;
}

// All that is open is left again, which takes nodes of its own.
TEST(ParserArena, CanBeFullWhereMuchIsOpen) {
    constexpr std::size_t depth = 250;
    for (const std::string_view open :
         {"(", "x[", "f(a := ", "NOT ", "a + (", "IF a THEN ", "CASE a OF 1: ", "REPEAT ",
          "FOR i := 1 TO 2 DO ", "WHILE a DO ", "IF a THEN ELSIF b THEN "}) {
        const bool statement = open.ends_with("THEN ") || open.ends_with("DO ") ||
                               open.ends_with("REPEAT ") || open.ends_with(": ");
        const std::string text = "PROGRAM p " + std::string(statement ? "" : "a := ") +
                                 repeated(open, depth) + " END_PROGRAM";
        EXPECT_EQ(room_fault(SourceText(text), {}, 200), "") << open;
    }
    const std::string types = "TYPE T : " + repeated("STRUCT a : ", depth) + "INT; END_TYPE";
    EXPECT_EQ(room_fault(SourceText(types), {}, 200), "");
    const std::string values = "TYPE T : A := " + repeated("[2(", depth) + "1; END_TYPE";
    EXPECT_EQ(room_fault(SourceText(values), {}, 200), "");
    const std::string instructions = "PROGRAM p\nLD a\n" + repeated("ADD(\nLD a\n", depth);
    EXPECT_EQ(room_fault(SourceText(instructions), {}, 200), "");
}

} // namespace
