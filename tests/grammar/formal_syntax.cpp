#include "grammar/formal_syntax.hpp"

#include "support/repository_files.hpp"

namespace iecfront::test {

FormalSyntax::FormalSyntax()
    : document(repository_files({"docs"}, {"/grammar.md"}).front().text),
      grammar(read_grammar(document)),
      words(grammar, document),
      lexical(grammar, words),
      differences(document),
      lenient_grammar(read_grammar_with(document, "ebnf-silent")),
      lenient_lexical(lenient_grammar, words) {}

const FormalSyntax& formal_syntax() {
    static const FormalSyntax one;
    return one;
}

} // namespace iecfront::test
