#pragma once

#include <iecfront/lexer/token.hpp>

#include <array>
#include <cstdint>
#include <initializer_list>

namespace iecfront {

/// A set of token kinds. A byte for each, as that is asked for with one look, and far more often
/// than sets are made.
class TokenSet {
public:
    constexpr TokenSet(std::initializer_list<TokenKind> kinds) noexcept {
        for (const TokenKind kind : kinds)
            add(kind);
    }
    /// All kinds from `first` to `last`, both included.
    static constexpr TokenSet range(TokenKind first, TokenKind last) noexcept {
        TokenSet set{};
        for (auto i = static_cast<unsigned>(first); i <= static_cast<unsigned>(last); ++i)
            set.add(static_cast<TokenKind>(i));
        return set;
    }
    [[nodiscard]] constexpr bool contains(TokenKind kind) const noexcept {
        return holds_[static_cast<std::size_t>(kind)];
    }
    friend constexpr TokenSet operator|(TokenSet a, const TokenSet& b) noexcept {
        for (std::size_t i = 0; i < a.holds_.size(); ++i)
            a.holds_[i] = a.holds_[i] || b.holds_[i];
        return a;
    }

private:
    constexpr void add(TokenKind kind) noexcept { holds_[static_cast<std::size_t>(kind)] = true; }
    std::array<bool, token_kind_count> holds_{};
};

} // namespace iecfront
