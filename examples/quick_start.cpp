#include <iecfront/iecfront.hpp>

#include <cstdio>

int main() {
    const iecfront::SourceText source("PROGRAM lamp\nVAR lit : BOOL; END_VAR\n"
                                      "    lit = NOT lit;\nEND_PROGRAM\n",
                                      "lamp.st");
    const iecfront::SyntaxTree tree = iecfront::parse(source);
    std::fputs(iecfront::render_text(tree.diagnostics(), source).c_str(), stdout);
    std::fputs(iecfront::dump_tree(tree).c_str(), stdout);
}
