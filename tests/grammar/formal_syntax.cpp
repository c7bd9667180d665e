#include "grammar/formal_syntax.hpp"

#include "support/repository_files.hpp"

namespace iecfront::test {

FormalSyntax::FormalSyntax()
    : document(repository_files({"docs"}, {"/grammar.md"}).front().text),
      grammar(read_grammar(document)),
      words(grammar, document),
      lexical(grammar, words),
      differences(document) {}

const FormalSyntax& formal_syntax() {
    static const FormalSyntax one;
    return one;
}

} // namespace iecfront::test
