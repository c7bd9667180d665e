#include <iecfront/diagnostics/render_json.hpp>

#include <gtest/gtest.h>
#include <string>

using namespace iecfront;

namespace {

std::string json(std::string_view text, Encoding encoding = Encoding::utf8) {
    std::string out;
    append_json_string(out, text, encoding);
    return out;
}

TEST(JsonString, EscapesWhatItMust) {
    EXPECT_EQ(json("a\"\\/b"), "\"a\\\"\\\\/b\"");
    EXPECT_EQ(json("\b\f\n\r\t"), "\"\\b\\f\\n\\r\\t\"");
    EXPECT_EQ(json(std::string("\0\x1F\x7F", 3)), "\"\\u0000\\u001f\\u007f\"");
    EXPECT_EQ(json("\xE2\x80\xA8"), "\"\\u2028\"");
    EXPECT_EQ(json(""), "\"\"");
}

TEST(JsonString, IsUtf8ForAnyBytes) {
    EXPECT_EQ(json("\xC3\x84\xF0\x9F\x98\x80"), "\"\xC3\x84\xF0\x9F\x98\x80\"");
    EXPECT_EQ(json("\xFFx\xC3"), "\"\xEF\xBF\xBDx\xEF\xBF\xBD\"");
    EXPECT_EQ(json("\xED\xA0\x80"), "\"\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\"");
    EXPECT_EQ(json("\xC4\x80", Encoding::windows_1252), "\"\xC3\x84\xE2\x82\xAC\"");
    EXPECT_EQ(json("\x81", Encoding::windows_1252), "\"\xEF\xBF\xBD\"");
    EXPECT_EQ(json("\xC4", Encoding::iso_8859_1), "\"\xC3\x84\"");
}

TEST(RenderJson, HasAllMembers) {
    const SourceText source("IF \xC3\x84 THEN\r\n  b := 1\n", "a\"b.st");
    Diagnostic diagnostic;
    diagnostic.id = DiagnosticId::missing_closing_word;
    diagnostic.range = {20, 20};
    diagnostic.arguments = {"END_IF", "IF"};
    diagnostic.labels.push_back({{6, 10}, LabelId::opened_here, "IF"});
    DiagnosticFix fix;
    fix.edits.push_back({{20, 20}, " END_IF;"});
    fix.edits.push_back({{3, 5}, ""});
    diagnostic.fixes = {fix};
    std::string out;
    EXPECT_TRUE(render_json(out, diagnostic, Severity::error, source, LineTable(source.bytes())));
    EXPECT_EQ(
        out,
        "{\"file\":\"a\\\"b.st\",\"line\":2,\"column\":9,\"endLine\":2,\"endColumn\":9,"
        "\"offset\":20,\"endOffset\":20,\"code\":\"IEC2002\",\"name\":\"missing-closing-word\","
        "\"severity\":\"error\",\"class\":\"violation\",\"clause\":\"Annex B\","
        "\"message\":\"`END_IF` is missing: it closes `IF`\","
        "\"labels\":[{\"line\":1,\"column\":6,\"endLine\":1,\"endColumn\":10,"
        "\"offset\":6,\"endOffset\":10,\"message\":\"`IF` begins here\"}],"
        "\"fixes\":[{\"description\":\"insert `END_IF;` and remove `\xC3\x84`\","
        "\"edits\":[{\"offset\":20,\"endOffset\":20,\"text\":\" END_IF;\"},"
        "{\"offset\":3,\"endOffset\":5,\"text\":\"\"}]}]}");
}

TEST(RenderJson, NamesTheRowOfAnnexE) {
    const SourceText source("(* (* *)");
    Diagnostic diagnostic;
    diagnostic.id = DiagnosticId::nested_comment;
    diagnostic.range = {3, 5};
    std::string out;
    EXPECT_TRUE(render_json(out, diagnostic, Severity::warning, source, LineTable(source.bytes())));
    EXPECT_NE(out.find("\"severity\":\"warning\",\"class\":\"error\""), std::string::npos);
    EXPECT_NE(out.find(",\"annexE\":1,\"labels\":[],\"fixes\":[]}"), std::string::npos);
}

TEST(RenderJson, ConvertsTheWordsOfTheSource) {
    const SourceText source("\xC4", "a", Encoding::iso_8859_1);
    Diagnostic diagnostic;
    diagnostic.id = DiagnosticId::missing_token;
    diagnostic.range = {0, 1};
    diagnostic.arguments = {"\xC4"};
    DiagnosticFix fix;
    fix.edits.push_back({{0, 1}, "\xD6"});
    diagnostic.fixes = {fix};
    std::string out;
    render_json(out, diagnostic, Severity::error, source, LineTable(source.bytes()));
    EXPECT_NE(out.find("\"message\":\"\xC3\x84 is missing\""), std::string::npos);
    EXPECT_NE(out.find("replace `\xC3\x84` by `\xC3\x96`"), std::string::npos);
    EXPECT_NE(out.find("\"text\":\"\xC3\x96\""), std::string::npos);
}

TEST(RenderJson, AppendsNothingWhenAllowed) {
    const SourceText source("a");
    std::string out = "x";
    EXPECT_FALSE(render_json(out, {}, Severity::allow, source, LineTable(source.bytes())));
    EXPECT_EQ(out, "x");
}

TEST(RenderJson, ARangeBehindTheTextIsCut) {
    const SourceText source("ab");
    Diagnostic diagnostic;
    diagnostic.range = {7, 9};
    std::string out;
    render_json(out, diagnostic, Severity::error, source, LineTable(source.bytes()));
    EXPECT_NE(out.find("\"offset\":2,\"endOffset\":2"), std::string::npos);
}

} // namespace
