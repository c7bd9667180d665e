#include "lexer/standard_names.hpp"

#include <iecfront/lexer/standard_names.hpp>

#include <gtest/gtest.h>
#include <string>
#include <string_view>

using namespace iecfront;

namespace {

void expect_all(StandardName expected, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
        EXPECT_EQ(standard_name(name), expected) << name;
        EXPECT_TRUE(expected == StandardName::none ||
                    look_at_name(name.data(), 0, name.size()).may_be_standard)
            << name;
    }
}

TEST(StandardNames, FunctionsOf2515) {
    expect_all(StandardName::function,
               {"TRUNC", "ABS",  "SQRT", "LN",     "LOG",    "EXP",    "SIN",    "COS",
                "TAN",   "ASIN", "ACOS", "ATAN",   "ADD",    "MUL",    "SUB",    "DIV",
                "MOD",   "EXPT", "MOVE", "SHL",    "SHR",    "ROR",    "ROL",    "AND",
                "OR",    "XOR",  "NOT",  "SEL",    "MAX",    "MIN",    "LIMIT",  "MUX",
                "GT",    "GE",   "EQ",   "LE",     "LT",     "NE",     "LEN",    "LEFT",
                "RIGHT", "MID",  "FIND", "CONCAT", "INSERT", "DELETE", "REPLACE"});
}

TEST(StandardNames, FunctionsOfTime) {
    expect_all(StandardName::function,
               {"ADD_TIME", "ADD_TOD_TIME", "ADD_DT_TIME", "SUB_TIME", "SUB_DATE_DATE",
                "SUB_TOD_TIME", "SUB_TOD_TOD", "SUB_DT_TIME", "SUB_DT_DT", "MULTIME", "DIVTIME",
                "CONCAT_DATE_TOD", "DT_TO_TOD", "DT_TO_DATE", "DATE_AND_TIME_TO_TIME_OF_DAY",
                "DATE_AND_TIME_TO_DATE"});
}

TEST(StandardNames, FunctionBlocksOf2523) {
    expect_all(StandardName::function_block,
               {"SR",        "RS",        "R_TRIG",     "F_TRIG",    "CTU",       "CTD",
                "CTUD",      "TP",        "TON",        "TOF",       "CTU_DINT",  "CTU_LINT",
                "CTU_UDINT", "CTU_ULINT", "CTD_DINT",   "CTD_LINT",  "CTD_UDINT", "CTD_ULINT",
                "CTUD_DINT", "CTUD_LINT", "CTUD_UDINT", "CTUD_ULINT"});
    expect_all(StandardName::none, {"SEMA", "RTC", "CTU_INT", "TON_1", "CTUD_"});
}

TEST(StandardNames, TypedFunctionsByTheClassOfTheirType) {
    expect_all(StandardName::function,
               {"ADD_INT", "ADD_LREAL", "MUL_UDINT", "MOD_USINT", "SQRT_REAL", "ABS_DINT",
                "SHL_WORD", "AND_BOOL", "NOT_LWORD", "SEL_STRING", "MAX_TIME", "LIMIT_REAL",
                "MUX_DATE_AND_TIME", "GT_TIME_OF_DAY", "NE_WSTRING", "MOVE_BOOL", "LEN_WSTRING"});
    expect_all(StandardName::none,
               {"ADD_BOOL", "MUL_TIME", "MOD_REAL", "SQRT_INT", "SHL_INT", "AND_REAL", "LEN_INT",
                "TRUNC_REAL", "ADD_MYTYPE", "ADD_", "ADD_ANY_NUM", "ADD_INT_", "ADD__INT"});
}

TEST(StandardNames, EveryConversionBetweenTwoTypes) {
    const std::string_view types[] = {
        "BOOL",  "SINT", "INT",   "DINT",  "LINT",  "USINT",       "UINT",   "UDINT",
        "ULINT", "REAL", "LREAL", "TIME",  "DATE",  "TIME_OF_DAY", "TOD",    "DATE_AND_TIME",
        "DT",    "BYTE", "WORD",  "DWORD", "LWORD", "STRING",      "WSTRING"};
    const auto group = [](std::string_view type) {
        return type == "TIME_OF_DAY" ? "TOD" : type == "DATE_AND_TIME" ? "DT" : type;
    };
    for (const std::string_view from : types)
        for (const std::string_view to : types) {
            const std::string name = std::string(from) + "_TO_" + std::string(to);
            EXPECT_EQ(standard_name(name),
                      group(from) == group(to) ? StandardName::none : StandardName::function)
                << name;
        }
}

TEST(StandardNames, ConversionsOfBcd) {
    expect_all(StandardName::function,
               {"BYTE_BCD_TO_USINT", "WORD_BCD_TO_UINT", "LWORD_BCD_TO_ULINT", "DWORD_BCD_TO_USINT",
                "USINT_TO_BCD_BYTE", "ULINT_TO_BCD_WORD"});
    expect_all(StandardName::none,
               {"BOOL_BCD_TO_USINT", "WORD_BCD_TO_INT", "INT_TO_BCD_WORD", "UINT_TO_BCD_BOOL",
                "BCD_TO_INT", "INT_TO_BCD", "_BCD_TO_INT", "UINT_TO_BCD_"});
}

TEST(StandardNames, CaseIsNotSignificant) {
    EXPECT_EQ(standard_name("ton"), StandardName::function_block);
    EXPECT_EQ(standard_name("Limit"), StandardName::function);
    EXPECT_EQ(standard_name("int_TO_Real"), StandardName::function);
    EXPECT_EQ(standard_name("word_bcd_to_uint"), StandardName::function);
}

TEST(StandardNames, AllElseIsFree) {
    expect_all(StandardName::none, {"", "_", "_TO_", "INT_TO_", "_TO_INT", "INT_TO_FOO",
                                    "FOO_TO_INT", "x", "pump", "LD", "ST", "SINX", "INT_TO_REAL_X",
                                    "IF", "INT", "a_name_that_is_longer_than_any_of_the_standard"});
}

} // namespace
