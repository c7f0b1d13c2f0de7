// SPDX-License-Identifier: MIT
#include "image.h"

#include "franken/png.h"

#include <algorithm>
#include <cmath>

namespace make_model {

std::vector<std::uint8_t> encodePng(const Image& image) {
    constexpr int kEffort = 20; // The file is made once and loaded often.
    return franken::encodePng(image.width, image.height, image.channels, image.pixels, kEffort);
}

std::uint8_t toByte(double value) {
    return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 1.0) * 255.0 + 0.5));
}

} // namespace make_model
