#include "support/case_file.hpp"
#include "support/case_outcome.hpp"
#include "support/layout.hpp"
#include "support/line_diff.hpp"

#include <gtest/gtest.h>
#include <string>

namespace iecfront::test {
namespace {

constexpr std::string_view two_cases = "What stands before.\n"
                                       "\n"
                                       "=== first\n"
                                       ": tags a b\n"
                                       ": tags c\n"
                                       ": fixes-leave a reason\n"
                                       "x\n"
                                       "\n"
                                       "=== second\n"
                                       ": tags a\n"
                                       ": encoding iso-8859-1\n"
                                       ": escapes\n"
                                       "a\\tb\\\n"
                                       "--- diagnostics\n"
                                       "one\n"
                                       "\n"
                                       "two\n"
                                       "\n"
                                       "--- tree\n"
                                       "t\n"
                                       "\n"
                                       "\n";

TEST(CaseFile, IsReadInItsParts) {
    const CaseFile file = read_case_file("f.txt", two_cases);
    ASSERT_EQ(file.cases.size(), 2U);
    EXPECT_TRUE(file.faults.empty());
    const Case& first = file.cases[0];
    EXPECT_EQ(first.title, "first");
    EXPECT_EQ(first.line, 3U);
    EXPECT_EQ(first.tags, (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ(first.fixes_leave, "a reason");
    EXPECT_EQ(first.source(), "x\n\n");
    EXPECT_EQ(first.find("diagnostics"), nullptr);
    const Case& second = file.cases[1];
    EXPECT_EQ(second.encoding, "iso-8859-1");
    EXPECT_EQ(second.source(), "a\tb");
    EXPECT_EQ(second.expected("diagnostics"), "one\n\ntwo\n");
    EXPECT_EQ(second.expected("tree"), "t\n");
}

TEST(CaseFile, IsWrittenAsItWasRead) {
    EXPECT_EQ(write_case_file(read_case_file("f.txt", two_cases)), two_cases);
}

TEST(CaseFile, KeepsTheRestWhenASectionChanges) {
    CaseFile file = read_case_file("f.txt", "=== a\n: tags t\nx\n--- tree\nold\n\n=== b\ny\n");
    file.cases[0].replace("tree", "new\n");
    file.cases[0].set_diagnostics("d\n");
    EXPECT_EQ(write_case_file(file),
              "=== a\n: tags t\nx\n--- diagnostics\nd\n--- tree\nnew\n\n=== b\ny\n");
    file.cases[0].set_diagnostics("");
    EXPECT_EQ(write_case_file(file), "=== a\n: tags t\nx\n--- tree\nnew\n\n=== b\ny\n");
}

TEST(CaseFile, NamesWhatItDoesNotKnow) {
    const CaseFile file = read_case_file("f.txt", "=== a\n: tag x\nx\n--- trees\n--- tree\n"
                                                  "--- tree\n");
    EXPECT_EQ(file.faults, (std::vector<std::string>{"f.txt:2: `: tag` is not known",
                                                     "f.txt:4: `--- trees` is not known",
                                                     "f.txt:6: `--- tree` is there twice"}));
}

TEST(CaseFile, EscapesWhatCannotBeSeen) {
    Case one;
    one.escapes = true;
    const std::string text("a\\\r\n\t\0\x7F \n\xC3", 10);
    one.raw_source = one.written(text);
    EXPECT_EQ(one.raw_source, "a\\\\\\r\n\\t\\0\\x7F\\x20\n\\xC3\\\n");
    EXPECT_EQ(one.source(), text);
}

TEST(CaseOutcome, AppliesTheFixes) {
    const CaseFile file =
        read_case_file("f.txt", "=== a\nFUNCTION f : INT f := 1 f := 2; END_FUNCTION\n");
    const CaseOutcome outcome = run_case(file.cases[0]);
    EXPECT_EQ(outcome.fixed, "FUNCTION f : INT f := 1; f := 2; END_FUNCTION\n");
    EXPECT_TRUE(outcome.fixable);
    EXPECT_TRUE(outcome.rejected);
    EXPECT_EQ(outcome.left_in_fixed, "");
}

TEST(LineDiff, MarksWhatDiffers) {
    EXPECT_EQ(line_diff("a\nb\nc\n", "a\nx\nc\nd\n"), "  a\n- b\n+ x\n  c\n+ d\n");
}

TEST(Trimmed, DropsBlanksAtEnds) {
    EXPECT_EQ(trimmed("a  \n  b\n \n\n"), "a\n  b\n");
    EXPECT_EQ(trimmed("\n"), "");
}

TEST(LaidOut, BreaksWhatIsTooLong) {
    const std::string item = "(variable_name \"" + std::string(50, 'x') + "(\")";
    EXPECT_EQ(laid_out(item), item);
    EXPECT_EQ(laid_out("(list a [" + item + ' ' + item + "])"),
              "(list a [\n  " + item + "\n  " + item + "])");
    EXPECT_EQ(laid_out("(pair left:" + item + " right:" + item + ')'),
              "(pair\n  left:" + item + "\n  right:" + item + ')');
}

} // namespace
} // namespace iecfront::test
