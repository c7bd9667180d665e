#include "grammar/ebnf.hpp"

#include "support/repository_files.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

namespace iecfront::test {
namespace {

using Kind = Expression::Kind;

[[nodiscard]] bool is_name_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

[[nodiscard]] bool is_blank(char c) {
    return c == ' ' || c == '\n';
}

/// Reads the productions of one block; recursive descent over the characters.
class BlockReader {
public:
    BlockReader(std::string_view block, std::string_view heading, Grammar& grammar)
        : rest_(block), heading_(heading), grammar_(grammar) {}

    void read() {
        for (skip_blanks(); !rest_.empty(); skip_blanks()) {
            const std::string_view begin = rest_;
            Production production;
            production.heading = heading_;
            production.name = read_name();
            if (production.name.empty() || !accept('='))
                return complain("`name =`");
            production.body = read_alternatives();
            if (!accept(';'))
                return complain("`;`");
            production.text = normalized(begin.substr(0, begin.size() - rest_.size()));
            grammar_.productions.push_back(std::move(production));
        }
    }

private:
    void skip_blanks() {
        while (!rest_.empty() && is_blank(rest_.front()))
            rest_.remove_prefix(1);
    }

    bool accept(char c) {
        skip_blanks();
        if (!rest_.starts_with(c))
            return false;
        rest_.remove_prefix(1);
        return true;
    }

    /// Says what is missing, once a block, and skips the rest of it.
    void complain(std::string_view expected) {
        if (!std::exchange(complained_, true))
            grammar_.faults.push_back("expected " + std::string(expected) + " before `" +
                                      std::string(rest_.substr(0, rest_.find('\n'))) + "`");
        rest_ = {};
    }

    [[nodiscard]] static std::string normalized(std::string_view text) {
        std::istringstream words{std::string(text)};
        std::string result;
        for (std::string word; words >> word;)
            result += (result.empty() ? "" : " ") + word;
        return result;
    }

    [[nodiscard]] std::string read_name() {
        skip_blanks();
        const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_name_character);
        return take(static_cast<std::size_t>(end - rest_.begin()));
    }

    [[nodiscard]] std::string take(std::size_t size) {
        std::string text(rest_.substr(0, size));
        rest_.remove_prefix(size);
        return text;
    }

    [[nodiscard]] Expression read_alternatives() {
        Expression result{Kind::alternatives, {}, 0, 0, {}};
        do
            result.parts.push_back(read_sequence());
        while (accept('|'));
        return simplified(std::move(result));
    }

    [[nodiscard]] Expression read_sequence() {
        Expression result{Kind::sequence, {}, 0, 0, {}};
        for (skip_blanks(); !rest_.empty() && begins_part(rest_.front()); skip_blanks())
            result.parts.push_back(read_part());
        if (result.parts.empty())
            complain("a part of a production");
        return simplified(std::move(result));
    }

    /// A row of one is that one.
    [[nodiscard]] static Expression simplified(Expression row) {
        if (row.parts.size() != 1)
            return row;
        Expression only = std::move(row.parts.front());
        return only;
    }

    [[nodiscard]] static bool begins_part(char c) {
        return is_name_character(c) || std::string_view("\"'<EN[{(").find(c) != std::string::npos;
    }

    [[nodiscard]] Expression read_part() {
        if (accept('['))
            return read_bracketed(Kind::option, ']');
        if (accept('{'))
            return read_bracketed(Kind::repetition, '}');
        if (accept('('))
            return read_bracketed(Kind::sequence, ')');
        if (accept('<'))
            return {Kind::described, read_up_to('>'), 0, 0, {}};
        if (accept('"'))
            return {Kind::terminal, read_up_to('"'), 0, 0, {}};
        if (accept('\''))
            return {Kind::terminal, read_up_to('\''), 0, 0, {}};
        if (rest_.starts_with("EOL")) {
            rest_.remove_prefix(3);
            return {Kind::line_end, {}, 0, 0, {}};
        }
        if (rest_.starts_with("NIL")) {
            rest_.remove_prefix(3);
            return {Kind::nothing, {}, 0, 0, {}};
        }
        Expression name{Kind::name, read_name(), 0, 0, {}};
        if (name.text.empty())
            complain("a part of a production");
        return name;
    }

    [[nodiscard]] Expression read_bracketed(Kind kind, char closer) {
        Expression inner = read_alternatives();
        if (!accept(closer))
            complain(std::string("`") + closer + "`");
        if (kind == Kind::sequence)
            return inner;
        Expression result{kind, {}, 0, 0, {}};
        result.parts.push_back(std::move(inner));
        return result;
    }

    [[nodiscard]] std::string read_up_to(char end) {
        const std::size_t size = rest_.find(end);
        if (size == 0 || size == std::string_view::npos || rest_.find('\n') < size) {
            complain("a terminal");
            return {};
        }
        std::string text = take(size);
        rest_.remove_prefix(1);
        return text;
    }

    std::string_view rest_;
    std::string_view heading_;
    Grammar& grammar_;
    bool complained_ = false;
};

/// Gives each expression its number and each name its production.
void resolve(Grammar& grammar) {
    std::map<std::string, std::size_t> places;
    for (std::size_t i = 0; i < grammar.productions.size(); ++i)
        if (!places.emplace(grammar.productions[i].name, i).second)
            grammar.faults.push_back(grammar.productions[i].name + " stands there twice");
    const auto resolve_one = [&](auto& self, Expression& expression) -> void {
        expression.number = grammar.expression_count++;
        if (expression.kind == Kind::name) {
            const auto found = places.find(expression.text);
            if (found == places.end())
                grammar.faults.push_back(expression.text + " has no production");
            else
                expression.production = found->second;
        }
        for (Expression& part : expression.parts)
            self(self, part);
    };
    for (Production& production : grammar.productions)
        resolve_one(resolve_one, production.body);
}

[[nodiscard]] Grammar read_blocks(std::string_view document, std::string_view mark) {
    Grammar grammar;
    std::string heading;
    std::string block;
    bool fenced = false;
    bool marked = false;
    for (const std::string_view line : lines_of(document)) {
        if (line.starts_with("```")) {
            if (marked)
                BlockReader(block, heading, grammar).read();
            block.clear();
            fenced = !fenced;
            marked = fenced && line.substr(3) == mark;
        } else if (marked) {
            block += std::string(line) + "\n";
        } else if (!fenced && line.starts_with('#')) {
            heading = line.substr(std::min(line.find_first_not_of("# "), line.size()));
        }
    }
    return grammar;
}

} // namespace

const Production* Grammar::find(std::string_view name) const {
    const auto found = std::find_if(productions.begin(), productions.end(),
                                    [&](const Production& one) { return one.name == name; });
    return found == productions.end() ? nullptr : &*found;
}

std::vector<GrammarExtension> read_extensions(std::string_view document,
                                              std::vector<std::string>& faults) {
    Grammar all = read_blocks(document, "ebnf-extension");
    faults = std::move(all.faults);
    std::vector<GrammarExtension> extensions;
    for (Production& production : all.productions) {
        const std::string& heading = production.heading;
        const std::size_t name = heading.find(" (");
        const std::string code = heading.substr(std::min(name + 2, heading.size()), 7);
        if (extensions.empty() || extensions.back().code != code)
            extensions.push_back({heading.substr(0, name), code, {}});
        extensions.back().productions.push_back(std::move(production));
    }
    return extensions;
}

Grammar extended_grammar(std::string_view document, const GrammarExtension& extension) {
    Grammar grammar = read_blocks(document, "ebnf");
    const Production* replaced = nullptr;
    for (const Production& production : extension.productions)
        replaced = replaced == nullptr ? grammar.find(production.name) : replaced;
    const std::string heading = replaced == nullptr ? "" : replaced->heading;
    for (const Production& production : extension.productions) {
        const auto found =
            std::ranges::find(grammar.productions, production.name, &Production::name);
        if (found == grammar.productions.end()) {
            grammar.productions.push_back(production);
            grammar.productions.back().heading = heading; // as lexical as what it is part of
        } else {
            found->text = production.text;
            found->body = production.body;
        }
    }
    resolve(grammar);
    return grammar;
}

Grammar read_grammar(std::string_view document, std::string_view mark) {
    Grammar grammar = read_blocks(document, mark);
    resolve(grammar);
    return grammar;
}

} // namespace iecfront::test
