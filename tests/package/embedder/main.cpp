// Reads two program organization units; the `;` behind the second one's statement is missing.
#include <iecfront/iecfront.hpp>

#include <cstdio>

int main() {
    const iecfront::SourceText source("FUNCTION_BLOCK Blink\n"
                                      "VAR_OUTPUT lamp : BOOL; END_VAR\n"
                                      "    lamp := NOT lamp;\n"
                                      "END_FUNCTION_BLOCK\n"
                                      "\n"
                                      "PROGRAM main\n"
                                      "VAR green : Blink; END_VAR\n"
                                      "    green()\n"
                                      "END_PROGRAM\n",
                                      "embedder.st");
    const iecfront::SyntaxTree tree = iecfront::parse(source);
    std::printf("%zu units, %zu diagnostics\n", tree.slots().size(), tree.diagnostics().size());
}
