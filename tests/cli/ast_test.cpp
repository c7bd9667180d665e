#include "cli/command.hpp"

#include <iecfront/ast/dump.hpp>
#include <iecfront/parser/parse.hpp>

namespace iecfront::test {
namespace {

using AstCommand = CommandTest;

[[nodiscard]] SyntaxTree tree_of(std::string_view text, const std::string& name) {
    return parse(SourceText(std::string(text), name));
}

TEST_F(AstCommand, PrintsTheTree) {
    write("good.st", good_program);
    const Outcome outcome = run({"ast", "good.st"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, dump_tree(tree_of(good_program, "good.st")));
    EXPECT_EQ(run({"ast", "--format", "tree", "good.st"}).out, outcome.out);
}

TEST_F(AstCommand, PrintsTheTreeOfAWrongTextToo) {
    write("bad.st", bad_program);
    const Outcome outcome = run({"ast", "bad.st"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, dump_tree(tree_of(bad_program, "bad.st")));
}

TEST_F(AstCommand, JsonIsOneObjectAFile) {
    write("good.st", good_program);
    write("empty.st", "");
    const JsonValue json = run_json({"ast", "--format", "json", "good.st"});
    EXPECT_EQ(json["file"].text, "good.st");
    EXPECT_EQ(json["units"].items.size(), 1U);
    EXPECT_EQ(json["units"][0]["kind"].text, "library_unit");
    EXPECT_EQ(run_json({"ast", "--format", "json", "empty.st"})["file"].text, "empty.st");
    EXPECT_EQ(run({"ast", "--format", "json", "good.st", "empty.st"}).out,
              run({"ast", "--format", "json", "good.st"}).out +
                  run({"ast", "--format", "json", "empty.st"}).out);
}

TEST_F(AstCommand, NamesTheFilesWhenThereAreSeveral) {
    write("a.st", good_program);
    write("b.st", good_program);
    const std::string tree = dump_tree(tree_of(good_program, "a.st"));
    EXPECT_EQ(run({"ast", "a.st", "b.st"}).out, "a.st:\n" + tree + "b.st:\n" + tree);
}

TEST_F(AstCommand, NestingIsLimited) {
    write("deep.st", deep_program);
    EXPECT_NE(run({"ast", "deep.st"}).out, run({"ast", "--max-nesting=5", "deep.st"}).out);
}

} // namespace
} // namespace iecfront::test
