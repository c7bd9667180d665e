// Any bytes, in any encoding: tokens, trivia and the gaps between them give back the bytes.

#include "support/lexed_faults.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace iecfront;
    const std::string text(data, data + size); // a zero byte stands behind it
    for (const Encoding encoding : {Encoding::utf8, Encoding::windows_1252, Encoding::iso_8859_1}) {
        const std::string fault = test::tiling_fault(text, lex(text, encoding), encoding);
        if (!fault.empty()) {
            std::fprintf(stderr, "%s\n", fault.c_str());
            std::abort();
        }
    }
    return 0;
}
