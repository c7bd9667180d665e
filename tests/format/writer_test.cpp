#include <iecfront/format/writer.hpp>
#include <iecfront/parser/parse.hpp>

#include <gtest/gtest.h>

// Requirement 1.5.1 j): standard text in ISO 646.

namespace iecfront {
namespace {

[[nodiscard]] WrittenText written(std::string text, const WriteOptions& options = {},
                                  Encoding encoding = Encoding::utf8) {
    return write(parse(SourceText(std::move(text), {}, encoding)), options);
}

[[nodiscard]] WrittenText written(std::string text, CommentHandling comments) {
    WriteOptions options;
    options.comments = comments;
    return written(std::move(text), options);
}

// A declaration with `value` as its initial value, and what becomes of it.
[[nodiscard]] std::string value_written(const std::string& type, const std::string& value,
                                        Encoding encoding = Encoding::utf8) {
    const WrittenText result =
        written("TYPE t : " + type + " := " + value + "; END_TYPE", {}, encoding);
    EXPECT_TRUE(result.beyond_iso_646.empty());
    const std::string before = "TYPE\n    t : " + type + " := ";
    const std::string behind = ";\nEND_TYPE\n";
    EXPECT_TRUE(result.text.starts_with(before) && result.text.ends_with(behind)) << result.text;
    return result.text.substr(before.size(), result.text.size() - before.size() - behind.size());
}

TEST(Writer, EscapesWhatIso646LacksByItsValue) {
    EXPECT_EQ(value_written("STRING", "'\xC3\x84\xC3\x8B'"), "'$C4$CB'");
    EXPECT_EQ(value_written("STRING", "'\xC4\xCB'", Encoding::iso_8859_1), "'$C4$CB'");
    EXPECT_EQ(value_written("STRING", "'\xC4\xCB'", Encoding::windows_1252), "'$C4$CB'");
    EXPECT_EQ(value_written("WSTRING", "\"\xC3\x84\xE2\x82\xAC\""), "\"$00C4$20AC\"");
    EXPECT_EQ(value_written("WSTRING", "\"\xC4\"", Encoding::iso_8859_1), "\"$00C4\"");
    EXPECT_EQ(value_written("WSTRING", "\"\x80\"", Encoding::windows_1252), "\"$20AC\"");
    EXPECT_EQ(value_written("STRING", "STRING#'\xC3\x84'"), "STRING#'$C4'");
}

TEST(Writer, LeavesTheRestOfAStringAsItIs) {
    EXPECT_EQ(value_written("STRING", "'$N$$a$'\xC3\x84$41 b'"), "'$N$$a$'$C4$41 b'");
    EXPECT_EQ(value_written("STRING", "'plain'"), "'plain'");
}

TEST(Writer, ReportsWhatCannotBeWritten) {
    const std::string euro = "TYPE t : STRING := '\xE2\x82\xAC'; END_TYPE";
    const WrittenText string = written(euro);
    EXPECT_EQ(string.beyond_iso_646, (std::vector<TextRange>{{19, 24}}));
    EXPECT_NE(string.text.find("\xE2\x82\xAC"), std::string::npos);

    const WrittenText name = written("TYPE \xC3\x84 : INT; END_TYPE");
    EXPECT_EQ(name.beyond_iso_646.size(), 1U);
    EXPECT_NE(name.text.find("\xC3\x84"), std::string::npos);

    EXPECT_EQ(written("TYPE t : STRING := '\xFF'; END_TYPE").beyond_iso_646.size(), 1U);
    EXPECT_EQ(written("{\xC3\x84} TYPE t : INT; END_TYPE").beyond_iso_646,
              (std::vector<TextRange>{{0, 4}}));
}

TEST(Writer, ReportsPlacesInTheWholeText) {
    const std::string first = "TYPE t : INT; END_TYPE\n";
    const auto begin = static_cast<std::uint32_t>(first.size());
    EXPECT_EQ(written(first + "(*\xC3\x84*) TYPE u : INT; END_TYPE").beyond_iso_646,
              (std::vector<TextRange>{{begin, begin + 6}}));
}

TEST(Writer, KeepsCommentsAsItIsTold) {
    const std::string text = "(* plain *)\nTYPE\n    t : INT;  (* \xC3\x84 *)\nEND_TYPE\n";
    const std::vector<TextRange> place = {{31, 39}};
    EXPECT_EQ(written(text).text, text);
    EXPECT_EQ(written(text).beyond_iso_646, place);
    const WrittenText plain = written(text, CommentHandling::keep_iso_646);
    EXPECT_EQ(plain.text, "(* plain *)\nTYPE\n    t : INT;\nEND_TYPE\n");
    EXPECT_EQ(plain.beyond_iso_646, place);
    const WrittenText none = written(text, CommentHandling::leave_out);
    EXPECT_EQ(none.text, "TYPE\n    t : INT;\nEND_TYPE\n");
    EXPECT_TRUE(none.beyond_iso_646.empty());
}

TEST(Writer, LeavesNoTraceOfComments) {
    EXPECT_EQ(written("PROGRAM p\n(* a *)\nx := (* b *) 1;\n// c\ny := 2; (* d\n\n *)\nEND_PROGRAM",
                      CommentHandling::leave_out)
                  .text,
              "PROGRAM p\n    x := 1;\n    y := 2;\nEND_PROGRAM\n");
}

TEST(Writer, WritesCommentsInTheStandardForm) {
    EXPECT_EQ(written("// one *) two\n/* three (* four */\n//\n/***/\nTYPE t : INT; END_TYPE").text,
              "(* one * ) two *)\n(* three ( * four *)\n(* *)\n(***)\n"
              "TYPE\n    t : INT;\nEND_TYPE\n");
}

TEST(Writer, LeavesTheByteOrderMarkOut) {
    EXPECT_EQ(written("\xEF\xBB\xBFTYPE t : INT; END_TYPE").text, "TYPE\n    t : INT;\nEND_TYPE\n");
}

TEST(Writer, WritesWhatIsBrokenAsItWas) {
    const std::string text = "PROGRAM p\n  a  :=  ) '\xC3\x84';\nEND_PROGRAM\n";
    EXPECT_EQ(written(text).text, "PROGRAM p\n  a  :=  ) '$C4';\nEND_PROGRAM\n");
}

} // namespace
} // namespace iecfront
