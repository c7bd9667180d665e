#include "lexer/characters.hpp"
#include "lexer/keywords.hpp"
#include "lexer/lexer.hpp"

#include <algorithm>
#include <string>

namespace iecfront {

namespace {

// True when every underscore of a word is followed by a letter or digit, as all have to be (2.1.2).
[[nodiscard]] bool has_single_underscores(const char* begin, const char* end) noexcept {
    for (const char* p = begin; p != end; ++p)
        if (*p == '_' && (p + 1 == end || p[1] == '_'))
            return false;
    return true;
}

} // namespace

// A word that a `#` or a character beyond ASCII may follow, or one with a fault.
const char* Lexer::odd_word(const char* begin) {
    const char* const end = extents_.word_end(begin);
    if (*end == '#')
        return prefixed(begin, end);
    if (const char* const literal_end = with_pound_sign(begin, end))
        return literal_end;
    return plain_word(begin, end);
}

const char* Lexer::plain_word(const char* begin, const char* end) {
    const TokenKind kind = keyword_kind(view(begin, end));
    if (kind == TokenKind::identifier)
        return identifier(begin, end);
    emit(kind, begin, end);
    return end;
}

const char* Lexer::identifier(const char* begin, const char* end) {
    if (const char* const whole_end = parted_keyword(begin, end))
        return whole_end;
    const bool malformed = !check_word(begin, end);
    emit_any(TokenKind::identifier, begin, end, malformed);
    return end;
}

// Reports what keeps a word from being an identifier (2.1.2). True when nothing does.
bool Lexer::check_word(const char* begin, const char* end) {
    if (!check_foreign_letters(begin, end))
        return false;
    if (has_single_underscores(begin, end))
        return true;
    check_underscores(begin, end);
    return false;
}

// `END_ IF` on one line, which is one keyword. Null when it is none.
const char* Lexer::parted_keyword(const char* begin, const char* end) {
    const char* const rest = Extents::blanks_end(end);
    if (end[-1] != '_' || rest == end)
        return nullptr;
    const char* const rest_end = extents_.word_end(rest);
    const std::string whole = std::string(view(begin, end)).append(view(rest, rest_end));
    const TokenKind kind = keyword_kind(whole);
    if (kind == TokenKind::identifier)
        return nullptr;
    Diagnostic& diagnostic = report(DiagnosticId::misspelt_word, range(begin, rest_end));
    diagnostic.arguments = {std::string(view(begin, rest_end)), whole};
    add_replacement(diagnostic, range(begin, rest_end), whole);
    emit_any(kind, begin, rest_end, true);
    return rest_end;
}

void Lexer::check_underscores(const char* begin, const char* end) {
    for (const char* p = begin; p != end;) {
        if (*p != '_') {
            ++p;
            continue;
        }
        const char* run = p;
        while (run != end && *run == '_')
            ++run;
        const TextRange where = range(p, run);
        if (p == begin && run == end)
            report(DiagnosticId::lone_underscore, where);
        else if (run == end)
            add_replacement(report(DiagnosticId::trailing_underscore, where), where);
        else if (run - p > 1)
            add_replacement(report(p == begin ? DiagnosticId::leading_underscores
                                              : DiagnosticId::consecutive_underscores,
                                   where),
                            where, "_");
        p = run;
    }
}

bool Lexer::check_foreign_letters(const char* begin, const char* end) {
    const char* p = std::find_if_not(begin, end, is_ascii);
    if (p == end)
        return true;
    while (p != end && !extents_.decode(p).valid) // of broken bytes the encoding check speaks
        p = std::find_if_not(p + 1, end, is_ascii);
    if (p != end) {
        const DecodedCharacter character = extents_.decode(p);
        report(DiagnosticId::character_in_identifier, range(p, p + character.size))
            .arguments.emplace_back(character.code_point);
    }
    return false;
}

} // namespace iecfront
