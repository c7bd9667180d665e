#pragma once

#include <iecfront/lexer/token.hpp>

#include <array>
#include <cstdint>
#include <initializer_list>

namespace iecfront {

/// A set of token kinds, as bits.
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
        const auto i = static_cast<unsigned>(kind);
        return ((bits_[i / 64] >> (i % 64)) & 1U) != 0;
    }
    friend constexpr TokenSet operator|(TokenSet a, const TokenSet& b) noexcept {
        for (std::size_t i = 0; i < a.bits_.size(); ++i)
            a.bits_[i] |= b.bits_[i];
        return a;
    }

private:
    constexpr void add(TokenKind kind) noexcept {
        const auto i = static_cast<unsigned>(kind);
        bits_[i / 64] |= std::uint64_t{1} << (i % 64);
    }
    std::array<std::uint64_t, (token_kind_count + 63) / 64> bits_{};
};

} // namespace iecfront
