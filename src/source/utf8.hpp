#pragma once

#include <string>

namespace iecfront {

/// Appends the UTF-8 form of `code_point`; of U+FFFD, when it is none that UTF-8 can hold.
inline void append_utf8(std::string& out, char32_t code_point) {
    const bool surrogate = code_point >= 0xD800 && code_point <= 0xDFFF;
    if (surrogate || code_point > 0x10FFFF)
        code_point = U'\uFFFD';
    const auto lead = [&](unsigned marker, unsigned shift) {
        out += static_cast<char>(marker | (code_point >> shift));
    };
    const auto trail = [&](unsigned shift) {
        out += static_cast<char>(0x80U | ((code_point >> shift) & 0x3FU));
    };
    if (code_point < 0x80) {
        lead(0, 0);
    } else if (code_point < 0x800) {
        lead(0xC0, 6);
        trail(0);
    } else if (code_point < 0x10000) {
        lead(0xE0, 12);
        trail(6);
        trail(0);
    } else {
        lead(0xF0, 18);
        trail(12);
        trail(6);
        trail(0);
    }
}

} // namespace iecfront
