#include <iecfront/lexer/token.hpp>

#include <array>

namespace iecfront {

namespace {

constexpr std::array<std::string_view, token_kind_count> spellings = {
#define IECFRONT_KEYWORD(enumerator, spelling) spelling,
#define IECFRONT_DELIMITER(enumerator, spelling) spelling,
#define IECFRONT_TOKEN(enumerator, description) description,
#include <iecfront/lexer/tokens.def>
};

constexpr std::array<std::string_view, token_kind_count> enumerators = {
#define IECFRONT_KEYWORD(enumerator, spelling) #enumerator,
#define IECFRONT_DELIMITER(enumerator, spelling) #enumerator,
#define IECFRONT_TOKEN(enumerator, description) #enumerator,
#include <iecfront/lexer/tokens.def>
};

} // namespace

std::string_view spelling(TokenKind kind) noexcept {
    return spellings[static_cast<std::size_t>(kind)];
}

std::string_view to_string(TokenKind kind) noexcept {
    return enumerators[static_cast<std::size_t>(kind)];
}

std::string_view to_string(TriviaKind kind) noexcept {
    switch (kind) {
    case TriviaKind::comment: return "comment";
    case TriviaKind::pragma: return "pragma";
    case TriviaKind::line_comment: return "line_comment";
    case TriviaKind::c_comment: return "c_comment";
    }
    return {};
}

} // namespace iecfront
