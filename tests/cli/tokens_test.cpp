#include "cli/command.hpp"

namespace iecfront::test {
namespace {

using TokensCommand = CommandTest;

TEST_F(TokensCommand, ListsTokensCommentsAndPragmasInOrder) {
    write("p.st",
          "(* one *)\nPROGRAM p { two }\n  s := 'a$'b'; // three\nEND_PROGRAM (* four\n*)\n");
    const Outcome outcome = run({"tokens", "p.st"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "1:1 comment \"(* one *)\"\n"
                           "2:1 kw_program \"PROGRAM\"\n"
                           "2:9 identifier \"p\"\n"
                           "2:11 pragma \"{ two }\"\n"
                           "3:3 identifier \"s\"\n"
                           "3:5 assign \":=\"\n"
                           "3:8 single_byte_string \"'a$'b'\"\n"
                           "3:14 semicolon \";\"\n"
                           "3:16 line_comment \"// three\"\n"
                           "4:1 kw_end_program \"END_PROGRAM\"\n"
                           "4:13 comment \"(* four\\n*)\"\n");
}

TEST_F(TokensCommand, ColumnsCountCharacters) {
    write("p.st", "\xEF\xBB\xBF(*\xC3\x84\xF0\x9F\x98\x80*) x\r\ny\rz\n\xFF w");
    EXPECT_EQ(run({"tokens", "p.st"}).out, "1:1 comment \"(*\xC3\x84\xF0\x9F\x98\x80*)\"\n"
                                           "1:8 identifier \"x\"\n"
                                           "2:1 identifier \"y\"\n"
                                           "3:1 identifier \"z\"\n"
                                           "4:1 unknown \"\xEF\xBF\xBD\"\n"
                                           "4:3 identifier \"w\"\n");
}

TEST_F(TokensCommand, TextIsUtf8WhateverTheEncoding) {
    write("p.st", "(*\xC4*) x");
    EXPECT_EQ(run({"tokens", "--encoding=latin-1", "p.st"}).out, "1:1 comment \"(*\xC3\x84*)\"\n"
                                                                 "1:7 identifier \"x\"\n");
}

TEST_F(TokensCommand, JsonIsOneObjectAFile) {
    write("p.st", "x := 1");
    const JsonValue json = run_json({"tokens", "--format=json", "p.st"});
    EXPECT_EQ(json.names(), "file tokens");
    EXPECT_EQ(json["file"].text, "p.st");
    ASSERT_EQ(json["tokens"].items.size(), 3U);
    const JsonValue& token = json["tokens"][1];
    EXPECT_EQ(token.names(), "kind line column offset endOffset text");
    EXPECT_EQ(token["kind"].text, "assign");
    EXPECT_EQ(token["line"].text, "1");
    EXPECT_EQ(token["column"].text, "3");
    EXPECT_EQ(token["offset"].text, "2");
    EXPECT_EQ(token["endOffset"].text, "4");
    EXPECT_EQ(token["text"].text, ":=");
    write("empty.st", "");
    EXPECT_TRUE(run_json({"tokens", "--format=json", "empty.st"})["tokens"].items.empty());
    EXPECT_EQ(run({"tokens", "--format=json", "p.st", "empty.st"}).out,
              run({"tokens", "--format=json", "p.st"}).out +
                  run({"tokens", "--format=json", "empty.st"}).out);
}

TEST_F(TokensCommand, NamesTheFilesWhenThereAreSeveral) {
    write("a.st", "x");
    write("b.st", "y");
    const Outcome outcome = run({"tokens", "a.st", "missing.st", "b.st"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "a.st:\n1:1 identifier \"x\"\nb.st:\n1:1 identifier \"y\"\n");
    EXPECT_EQ(outcome.err, "iecfront: missing.st: No such file or directory\n");
}

TEST_F(TokensCommand, ALongListComesWhole) {
    std::string text;
    for (int i = 0; i < 30000; ++i)
        text += "x ";
    write("p.st", text);
    const JsonValue json = run_json({"tokens", "--format=json", "p.st"});
    ASSERT_EQ(json["tokens"].items.size(), 30000U);
    EXPECT_EQ(json["tokens"][29999]["column"].text, "59999");
}

} // namespace
} // namespace iecfront::test
