// SPDX-License-Identifier: MIT
// Any bytes as a picture of the sky or as a baked sky: finite radiances, or an error.
#include <cmath>

#include "franken/baked_sky.h"
#include "image/hdr.h"
#include "require.h"

namespace {

using namespace franken;

constexpr int kMaxSize = 512;
constexpr std::size_t kMaxBytes = std::size_t{16} << 20;

void check(const Result<FloatImage>& image) {
    if (!image) {
        require(!image.error().code.empty() && !image.error().what.empty(), "an error says what");
        return;
    }
    require(image->texels.size() ==
                static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height),
            "all texels");
    for (const glm::vec3& texel : image->texels)
        for (int i = 0; i < 3; ++i)
            require(texel[i] >= 0 && texel[i] <= 1e9f, "radiances in range");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::uint8_t> bytes(data, size);
    check(isHdr(bytes) ? decodeHdr(bytes, kMaxSize, kMaxBytes) : decodeSrgbImage(bytes, kMaxSize, kMaxBytes));
    const auto baked = decodeBakedSky(bytes);
    require(baked || baked.error().code == "sky.baked", "a documented code");
    return 0;
}
