// SPDX-License-Identifier: MIT
// Any bytes as a picture of the sky or as a baked sky: finite radiances, or an error.
#include <cmath>

#include "franken/baked_sky.h"
#include "image/exr.h"
#include "image/hdr.h"
#include "require.h"
#include "sky/hdre.h"

namespace {

using namespace franken;

constexpr int kMaxSize = 512;
constexpr std::size_t kMaxBytes = std::size_t{16} << 20;

void checkTexels(const std::vector<glm::vec3>& texels) {
    for (const glm::vec3& texel : texels)
        for (int i = 0; i < 3; ++i)
            require(texel[i] >= 0 && texel[i] <= 1e9f, "radiances in range");
}

template<typename Picture>
void check(const Result<Picture>& image) {
    if (!image) {
        require(!image.error().code.empty() && !image.error().what.empty(), "an error says what");
        return;
    }
    require(image->texels.size() ==
                static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height),
            "all texels");
    checkTexels(image->texels);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::uint8_t> bytes(data, size);
    if (isHdre(bytes))
        check(decodeHdre(bytes, kMaxSize, kMaxBytes));
    else
        check(isHdr(bytes)   ? decodeHdr(bytes, kMaxSize, kMaxBytes)
              : isExr(bytes) ? decodeExr(bytes, kMaxSize, kMaxBytes)
                             : decodeSrgbImage(bytes, kMaxSize, kMaxBytes));
    const auto baked = decodeBakedSky(bytes);
    require(baked || baked.error().code == "sky.baked", "a documented code");
    return 0;
}
