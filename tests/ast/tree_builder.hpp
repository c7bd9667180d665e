#pragma once

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/unit.hpp>

#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace iecfront::test {

// Builds a unit by hand. Its tokens are the words of the text, divided by spaces and line ends.
class TreeBuilder {
public:
    explicit TreeBuilder(std::string text, Encoding encoding = Encoding::utf8)
        : TreeBuilder(std::make_shared<const std::string>(std::move(text)), encoding) {}
    // A unit over all of a shared text, or over `range` of it.
    explicit TreeBuilder(std::shared_ptr<const std::string> buffer,
                         Encoding encoding = Encoding::utf8) {
        parts_.buffer = std::move(buffer);
        parts_.text = *parts_.buffer;
        parts_.encoding = encoding;
        cut_words();
    }
    TreeBuilder(std::shared_ptr<const std::string> buffer, TextRange range) {
        parts_.buffer = std::move(buffer);
        parts_.text = std::string_view(*parts_.buffer).substr(range.begin, range.size());
        cut_words();
    }

    // A node over tokens [first, end); without tokens it is missing.
    template<class T>
    T* node(std::uint32_t first, std::uint32_t end) {
        T* made = parts_.arena.create<T>();
        made->first_token = first;
        made->end_token = end;
        made->missing = first == end;
        return made;
    }

    // A leaf over one token.
    template<class T>
    T* leaf(std::uint32_t token) {
        return node<T>(token, token + 1);
    }

    template<class T>
    std::span<const ast::Child<T>> list(const std::vector<const T*>& items) {
        const std::span<ast::Child<T>> children{
            static_cast<ast::Child<T>*>(parts_.arena.allocate(
                items.size() * sizeof(ast::Child<T>) + 1, alignof(ast::Child<T>))),
            items.size()};
        std::uninitialized_default_construct(children.begin(), children.end());
        for (std::size_t i = 0; i < items.size(); ++i)
            children[i] = items[i];
        return children;
    }

    void add(Diagnostic diagnostic) { parts_.diagnostics.push_back(std::move(diagnostic)); }

    // Ends the building. The root has `elements`, and all tokens.
    std::shared_ptr<const Unit> unit(const std::vector<const ast::Node*>& elements = {}) {
        const auto tokens = static_cast<std::uint32_t>(parts_.tokens.size());
        auto* root = node<ast::LibraryUnit>(0, tokens);
        root->missing = false;
        root->elements = list<ast::Node>(elements);
        parts_.root = root;
        return std::make_shared<const Unit>(std::move(parts_));
    }

private:
    static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r'; }

    void cut_words() {
        parts_.arena = Arena(10'000 + 100 * parts_.text.size()); // more than any test needs
        std::vector<Token> tokens;
        const std::string_view text = parts_.text;
        for (std::size_t begin = 0; begin < text.size(); ++begin) {
            if (is_space(text[begin]))
                continue;
            std::size_t end = begin;
            while (end < text.size() && !is_space(text[end]))
                ++end;
            tokens.emplace_back(TokenKind::identifier, static_cast<std::uint32_t>(begin),
                                static_cast<std::uint32_t>(end - begin));
            begin = end;
        }
        parts_.tokens = parts_.arena.copy(std::span<const Token>(tokens));
    }

    Unit::Parts parts_;
};

// `x := a + b ;` as a statement, of which the first token is number `first`.
inline ast::AssignmentStatement* assignment(TreeBuilder& builder, std::uint32_t first = 0) {
    auto* sum = builder.node<ast::BinaryExpression>(first + 2, first + 5);
    sum->op = ast::BinaryOperator::add;
    sum->left = builder.leaf<ast::VariableName>(first + 2);
    sum->right = builder.leaf<ast::VariableName>(first + 4);
    auto* statement = builder.node<ast::AssignmentStatement>(first, first + 5);
    statement->variable = builder.leaf<ast::VariableName>(first);
    statement->expression = sum;
    return statement;
}

// `a + a + ... + a` with `operands` operands, associating to the left; the text must be such.
inline const ast::Expression* chain(TreeBuilder& builder, std::uint32_t operands) {
    const ast::Expression* left = builder.leaf<ast::VariableName>(0);
    for (std::uint32_t i = 1; i < operands; ++i) {
        auto* sum = builder.node<ast::BinaryExpression>(0, 2 * i + 1);
        sum->op = ast::BinaryOperator::add;
        sum->left = left;
        sum->right = builder.leaf<ast::VariableName>(2 * i);
        left = sum;
    }
    return left;
}

// The text of such a chain.
inline std::string chain_text(std::uint32_t operands) {
    std::string text = "a";
    for (std::uint32_t i = 1; i < operands; ++i)
        text += " + a";
    return text;
}

// `( ( ... a ... ) )` in `depth` parentheses; the text must be such.
inline const ast::Expression* nested(TreeBuilder& builder, std::uint32_t depth) {
    const ast::Expression* inner = builder.leaf<ast::VariableName>(depth);
    for (std::uint32_t i = 1; i <= depth; ++i) {
        auto* outer = builder.node<ast::ParenthesizedExpression>(depth - i, depth + i + 1);
        outer->expression = inner;
        inner = outer;
    }
    return inner;
}

inline std::string nested_text(std::uint32_t depth) {
    std::string text;
    for (std::uint32_t i = 0; i < depth; ++i)
        text += "( ";
    text += 'a';
    for (std::uint32_t i = 0; i < depth; ++i)
        text += " )";
    return text;
}

} // namespace iecfront::test
