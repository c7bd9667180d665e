#include "grammar/words.hpp"

#include "grammar/markdown.hpp"

#include <algorithm>
#include <sstream>

namespace iecfront::test {
namespace {

[[nodiscard]] bool is_word(std::string_view text) {
    return !text.empty() && (text.front() < '0' || text.front() > '9') &&
           std::all_of(text.begin(), text.end(), is_word_character);
}

[[nodiscard]] bool names_standard_elements(const Production& production) {
    return production.name == "standard_function_name" ||
           production.name == "standard_function_block_name";
}

void add_words(const Production& production, std::set<std::string>& words) {
    for_each_expression(production.body, [&](const Expression& part) {
        if (part.kind == Expression::Kind::terminal && is_word(part.text))
            words.insert(part.text);
    });
}

} // namespace

Words::Words(const Grammar& grammar, std::string_view document) {
    for (const Production& production : grammar.productions) {
        if (names_standard_elements(production))
            add_words(production, standard_names);
        else if (production.heading.starts_with("B.2.2"))
            add_words(production, il_operators);
        else if (!production.lexical())
            add_words(production, keywords);
    }
    for (const Production& production : read_grammar(document, "ebnf-unreachable").productions)
        add_words(production, keywords);
    keywords.insert({"TRUE", "FALSE"});
    for (const auto& row : table_rows(document, "Words that are terminals but not keywords")) {
        std::istringstream words(code_in(row.front()));
        for (std::string word; words >> word;)
            keywords.erase(word);
    }
}

bool Words::is_keyword(std::string_view word) const {
    return keywords.contains(upper_case(word));
}

bool Words::is_reserved(std::string_view word) const {
    const std::string upper = upper_case(word);
    return keywords.contains(upper) || standard_names.contains(upper);
}

std::string upper_case(std::string_view word) {
    std::string result(word);
    for (char& c : result)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return result;
}

bool is_word_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

} // namespace iecfront::test
