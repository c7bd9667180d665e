// `mutate FROM TO CHOSEN FOLDER...` writes the sources of these folders of FROM to TO with
// mutations in them, those whose numbers the file CHOSEN holds, and prints a line for every one
// that could be chosen: its number, where it is, of what kind, and what is changed.
//
// An expression E becomes `(mutant(1) ? (E1) : mutant(2) ? (E2) : (E))`, where each Ei has one
// token changed; a statement `f(x);` becomes `{ if (!mutant(3)) f(x); }`. Each Ei stands in a line
// that `#line` gives the name of a file `mutant` and the number of the mutation, so that the
// compiler says which it refuses. Lines of the source keep their numbers.
//
// The sources are read as tokens only. That is enough, because they are formatted: an operator
// stands between blanks, and the brackets of a template do not.

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

// ---- tokens -------------------------------------------------------------------------------------

enum class Kind { word, number, text, mark };

struct Token {
    Kind kind;
    std::size_t begin;
    std::size_t end;
};

constexpr std::array<std::string_view, 26> long_marks = {
    "<<=", ">>=", "<=>", "...", "::", "->", "++", "--", "&&", "||", "==", "!=", "<=",
    ">=",  "<<",  ">>",  "+=",  "-=", "*=", "/=", "%=", "|=", "&=", "^=", "##", ".*"};

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_blank(char c) {
    return c == ' ' || c == '\n';
}

class Lexer {
public:
    explicit Lexer(std::string_view text) : text_(text) {}

    std::vector<Token> tokens() {
        std::vector<Token> tokens;
        while (skip_to_token()) {
            const std::size_t begin = at_;
            const Kind kind = read();
            tokens.push_back({kind, begin, at_});
        }
        return tokens;
    }

private:
    // Over blanks, comments and directives.
    bool skip_to_token() {
        while (at_ < text_.size()) {
            if (is_blank(text_[at_]))
                ++at_;
            else if (rest().starts_with("//") || text_[at_] == '#')
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (rest().starts_with("/*"))
                at_ = text_.find("*/", at_) + 2;
            else
                return true;
        }
        return false;
    }

    Kind read() {
        const char first = text_[at_];
        if (first == '"' || first == '\'') {
            for (++at_; text_[at_] != first; ++at_)
                at_ += text_[at_] == '\\' ? 1 : 0;
            ++at_;
            return Kind::text;
        }
        if (is_word(first)) {
            while (is_word(text_[at_]) || (is_digit(first) && text_[at_] == '\''))
                ++at_;
            return is_digit(first) ? Kind::number : Kind::word;
        }
        const auto* mark =
            std::find_if(long_marks.begin(), long_marks.end(),
                         [this](std::string_view one) { return rest().starts_with(one); });
        at_ += mark == long_marks.end() ? 1 : mark->size();
        return Kind::mark;
    }

    std::string_view rest() const { return text_.substr(at_); }

    std::string_view text_;
    std::size_t at_ = 0;
};

// ---- a source -----------------------------------------------------------------------------------

struct Source {
    std::string path;
    std::string text;
    std::vector<Token> tokens;

    std::string_view word(std::size_t i) const {
        if (i >= tokens.size())
            return {};
        return std::string_view(text).substr(tokens[i].begin, tokens[i].end - tokens[i].begin);
    }
    std::size_t line(std::size_t i) const {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(tokens[i].begin);
        return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
    }
    std::string_view text_of_line(std::size_t i) const {
        const std::size_t before = text.rfind('\n', tokens[i].begin);
        const std::size_t begin = text.find_first_not_of(' ', before + 1);
        return std::string_view(text).substr(begin, text.find('\n', begin) - begin);
    }
    // Blanks on both sides.
    bool stands_free(std::size_t i) const {
        return is_blank(text[tokens[i].begin - 1]) && is_blank(text[tokens[i].end]);
    }
    // What closes the bracket at `i`.
    std::size_t closer(std::size_t i) const {
        std::size_t depth = 0;
        for (; i < tokens.size(); ++i) {
            const std::string_view here = word(i);
            if (here == "(" || here == "[" || here == "{")
                ++depth;
            else if ((here == ")" || here == "]" || here == "}") && --depth == 0)
                return i;
        }
        return i;
    }
    // The first of `words` outside of brackets, `last` when there is none.
    std::size_t find(std::size_t first, std::size_t last,
                     std::initializer_list<std::string_view> words) const {
        for (std::size_t i = first; i < last; ++i) {
            const std::string_view here = word(i);
            if (std::find(words.begin(), words.end(), here) != words.end())
                return i;
            if (here == "(" || here == "[" || here == "{")
                i = closer(i);
        }
        return last;
    }
    // Tokens from `first` on, in one line and without comments; `instead` stands for `count` at
    // `at`.
    std::string joined(std::size_t first, std::size_t last, std::size_t at, std::size_t count,
                       std::string_view instead) const {
        std::string all;
        for (std::size_t i = first; i < last; ++i) {
            if (i > first && tokens[i - 1].end != tokens[i].begin)
                all += ' ';
            if (i == at)
                all += instead;
            else if (i < at || i >= at + count)
                all += word(i);
        }
        return all;
    }
};

bool is_assignment(std::string_view word) {
    return word.size() <= 3 && word.ends_with('=') && word != "==" && word != "!=" &&
           word != "<=" && word != ">=";
}

bool is_constant_name(std::string_view word) {
    return !word.empty() && word[0] >= 'a' && word[0] <= 'z';
}

// ---- what is changed ----------------------------------------------------------------------------

struct Change {
    std::size_t at; // token
    std::size_t count;
    std::string instead;
    std::string kind;
};

using Enumerations = std::set<std::string, std::less<>>;

// Which token of an expression can be another one.
class Changes {
public:
    Changes(const Source& source, const Enumerations& enumerations) : source_(source) {
        for (std::size_t i = 0; i < source.tokens.size(); ++i)
            if (is_constant(i, enumerations)) {
                auto& names = constants_[source.word(i)];
                if (std::find(names.begin(), names.end(), source.word(i + 2)) == names.end())
                    names.push_back(source.word(i + 2));
            }
    }

    void find(std::size_t first, std::size_t last, std::vector<Change>& changes) const {
        for (std::size_t i = first; i < last; ++i)
            if (std::optional<Change> change = change_at(i))
                changes.push_back(*std::move(change));
    }

    // Another constant of the same enumeration, the next one in this source.
    std::optional<Change> other_constant(std::size_t i) const {
        const auto found = constants_.find(source_.word(i));
        if (found == constants_.end() || source_.word(i + 1) != "::" || found->second.size() < 2)
            return std::nullopt;
        const auto& names = found->second;
        auto name = std::find(names.begin(), names.end(), source_.word(i + 2));
        if (name == names.end())
            return std::nullopt;
        ++name;
        const std::string_view other = name == names.end() ? names.front() : *name;
        return Change{i, 3, std::string(source_.word(i)).append("::").append(other), "constant"};
    }

private:
    bool is_constant(std::size_t i, const Enumerations& enumerations) const {
        return enumerations.contains(source_.word(i)) && source_.word(i + 1) == "::" &&
               is_constant_name(source_.word(i + 2)) && source_.word(i + 3) != "(";
    }

    std::optional<Change> change_at(std::size_t i) const {
        const std::string_view here = source_.word(i);
        if (source_.tokens[i].kind == Kind::number)
            return other_number(i);
        if (here == "true" || here == "false")
            return Change{i, 1, here == "true" ? "false" : "true", "truth"};
        if (here == "!")
            return Change{i, 1, "", "not"};
        for (const auto& [mark, instead, kind] : operators)
            if (here == mark && source_.stands_free(i))
                return Change{i, 1, std::string(instead), std::string(kind)};
        return other_constant(i);
    }

    std::optional<Change> other_number(std::size_t i) const {
        const std::string_view here = source_.word(i);
        const std::size_t digits = std::min(here.find_first_not_of("0123456789"), here.size());
        if (digits > 9 || source_.word(i - 1) == "." || source_.word(i + 1) == "." ||
            here.find_first_not_of("uUlL", digits) != std::string_view::npos)
            return std::nullopt;
        const int value = std::stoi(std::string(here.substr(0, digits)));
        return Change{i, 1, std::to_string(value == 0 ? 1 : value - 1).append(here.substr(digits)),
                      "number"};
    }

    struct Operator {
        std::string_view mark;
        std::string_view instead;
        std::string_view kind;
    };
    static constexpr std::array<Operator, 10> operators = {{
        {"<", "<=", "comparison"},
        {"<=", "<", "comparison"},
        {">", ">=", "comparison"},
        {">=", ">", "comparison"},
        {"==", "!=", "comparison"},
        {"!=", "==", "comparison"},
        {"&&", "||", "logic"},
        {"||", "&&", "logic"},
        {"+", "-", "sum"},
        {"-", "+", "sum"},
    }};

    const Source& source_;
    std::map<std::string_view, std::vector<std::string_view>> constants_;
};

// ---- writing ------------------------------------------------------------------------------------

struct Edit {
    std::size_t begin;
    std::size_t end;
    std::string text;
};

class Mutator {
public:
    Mutator(const Source& source, const Enumerations& enumerations,
            const std::set<unsigned>& chosen, unsigned& number)
        : source_(source), changes_(source, enumerations), chosen_(chosen), number_(number) {}

    std::string mutated() {
        for (at_ = 0; at_ < source_.tokens.size(); ++at_)
            visit();
        return apply_edits();
    }

private:
    enum class Scope { outside, function, compile_time };

    void visit() {
        const std::string_view here = source_.word(at_);
        if (here == "constexpr" && is_table())
            return table();
        if (here == "{")
            scopes_.push_back(scope_of_brace());
        else if (here == "}")
            scopes_.pop_back();
        if (here == ";" || here == "{" || here == "}")
            head_ = at_ + 1;
        if (!scopes_.empty() && scopes_.back() == Scope::function)
            visit_in_function(here);
    }

    Scope scope_of_brace() const {
        const auto has = [this](std::string_view word) {
            return source_.find(head_, at_, {word}) != at_;
        };
        if (has("consteval"))
            return Scope::compile_time;
        if (has("class") || has("struct") || has("enum") || has("namespace"))
            return Scope::outside;
        const Scope around = scopes_.empty() ? Scope::outside : scopes_.back();
        return around == Scope::outside && has("(") ? Scope::function : around;
    }

    void visit_in_function(std::string_view here) {
        if (here == "if" || here == "while" || here == "for" || here == "switch")
            return header(here);
        if (here == "return")
            return expression(at_ + 1, semicolon());
        if (is_assignment(here) && source_.word(head_) != "constexpr" &&
            source_.word(head_ + 1) != "constexpr")
            return expression(at_ + 1, semicolon());
        if (begins_statement())
            statement();
    }

    std::size_t semicolon() const { return source_.find(at_, source_.tokens.size(), {";"}); }

    // `constexpr TokenSet NAME`: what is in it is mutated, and it is computed at run time. Other
    // tables are computed when they are compiled.
    bool is_table() const {
        return source_.word(at_ + 1) == "TokenSet" && source_.word(at_ + 2) != "(" &&
               source_.word(at_ + 3) != "(";
    }

    void table() {
        edit(at_, at_ + 1, "const");
        const std::size_t end = semicolon();
        for (; at_ < end; ++at_)
            if (const std::optional<Change> change = changes_.other_constant(at_)) {
                if (const std::string choice = choice_of({*change}, at_, at_ + 3); !choice.empty())
                    edit(at_, at_ + 3, "(" + choice + original(at_, at_ + 3, "") + ")");
                at_ += 2;
            }
        head_ = end + 1;
    }

    // The parentheses of `if`, `while`, `for` and `switch`.
    void header(std::string_view keyword) {
        if (source_.word(at_ + 1) != "(")
            return; // `if constexpr`
        const std::size_t first = at_ + 2;
        const std::size_t last = source_.closer(at_ + 1);
        after_header_ = last + 1;
        const std::size_t part = source_.find(first, last, {";"});
        const std::size_t colon = source_.find(first, last, {":"});
        if (part == last && keyword == "for")
            expression(colon + 1, last);
        else if (part == last && keyword == "switch")
            expression(first, last);
        else if (part == last)
            condition(first, last, keyword);
        else {
            initialiser(first, part);
            condition(part + 1, source_.find(part + 1, last, {";"}), keyword);
            at_ = last; // the step of `for` is no statement
        }
    }

    void initialiser(std::size_t first, std::size_t last) {
        const std::size_t equal = source_.find(first, last, {"="});
        if (equal < last)
            expression(equal + 1, last);
    }

    void condition(std::size_t first, std::size_t last, std::string_view keyword) {
        if (source_.find(first, last, {"="}) < last)
            return initialiser(first, last);
        if (keyword == "switch")
            return expression(first, last);
        if (first >= last || has_statement(first, last))
            return;
        std::vector<Change> changes;
        changes.push_back({first, last - first, "false", "check never"});
        if (keyword == "if")
            changes.push_back({first, last - first, "true", "check always"});
        changes_.find(first, last, changes);
        replace(first, last, changes, "static_cast<bool>");
    }

    void expression(std::size_t first, std::size_t last) {
        if (first >= last || source_.word(first) == "{" || has_statement(first, last) ||
            source_.find(first, last, {",", ")"}) != last)
            return;
        std::vector<Change> changes;
        changes_.find(first, last, changes);
        replace(first, last, changes, "");
    }

    // A lambda, whose statements are visited in their turn.
    bool has_statement(std::size_t first, std::size_t last) const {
        for (std::size_t i = first; i < last; ++i)
            if (source_.word(i) == ";")
                return true;
        return false;
    }

    bool begins_statement() const {
        if (at_ == after_header_)
            return true;
        const std::string_view before = source_.word(at_ - 1);
        return before == ";" || before == "{" || before == "}" || before == "else" ||
               before == "do" || (before == ":" && is_label(source_.word(head_)));
    }
    static bool is_label(std::string_view word) { return word == "case" || word == "default"; }

    // `f(x);`, `a.b = c;`, `++i;`: it may be dropped, and what is in it changed. Asserts and what
    // makes room are no behaviour.
    void statement() {
        const std::size_t first = at_;
        const std::size_t last = semicolon();
        const std::size_t end = end_of_target(first);
        const bool assigns = is_assignment(source_.word(end));
        if (end == first || (!assigns && source_.word(end) != ";") || is_no_behaviour(first, last))
            return;
        if (const unsigned dropped = next("drop", first, first, last, "")) {
            const std::string condition = "if (!mutant(" + std::to_string(dropped) + "))";
            insert(source_.tokens[first].begin,
                   "{" + line("mutant", dropped) + condition + line_of(first));
            insert(source_.tokens[last].end, " }");
        }
        if (assigns)
            at_ = end - 1; // the assignment is visited next
        else
            expression(first, last);
    }

    bool is_no_behaviour(std::size_t first, std::size_t last) const {
        for (std::size_t i = first; i < last; ++i)
            if (source_.word(i) == "reserve" || source_.word(i) == "assert")
                return true;
        return false;
    }

    // Behind `++`, `*`, a name and calls, members and subscripts of it; `i` when nothing is called,
    // counted or assigned.
    std::size_t end_of_target(std::size_t i) const {
        const std::size_t begin = i;
        bool acts = false;
        while (source_.word(i) == "++" || source_.word(i) == "--" || source_.word(i) == "*")
            acts = source_.word(i++) != "*" || acts;
        if (source_.tokens[i].kind != Kind::word)
            return begin;
        for (++i; i < source_.tokens.size();) {
            const std::string_view here = source_.word(i);
            if (here == "::" || here == "." || here == "->")
                i += 2;
            else if (here == "(" || here == "[") {
                acts = acts || here == "(";
                i = source_.closer(i) + 1;
            } else
                break;
        }
        return acts || is_assignment(source_.word(i)) ? i : begin;
    }

    // ---- the text

    void replace(std::size_t first, std::size_t last, const std::vector<Change>& changes,
                 const std::string& cast) {
        const std::string choice = choice_of(changes, first, last, cast);
        if (!choice.empty())
            edit(first, last, "(" + choice + original(first, last, cast) + ")");
        at_ = last - 1;
    }

    // `mutant(1) ? (E1) : mutant(2) ? (E2) :`
    std::string choice_of(const std::vector<Change>& changes, std::size_t first, std::size_t last,
                          const std::string& cast = "") {
        std::string all;
        for (const Change& change : changes) {
            const unsigned chosen =
                next(change.kind, change.at, change.at, change.at + change.count, change.instead);
            if (chosen == 0)
                continue;
            all += line("mutant", chosen) + "mutant(" + std::to_string(chosen) + ") ? " + cast;
            all += "(" + source_.joined(first, last, change.at, change.count, change.instead);
            all += ") : ";
        }
        return all;
    }

    std::string original(std::size_t first, std::size_t last, const std::string& cast) const {
        const std::size_t begin = source_.tokens[first].begin;
        return line_of(first) + cast + "(" +
               source_.text.substr(begin, source_.tokens[last - 1].end - begin) + ")";
    }

    static std::string line(const std::string& path, std::size_t number) {
        return "\n#line " + std::to_string(number) + " \"" + path + "\"\n";
    }
    std::string line_of(std::size_t token) const { return line(source_.path, source_.line(token)); }

    // Gives the mutation a number and tells of it; 0 when it is not chosen.
    unsigned next(const std::string& kind, std::size_t at, std::size_t first, std::size_t last,
                  const std::string& instead) {
        const unsigned number = ++number_;
        std::cout << number << '\t' << source_.path << ':' << source_.line(at) << '\t' << kind
                  << '\t' << source_.joined(first, last, last, 0, "");
        if (kind != "drop")
            std::cout << " -> " << (instead.empty() ? "nothing" : instead);
        std::cout << '\t' << source_.text_of_line(at) << '\n';
        return chosen_.contains(number) ? number : 0;
    }

    void edit(std::size_t first, std::size_t last, std::string text) {
        edits_.push_back(
            {source_.tokens[first].begin, source_.tokens[last - 1].end, std::move(text)});
    }
    void insert(std::size_t at, std::string text) { edits_.push_back({at, at, std::move(text)}); }

    std::string apply_edits() {
        std::stable_sort(edits_.begin(), edits_.end(),
                         [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
        std::string all = "#line 1 \"" + source_.path + "\"\n";
        std::size_t at = 0;
        for (const Edit& one : edits_) {
            all.append(source_.text, at, one.begin - at).append(one.text);
            at = one.end;
        }
        return all.append(source_.text, at);
    }

    const Source& source_;
    Changes changes_;
    const std::set<unsigned>& chosen_;
    unsigned& number_;
    std::vector<Scope> scopes_;
    std::vector<Edit> edits_;
    std::size_t at_ = 0;
    std::size_t head_ = 0;         // where the statement or declaration begins
    std::size_t after_header_ = 0; // the token behind `if (...)`
};

// ---- files --------------------------------------------------------------------------------------

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

bool is_source(const fs::path& path) {
    return path.extension() == ".cpp" || path.extension() == ".hpp";
}

// All that `enum class` declares anywhere.
Enumerations enumerations_below(const fs::path& root) {
    Enumerations names;
    for (const char* folder : {"include", "src"})
        for (const auto& file : fs::recursive_directory_iterator(root / folder)) {
            if (!is_source(file.path()))
                continue;
            Source source{{}, read(file.path()), {}};
            source.tokens = Lexer(source.text).tokens();
            for (std::size_t i = 0; i < source.tokens.size(); ++i)
                if (source.word(i) == "enum" && source.word(i + 1) == "class")
                    names.emplace(source.word(i + 2));
        }
    return names;
}

std::vector<fs::path> sources_in(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& file : fs::directory_iterator(folder))
        if (is_source(file.path()))
            paths.push_back(file.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

} // namespace

int main(int count, char** arguments) {
    if (count < 5) {
        std::cerr << "usage: mutate FROM TO CHOSEN FOLDER...\n";
        return 2;
    }
    const fs::path from = arguments[1];
    const fs::path to = arguments[2];
    std::ifstream numbers(arguments[3]);
    const std::set<unsigned> chosen{std::istream_iterator<unsigned>(numbers), {}};
    const Enumerations enumerations = enumerations_below(from);
    unsigned number = 0;
    for (int i = 4; i < count; ++i)
        for (const fs::path& path : sources_in(from / arguments[i])) {
            Source source{fs::relative(path, from).generic_string(), read(path), {}};
            source.tokens = Lexer(source.text).tokens();
            const std::string text = Mutator(source, enumerations, chosen, number).mutated();
            if (text != read(to / source.path)) // or it would be compiled again
                std::ofstream(to / source.path, std::ios::binary) << text;
        }
    return 0;
}
