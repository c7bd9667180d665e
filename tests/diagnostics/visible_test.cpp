#include "diagnostics/visible.hpp"

#include <gtest/gtest.h>
#include <string>

using namespace iecfront;

namespace {

// Bytes that only go on with a character, and none that begins one: the end of the text is looked
// for from behind.
TEST(Visible, ShortensBrokenBytes) {
    for (std::size_t size = 1; size < 100; ++size) {
        std::string out;
        append_shortened(out, std::string(size, '\x96'), 20, Encoding::utf8);
        EXPECT_TRUE(out.starts_with("\\x96")) << size;
        EXPECT_TRUE(out.ends_with("\\x96")) << size;
        EXPECT_EQ(out.find("...") != std::string::npos, size > 20) << out;
    }
}

} // namespace
