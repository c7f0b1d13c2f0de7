// SPDX-License-Identifier: MIT
// Any bytes as a manifest: refused, or the same again after it is written.
#include <string_view>

#include "franken/manifest.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace franken;
    const auto uses = parseManifest({reinterpret_cast<const char*>(data), size}, "input");
    if (!uses) {
        require(uses.error().code.starts_with("manifest."), "a documented code");
        return 0;
    }
    const std::string text = toManifest(*uses);
    const auto again = parseManifest(text, "again");
    require(again.has_value(), "what is written can be read");
    require(toManifest(*again) == text, "and says the same");
    return 0;
}
