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

} // namespace
} // namespace iecfront
