#include "builder/rebuild.hpp"
#include "format/format_faults.hpp"
#include "fuzz/numbers.hpp"
#include "fuzz/targets.hpp"
#include "grammar/damage.hpp"
#include "grammar/formal_syntax.hpp"
#include "grammar/reading.hpp"
#include "grammar/sentences.hpp"
#include "support/tree_faults.hpp"

#include <algorithm>

// The bytes choose a text that the grammar derives, and then what happens to its tokens.

namespace iecfront::test {
namespace {

constexpr std::size_t tokens_at_most = 80; // the recogniser takes its time
constexpr std::size_t damages_at_most = 4;

/// What is reported and the formal syntax differ, and no known difference says so.
[[nodiscard]] std::string disagreement(const SyntaxTree& tree, std::string_view text) {
    const std::set<std::string> codes = reported_codes(tree);
    if (!formal_syntax().derives(text))
        return codes.empty() ? "not reported, and not of the language" : "";
    for (const std::string& code : codes)
        if (formal_syntax().differences.find(code) == nullptr)
            return "reported, and of the language: " + code;
    return {};
}

[[nodiscard]] std::string fault_of(const std::string& text) {
    const SourceText source(text);
    const SyntaxTree tree = parse(source);
    std::string fault = tree_fault(tree, text);
    if (fault.empty())
        fault = disagreement(tree, text);
    if (fault.empty())
        fault = format_fault(source);
    if (fault.empty())
        fault = write_fault(source);
    if (fault.empty() && tree.diagnostics().empty())
        fault = rebuild_fault(tree);
    return fault;
}

} // namespace

std::string sentence_fault(std::string_view bytes) {
    const FormalSyntax& syntax = formal_syntax();
    static const SentenceDeriver any_deriver(syntax.grammar, syntax.words, 0);
    static const Damager any_damager(syntax.grammar, 0);
    Numbers numbers(bytes);
    const auto next = [&numbers] { return numbers.next(); };
    SentenceDeriver deriver = any_deriver; // a copy: what went before must not count
    Damager damager = any_damager;
    deriver.follow(next);
    damager.follow(next);

    const std::size_t damages = numbers.below(damages_at_most + 1);
    std::string text = deriver.derive(1 + numbers.below(tokens_at_most)).text;
    for (std::size_t i = 0; i < damages; ++i)
        text = damager.damaged(text);
    const std::string fault = fault_of(text);
    return fault.empty() ? "" : fault + "\nin\n" + text;
}

} // namespace iecfront::test
