#include "lexer/block_words.hpp"
#include "lexer/lexer.hpp"
#include "lexer/unit_cutter.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

using namespace iecfront;

namespace {

// Counted in the unit itself, as the parser does when nobody has told it.
bool is_balanced(std::span<const Token> unit) {
    std::map<TokenKind, int> unclosed; // by closing word
    for (const BlockWords& words : block_pairs)
        for (const Token token : unit)
            unclosed[words.closer] += token.kind() == words.opener ? 1 : 0;
    for (const Token token : unit)
        if (unclosed.contains(token.kind()))
            --unclosed[token.kind()];
    return std::ranges::all_of(unclosed, [](const auto& one) { return one.second == 0; });
}

std::vector<UnitCut> checked_cuts(const LexedText& lexed) {
    const std::vector<UnitCut> cuts = cut_units(lexed.tokens);
    EXPECT_FALSE(cuts.empty());
    std::uint32_t last = 0;
    for (const UnitCut& cut : cuts) {
        EXPECT_TRUE(cut.end_token > last || cuts.size() == 1);
        EXPECT_EQ(cut.balanced,
                  is_balanced(std::span(lexed.tokens).subspan(last, cut.end_token - last)));
        last = cut.end_token;
    }
    EXPECT_EQ(last, lexed.tokens.size() - 1);
    return cuts;
}

// The same cuts, asked for with a token more each time, and without those that were cut.
std::vector<UnitCut> cuts_of_growing_row(std::span<const Token> tokens) {
    UnitCutter cutter;
    std::vector<UnitCut> cuts;
    std::size_t dropped = 0;
    for (std::size_t end = 0; end <= tokens.size() && cuts.size() <= tokens.size();) {
        const auto row = tokens.first(end).subspan(dropped);
        const std::optional<UnitCut> cut = cutter.next(row, end == tokens.size());
        if (!cut) {
            ++end;
            continue;
        }
        const auto moved = static_cast<std::uint32_t>(dropped);
        cuts.push_back({cut->end_token + moved, cut->opener + moved, cut->balanced});
        cutter.drop(cut->end_token);
        dropped += cut->end_token;
    }
    return cuts;
}

std::string as_text(const std::vector<UnitCut>& cuts) {
    std::string text;
    for (const UnitCut& cut : cuts)
        text += std::to_string(cut.opener) + ".." + std::to_string(cut.end_token) +
                (cut.balanced ? " " : "! ");
    return text;
}

void expect_same_in_growing_row(const std::string& text) {
    const LexedText lexed = lex(text, Encoding::utf8);
    EXPECT_EQ(as_text(cuts_of_growing_row(lexed.tokens)), as_text(checked_cuts(lexed))) << text;
}

// The units of a text, each with its tokens separated by one space.
std::vector<std::string> units(std::string_view text) {
    const std::string terminated(text);
    const LexedText lexed = lex(terminated, Encoding::utf8);
    std::vector<std::string> result;
    std::uint32_t token = 0;
    for (const UnitCut& cut : checked_cuts(lexed)) {
        std::string unit;
        for (; token < cut.end_token; ++token) {
            unit += unit.empty() ? "" : " ";
            unit += text.substr(lexed.tokens[token].offset(), lexed.tokens[token].length());
        }
        result.push_back(unit);
    }
    return result;
}

using Units = std::vector<std::string>;

TEST(UnitCutter, TextWithoutTokensIsOneEmptyUnit) {
    EXPECT_EQ(units(""), Units{""});
    EXPECT_EQ(units(" (* c *)\n{p}"), Units{""});
}

TEST(UnitCutter, EveryLibraryElementIsAUnit) {
    EXPECT_EQ(units("TYPE A : INT; END_TYPE FUNCTION f : INT f := 1; END_FUNCTION "
                    "FUNCTION_BLOCK g END_FUNCTION_BLOCK program p end_program "
                    "CONFIGURATION c END_CONFIGURATION (* end *)"),
              (Units{"TYPE A : INT ; END_TYPE", "FUNCTION f : INT f := 1 ; END_FUNCTION",
                     "FUNCTION_BLOCK g END_FUNCTION_BLOCK", "program p end_program",
                     "CONFIGURATION c END_CONFIGURATION"}));
}

TEST(UnitCutter, SemicolonsBehindTheClosingWordBelongToIt) {
    EXPECT_EQ(units("PROGRAM p END_PROGRAM ; TYPE END_TYPE; ;"),
              (Units{"PROGRAM p END_PROGRAM ;", "TYPE END_TYPE ; ;"}));
}

TEST(UnitCutter, WaitsForAllSemicolonsBehindTheClosingWord) {
    for (const std::string unit : {"PROGRAM p END_PROGRAM ", "VAR_GLOBAL a : INT; END_VAR "})
        for (const std::size_t count : {1U, 10U, 100U})
            expect_same_in_growing_row(unit + std::string(count, ';') + " TYPE END_TYPE");
}

TEST(UnitCutter, WordsOfProseOpenNothing) {
    EXPECT_EQ(units("this is a PROGRAM that does\nPROGRAM that does, too\n"
                    "PROGRAM p END_PROGRAM the TYPE below TYPE t : INT; END_TYPE"),
              (Units{"this is a PROGRAM that does PROGRAM that does , too PROGRAM p END_PROGRAM",
                     "the TYPE below TYPE t : INT ; END_TYPE"}));
}

TEST(UnitCutter, ClosingWordOfAnotherDeclarationEndsABlockOfVariables) {
    EXPECT_EQ(
        units("PROGRAM p VAR a : INT; END_TYPE a := 1; END_PROGRAM PROGRAM q END_PROGRAM"),
        (Units{"PROGRAM p VAR a : INT ; END_TYPE a := 1 ; END_PROGRAM", "PROGRAM q END_PROGRAM"}));
}

TEST(UnitCutter, StrayTokensGoWithTheDeclarationBehindThem) {
    EXPECT_EQ(units("x := 1; PROGRAM p END_PROGRAM y z"),
              (Units{"x := 1 ; PROGRAM p END_PROGRAM", "y z"}));
    EXPECT_EQ(units("x"), Units{"x"});
}

TEST(UnitCutter, StrayClosingWordEndsAUnit) {
    EXPECT_EQ(units("x := 1; END_PROGRAM PROGRAM p END_PROGRAM"),
              (Units{"x := 1 ; END_PROGRAM", "PROGRAM p END_PROGRAM"}));
    EXPECT_EQ(units("END_TYPE END_TYPE"), (Units{"END_TYPE", "END_TYPE"}));
}

TEST(UnitCutter, AnyClosingWordEndsWhatIsOpen) {
    EXPECT_EQ(units("FUNCTION_BLOCK f x := 1; END_FUNCTION PROGRAM p END_PROGRAM"),
              (Units{"FUNCTION_BLOCK f x := 1 ; END_FUNCTION", "PROGRAM p END_PROGRAM"}));
}

TEST(UnitCutter, ClosingWordInTheMiddleOfALineOfSomethingElseEndsNothing) {
    for (const char* const source : {"TYPE a : INT ; END_TYPE : INT ; c : INT ; END_TYPE",
                                     "TYPE b : END_TYPE INT ; c : INT ; END_TYPE",
                                     "TYPE b : INT := END_TYPE ; c : INT ; END_TYPE",
                                     "PROGRAM p x := ( END_PROGRAM + 1 ) ; END_PROGRAM"})
        EXPECT_EQ(units(source), Units{source});
    EXPECT_EQ(
        units("PROGRAM p x := END_PROGRAM PROGRAM q x := END_PROGRAM ; PROGRAM r END_PROGRAM"),
        (Units{"PROGRAM p x := END_PROGRAM", "PROGRAM q x := END_PROGRAM ;",
               "PROGRAM r END_PROGRAM"}));
}

TEST(UnitCutter, WordBeforeAHeadCanBeAMisspeltClosingWord) {
    EXPECT_EQ(
        units("FUNCTION F : INT F := 1; END_FUNCION FUNCTION G : INT G := 2; END_FUNCTION"),
        (Units{"FUNCTION F : INT F := 1 ; END_FUNCION", "FUNCTION G : INT G := 2 ; END_FUNCTION"}));
}

TEST(UnitCutter, GlobalVariablesOutsideAreAUnit) {
    EXPECT_EQ(
        units("VAR_GLOBAL x : INT; END_VAR VAR_GLOBAL END_VAR; PROGRAM p END_PROGRAM"),
        (Units{"VAR_GLOBAL x : INT ; END_VAR", "VAR_GLOBAL END_VAR ;", "PROGRAM p END_PROGRAM"}));
    EXPECT_EQ(units("VAR_GLOBAL x : INT;\nPROGRAM p\nEND_PROGRAM"),
              (Units{"VAR_GLOBAL x : INT ;", "PROGRAM p END_PROGRAM"}));
    EXPECT_EQ(units("CONFIGURATION c VAR_GLOBAL END_VAR TASK t END_CONFIGURATION"),
              Units{"CONFIGURATION c VAR_GLOBAL END_VAR TASK t END_CONFIGURATION"});
    EXPECT_EQ(units("PROGRAM p VAR_GLOBAL x : INT; END_VAR END_PROGRAM"),
              Units{"PROGRAM p VAR_GLOBAL x : INT ; END_VAR END_PROGRAM"});
}

TEST(UnitCutter, DeclarationHeadEndsAnUnclosedUnit) {
    const struct {
        std::string_view head;
        std::string_view tail;
    } heads[] = {
        {"FUNCTION g : INT", "g := 1; END_FUNCTION"},
        {"FUNCTION g VAR_INPUT", "END_VAR END_FUNCTION"},
        {"FUNCTION g", "\nx := 1; END_FUNCTION"},
        {"FUNCTION_BLOCK g", "\nVAR END_VAR END_FUNCTION_BLOCK"},
        {"FUNCTION_BLOCK g VAR", "END_VAR END_FUNCTION_BLOCK"},
        {"PROGRAM g", "\nEND_PROGRAM"},
        {"PROGRAM step", "\nEND_PROGRAM"}, // a reserved word for a name
        {"PROGRAM g END_PROGRAM", ""},
        {"CONFIGURATION g", "\nEND_CONFIGURATION"},
        {"TYPE A :", "INT; END_TYPE"},
        {"TYPE\n  A :", "INT; END_TYPE"},
        {"TYPE END_TYPE", ""},
    };
    for (const auto& row : heads)
        for (const std::string_view before :
             {"FUNCTION f : INT f := 1;\n", "PROGRAM f x := 1; ",
              "FUNCTION_BLOCK f IF x THEN y; END_IF ", "TYPE A : INT\n", "CONFIGURATION c\n"}) {
            const std::string text =
                std::string(before) + std::string(row.head) + " " + std::string(row.tail);
            const Units found = units(text);
            if (before.starts_with("CONFIGURATION") && row.head == "PROGRAM g END_PROGRAM")
                continue; // may as well be a program configuration without its `:`
            ASSERT_EQ(found.size(), 2U) << text;
            EXPECT_EQ(found[0].substr(0, 4), before.substr(0, 4));
            EXPECT_EQ(found[1].substr(0, 4), row.head.substr(0, 4)) << text;
        }
}

TEST(UnitCutter, MisusedWordsOpenNothing) {
    for (const std::string_view inside :
         {"TYPE : INT;", "\nTYPE : INT;", "\nTYPE := 1;", "x.TYPE := 1;", "f(PROGRAM, 1);",
          "\nPROGRAM.x := 1;", "\nPROGRAM();", "\nCONFIGURATION : BOOL;", "x := FUNCTION;",
          "\nFUNCTION, y : INT;", "\nPROGRAM x := 1;", "\nPROGRAM x.y := 1;", "x TYPE A : INT;",
          "\nFUNCTION\ny := 1;", "x := CONFIGURATION y;"}) {
        const std::string text =
            "FUNCTION_BLOCK f x; " + std::string(inside) + "\nEND_FUNCTION_BLOCK";
        EXPECT_EQ(units(text).size(), 1U) << text;
    }
}

TEST(UnitCutter, MisusedWordsOutsideOpenNothing) {
    EXPECT_EQ(units("TYPE : x; PROGRAM p END_PROGRAM"), Units{"TYPE : x ; PROGRAM p END_PROGRAM"});
}

TEST(UnitCutter, ProgramConfigurationStaysInItsConfiguration) {
    for (const std::string_view program :
         {"PROGRAM p : q;", "PROGRAM p WITH t : q;", "PROGRAM RETAIN p : q;",
          "PROGRAM NON_RETAIN p WITH t : q (a := b);", "PROGRAM p\nWITH t : q;", "PROGRAM p q;",
          "PROGRAM\np : q;"}) {
        const std::string text = "CONFIGURATION c\nRESOURCE r ON s\n" + std::string(program) +
                                 "\nEND_RESOURCE\nEND_CONFIGURATION";
        EXPECT_EQ(units(text).size(), 1U) << text;
    }
}

TEST(UnitCutter, ProgramDeclarationEndsAnUnclosedConfiguration) {
    EXPECT_EQ(units("CONFIGURATION c\nPROGRAM p : q;\nPROGRAM q\nVAR END_VAR\nEND_PROGRAM"),
              (Units{"CONFIGURATION c PROGRAM p : q ;", "PROGRAM q VAR END_VAR END_PROGRAM"}));
    EXPECT_EQ(units("CONFIGURATION c\nPROGRAM q VAR END_VAR\nEND_PROGRAM"),
              (Units{"CONFIGURATION c", "PROGRAM q VAR END_VAR END_PROGRAM"}));
}

TEST(UnitCutter, UnclosedUnitAtTheEnd) {
    EXPECT_EQ(units("PROGRAM p x := 1;"), Units{"PROGRAM p x := 1 ;"});
    EXPECT_EQ(units("PROGRAM"), Units{"PROGRAM"});
    EXPECT_EQ(units("TYPE END_TYPE PROGRAM"), (Units{"TYPE END_TYPE", "PROGRAM"}));
}

TEST(UnitCutter, AnyWordsAreCutIntoRowsOfUnits) {
    constexpr std::string_view words[] = {"FUNCTION ",
                                          "END_FUNCTION ",
                                          "FUNCTION_BLOCK ",
                                          "END_FUNCTION_BLOCK ",
                                          "PROGRAM ",
                                          "END_PROGRAM ",
                                          "TYPE ",
                                          "END_TYPE ",
                                          "CONFIGURATION ",
                                          "END_CONFIGURATION ",
                                          "VAR_GLOBAL ",
                                          "VAR ",
                                          "END_VAR ",
                                          "IF ",
                                          "END_IF ",
                                          "x ",
                                          ": ",
                                          ":= ",
                                          "; ",
                                          "\n",
                                          "RETAIN ",
                                          "WITH "};
    std::mt19937 random(20032); // fixed: a failure has to come back
    for (int round = 0; round < 20000; ++round) {
        std::string text;
        for (auto i = random() % (round % 100 == 0 ? 300 : 16); i > 0; --i)
            text += words[random() % std::size(words)];
        expect_same_in_growing_row(text);
        ASSERT_FALSE(HasFailure()) << text;
    }
}

// What opened an earlier unit says nothing of a later one.
TEST(UnitCutter, StrayWordsAreCutAlikeWhereverTheyStand) {
    EXPECT_EQ(units("a b END_TYPE c d"), Units{"a b END_TYPE c d"});
    EXPECT_EQ(units("TYPE END_TYPE\na b END_TYPE c d"),
              (Units{"TYPE END_TYPE", "a b END_TYPE c d"}));
}

} // namespace
