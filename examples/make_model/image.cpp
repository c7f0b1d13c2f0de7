// SPDX-License-Identifier: MIT
#include "image.h"

#include <algorithm>
#include <cmath>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

namespace make_model {

std::vector<std::uint8_t> encodePng(const Image& image) {
    std::vector<std::uint8_t> file;
    const auto append = [](void* context, void* data, int size) {
        const auto* bytes = static_cast<const std::uint8_t*>(data);
        auto& target = *static_cast<std::vector<std::uint8_t>*>(context);
        target.insert(target.end(), bytes, bytes + size);
    };
    stbi_write_png_compression_level = 20; // How many matches it tries for each byte; 8 is the default.
    stbi_write_png_to_func(append, &file, image.width, image.height, image.channels, image.pixels.data(),
                           image.width * image.channels);
    return file;
}

std::uint8_t toByte(double value) {
    return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 1.0) * 255.0 + 0.5));
}

} // namespace make_model
