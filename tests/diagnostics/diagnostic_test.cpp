#include <iecfront/diagnostics/diagnostic.hpp>

#include <gtest/gtest.h>
#include <string>

using namespace iecfront;

namespace {

Diagnostic make(DiagnosticId id, std::vector<DiagnosticArgument> arguments = {}) {
    Diagnostic diagnostic;
    diagnostic.id = id;
    diagnostic.arguments = std::move(arguments);
    return diagnostic;
}

DiagnosticFix edit(TextRange range, std::string replacement) {
    DiagnosticFix fix;
    fix.edits.push_back({range, std::move(replacement)});
    return fix;
}

TEST(Catalogue, EveryRowIsFoundByIdCodeAndName) {
    for (const DiagnosticInfo& row : diagnostic_catalogue()) {
        EXPECT_EQ(&diagnostic_info(row.id), &row);
        EXPECT_EQ(find_diagnostic(code_string(row.id)), &row);
        EXPECT_EQ(find_diagnostic(row.name), &row);
    }
}

TEST(Catalogue, IsSearchedInAnyCase) {
    const DiagnosticInfo* row = find_diagnostic("iec2006");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->id, DiagnosticId::missing_semicolon);
    EXPECT_EQ(row->name, "missing-semicolon");
    EXPECT_EQ(find_diagnostic("Missing-Semicolon"), row);
    EXPECT_EQ(find_diagnostic("missing_semicolon"), nullptr);
    EXPECT_EQ(find_diagnostic("2006"), nullptr);
    EXPECT_EQ(find_diagnostic("IEC20061"), nullptr);
    EXPECT_EQ(find_diagnostic(""), nullptr);
}

TEST(Catalogue, ErrorsOfAnnexEHaveTheirRow) {
    const DiagnosticInfo& row = diagnostic_info(DiagnosticId::nested_comment);
    EXPECT_EQ(row.annex_e_row, 1);
    EXPECT_EQ(to_string(row.category), "error");
    EXPECT_EQ(row.clause, "2.1.5");
}

TEST(Message, TakesWordsNumbersAndCharacters) {
    EXPECT_EQ(message(make(DiagnosticId::missing_semicolon)), "`;` is missing");
    EXPECT_EQ(message(make(DiagnosticId::digit_outside_base, {"9", std::uint64_t{8}})),
              "`9` is not a digit of base 8");
    EXPECT_EQ(message(make(DiagnosticId::unexpected_character, {U'?'})),
              "`?` (U+003F) has no meaning here");
    EXPECT_EQ(message(make(DiagnosticId::day_out_of_range, {std::uint64_t{30}, "February"})),
              "February has no day 30");
}

TEST(Message, KeepsBracesOfItsOwn) {
    EXPECT_EQ(message(make(DiagnosticId::stray_pragma_end, {"x"})), "`}` closes nothing");
}

TEST(Message, LeavesAPlaceholderWithoutArgument) {
    EXPECT_EQ(message(make(DiagnosticId::unknown_base)),
              "base {0} does not exist: the bases are 2, 8 and 16");
}

TEST(Message, DoesNotFillWhatAnArgumentBringsAlong) {
    EXPECT_EQ(message(make(DiagnosticId::foreign_operator, {"{1}", "="})),
              "`{1}` is not an operator; write `=`");
}

std::string shown(char32_t character) {
    const std::string text = message(make(DiagnosticId::unexpected_character, {character}));
    return text.substr(0, text.find(" has"));
}

TEST(Message, ShowsACharacterWhenItCanBeSeen) {
    EXPECT_EQ(shown(U'\u00C4'), "`\xC3\x84` (U+00C4)");
    EXPECT_EQ(shown(U'\U0001F600'), "`\xF0\x9F\x98\x80` (U+1F600)");
    EXPECT_EQ(shown(0), "U+0000");
    EXPECT_EQ(shown(0x7F), "U+007F");
    EXPECT_EQ(shown(0x85), "U+0085");
    EXPECT_EQ(shown(0xA0), "U+00A0");
    EXPECT_EQ(shown(0x200B), "U+200B");
    EXPECT_EQ(shown(0x202E), "U+202E");
    EXPECT_EQ(shown(0xFEFF), "U+FEFF");
    EXPECT_EQ(shown(0xD800), "U+D800");
    EXPECT_EQ(shown(0x10FFFF), "U+10FFFF");
    EXPECT_EQ(shown(0x110000), "U+110000");
    EXPECT_EQ(shown(U' '), "` ` (U+0020)");
}

std::string argument(std::string text, Encoding encoding = Encoding::utf8) {
    const std::string words =
        message(make(DiagnosticId::missing_token, {std::move(text)}), encoding);
    return words.substr(0, words.size() - std::string(" is missing").size());
}

TEST(Message, MakesEverythingInAnArgumentVisible) {
    EXPECT_EQ(argument("a\x1B[31mb\n"), "a\\x1B[31mb\\x0A");
    EXPECT_EQ(argument(std::string("\0", 1)), "\\x00");
    EXPECT_EQ(argument("\xFF\xC3"), "\\xFF\\xC3");
    EXPECT_EQ(argument("\xC2\x85"), "\\u0085");
    EXPECT_EQ(argument("\xE2\x80\xAE"), "\\u202E");
    EXPECT_EQ(argument("`\xC3\x84`"), "`\xC3\x84`");
}

TEST(Message, ReadsArgumentsInTheEncodingOfTheSource) {
    EXPECT_EQ(argument("\xC4", Encoding::iso_8859_1), "\xC3\x84");
    EXPECT_EQ(argument("\x80", Encoding::windows_1252), "\xE2\x82\xAC");
    EXPECT_EQ(argument("\x81", Encoding::windows_1252), "\\x81");
}

TEST(Message, ShortensALongArgumentInTheMiddle) {
    EXPECT_EQ(argument(std::string(60, 'x')), std::string(60, 'x'));
    EXPECT_EQ(argument("a" + std::string(100, 'x') + "b"),
              "a" + std::string(28, 'x') + "..." + std::string(27, 'x') + "b");
}

TEST(Message, CutsNoCharacter) {
    std::string text;
    std::string expected;
    for (int i = 0; i < 70; ++i)
        text += "\xE2\x82\xAC";
    for (int i = 0; i < 29; ++i)
        expected += "\xE2\x82\xAC";
    expected += "...";
    for (int i = 0; i < 28; ++i)
        expected += "\xE2\x82\xAC";
    EXPECT_EQ(argument(text), expected);
}

TEST(Message, OfALabelTakesItsArgument) {
    DiagnosticLabel label;
    label.id = LabelId::opened_here;
    label.argument = "IF";
    EXPECT_EQ(message(label), "`IF` begins here");
    label.id = LabelId::comment_begin;
    EXPECT_EQ(message(label), "the comment begins here");
}

TEST(Description, NamesTheOneEdit) {
    EXPECT_EQ(description(edit({2, 2}, ";"), "ab"), "insert `;`");
    EXPECT_EQ(description(edit({1, 2}, ""), "a;b"), "remove `;`");
    EXPECT_EQ(description(edit({1, 2}, ":="), "a=b"), "replace `=` by `:=`");
}

TEST(Description, LeavesOuterBlanksOut) {
    EXPECT_EQ(description(edit({1, 1}, " THEN"), "a"), "insert `THEN`");
    EXPECT_EQ(description(edit({1, 3}, ""), "a  b"), "remove white space");
}

TEST(Description, JoinsSeveralEdits) {
    DiagnosticFix fix;
    fix.edits = {{{0, 1}, "b"}, {{2, 3}, "b"}, {{4, 5}, "b"}};
    EXPECT_EQ(description(fix, "a a a"), "replace `a` by `b` in 3 places");
    fix.edits = {{{0, 2}, "(*"}, {{3, 3}, " *)"}};
    EXPECT_EQ(description(fix, "//x"), "replace `//` by `(*` and insert `*)`");
    fix.edits = {{{0, 0}, "1"}, {{0, 0}, "2"}, {{0, 0}, "3"}};
    EXPECT_EQ(description(fix, ""), "insert `1`, insert `2` and insert `3`");
    fix.edits.push_back({{0, 0}, "4"});
    EXPECT_EQ(description(fix, ""), "make 4 edits");
}

TEST(Description, StaysOnOneLine) {
    EXPECT_EQ(description(edit({0, 5}, ""), "ab\ncd"), "remove `ab ...`");
    const std::string words = description(edit({0, 200}, ""), std::string(200, 'x'));
    EXPECT_LT(words.size(), 80U);
}

TEST(Description, EndsAtTheEndOfTheSource) {
    EXPECT_EQ(description(edit({1, 9}, ""), "ab"), "remove `b`");
    EXPECT_EQ(description(edit({7, 9}, "x"), "ab"), "insert `x`");
    EXPECT_EQ(description({}, "ab"), "");
}

TEST(Equality, SeesEachMember) {
    Diagnostic whole = make(DiagnosticId::missing_token, {std::string("`)`")});
    whole.range = {4, 5};
    whole.labels.push_back({{1, 2}, LabelId::opened_here, "x"});
    whole.fixes.push_back(edit({5, 5}, ")"));
    EXPECT_EQ(whole, Diagnostic(whole));
    std::vector<Diagnostic> others(8, whole);
    others[0].id = DiagnosticId::missing_name;
    others[1].range.end = 6;
    others[2].arguments.clear();
    others[3].labels[0].range.begin = 0;
    others[4].labels[0].id = LabelId::first_given;
    others[5].labels[0].argument = "y";
    others[6].fixes[0].edits[0].range.begin = 4;
    others[7].fixes[0].edits[0].replacement = "]";
    for (const Diagnostic& other : others)
        EXPECT_NE(whole, other) << "member " << &other - others.data();
}

TEST(Shifted, MovesLabelsAndFixesAlong) {
    Diagnostic diagnostic = make(DiagnosticId::missing_closing_word);
    diagnostic.range = {5, 5};
    diagnostic.labels.push_back({{1, 3}, LabelId::opened_here, "IF"});
    diagnostic.fixes.push_back(edit({5, 5}, "END_IF"));
    const Diagnostic moved = shifted(diagnostic, 10);
    EXPECT_EQ(moved.range, (TextRange{15, 15}));
    EXPECT_EQ(moved.labels[0].range, (TextRange{11, 13}));
    EXPECT_EQ(moved.fixes[0].edits[0].range, (TextRange{15, 15}));
}

} // namespace
