// SPDX-License-Identifier: MIT
// Any bytes as a TrueType font: glyphs within limits, or an error.
#include "require.h"
#include "support/font_walk.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string broken = franken::test::brokenPromiseOf({data, size});
    require(broken.empty(), broken.c_str());
    return 0;
}
