#include "parser/misspelling.hpp"

#include <gtest/gtest.h>
#include <string>

namespace iecfront {
namespace {

TEST(Misspelling, TakesSlipsOfAKeyword) {
    for (const char* word : {"ENDIF", "end_fi", "END_IFF", "END_I", "EN_DIF", "End_If"})
        EXPECT_TRUE(is_misspelling(word, "END_IF")) << word;
    for (const char* word : {"FUNCTON", "FUNKTION", "FUNCTIONS", "FUCNTION"})
        EXPECT_TRUE(is_misspelling(word, "FUNCTION")) << word;
}

TEST(Misspelling, LeavesOtherNamesAlone) {
    for (const char* word : {"END", "ENDLESS", "IF", "x", "", "END_FOR"})
        EXPECT_FALSE(is_misspelling(word, "END_IF")) << word;
    EXPECT_FALSE(is_misspelling("JUNCTIONS_", "END_FUNCTION"));
    EXPECT_FALSE(is_misspelling(std::string(10'000, 'E'), "END_FUNCTION_BLOCK"));
}

TEST(Misspelling, TakesTheBeginningOfAClosingWord) {
    for (const char* word : {"END_CO", "end_conf", "ENDCONFIG", "END_CONFIGURATION"})
        EXPECT_TRUE(is_abbreviation(word, "END_CONFIGURATION")) << word;
    for (const char* word : {"END", "END_", "END_C", "END_CONG", "CONF", "END_CONFIGURATIONS", ""})
        EXPECT_FALSE(is_abbreviation(word, "END_CONFIGURATION")) << word;
}

TEST(Misspelling, TakesTheInitialsOfAClosingWord) {
    EXPECT_TRUE(is_abbreviation("END_FB", "END_FUNCTION_BLOCK"));
    EXPECT_TRUE(is_abbreviation("endfb", "END_FUNCTION_BLOCK"));
    EXPECT_FALSE(is_abbreviation("END_FB", "END_FUNCTION"));
    EXPECT_FALSE(is_abbreviation("END_FX", "END_FUNCTION_BLOCK"));
    EXPECT_FALSE(is_abbreviation(std::string(10'000, 'E'), "END_FUNCTION_BLOCK"));
}

} // namespace
} // namespace iecfront
