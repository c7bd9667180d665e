// A libFuzzer target: the row of `fuzz_targets()` that IECFRONT_FUZZ_TARGET names.

#include "fuzz/targets.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace iecfront::test;
    static const FuzzTarget target =
        *std::ranges::find(fuzz_targets(), IECFRONT_FUZZ_TARGET, &FuzzTarget::name);
    const std::string bytes(data, data + size);
    const std::string fault = target.fault(bytes);
    if (!fault.empty()) {
        std::fprintf(stderr, "%s\n", fault.c_str());
        std::abort();
    }
    return 0;
}
