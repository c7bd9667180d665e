#include <iecfront/diagnostics/render_text.hpp>

#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace iecfront;

namespace {

Diagnostic missing_semicolon(TextRange range) {
    Diagnostic diagnostic;
    diagnostic.id = DiagnosticId::missing_semicolon;
    diagnostic.range = range;
    return diagnostic;
}

std::string render(const Diagnostic& diagnostic, const SourceText& source, TextStyle style = {},
                   Severity severity = Severity::error) {
    std::string out;
    render_text(out, diagnostic, severity, source, LineTable(source.bytes()), style);
    return out;
}

// The line of the source and the line of carets, without the gutter of a one-digit line number.
std::string snippet(std::string text, TextRange range, Encoding encoding = Encoding::utf8) {
    const std::string out =
        render(missing_semicolon(range), SourceText(std::move(text), "a", encoding));
    std::string result;
    std::size_t begin = out.find('\n') + 1;
    while (begin < out.size()) {
        const std::size_t end = out.find('\n', begin);
        const std::string line = out.substr(begin, end - begin);
        result += line.size() > 6 ? line.substr(6) : "";
        result += '\n';
        begin = end + 1;
    }
    return result;
}

TEST(RenderText, ShowsLineCaretsLabelsAndFix) {
    const SourceText source("IF a THEN\n  b := 1;\nEND_PROGRAM\n", "tank.st");
    Diagnostic diagnostic;
    diagnostic.id = DiagnosticId::missing_closing_word;
    diagnostic.range = {19, 19};
    diagnostic.arguments = {"END_IF", "IF"};
    diagnostic.labels.push_back({{0, 2}, LabelId::opened_here, "IF"});
    DiagnosticFix fix;
    fix.edits.push_back({{19, 19}, " END_IF;"});
    diagnostic.fixes = {fix};
    EXPECT_EQ(render(diagnostic, source),
              "tank.st:2:10: error IEC2002: `END_IF` is missing: it closes `IF`\n"
              "  2 |   b := 1;\n"
              "    |          ^\n"
              "tank.st:1:1: note: `IF` begins here\n"
              "  1 | IF a THEN\n"
              "    | ^^\n"
              "help: insert `END_IF;`\n");
}

TEST(RenderText, IsOneLineWithoutSnippet) {
    const SourceText source("a := 1", "tank.st");
    EXPECT_EQ(render(missing_semicolon({6, 6}), source, {.snippet = false}, Severity::warning),
              "tank.st:1:7: warning IEC2006: `;` is missing\n");
}

TEST(RenderText, SaysNothingOfWhatIsAllowed) {
    EXPECT_EQ(render(missing_semicolon({0, 0}), SourceText("a"), {}, Severity::allow), "");
}

TEST(RenderText, ColoursOnRequest) {
    const std::string out = render(missing_semicolon({1, 1}), SourceText("a"), {.colour = true});
    EXPECT_NE(out.find("\x1B[1;31merror\x1B[0m"), std::string::npos);
    EXPECT_NE(out.find("\x1B[1;32m ^\x1B[0m"), std::string::npos);
}

TEST(RenderText, TextsWithoutNameOrBytesHaveAPlaceToo) {
    EXPECT_EQ(render(missing_semicolon({0, 0}), SourceText("")),
              "<text>:1:1: error IEC2006: `;` is missing\n");
}

TEST(RenderText, AFileNameCannotDisturbATerminal) {
    EXPECT_EQ(render(missing_semicolon({0, 0}), SourceText("", "a\x1B[2Jb\n\xC3\x84")),
              "a?[2Jb?\xC3\x84:1:1: error IEC2006: `;` is missing\n");
}

TEST(RenderText, LineNumbersShareOneGutter) {
    std::string text;
    for (int i = 0; i < 11; ++i)
        text += "x;\n";
    Diagnostic diagnostic = missing_semicolon({30, 31});
    diagnostic.labels.push_back({{0, 1}, LabelId::first_given, ""});
    EXPECT_EQ(render(diagnostic, SourceText(text, "a")), "a:11:1: error IEC2006: `;` is missing\n"
                                                         "  11 | x;\n"
                                                         "     | ^\n"
                                                         "a:1:1: note: the first one is here\n"
                                                         "   1 | x;\n"
                                                         "     | ^\n");
}

TEST(Snippet, UnderlinesARange) {
    EXPECT_EQ(snippet("abcdef", {1, 4}), "abcdef\n ^^^\n");
}

TEST(Snippet, ARangeOfSeveralLinesEndsWithTheFirst) {
    EXPECT_EQ(snippet("abc\r\ndef", {1, 7}), "abc\n ^^\n");
    EXPECT_EQ(snippet("abc\ndef", {3, 7}), "abc\n   ^\n");
}

TEST(Snippet, HasAtLeastOneCaret) {
    EXPECT_EQ(snippet("ab", {1, 1}), "ab\n ^\n");
    EXPECT_EQ(snippet("ab", {2, 2}), "ab\n  ^\n");
    EXPECT_EQ(snippet("ab\r\n", {3, 4}), "ab\n  ^\n"); // the LF of CR LF
    EXPECT_EQ(snippet("\n", {0, 0}), "\n^\n");
    EXPECT_EQ(snippet("ab", {7, 9}), "ab\n  ^\n");
}

TEST(Snippet, ExpandsTabsInBothLines) {
    EXPECT_EQ(snippet("\ta\tb", {3, 4}), "    a    b\n         ^\n");
    EXPECT_EQ(snippet("a\tb", {1, 2}), "a    b\n ^^^^\n");
    EXPECT_EQ(snippet("a\tb", {1, 1}), "a    b\n ^\n");
}

TEST(Snippet, MakesEverythingVisibleInOneColumn) {
    EXPECT_EQ(snippet(std::string("\x1B\0\x7F", 3) + "\xFFx", {4, 5}),
              "\xE2\x90\x9B\xE2\x90\x80\xE2\x90\xA1\xEF\xBF\xBDx\n    ^\n");
    EXPECT_EQ(snippet("\xE2\x80\xAEx", {3, 4}), "\xEF\xBF\xBDx\n ^\n");
}

TEST(Snippet, CountsCharactersAndConvertsThem) {
    EXPECT_EQ(snippet("\xC3\x84x", {2, 3}), "\xC3\x84x\n ^\n");
    EXPECT_EQ(snippet("\xC4x", {1, 2}, Encoding::iso_8859_1), "\xC3\x84x\n ^\n");
    EXPECT_EQ(snippet("\x80x\x81", {1, 2}, Encoding::windows_1252),
              "\xE2\x82\xACx\xEF\xBF\xBD\n ^\n");
}

TEST(Snippet, DoesNotShowAByteOrderMark) {
    EXPECT_EQ(snippet("\xEF\xBB\xBFxy", {4, 5}), "xy\n ^\n");
    EXPECT_EQ(snippet("\xEF\xBB\xBFxy", {0, 3}), "xy\n^\n");
    EXPECT_EQ(snippet("\xEF\xBB\xBF", {0, 0}), "\n^\n");
}

TEST(Snippet, CutsALongLineAtItsEnd) {
    const std::string line(300, 'x');
    EXPECT_EQ(snippet(line, {80, 82}),
              std::string(100, 'x') + "...\n" + std::string(80, ' ') + "^^\n");
}

TEST(Snippet, CutsALongLineOnBothSides) {
    const std::string line(300, 'x');
    EXPECT_EQ(snippet(line, {150, 151}),
              "..." + std::string(100, 'x') + "...\n" + std::string(43, ' ') + "^\n");
    EXPECT_EQ(snippet(line, {300, 300}),
              "..." + std::string(40, 'x') + "\n" + std::string(43, ' ') + "^\n");
    EXPECT_EQ(snippet(line, {150, 290}), "..." + std::string(100, 'x') + "...\n" +
                                             std::string(43, ' ') + std::string(60, '^') + "\n");
}

TEST(Snippet, CutsNoCharacterOfALongLine) {
    for (const std::string character : {"\xC3\x84", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"}) {
        const auto size = static_cast<std::uint32_t>(character.size());
        std::string line;
        std::string shown;
        for (int i = 0; i < 300; ++i)
            line += character;
        for (int i = 0; i < 100; ++i)
            shown += character;
        EXPECT_EQ(snippet(line, {150 * size, 151 * size}),
                  "..." + shown + "...\n" + std::string(43, ' ') + "^\n");
    }
}

TEST(Snippet, TabsBeforeALongLineDoNotHideTheRange) {
    const std::string line = std::string(200, '\t') + "x";
    EXPECT_EQ(snippet(line, {200, 201}),
              "..." + std::string(40, ' ') + "x\n" + std::string(43, ' ') + "^\n");
}

TEST(RenderTextOfAll, GivesEachItsSeverity) {
    const SourceText source("x\ny\n", "a.st");
    const std::vector<Diagnostic> found = {missing_semicolon({1, 1}), missing_semicolon({3, 3})};
    SeverityPolicy policy;
    policy.set(DiagnosticId::missing_semicolon, Severity::warning);
    const TextStyle no_snippet{false, false};
    const std::string text = render_text(found, source, policy, no_snippet);
    EXPECT_TRUE(text.starts_with("a.st:1:2: warning IEC")) << text;
    EXPECT_NE(text.find("\na.st:2:2: warning IEC"), std::string::npos) << text;
    policy.set(DiagnosticId::missing_semicolon, Severity::allow);
    EXPECT_EQ(render_text(found, source, policy, no_snippet), "");
    EXPECT_EQ(render_text({}, source), "");
}

} // namespace
